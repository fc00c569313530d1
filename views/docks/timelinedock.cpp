// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/docks/timelinedock.h"

#include "views/docks/errorpanel.h"
#include "views/widgets/flowlayout.h"
#include "views/widgets/icons.h"
#include "views/widgets/timelineslider.h"

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QResizeEvent>
#include <QSignalBlocker>
#include <QToolButton>

#include <cmath>
#include <utility>

namespace views {

namespace {

constexpr int JumpFrames = 10;

/// "1:02.44": minutes, seconds and hundredths.
QString timeText(double seconds)
{
    const auto hundredths = qint64(std::floor(seconds * 100 + 0.5));
    return QStringLiteral("%1:%2%3%4")
        .arg(hundredths / 6000)
        .arg(hundredths / 100 % 60, 2, 10, QLatin1Char('0'))
        .arg(QLocale().decimalPoint())
        .arg(hundredths % 100, 2, 10, QLatin1Char('0'));
}

/// A button that Space presses while it has the focus, though Space is a shortcut for something else.
class ControlButton final : public QToolButton
{
public:
    using QToolButton::QToolButton;

protected:
    bool event(QEvent *event) override
    {
        if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent *>(event)->key() == Qt::Key_Space) {
            event->accept();
            return true;
        }
        return QToolButton::event(event);
    }
};

/// A dock gives its content no height for its width: the content asks for it.
class WrappingPanel final : public QWidget
{
public:
    using QWidget::QWidget;

protected:
    void resizeEvent(QResizeEvent *event) override
    {
        QWidget::resizeEvent(event);
        setMinimumHeight(layout()->heightForWidth(event->size().width()));
    }
};

} // namespace

TimelineDock::TimelineDock(QWidget *parent)
    : QDockWidget(parent)
{
    setObjectName(QStringLiteral("timelineDock"));
    makeActions();
    makeWidgets();
    retranslate();
    setPlayer(nullptr);
}

QAction *TimelineDock::addAction(const char *name, const char *iconName, const QList<QKeySequence> &shortcuts,
                                 bool isCheckable)
{
    auto *added = new QAction(icon(QLatin1String(iconName)), QString(), this);
    added->setObjectName(QLatin1String(name));
    added->setShortcuts(shortcuts);
    added->setCheckable(isCheckable);
    QWidget::addAction(added);
    return added;
}

QAction *TimelineDock::action(const QString &name) const
{
    return findChild<QAction *>(name, Qt::FindDirectChildrenOnly);
}

void TimelineDock::makeActions()
{
    const auto onTrigger = [this](QAction *added, auto call) {
        connect(added, &QAction::triggered, this, [this, call] {
            if (mPlayer)
                call(*mPlayer);
        });
    };
    onTrigger(addAction("playPause", "play", {Qt::Key_Space}), [](Player &player) { player.togglePlay(); });
    onTrigger(addAction("stop", "stop", {Qt::SHIFT | Qt::Key_Space}), [](Player &player) { player.stop(); });
    // Comma and full stop step wherever the focus is; the arrows turn the mesh while the viewport has it.
    const auto step = [&](QAction *added, int frames) {
        added->setAutoRepeat(true);
        onTrigger(added, [frames](Player &player) {
            player.pause();
            player.step(frames);
        });
    };
    step(addAction("stepBack", "step-back", {Qt::Key_Left, Qt::Key_Comma}), -1);
    step(addAction("stepForward", "step-forward", {Qt::Key_Right, Qt::Key_Period}), 1);
    step(addAction("jumpBack", "step-back", {Qt::CTRL | Qt::Key_Left, Qt::CTRL | Qt::Key_Comma}), -JumpFrames);
    step(addAction("jumpForward", "step-forward", {Qt::CTRL | Qt::Key_Right, Qt::CTRL | Qt::Key_Period}), JumpFrames);
    onTrigger(addAction("firstFrame", "first-frame", {Qt::Key_Home}), [](Player &player) { player.goToFirst(); });
    onTrigger(addAction("lastFrame", "last-frame", {Qt::Key_End}), [](Player &player) { player.goToLast(); });

    QAction *const reverse = addAction("playBackwards", "play-reverse", {Qt::Key_B}, true);
    onTrigger(reverse, [reverse](Player &player) { player.setReversed(reverse->isChecked()); });

    mLoopModes = new QActionGroup(this);
    const struct
    {
        const char *name;
        const char *iconName;
        model::LoopMode mode;
    } modes[] = {{"loopOnce", "loop-once", model::LoopMode::Once},
                 {"loopRepeat", "loop", model::LoopMode::Loop},
                 {"loopPingPong", "ping-pong", model::LoopMode::PingPong}};
    for (const auto &[name, iconName, mode] : modes) {
        QAction *const added = addAction(name, iconName, {}, true);
        added->setData(int(mode));
        mLoopModes->addAction(added);
        onTrigger(added, [mode = mode](Player &player) { player.setLoopMode(mode); });
    }

    connect(addAction("rangeStart", "range-start", {Qt::Key_I}), &QAction::triggered, this,
            [this] { setRangeEnd(true); });
    connect(addAction("rangeEnd", "range-end", {Qt::Key_O}), &QAction::triggered, this, [this] { setRangeEnd(false); });
    onTrigger(addAction("rangeReset", "range-reset", {Qt::SHIFT | Qt::Key_I}),
              [](Player &player) { player.setRange(0, player.playback().frameCount() - 1); });
    connect(addAction("worstFrame", "worst-frame", {Qt::Key_W}), &QAction::triggered, this,
            [this] { mErrors->goToWorstFrame(); });
    QAction *const everyFrame = addAction("everyFrame", "every-frame", {Qt::Key_E}, true);
    onTrigger(everyFrame, [everyFrame](Player &player) {
        player.setPacing(everyFrame->isChecked() ? model::Pacing::EveryFrame : model::Pacing::RealTime);
    });
}

void TimelineDock::setRangeEnd(bool isFirst)
{
    if (!mPlayer)
        return;
    const model::Playback &playback = mPlayer->playback();
    // An end set beyond the other one takes that along.
    if (isFirst)
        mPlayer->setRange(playback.frame(), std::max(playback.frame(), playback.rangeLast()));
    else
        mPlayer->setRange(std::min(playback.frame(), playback.rangeFirst()), playback.frame());
}

QWidget *TimelineDock::makeButtons(const QList<const char *> &names)
{
    auto *group = new QWidget;
    auto *layout = new QHBoxLayout(group);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(1);
    for (const char *name : names) {
        auto *button = new ControlButton;
        button->setDefaultAction(action(QLatin1String(name)));
        button->setAutoRaise(true);
        button->setIconSize({20, 20});
        button->setFocusPolicy(Qt::TabFocus);
        button->setObjectName(QLatin1String(name) + QStringLiteral("Button"));
        layout->addWidget(button);
    }
    return group;
}

void TimelineDock::makeWidgets()
{
    mSlider = new TimelineSlider;
    connect(mSlider, &QAbstractSlider::sliderPressed, this, [this] {
        if (mPlayer)
            mPlayer->beginScrub();
    });
    connect(mSlider, &QAbstractSlider::sliderReleased, this, [this] {
        if (mPlayer)
            mPlayer->endScrub();
    });
    connect(mSlider, &QAbstractSlider::valueChanged, this, [this](int value) {
        if (mPlayer)
            mPlayer->seek(value - 1);
    });
    connect(mSlider, &TimelineSlider::loopRangeMoved, this, [this](int first, int last) {
        if (mPlayer)
            mPlayer->setRange(first - 1, last - 1);
    });

    mErrors = new ErrorPanel(*mSlider);
    mErrors->addAction(action(QStringLiteral("worstFrame")));
    connect(mErrors, &ErrorPanel::stateChanged, this, &TimelineDock::setEnabledState);

    mFrame = new QSpinBox;
    mFrame->setObjectName(QStringLiteral("frame"));
    mFrame->setKeyboardTracking(false);
    mFrame->setAlignment(Qt::AlignRight);
    connect(mFrame, &QSpinBox::valueChanged, this, [this](int value) {
        if (mPlayer)
            mPlayer->seek(value - 1);
    });
    mTime = new QLabel;
    mTime->setTextInteractionFlags(Qt::NoTextInteraction);

    mRate = new QDoubleSpinBox;
    mRate->setObjectName(QStringLiteral("framesPerSecond"));
    mRate->setRange(model::Playback::MinRate, model::Playback::MaxRate);
    mRate->setDecimals(2);
    mRate->setKeyboardTracking(false);
    connect(mRate, &QDoubleSpinBox::valueChanged, this, [this](double rate) {
        if (mPlayer)
            mPlayer->setFramesPerSecond(rate);
    });
    mRateLabel = new QLabel;
    mRateLabel->setBuddy(mRate);
    auto *rate = new QWidget;
    auto *rateLayout = new QHBoxLayout(rate);
    rateLayout->setContentsMargins(0, 0, 0, 0);
    rateLayout->addWidget(mRateLabel);
    rateLayout->addWidget(mRate);

    mPacing = new QComboBox;
    mPacing->setObjectName(QStringLiteral("pacing"));
    mPacing->addItems({QString(), QString()});
    connect(mPacing, &QComboBox::activated, this, [this](int index) {
        if (mPlayer)
            mPlayer->setPacing(model::Pacing(index));
    });

    auto *controls = new WrappingPanel;
    auto *flow = new FlowLayout(controls);
    flow->setContentsMargins(0, 0, 0, 0);
    flow->setSpacing(12);
    flow->addWidget(makeButtons({"firstFrame", "stepBack", "playPause", "stepForward", "lastFrame", "stop"}));
    flow->addWidget(mFrame);
    flow->addWidget(mTime);
    flow->addWidget(makeButtons({"playBackwards", "loopOnce", "loopRepeat", "loopPingPong"}));
    flow->addWidget(makeButtons({"rangeStart", "rangeEnd", "rangeReset"}));
    flow->addWidget(rate);
    flow->addWidget(mPacing);

    auto *content = new QWidget;
    content->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum); // the room is the picture's
    auto *layout = new QVBoxLayout(content);
    layout->setContentsMargins(8, 4, 8, 6);
    layout->setSpacing(4);
    layout->addWidget(mErrors);
    layout->addWidget(mSlider);
    layout->addWidget(controls);
    layout->addStretch();
    setWidget(content);
}

void TimelineDock::retranslate()
{
    setWindowTitle(tr("Timeline"));
    const std::pair<const char *, QString> texts[] = {
        {"playPause", tr("&Play")},
        {"stop", tr("&Stop")},
        {"stepBack", tr("Previous &Frame")},
        {"stepForward", tr("&Next Frame")},
        {"jumpBack", tr("Ten Frames Back")},
        {"jumpForward", tr("Ten Frames On")},
        {"firstFrame", tr("F&irst Frame")},
        {"lastFrame", tr("&Last Frame")},
        {"playBackwards", tr("Play &Backwards")},
        {"loopOnce", tr("Play &Once")},
        {"loopRepeat", tr("&Repeat")},
        {"loopPingPong", tr("Ping-Pon&g")},
        {"rangeStart", tr("Start Loop &Here")},
        {"rangeEnd", tr("&End Loop Here")},
        {"rangeReset", tr("Loop &All Frames")},
        {"worstFrame", tr("Go to &Worst Frame")},
        {"everyFrame", tr("Show Ever&y Frame")},
    };
    for (const auto &[name, text] : texts)
        action(QLatin1String(name))->setText(text);
    mSlider->setAccessibleName(tr("Timeline"));
    mSlider->setAccessibleDescription(
        tr("The current frame. Drag the marks above the ruler to change the loop range."));
    mFrame->setAccessibleName(tr("Frame"));
    mFrame->setToolTip(tr("Frame"));
    mTime->setAccessibleName(tr("Time"));
    mTime->setToolTip(tr("Time / duration, minutes and seconds"));
    mRateLabel->setText(tr("Frames/s:"));
    mRate->setAccessibleName(tr("Frames per second"));
    mRate->setToolTip(tr("Frames per second of playback, 1 to 120"));
    mPacing->setItemText(int(model::Pacing::RealTime), tr("Real Time"));
    mPacing->setItemText(int(model::Pacing::EveryFrame), tr("Every Frame"));
    mPacing->setAccessibleName(tr("Pacing"));
    mPacing->setToolTip(
        tr("Real Time drops frames where drawing is too slow; Every Frame shows each and takes longer"));
    mErrors->retranslate();
    showState();
}

void TimelineDock::changeEvent(QEvent *event)
{
    QDockWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

void TimelineDock::setPlayer(Player *player)
{
    if (mPlayer)
        mPlayer->disconnect(this);
    mPlayer = player;
    if (mPlayer) {
        connect(mPlayer, &Player::frameChanged, this, &TimelineDock::showFrame);
        connect(mPlayer, &Player::stateChanged, this, &TimelineDock::showState);
        connect(mPlayer, &Player::sourceChanged, this, &TimelineDock::showState);
        connect(mPlayer, &QObject::destroyed, this, [this] { setPlayer(nullptr); });
    }
    showState();
}

void TimelineDock::setComparison(Comparison *comparison)
{
    mErrors->setComparison(comparison, mPlayer);
}

void TimelineDock::addErrorActions(const QList<QAction *> &actions)
{
    for (QAction *each : actions)
        mErrors->addAction(each);
}

void TimelineDock::setEnabledState()
{
    const bool isEnabled = mPlayer && mPlayer->source();
    widget()->setEnabled(isEnabled);
    for (QAction *each : actions())
        each->setEnabled(isEnabled);
    action(QStringLiteral("worstFrame"))->setEnabled(isEnabled && mErrors->hasErrors());
}

void TimelineDock::showState()
{
    setEnabledState();
    const model::Playback playback = mPlayer ? mPlayer->playback() : model::Playback();
    const int count = int(playback.frameCount());
    {
        const QSignalBlocker blockers[] = {QSignalBlocker(mSlider), QSignalBlocker(mFrame), QSignalBlocker(mRate)};
        mSlider->setFrameCount(count);
        mSlider->setLoopRange(int(playback.rangeFirst()) + 1, int(playback.rangeLast()) + 1);
        mFrame->setRange(1, count);
        //: After the number of the current frame: how many there are.
        mFrame->setSuffix(tr(" / %1").arg(count));
        if (!mRate->hasFocus() || mRate->value() != playback.framesPerSecond())
            mRate->setValue(playback.framesPerSecond());
    }
    QAction *const play = action(QStringLiteral("playPause"));
    play->setIcon(icon(playback.isPlaying() ? QStringLiteral("pause") : QStringLiteral("play")));
    play->setText(playback.isPlaying() ? tr("&Pause") : tr("&Play"));
    action(QStringLiteral("playBackwards"))->setChecked(playback.isReversed());
    action(QStringLiteral("everyFrame"))->setChecked(playback.pacing() == model::Pacing::EveryFrame);
    mPacing->setCurrentIndex(int(playback.pacing()));
    for (QAction *mode : mLoopModes->actions())
        mode->setChecked(mode->data().toInt() == int(playback.loopMode()));
    showFrame();
}

void TimelineDock::showFrame()
{
    const model::Playback playback = mPlayer ? mPlayer->playback() : model::Playback();
    const int number = int(playback.frame()) + 1;
    {
        const QSignalBlocker blockers[] = {QSignalBlocker(mSlider), QSignalBlocker(mFrame)};
        mSlider->setValue(number);
        mFrame->setValue(number);
    }
    const double rate = playback.framesPerSecond();
    mTime->setText(tr("%1 / %2").arg(timeText(playback.frame() / rate), timeText(playback.frameCount() / rate)));
}

} // namespace views
