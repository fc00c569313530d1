// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/start/welcomepage.h"

#include "app/editor/start/samples.h"
#include "views/dialogs/quantitytext.h"
#include "views/widgets/icons.h"

#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

namespace editor {

namespace {

constexpr int ContentWidth = 800;
constexpr int Spacing = 14;

/// A place for a picture that is not there.
QPixmap emptyPicture(double ratio)
{
    QPixmap pixmap(int(Thumbnails::Width * ratio), int(Thumbnails::Height * ratio));
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(QColor(40, 45, 54));
    QPainter painter(&pixmap);
    painter.setOpacity(0.35);
    painter.drawPixmap(QRect((Thumbnails::Width - 48) / 2, (Thumbnails::Height - 48) / 2, 48, 48),
                       views::applicationIcon().pixmap(QSize(48, 48), ratio));
    return pixmap;
}

QLabel *makeHeading(QWidget *parent)
{
    auto *label = new QLabel(parent);
    QFont font = label->font();
    font.setBold(true);
    label->setFont(font);
    return label;
}

/// A button for an action that is as large as its importance here.
QPushButton *makeButton(QAction &action, QWidget *parent)
{
    auto *button = new QPushButton(action.icon(), action.text(), parent);
    button->setIconSize({22, 22});
    button->setMinimumHeight(42);
    button->setObjectName(QStringLiteral("welcome.") + action.objectName());
    QObject::connect(button, &QPushButton::clicked, &action, &QAction::trigger);
    QObject::connect(&action, &QAction::changed, button, [button, &action] { button->setText(action.text()); });
    return button;
}

} // namespace

WelcomePage::WelcomePage(Actions &actions, const Settings &settings, QWidget *parent)
    : QWidget(parent)
    , mSettings(settings)
    , mContent(new QWidget)
    , mSlogan(new QLabel(mContent))
    , mSamplesTitle(makeHeading(mContent))
    , mRecentTitle(makeHeading(mContent))
    , mHint(new QLabel(mContent))
    , mSamples(new QGridLayout)
    , mRecent(new QGridLayout)
{
    auto *logo = new QLabel(mContent);
    logo->setPixmap(views::applicationIcon().pixmap(72, 72));
    auto *title = new QLabel(QStringLiteral("Sandreel"), mContent);
    QFont font = title->font();
    font.setPointSizeF(font.pointSizeF() * 2.2);
    font.setWeight(QFont::DemiBold);
    title->setFont(font);
    auto *titles = new QVBoxLayout;
    titles->setSpacing(2);
    titles->addStretch();
    titles->addWidget(title);
    titles->addWidget(mSlogan);
    titles->addStretch();
    auto *head = new QHBoxLayout;
    head->setSpacing(18);
    head->addWidget(logo);
    head->addLayout(titles, 1);

    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(Spacing);
    buttons->addWidget(makeButton(actions[ActionId::Prepare], mContent));
    buttons->addWidget(makeButton(actions[ActionId::NewTerrain], mContent));
    buttons->addWidget(makeButton(actions[ActionId::Open], mContent));
    buttons->addStretch();

    for (QGridLayout *grid : {mSamples, mRecent}) {
        grid->setSpacing(Spacing);
        grid->setContentsMargins(0, 0, 0, 0);
    }
    auto *layout = new QVBoxLayout(mContent);
    layout->setContentsMargins(32, 32, 32, 32);
    layout->setSpacing(12);
    layout->addLayout(head);
    layout->addSpacing(8);
    layout->addLayout(buttons);
    layout->addSpacing(16);
    layout->addWidget(mSamplesTitle);
    layout->addLayout(mSamples);
    layout->addSpacing(16);
    layout->addWidget(mRecentTitle);
    layout->addLayout(mRecent);
    layout->addSpacing(16);
    layout->addWidget(mHint);
    layout->addStretch();
    mHint->setWordWrap(true);
    mHint->setEnabled(false);

    auto *scroll = new QScrollArea(this);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus);
    auto *centred = new QWidget;
    auto *centring = new QHBoxLayout(centred);
    centring->setContentsMargins(0, 0, 0, 0);
    mContent->setMaximumWidth(ContentWidth + 64);
    centring->addWidget(mContent);
    scroll->setWidget(centred);
    auto *outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scroll);

    connect(&mThumbnails, &Thumbnails::ready, this, [this](const QString &path) {
        const auto cards = mContent->findChildren<QToolButton *>();
        for (QToolButton *card : cards)
            if (card->property("path").toString() == path)
                card->setIcon(mThumbnails.of(path));
    });
    retranslate();
}

QToolButton *WelcomePage::makeCard(const Card &card)
{
    auto *button = new QToolButton(mContent);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIconSize({Thumbnails::Width, Thumbnails::Height});
    const QPixmap picture = mThumbnails.of(card.path);
    button->setIcon(picture.isNull() ? emptyPicture(devicePixelRatioF()) : picture);
    QString text = button->fontMetrics().elidedText(card.name, Qt::ElideMiddle, Thumbnails::Width - 8);
    text.replace(QLatin1Char('&'), QLatin1String("&&"));
    button->setText(text);
    button->setAccessibleName(card.name);
    button->setProperty("path", card.path);
    const QFileInfo file(card.path);
    if (!card.path.startsWith(QLatin1String(":/")))
        button->setToolTip(QDir::toNativeSeparators(card.path) + QLatin1Char('\n') +
                           views::bytesText(std::uint64_t(file.size())));
    connect(button, &QToolButton::clicked, this, [this, path = card.path] { emit openRequested(path); });
    return button;
}

void WelcomePage::fill(QGridLayout &grid, const std::vector<Card> &cards)
{
    while (QLayoutItem *item = grid.takeAt(0)) {
        if (item->widget())
            item->widget()->deleteLater();
        delete item;
    }
    int place = 0;
    for (const Card &card : cards) {
        grid.addWidget(makeCard(card), place / mColumns, place % mColumns);
        ++place;
    }
    grid.setColumnStretch(mColumns, 1);
}

int WelcomePage::columns() const
{
    const int card = Thumbnails::Width + 12 + Spacing;
    return std::clamp((std::min(width(), ContentWidth + 64) - 64 + Spacing) / card, 1, 4);
}

void WelcomePage::refresh()
{
    for (QGridLayout *grid : {mSamples, mRecent})
        grid->setColumnStretch(mColumns, 0);
    mColumns = columns();
    std::vector<Card> sampleCards;
    for (const Sample &sample : samples())
        sampleCards.push_back({sample.path, sample.name});
    std::vector<Card> recentCards;
    const QStringList recent = mSettings.recentFiles();
    for (const QString &path : recent)
        if (QFileInfo::exists(path) && int(recentCards.size()) < 2 * mColumns)
            recentCards.push_back({path, QFileInfo(path).completeBaseName()});
    mSamplesTitle->setVisible(!sampleCards.empty());
    mRecentTitle->setVisible(!recentCards.empty());
    fill(*mSamples, sampleCards);
    fill(*mRecent, recentCards);
}

void WelcomePage::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        refresh();
    }
    QWidget::changeEvent(event);
}

void WelcomePage::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    if (isVisible() && columns() != mColumns)
        refresh();
}

void WelcomePage::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    refresh();
}

void WelcomePage::retranslate()
{
    mSlogan->setText(tr("Mesh animations and sandy terrain"));
    mSamplesTitle->setText(tr("Samples"));
    mRecentTitle->setText(tr("Recent"));
    mHint->setText(
        tr("You can also drop files here: an .anim or .terrain file, a folder of OBJ, OFF, PLY or STL meshes, a PC2 or "
           "MDD point cache, a glTF or FBX scene, or an elevation model."));
}

} // namespace editor
