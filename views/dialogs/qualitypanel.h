// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/qualitytarget.h"
#include "views/dialogs/trialbench.h"
#include "views/jobs/job.h"

#include <QTimer>
#include <QWidget>

#include <memory>
#include <optional>

class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QSlider;

namespace views {

class HintLabel;
class NumberField;
class RatePlot;

/// How good an encoding will be: one slider, for experts a target to search settings for, what the present settings are
/// expected to give, and a plot of all that was tried. Works in the background, on the newest wish alone.
class QualityPanel final : public QWidget
{
    Q_OBJECT

public:
    explicit QualityPanel(QWidget *parent = nullptr);
    ~QualityPanel() override;

    /// Another animation: what was tried is forgotten. \param frames  null: there is none
    void setAnimation(const model::FrameSourcePtr &frames, model::Normalisation normalisation);
    /// The settings that the user sees; nothing while some are refused. Their size and error are found out.
    void setSettings(const std::optional<model::CompressionSettings> &settings);
    /// Another encoding that is known of: a point in the plot.
    void addTrial(const model::codec::Trial &trial);
    /// Work waits or is under way.
    bool isBusy() const { return mDelay.isActive() || mWork.isRunning(); }

public slots:
    /// Stops what is under way.
    void stop();

signals:
    /// The user asked for a quality, or chose a point: these settings give it.
    void settingsFound(const model::CompressionSettings &settings);

private:
    QWidget *makeControls();
    void wishForQuality();
    void wishForTarget();
    void wishForSettings();
    void startWork();
    void showOutcome(const model::Result<TrialOutcome> &result, const std::optional<model::QualityTarget> &wish);
    int showPoint(const model::codec::Trial &trial);
    void showExpected(const model::codec::Trial &trial);
    void moveSliderTo(const model::codec::Trial &trial);
    void showBusy();
    void updateTargetField();
    std::optional<model::QualityTarget> expertTarget() const;

    std::shared_ptr<TrialBench> mBench;
    std::optional<model::CompressionSettings> mSettings;
    std::optional<model::QualityTarget> mWish; ///< to search for; else the settings are to be tried
    std::vector<model::codec::Trial> mTrials;  ///< as the plot's points

    QSlider *mSlider;
    QLabel *mSliderText;
    QComboBox *mTarget;
    NumberField *mTargetValue;
    QPushButton *mFind;
    HintLabel *mExpected;
    QPushButton *mStop;
    RatePlot *mPlot;
    QTimer mDelay;
    Job mWork; ///< last: its result must not arrive in half a panel
};

} // namespace views
