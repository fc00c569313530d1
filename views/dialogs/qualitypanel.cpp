// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/qualitypanel.h"

#include "model/io/errortext.h"
#include "views/dialogs/compressionfields.h"
#include "views/dialogs/numberfield.h"
#include "views/dialogs/quantitytext.h"
#include "views/widgets/rateplot.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSlider>

#include <cmath>
#include <utility>

namespace views {

using namespace model;

namespace {

// Long enough not to begin at every step of a drag or letter of a number, short enough to feel at once.
constexpr int DelayMilliseconds = 350;
constexpr int SliderSteps = 100;
// Trials are shown whose error is at most so many times larger or smaller than what a search found.
constexpr double Nearby = 4;

enum Target { KgError, VertexError, FileSize };

/// A row of several fields; the label leads to `buddy`, which a form only does for a single field.
void addRow(QFormLayout &form, const QString &text, QLayout *fields, QWidget *buddy)
{
    auto *label = new QLabel(text, form.parentWidget());
    label->setBuddy(buddy);
    form.addRow(label, fields);
}

double qualityOf(int sliderValue)
{
    return double(sliderValue) / SliderSteps;
}

} // namespace

QualityPanel::QualityPanel(QWidget *parent)
    : QWidget(parent)
{
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(makeControls(), 2);
    mPlot = new RatePlot(this);
    mPlot->setObjectName(QStringLiteral("ratePlot"));
    for (const CodecId codec : codec::availableCodecs())
        mPlot->setSeriesName(int(codec), CompressionFields::codecName(codec));
    row->addWidget(mPlot, 3);

    mDelay.setSingleShot(true);
    mDelay.setInterval(DelayMilliseconds);
    connect(&mDelay, &QTimer::timeout, this, &QualityPanel::startWork);
    connect(&mWork, &Job::runningChanged, this, &QualityPanel::showBusy);
    connect(&mWork, &Job::progressed, this, &QualityPanel::showBusy);
    connect(mPlot, &RatePlot::pointChosen, this, [this](int index) {
        stop();
        const codec::Trial &trial = mTrials[std::size_t(index)];
        mSettings = CompressionSettings{trial.settings, mSettings && mSettings->keepOrder};
        showExpected(trial);
        moveSliderTo(trial);
        mPlot->setCurrent(index);
        emit settingsFound(*mSettings);
    });
    updateTargetField();
    showBusy();
}

QualityPanel::~QualityPanel() = default;

QWidget *QualityPanel::makeControls()
{
    auto *part = new QWidget(this);
    auto *form = new QFormLayout(part);
    form->setContentsMargins(0, 0, 0, 0);
    mSlider = new QSlider(Qt::Horizontal, part);
    mSlider->setObjectName(QStringLiteral("quality"));
    mSlider->setAccessibleName(tr("Quality"));
    mSlider->setRange(0, SliderSteps);
    mSlider->setPageStep(10);
    mSlider->setToolTip(
        tr("Settings of the chosen codec are searched for that give this quality in the smallest file."));
    mSliderText = new QLabel(part);
    mSliderText->setObjectName(QStringLiteral("qualityText"));
    mSliderText->setMinimumWidth(fontMetrics().horizontalAdvance(tr("KG error at most %1 %").arg(0.0555)));
    auto *sliderRow = new QHBoxLayout;
    sliderRow->addWidget(mSlider, 1);
    sliderRow->addWidget(mSliderText);
    addRow(*form, tr("&Quality:"), sliderRow, mSlider);

    mTarget = new QComboBox(part);
    mTarget->setObjectName(QStringLiteral("target"));
    mTarget->setAccessibleName(tr("Target"));
    mTarget->addItem(tr("KG error"), KgError);
    mTarget->addItem(tr("Largest error"), VertexError);
    mTarget->addItem(tr("File size"), FileSize);
    mTargetValue = new NumberField(tr("Target"), {}, part);
    mTargetValue->setObjectName(QStringLiteral("targetValue"));
    mFind = new QPushButton(tr("F&ind Settings"), part);
    mFind->setObjectName(QStringLiteral("findSettings"));
    mFind->setAutoDefault(false);
    mFind->setToolTip(tr("Search settings of the chosen codec that reach the target"));
    auto *targetRow = new QHBoxLayout;
    targetRow->addWidget(mTarget);
    targetRow->addWidget(mTargetValue, 1);
    targetRow->addWidget(mFind);
    addRow(*form, tr("&At most:"), targetRow, mTarget);

    mExpected = new HintLabel(part);
    mExpected->setObjectName(QStringLiteral("expected"));
    mExpected->setWordWrap(true);
    mExpected->setMinimumHeight(2 * fontMetrics().lineSpacing());
    mExpected->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    mStop = new QPushButton(tr("Stop"), part);
    mStop->setObjectName(QStringLiteral("stopTrials"));
    mStop->setAutoDefault(false);
    auto *expectedRow = new QHBoxLayout;
    expectedRow->addWidget(mExpected, 1);
    expectedRow->addWidget(mStop, 0, Qt::AlignTop);
    form->addRow(tr("Expected:"), expectedRow);

    connect(mSlider, &QSlider::valueChanged, this, &QualityPanel::wishForQuality);
    connect(mTarget, &QComboBox::currentIndexChanged, this, &QualityPanel::updateTargetField);
    connect(mTargetValue, &NumberField::changed, this, &QualityPanel::showBusy);
    connect(mFind, &QPushButton::clicked, this, &QualityPanel::wishForTarget);
    connect(mStop, &QPushButton::clicked, this, &QualityPanel::stop);
    const QSignalBlocker blocker(mSlider);
    mSlider->setValue(SliderSteps / 2);
    mSliderText->setText(tr("KG error at most %1 %").arg(significantText(kgErrorOfQuality(0.5))));
    return part;
}

void QualityPanel::setAnimation(const FrameSourcePtr &frames, Normalisation normalisation)
{
    stop();
    mTrials.clear();
    mPlot->clear();
    mExpected->showHint({});
    mBench = frames ? std::make_shared<TrialBench>(frames, normalisation) : nullptr;
    wishForSettings();
}

void QualityPanel::setSettings(const std::optional<CompressionSettings> &settings)
{
    if (settings == mSettings)
        return;
    mSettings = settings;
    wishForSettings();
}

void QualityPanel::stop()
{
    mDelay.stop();
    mWork.cancel();
    showBusy();
}

void QualityPanel::wishForSettings()
{
    mWork.cancel();
    mWish.reset();
    mExpected->showHint({});
    mPlot->setCurrent(-1);
    if (mBench && mSettings)
        mDelay.start();
    else
        mDelay.stop();
    showBusy();
}

void QualityPanel::wishForQuality()
{
    const double quality = qualityOf(mSlider->value());
    mSliderText->setText(tr("KG error at most %1 %").arg(significantText(kgErrorOfQuality(quality))));
    if (!mBench || !mSettings)
        return;
    mWish = Quality{quality};
    mDelay.start();
    showBusy();
}

std::optional<QualityTarget> QualityPanel::expertTarget() const
{
    const std::optional<double> value = mTargetValue->value();
    if (!value)
        return std::nullopt;
    switch (Target(mTarget->currentData().toInt())) {
    case KgError:
        return MaxKgError{*value};
    case VertexError:
        return MaxVertexError{*value / 100};
    case FileSize:
        return MaxBytes{std::uint64_t(*value * 1000)};
    }
    return std::nullopt;
}

void QualityPanel::wishForTarget()
{
    mWish = expertTarget();
    if (mWish && mBench && mSettings)
        startWork();
}

void QualityPanel::updateTargetField()
{
    switch (Target(mTarget->currentData().toInt())) {
    case KgError:
        mTargetValue->setRange({MinKgTarget, MaxKgTarget, 4});
        mTargetValue->setStep(0.1);
        mTargetValue->setHint(QStringLiteral("%"));
        mTargetValue->setValue(1);
        break;
    case VertexError:
        mTargetValue->setRange({100 * MinVertexTarget, 100 * MaxVertexTarget, 5});
        mTargetValue->setStep(0.1);
        mTargetValue->setHint(tr("% of the diagonal"));
        mTargetValue->setValue(0.5);
        break;
    case FileSize:
        mTargetValue->setRange({0.1, 1e9, 1});
        mTargetValue->setStep(100);
        mTargetValue->setHint(tr("kB"));
        mTargetValue->setValue(500);
        break;
    }
    showBusy();
}

void QualityPanel::startWork()
{
    mDelay.stop();
    if (!mBench || !mSettings)
        return;
    const auto wish = std::exchange(mWish, std::nullopt);
    mWork.start(
        [bench = mBench, settings = *mSettings, wish](const Progress &progress) {
            return wish ? bench->search(settings.codec(), *wish, progress) : bench->attempt(settings.method, progress);
        },
        [this, bench = mBench, wish](Result<TrialOutcome> result) {
            if (bench == mBench)
                showOutcome(result, wish);
        });
    showBusy();
}

void QualityPanel::showOutcome(const Result<TrialOutcome> &result, const std::optional<QualityTarget> &wish)
{
    if (!result) {
        if (result.error().code == ErrorCode::Cancelled)
            mExpected->showHint(mDelay.isActive() ? QString() : tr("Stopped."));
        else
            mExpected->showRefusal(io::errorText(result.error()));
        return;
    }
    // A search begins far off on both sides: that would only stretch the axes.
    for (const codec::Trial &trial : result->tried)
        if (trial.kgErrorPercent > result->found.kgErrorPercent / Nearby &&
            trial.kgErrorPercent < result->found.kgErrorPercent * Nearby)
            showPoint(trial);
    mPlot->setCurrent(showPoint(result->found));
    showExpected(result->found);
    // What was asked for by the slider stays there, though the result is a little better.
    if (!wish || !std::holds_alternative<Quality>(*wish))
        moveSliderTo(result->found);
    if (!wish)
        return;
    mSettings = CompressionSettings{result->found.settings, mSettings && mSettings->keepOrder};
    emit settingsFound(*mSettings);
}

int QualityPanel::showPoint(const codec::Trial &trial)
{
    const double bits = mBench->bitsPerFrameAndVertex(trial.bytes);
    const int index = mPlot->addPoint({int(CompressionSettings{trial.settings}.codec()), bits, trial.kgErrorPercent,
                                       tr("%1\n%2, %3 bits per frame and vertex\nKG error %4")
                                           .arg(CompressionFields::summary({trial.settings}), bytesText(trial.bytes),
                                                numberText(bits, 3), percentText(trial.kgErrorPercent))});
    if (index == int(mTrials.size()))
        mTrials.push_back(trial);
    return index;
}

void QualityPanel::addTrial(const codec::Trial &trial)
{
    if (mBench)
        showPoint(trial);
}

void QualityPanel::showExpected(const codec::Trial &trial)
{
    mExpected->showHint(tr("%1, %2 bits per frame and vertex, KG error %3")
                            .arg(bytesText(trial.bytes), numberText(mBench->bitsPerFrameAndVertex(trial.bytes), 3),
                                 percentText(trial.kgErrorPercent)));
}

/// The slider follows what was set elsewhere.
void QualityPanel::moveSliderTo(const codec::Trial &trial)
{
    if (mSlider->isSliderDown())
        return;
    const QSignalBlocker blocker(mSlider);
    mSlider->setValue(int(std::floor(SliderSteps * qualityOfKgError(trial.kgErrorPercent) + 1e-6)));
    mSliderText->setText(
        tr("KG error at most %1 %").arg(significantText(kgErrorOfQuality(qualityOf(mSlider->value())))));
}

void QualityPanel::showBusy()
{
    const bool isReady = mBench && mSettings;
    mSlider->setEnabled(isReady);
    mFind->setEnabled(isReady && mTargetValue->problem().isEmpty());
    mFind->setToolTip(mTargetValue->problem());
    mStop->setVisible(mWork.isRunning());
    if (mWork.isRunning())
        mExpected->showHint(tr("Trying… %1 %").arg(int(100 * mWork.fraction())));
}

} // namespace views
