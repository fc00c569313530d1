// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/sandbox/feeling.h"

#include "views/haptics/hapticsdock.h"
#include "views/widgets/icons.h"

#include <QAction>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QMainWindow>
#include <QPushButton>
#include <QStatusBar>

namespace editor {

namespace {

QAction *makeAction(const char *name, const char *iconName, const char *shortcut, QObject *parent)
{
    auto *action = new QAction(views::icon(QLatin1String(iconName)), QString(), parent);
    action->setObjectName(QLatin1String(name));
    action->setShortcut(QKeySequence(QLatin1String(shortcut)));
    action->setAutoRepeat(false);
    return action;
}

} // namespace

Feeling::Feeling(const views::ToolSettings &settings, QMainWindow &window, QObject *parent)
    : QObject(parent)
    , mSession(model::haptics::hidapiSystem(), settings)
    , mDock(new views::HapticsDock(mSession, &window))
    , mMode(makeAction("haptics.feel", "feel", "H", this))
    , mForces(makeAction("haptics.forces", "force", "Ctrl+Shift+H", this))
    , mStop(makeAction("haptics.stop", "stop", "Ctrl+.", this))
    , mStopButton(new QPushButton(&window))
{
    mMode->setCheckable(true);
    mForces->setCheckable(true);
    mStopButton->setObjectName(QStringLiteral("stopForces"));
    mStopButton->setStyleSheet(QStringLiteral("background-color: #c01c28; color: white; font-weight: bold; "
                                              "border-radius: 3px; padding: 2px 12px;"));
    mStopButton->hide();
    window.statusBar()->addPermanentWidget(mStopButton);

    const auto stop = [this] { mSession.setForces(false); };
    connect(mStopButton, &QPushButton::clicked, this, stop);
    connect(mStop, &QAction::triggered, this, stop);
    connect(mForces, &QAction::triggered, this, [this](bool isOn) {
        mSession.setForces(isOn);
        follow(); // it may not have been possible
    });
    connect(mMode, &QAction::toggled, this, [this](bool isOn) {
        if (!isOn)
            return;
        if (!mSession.service().simulated())
            mSession.choose(QString::fromStdString(model::haptics::simulatedDevice().id));
        mDock->show();
        mDock->raise();
    });
    connect(mDock->toggleViewAction(), &QAction::triggered, this, [this](bool isOn) {
        if (isOn)
            mDock->raise(); // from behind other docks
    });
    connect(mDock, &QDockWidget::visibilityChanged, this, [this] {
        if (mDock->isHidden())
            mSession.setForces(false);
    });
    connect(&mSession, &views::HapticsSession::chosenChanged, this, [this] {
        mMode->setChecked(mSession.service().simulated());
        follow();
    });
    connect(&mSession, &views::HapticsSession::forcesChanged, this, [this](bool isOn) {
        // Before any window, dialog or shortcut hears of it.
        if (isOn)
            QCoreApplication::instance()->installEventFilter(this);
        else
            QCoreApplication::instance()->removeEventFilter(this);
        follow();
    });
    retranslate();
    follow();
}

Feeling::~Feeling()
{
    mSession.disconnect(this);
    mDock->disconnect(this);
    delete mDock; // before the session that it shows
}

void Feeling::setTerrain(const model::TerrainDocument *document, views::StrokeController *strokes)
{
    mSession.setTerrain(document, strokes);
    follow();
}

bool Feeling::eventFilter(QObject *watched, QEvent *event)
{
    if ((event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride) &&
        static_cast<QKeyEvent *>(event)->key() == Qt::Key_Escape)
        mSession.setForces(false); // and Escape does what else it does there
    return QObject::eventFilter(watched, event);
}

void Feeling::follow()
{
    const model::haptics::Capabilities *const device = mSession.service().capabilities();
    const bool isOn = mSession.wantsForces();
    mMode->setEnabled(mSession.hasTerrain());
    mForces->setEnabled(device && device->hasForce && mSession.hasTerrain());
    mForces->setChecked(isOn);
    mStopButton->setVisible(isOn);
}

void Feeling::retranslate()
{
    mStopButton->setText(tr("STOP"));
    mStopButton->setAccessibleName(tr("Stop all forces"));
    mStopButton->setToolTip(tr("Forces off, at once (Escape)"));
}

} // namespace editor
