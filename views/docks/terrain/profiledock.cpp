// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/docks/terrain/profiledock.h"

#include "views/dialogs/measuretext.h"
#include "views/docks/terrain/profilecsv.h"
#include "views/docks/terrain/profileplot.h"

#include <QAction>
#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace views {

using namespace model::terrain;

namespace {

/// Between two looks at a terrain that goes on changing.
constexpr int LaterMilliseconds = 50;

QString signedLengthText(double metres)
{
    return (metres > 0 ? QStringLiteral("+") : QString()) + lengthText(metres);
}

} // namespace

ProfileDock::ProfileDock(QAction &pick, QWidget *parent)
    : QDockWidget(parent)
    , mPickAction(pick)
{
    setObjectName(QStringLiteral("profileDock"));
    mLater.setSingleShot(true);
    mLater.setInterval(LaterMilliseconds);
    connect(&mLater, &QTimer::timeout, this, &ProfileDock::measure);
    build();
}

ProfileDock::~ProfileDock() = default;

void ProfileDock::setTerrain(const model::TerrainDocument *document, ProfileLine *line, GroundReference *reference)
{
    if (document == mDocument && line == mLine && reference == mReference)
        return;
    for (const QMetaObject::Connection &connection : mConnections)
        disconnect(connection);
    mConnections.clear();
    mDocument = document;
    mLine = line;
    mReference = reference;
    const auto later = [this] {
        if (!mLater.isActive())
            mLater.start();
    };
    if (document && line && reference)
        mConnections << connect(document, &model::TerrainDocument::changed, this, later)
                     << connect(line, &ProfileLine::changed, this, &ProfileDock::measure)
                     << connect(reference, &GroundReference::changed, this, &ProfileDock::measure)
                     << connect(document, &QObject::destroyed, this, [this] { setTerrain(nullptr, nullptr, nullptr); });
    measure();
}

void ProfileDock::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::LanguageChange)
        build();
    QDockWidget::changeEvent(event);
}

void ProfileDock::build()
{
    setWindowTitle(tr("Cross-Section"));
    auto *content = new QWidget;
    auto *column = new QVBoxLayout(content);
    mPlot = new ProfilePlot(content);
    mReading = new QLabel(content);
    mReading->setObjectName(QStringLiteral("profileReading"));
    mReading->setTextInteractionFlags(Qt::TextSelectableByMouse);
    mReading->setWordWrap(true);
    auto *row = new QHBoxLayout;
    auto *pick = new QToolButton(content);
    pick->setDefaultAction(&mPickAction);
    pick->setText(tr("Pick"));
    pick->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    pick->setFocusPolicy(Qt::StrongFocus);
    pick->setAccessibleName(tr("Pick on the Ground"));
    mCopyTable = new QPushButton(tr("Copy &Table"), content);
    mCopyTable->setObjectName(QStringLiteral("copyTable"));
    mCopyTable->setToolTip(tr("Put the cross-section on the clipboard as comma-separated values"));
    mCopyPicture = new QPushButton(tr("Copy &Picture"), content);
    mCopyPicture->setObjectName(QStringLiteral("copyPicture"));
    mCopyPicture->setToolTip(tr("Put the plot on the clipboard as a picture"));
    mClear = new QPushButton(tr("C&lear"), content);
    mClear->setObjectName(QStringLiteral("clearProfile"));
    mClear->setToolTip(tr("Take the line away"));
    row->addWidget(pick);
    row->addWidget(mReading, 1);
    for (QPushButton *button : {mCopyTable, mCopyPicture, mClear})
        row->addWidget(button);
    column->addWidget(mPlot, 1);
    column->addLayout(row);
    connect(mPlot, &ProfilePlot::cursorChanged, this, &ProfileDock::showReading);
    connect(mCopyTable, &QPushButton::clicked, this, &ProfileDock::copyTable);
    connect(mCopyPicture, &QPushButton::clicked, this, &ProfileDock::copyPicture);
    connect(mClear, &QPushButton::clicked, this, [this] { mLine->setEnds(std::nullopt); });
    QWidget *before = widget();
    setWidget(content);
    delete before;
    measure();
}

void ProfileDock::measure()
{
    ProfilePlot::Curve now, before;
    if (mDocument && mLine && mLine->ends()) {
        const auto [a, b] = *mLine->ends();
        now = profile(mDocument->tin(), a, b);
        if (mReference && mReference->terrain())
            before = profile(mReference->terrain()->tin, a, b);
    }
    for (QPushButton *button : {mCopyTable, mCopyPicture, mClear})
        button->setEnabled(!now.empty());
    mPlot->setCurves(std::move(now), std::move(before));
}

QString ProfileDock::readingText() const
{
    const ProfilePlot::Curve &now = mPlot->now();
    if (now.empty())
        return {};
    const auto cursor = mPlot->cursor();
    if (!cursor) {
        const auto [lowest, highest] = std::minmax_element(
            now.begin(), now.end(), [](const ProfilePoint &p, const ProfilePoint &q) { return p.height < q.height; });
        return tr("Length %1   height %2 to %3")
            .arg(lengthText(now.back().distance - now.front().distance), lengthText(lowest->height),
                 lengthText(highest->height));
    }
    QStringList parts{tr("At %1").arg(lengthText(*cursor))};
    const auto height = heightAt(now, *cursor), then = heightAt(mPlot->before(), *cursor);
    parts << (height ? tr("height %1").arg(lengthText(*height)) : tr("no ground"));
    if (then)
        parts << tr("reference %1").arg(lengthText(*then));
    if (height && then)
        parts << tr("difference %1").arg(signedLengthText(*height - *then));
    return parts.join(QStringLiteral("   "));
}

void ProfileDock::showReading()
{
    const QString text = readingText();
    mReading->setText(text);
    mPlot->setAccessibleDescription(text);
    if (mLine)
        mLine->setMark(mPlot->cursor());
}

void ProfileDock::copyTable()
{
    QGuiApplication::clipboard()->setText(profileCsv(mPlot->now(), mPlot->before()));
}

void ProfileDock::copyPicture()
{
    QGuiApplication::clipboard()->setImage(mPlot->grab().toImage());
}

} // namespace views
