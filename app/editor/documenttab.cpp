// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/documenttab.h"

#include "views/viewport/animationviewport.h"
#include "views/viewport/glsupport.h"
#include "views/widgets/icons.h"

#include <QEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedLayout>
#include <QVBoxLayout>

namespace editor {

namespace {

constexpr int ProgressSteps = 1000;

QLabel *makeTitle(QWidget *parent)
{
    auto *label = new QLabel(parent);
    QFont font = label->font();
    font.setPointSizeF(font.pointSizeF() * 1.25);
    label->setFont(font);
    label->setAlignment(Qt::AlignCenter);
    return label;
}

} // namespace

DocumentTab::DocumentTab(bool canDraw, QWidget *parent)
    : QWidget(parent)
    , mCanDraw(canDraw)
    , mPages(new QStackedLayout(this))
{
    mPages->addWidget(makeOpeningPage());
    connect(&mDocument, &Document::opened, this, &DocumentTab::showDocument);
    connect(&mDocument, &Document::stateChanged, this, &DocumentTab::retranslate);
    connect(&mDocument.openingJob(), &views::Job::progressed, this,
            [this](double fraction) { mOpeningBar->setValue(int(fraction * ProgressSteps)); });
    retranslate();
}

QWidget *DocumentTab::makeOpeningPage()
{
    auto *page = new QWidget(this);
    auto *layout = new QVBoxLayout(page);
    mOpeningTitle = makeTitle(page);
    mOpeningBar = new QProgressBar(page);
    mOpeningBar->setRange(0, ProgressSteps);
    mOpeningBar->setTextVisible(false);
    mOpeningBar->setFixedWidth(320);
    mCancel = new QPushButton(page);
    mCancel->setObjectName(QStringLiteral("cancelOpening"));
    connect(mCancel, &QPushButton::clicked, &mDocument, &Document::cancelOpening);
    layout->addStretch();
    layout->addWidget(mOpeningTitle, 0, Qt::AlignHCenter);
    layout->addSpacing(8);
    layout->addWidget(mOpeningBar, 0, Qt::AlignHCenter);
    layout->addSpacing(8);
    layout->addWidget(mCancel, 0, Qt::AlignHCenter);
    layout->addStretch();
    return page;
}

QWidget *DocumentTab::makeNoGlPage()
{
    auto *page = new QWidget(this);
    page->setObjectName(QStringLiteral("noOpenGlPage"));
    auto *layout = new QVBoxLayout(page);
    auto *picture = new QLabel(page);
    picture->setPixmap(views::icon(QStringLiteral("warning")).pixmap(48, 48));
    mNoGlTitle = makeTitle(page);
    mNoGlText = new QLabel(page);
    mNoGlText->setWordWrap(true);
    mNoGlText->setFixedWidth(460);
    mNoGlText->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
    mNoGlText->setTextInteractionFlags(Qt::TextSelectableByMouse);
    layout->addStretch();
    layout->addWidget(picture, 0, Qt::AlignHCenter);
    layout->addWidget(mNoGlTitle, 0, Qt::AlignHCenter);
    layout->addWidget(mNoGlText, 0, Qt::AlignHCenter);
    layout->addStretch();
    return page;
}

void DocumentTab::showDocument()
{
    if (mPages->count() == 1) {
        QWidget *page = nullptr;
        if (mCanDraw)
            page = mViewport = new views::AnimationViewport(mDocument.player(), this);
        else
            page = makeNoGlPage();
        mPages->addWidget(page);
        retranslate();
    }
    mPages->setCurrentIndex(1);
}

void DocumentTab::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void DocumentTab::retranslate()
{
    mOpeningTitle->setText(tr("Opening %1…").arg(mDocument.title()));
    mOpeningBar->setAccessibleName(tr("Progress of opening"));
    mCancel->setText(tr("Cancel"));
    if (mNoGlTitle) {
        mNoGlTitle->setText(tr("The picture cannot be drawn"));
        const QString found = views::glSupport().version;
        mNoGlText->setText(
            tr("Sandreel draws with OpenGL 3.3 or newer. %1 Installing or updating the graphics driver usually helps. "
               "Everything else works: the animation can be edited, saved and exported.")
                .arg(found.isEmpty() ? tr("This computer offers no OpenGL.")
                                     : tr("This computer offers only OpenGL %1.").arg(found)));
    }
}

} // namespace editor
