// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QElapsedTimer>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace views {

class HapticsSession;
class HintLabel;
class LatenessPlot;
class NumberField;
class TracePlot;

/// The device at the ground: which, how the ground feels through it, and what it does now. STOP and the switch of the
/// forces stay in sight however far the rest is scrolled.
class HapticsDock final : public QDockWidget
{
    Q_OBJECT

public:
    explicit HapticsDock(HapticsSession &session, QWidget *parent = nullptr);

    /// While somebody sees it, devices are looked for.
    bool isSeen() const { return mIsSeen; }
    // What it shows of the present: for tests.
    const TracePlot &forcePlot() const { return *mForces; }
    const TracePlot &positionPlot() const { return *mPositions; }
    const LatenessPlot &latenessPlot() const { return *mLateness; }

protected:
    void changeEvent(QEvent *event) override;

private:
    void build();
    QWidget *makeSwitches(QWidget *parent);
    QWidget *makeDevice(QWidget *parent);
    QWidget *makeFeel(QWidget *parent);
    QWidget *makeFigures(QWidget *parent);
    void showDevices();
    void showHint();
    void showForces();
    void showFeel();
    void takeSamples();
    void showNow();

    HapticsSession &mSession;
    QPushButton *mStop = nullptr;
    QCheckBox *mWanted = nullptr;
    QLabel *mState = nullptr;
    QComboBox *mDevice = nullptr, *mLaw = nullptr, *mMaterial = nullptr;
    HintLabel *mHint = nullptr;
    QLabel *mLawHint = nullptr;
    NumberField *mGain = nullptr, *mMaxForce = nullptr;
    QLabel *mPosition = nullptr, *mForce = nullptr, *mRate = nullptr, *mLate = nullptr;
    TracePlot *mForces = nullptr, *mPositions = nullptr;
    LatenessPlot *mLateness = nullptr;
    QString mRefusal; ///< of the last device that could not be opened
    QElapsedTimer mSinceShown;
    bool mIsSeen = false;
};

} // namespace views
