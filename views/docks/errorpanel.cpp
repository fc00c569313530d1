// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/docks/errorpanel.h"

#include "model/io/errortext.h"
#include "views/widgets/errorplot.h"
#include "views/widgets/flowlayout.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>

namespace views {

namespace {

constexpr int ProgressSteps = 1000;

} // namespace

ErrorPanel::ErrorPanel(const TimelineSlider &slider, QWidget *parent)
    : QWidget(parent)
    , mCurve(new QComboBox)
    , mValues(new QLabel)
    , mMessage(new QLabel)
    , mButtons(new QWidget)
    , mHeader(new QWidget)
    , mHeaderLayout(new FlowLayout(mHeader))
    , mMeasuringRow(new QWidget)
    , mMeasuring(new QLabel)
    , mProgress(new QProgressBar)
    , mCancel(new QToolButton)
    , mPlot(new ErrorPlot(slider))
{
    setObjectName(QStringLiteral("errorPanel"));
    mCurve->setObjectName(QStringLiteral("errorCurve"));
    mCurve->addItems({QString(), QString()});
    mValues->setObjectName(QStringLiteral("errorValues"));
    mMessage->setObjectName(QStringLiteral("errorMessage"));
    mCancel->setObjectName(QStringLiteral("cancelComparing"));
    mPlot->setObjectName(QStringLiteral("errorPlot"));
    mProgress->setObjectName(QStringLiteral("comparingProgress"));
    mProgress->setRange(0, ProgressSteps);
    mProgress->setTextVisible(false);
    mProgress->setMaximumWidth(260);

    auto *buttons = new QHBoxLayout(mButtons);
    buttons->setContentsMargins(0, 0, 0, 0);
    buttons->setSpacing(1);
    mHeaderLayout->setContentsMargins(0, 0, 0, 0);
    mHeaderLayout->setSpacing(8);
    mHeaderLayout->addWidget(mCurve);
    mHeaderLayout->addWidget(mButtons);
    mHeaderLayout->addWidget(mValues); // last: its width changes from frame to frame
    mHeaderLayout->addWidget(mMessage);
    auto *measuring = new QHBoxLayout(mMeasuringRow);
    measuring->setContentsMargins(0, 0, 0, 0);
    measuring->addWidget(mMeasuring);
    measuring->addWidget(mProgress, 1);
    measuring->addWidget(mCancel);
    measuring->addStretch();

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(mHeader);
    layout->addWidget(mMeasuringRow);
    layout->addWidget(mPlot);

    connect(mCurve, &QComboBox::currentIndexChanged, this, &ErrorPanel::follow);
    connect(mCancel, &QToolButton::clicked, this, [this] {
        if (mComparison)
            mComparison->cancel();
    });
    connect(mPlot, &ErrorPlot::frameChosen, this, [this](int number) {
        if (!mPlayer)
            return;
        mPlayer->pause();
        mPlayer->seek(number - 1);
    });
    retranslate();
}

void ErrorPanel::addAction(QAction *action)
{
    auto *button = new QToolButton;
    button->setDefaultAction(action);
    button->setAutoRaise(true);
    button->setIconSize({20, 20});
    button->setFocusPolicy(Qt::TabFocus);
    button->setObjectName(action->objectName() + QStringLiteral("Button"));
    mButtons->layout()->addWidget(button);
}

void ErrorPanel::setComparison(Comparison *comparison, Player *player)
{
    if (mComparison)
        mComparison->disconnect(this);
    if (mPlayer)
        mPlayer->disconnect(this);
    mComparison = comparison;
    mPlayer = player;
    if (mComparison) {
        connect(mComparison, &Comparison::changed, this, &ErrorPanel::follow);
        connect(mComparison, &Comparison::progressed, this, &ErrorPanel::showProgress);
        connect(mComparison, &QObject::destroyed, this, [this] { setComparison(nullptr, nullptr); });
    }
    if (mPlayer)
        connect(mPlayer, &Player::frameChanged, this, &ErrorPanel::showFrame);
    follow();
}

std::vector<double> ErrorPanel::values() const
{
    std::vector<double> result;
    if (!hasErrors())
        return result;
    const model::ComparisonResult &errors = *mComparison->result();
    const double percent = errors.diagonal > 0 ? 100 / errors.diagonal : 1;
    for (const model::FrameError &frame : errors.frames)
        result.push_back(mCurve->currentIndex() == KgError ? frame.kgErrorPercent : frame.maxVertexError * percent);
    return result;
}

std::uint32_t ErrorPanel::worstFrame() const
{
    const std::vector<double> all = values();
    return std::uint32_t(std::ranges::max_element(all) - all.begin());
}

void ErrorPanel::goToWorstFrame()
{
    Q_ASSERT(hasErrors());
    if (!mPlayer)
        return;
    mPlayer->pause();
    mPlayer->seek(worstFrame());
}

void ErrorPanel::follow()
{
    const bool isActive = mComparison && mComparison->isActive();
    const bool isWorking = isActive && (mComparison->isReading() || mComparison->isMeasuring());
    mHeader->setVisible(!isWorking);
    mMeasuringRow->setVisible(isWorking);
    mPlot->setVisible(hasErrors());
    mCurve->setVisible(hasErrors());
    mValues->setVisible(hasErrors());
    mMessage->setVisible(isActive && !hasErrors());
    if (isActive && mComparison->mismatch())
        mMessage->setText(tr("Not comparable with %1 now: %2")
                              .arg(mComparison->originalName(), model::io::errorText(*mComparison->mismatch())));
    const bool isKg = mCurve->currentIndex() == KgError;
    const bool hasDiagonal = hasErrors() && mComparison->result()->diagonal > 0;
    mPlot->setValues(values(), mCurve->currentText(), isKg || hasDiagonal ? QStringLiteral("%") : QString());
    if (hasErrors()) {
        mWorst = int(worstFrame()) + 1;
        mPlot->setAccessibleDescription(tr("Up to %1 in frame %2").arg(mPlot->valueText(mWorst)).arg(mWorst));
        const QString whole = locale().toString(mComparison->result()->kgErrorPercent, 'g', 3);
        mValues->setToolTip(isKg ? tr("All frames together: %1 %").arg(whole)
                                 : tr("Per cent of the diagonal of the original's box over all frames"));
    }
    showProgress();
    showFrame();
    setVisible(isActive);
    wrapHeader();
    emit stateChanged();
}

/// A dock gives its content no height for its width: the content asks for it.
void ErrorPanel::wrapHeader()
{
    mHeader->setMinimumHeight(mHeaderLayout->heightForWidth(width()));
}

void ErrorPanel::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    wrapHeader();
}

void ErrorPanel::showProgress()
{
    if (!mComparison)
        return;
    //: %1: the name of the original
    mMeasuring->setText(
        (mComparison->isReading() ? tr("Reading %1…") : tr("Comparing with %1…")).arg(mComparison->originalName()));
    mProgress->setValue(int(mComparison->fraction() * ProgressSteps));
}

void ErrorPanel::showFrame()
{
    if (!mPlayer)
        return;
    const int number = int(mPlayer->playback().frame()) + 1;
    mPlot->setFrame(number);
    if (hasErrors())
        mValues->setText(
            tr("%1 here, up to %2 in frame %3").arg(mPlot->valueText(number), mPlot->valueText(mWorst)).arg(mWorst));
}

void ErrorPanel::retranslate()
{
    {
        const QSignalBlocker blocker(mCurve);
        mCurve->setItemText(KgError, tr("KG Error"));
        mCurve->setItemText(LargestVertexError, tr("Largest Vertex Error"));
    }
    mCurve->setAccessibleName(tr("Error shown"));
    mCurve->setToolTip(tr("KG: of all vertices of a frame together, against the frame's extent.\n"
                          "Largest: of the worst vertex, in per cent of the diagonal of the original's box."));
    mPlot->setAccessibleName(tr("Error of each frame"));
    mProgress->setAccessibleName(tr("Progress of comparing"));
    mCancel->setText(tr("Cancel"));
    follow();
}

} // namespace views
