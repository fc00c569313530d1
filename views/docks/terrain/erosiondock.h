// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/sculpt/backgroundedit.h"
#include "views/sculpt/sandflow.h"
#include "views/sculpt/toolsettings.h"

#include <QDockWidget>
#include <QPointer>

#include <functional>
#include <memory>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace views {

class HintLabel;
class NumberField;

/// How sand slides: by which rule, how fast, until when; it runs live or until all rests, and says how it goes.
class ErosionDock final : public QDockWidget
{
    Q_OBJECT

public:
    explicit ErosionDock(ToolSettings &settings, QWidget *parent = nullptr);
    ~ErosionDock() override;

    /// \param context, flow  of the terrain in front; null: none. Let go of by itself when they are destroyed
    void setTerrain(commands::TerrainContext *context, SandFlow *flow);

    /// The sand of the terrain in front slides, live.
    bool isRunning() const { return mFlow && mFlow->isRunning(); }
    /// All of it comes to rest in the background.
    bool isSettling() const { return mSettling && mSettling->job().isRunning(); }
    bool hasTerrain() const { return mFlow != nullptr; }
    // As the buttons do. Nothing happens where they are disabled.
    void runOrPause();
    void step();
    void settle();

signals:
    /// What can be done, or what is done.
    void stateChanged();

protected:
    void changeEvent(QEvent *event) override;

private:
    void build();
    QWidget *makeButtons(QWidget *parent);
    QWidget *makeFigures(QWidget *parent);
    QWidget *makeSettings(QWidget *parent);
    void addNumber(QFormLayout &form, const QString &label, const QString &hint, const QString &unit, double min,
                   double max, int decimals, double step, double &(*member)(FlowSettings &));
    void change(const std::function<void(FlowSettings &)> &change);
    void showSettings();
    void showState();
    void showFigures();

    ToolSettings &mSettings;
    QPointer<commands::TerrainContext> mContext;
    QPointer<SandFlow> mFlow;
    std::unique_ptr<BackgroundEdit> mSettling;
    QList<QMetaObject::Connection> mConnections;

    QVBoxLayout *mColumn = nullptr;
    QWidget *mPanel = nullptr; ///< of the job that runs
    QPushButton *mRun = nullptr, *mStep = nullptr, *mSettle = nullptr;
    HintLabel *mRefusal = nullptr;
    QLabel *mValues[5] = {};
    QCheckBox *mWhileDrawing = nullptr, *mCoarse = nullptr;
    QComboBox *mRule = nullptr;
    NumberField *mAngle = nullptr;
    QLabel *mAngleFrom = nullptr;
    std::vector<std::pair<NumberField *, double &(*)(FlowSettings &)>> mNumbers;
    bool mIsShowing = false;
};

} // namespace views
