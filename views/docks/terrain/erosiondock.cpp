// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/docks/terrain/erosiondock.h"

#include "views/dialogs/inputline.h"
#include "views/dialogs/jobpanel.h"
#include "views/dialogs/measuretext.h"
#include "views/dialogs/numberfield.h"
#include "views/dialogs/quantitytext.h"
#include "views/docks/terrain/dockform.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace views {

using namespace model::terrain;

ErosionDock::ErosionDock(ToolSettings &settings, QWidget *parent)
    : QDockWidget(parent)
    , mSettings(settings)
{
    setObjectName(QStringLiteral("erosionDock"));
    build();
    connect(&mSettings, &ToolSettings::flowChanged, this, &ErosionDock::showSettings);
}

ErosionDock::~ErosionDock() = default;

void ErosionDock::setTerrain(commands::TerrainContext *context, SandFlow *flow)
{
    if (context == mContext && flow == mFlow)
        return;
    for (const QMetaObject::Connection &connection : mConnections)
        disconnect(connection);
    mConnections.clear();
    delete mPanel;
    mPanel = nullptr;
    mSettling.reset();
    mContext = context;
    mFlow = flow;
    if (context && flow) {
        mConnections << connect(flow, &SandFlow::runningChanged, this, &ErosionDock::showState)
                     << connect(flow, &SandFlow::figuresChanged, this, &ErosionDock::showFigures)
                     << connect(context, &QObject::destroyed, this, [this] { setTerrain(nullptr, nullptr); });
        mSettling = std::make_unique<BackgroundEdit>(*context);
        connect(&mSettling->job(), &Job::runningChanged, this, &ErosionDock::showState);
        connect(mSettling.get(), &BackgroundEdit::failed, this, [this](const QString &reason) {
            mRefusal->showRefusal(reason);
            mRefusal->show();
        });
    }
    showSettings();
    showState();
    showFigures();
}

void ErosionDock::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::LanguageChange)
        build();
    QDockWidget::changeEvent(event);
}

void ErosionDock::build()
{
    setWindowTitle(tr("Erosion"));
    auto *content = new QWidget;
    mColumn = new QVBoxLayout(content);
    mPanel = nullptr;
    mColumn->addWidget(makeButtons(content));
    mRefusal = new HintLabel(content);
    mRefusal->setWordWrap(true);
    mRefusal->hide();
    mColumn->addWidget(mRefusal);
    mColumn->addWidget(makeFigures(content));
    mColumn->addWidget(makeSettings(content));
    mColumn->addStretch();
    setScrolledWidget(*this, content);
    showSettings();
    showState();
    showFigures();
}

QWidget *ErosionDock::makeButtons(QWidget *parent)
{
    auto *part = new QWidget(parent);
    auto *grid = new QGridLayout(part);
    grid->setContentsMargins(0, 0, 0, 0);
    mWhileDrawing = new QCheckBox(tr("Slide &while drawing"), part);
    mWhileDrawing->setObjectName(QStringLiteral("whileDrawing"));
    connect(mWhileDrawing, &QCheckBox::toggled, this,
            [this](bool isOn) { change([isOn](FlowSettings &flow) { flow.isOn = isOn; }); });
    mRun = new QPushButton(part);
    mRun->setObjectName(QStringLiteral("run"));
    connect(mRun, &QPushButton::clicked, this, &ErosionDock::runOrPause);
    mStep = new QPushButton(tr("&Step"), part);
    mStep->setObjectName(QStringLiteral("step"));
    mStep->setToolTip(tr("Go once over everything that is too steep"));
    connect(mStep, &QPushButton::clicked, this, &ErosionDock::step);
    mSettle = new QPushButton(tr("&Until Settled"), part);
    mSettle->setObjectName(QStringLiteral("settle"));
    mSettle->setToolTip(tr("Let everything slide in the background, until no face is too steep"));
    connect(mSettle, &QPushButton::clicked, this, &ErosionDock::settle);
    grid->addWidget(mWhileDrawing, 0, 0, 1, 2);
    grid->addWidget(mRun, 1, 0);
    grid->addWidget(mStep, 1, 1);
    grid->addWidget(mSettle, 2, 0, 1, 2);
    return part;
}

QWidget *ErosionDock::makeFigures(QWidget *parent)
{
    auto *box = new QGroupBox(tr("Now"), parent);
    auto *form = new QFormLayout(box);
    const QString labels[] = {tr("Active triangles:"), tr("Moving:"), tr("Moved:"), tr("Steepest face:"),
                              tr("Volume drift:")};
    for (std::size_t i = 0; i < std::size(mValues); ++i)
        mValues[i] = addFact(*form, labels[i]);
    mValues[4]->setToolTip(tr("Volume that the ledger does not explain, as a part of the whole"));
    return box;
}

void ErosionDock::addNumber(QFormLayout &form, const QString &label, const QString &hint, const QString &unit,
                            double min, double max, int decimals, double step, double &(*member)(FlowSettings &))
{
    auto *field = new NumberField(QString(label).remove(QLatin1Char(':')), {min, max, decimals});
    field->setStep(step);
    field->setToolTip(hint);
    connect(field, &NumberField::changed, this, [=, this] {
        if (const auto value = field->value())
            change([=](FlowSettings &flow) { member(flow) = *value; });
    });
    mNumbers.emplace_back(field, member);
    addRow(form, label, field, unit);
}

QWidget *ErosionDock::makeSettings(QWidget *parent)
{
    auto *box = new QGroupBox(tr("Settings"), parent);
    auto *form = new QFormLayout(box);
    mNumbers.clear();
    mRule = new QComboBox(box);
    mRule->setObjectName(QStringLiteral("rule"));
    mRule->addItems({tr("Faces"), tr("Edges")});
    mRule->setToolTip(tr("Faces come to rest at the critical angle. Edges are the older rule: faces stay steeper."));
    connect(mRule, &QComboBox::activated, this,
            [this](int row) { change([row](FlowSettings &flow) { flow.erosion.rule = ErosionRule(row); }); });
    addRow(*form, tr("Rule:"), mRule);
    mAngle = new NumberField(tr("Critical angle"), {SmallestCriticalAngle, LargestCriticalAngle, 1}, box);
    connect(mAngle, &NumberField::changed, this, [this] {
        if (const auto value = mAngle->value())
            change([=](FlowSettings &flow) { flow.erosion.material.criticalAngles = {{0, *value}}; });
    });
    addRow(*form, tr("Critical angle:"), mAngle, QStringLiteral("°"));
    mAngleFrom = new QLabel(tr("from the materials"), box);
    addRow(*form, tr("Critical angle:"), mAngleFrom);
    addNumber(*form, tr("Starts at:"), tr("Degrees above the critical angle from which resting sand starts to slide"),
              QStringLiteral("°"), 0, 10, 2, 0.5, [](FlowSettings &f) -> double & { return f.erosion.startAngle; });
    addNumber(*form, tr("Speed:"), tr("Simulated seconds in a second"), QStringLiteral("×"), 0.01, 100, 2, 0.25,
              [](FlowSettings &f) -> double & { return f.speed; });
    addNumber(*form, tr("Sweeps:"), tr("Over everything that may move, in a simulated second"), tr("per s"), 1, 100000,
              0, 10, [](FlowSettings &f) -> double & { return f.erosion.sweepsPerSecond; });
    addNumber(*form, tr("Over-relaxation:"), tr("Above 1, each step goes too far and all comes to rest sooner"), {},
              0.1, 1.95, 2, 0.05, [](FlowSettings &f) -> double & { return f.erosion.relaxation; });
    addNumber(*form, tr("Longest edge:"), tr("Longer ones are split before sand slides over them; 0: none"),
              QStringLiteral("m"), 0, 1e6, 4, 0.01, [](FlowSettings &f) -> double & { return f.erosion.longestEdge; });
    addNumber(*form, tr("Vertical error:"),
              tr("Vertices that are of no use are removed if the surface changes by no more; 0: none are"),
              QStringLiteral("m"), 0, 1e6, 6, 0.0001, [](FlowSettings &f) -> double & { return f.erosion.flatError; });
    addNumber(*form, tr("Redundancy angle:"), tr("Between the triangles around a vertex that may be of no use"),
              QStringLiteral("°"), 0, 10, 2, 0.1, [](FlowSettings &f) -> double & { return f.erosion.flatAngle; });
    addNumber(*form, tr("Time per frame:"), tr("More slides sooner, less keeps the window quick"), tr("ms"), 1, 100, 1,
              1, [](FlowSettings &f) -> double & { return f.milliseconds; });
    mCoarse = new QCheckBox(tr("Settle on a coarse grid first"), box);
    mCoarse->setToolTip(tr("A third faster; the tip of a heap ends a hundredth lower"));
    connect(mCoarse, &QCheckBox::toggled, this,
            [this](bool isOn) { change([isOn](FlowSettings &flow) { flow.erosion.hasCoarsePass = isOn; }); });
    form->addRow(mCoarse);
    return box;
}

void ErosionDock::change(const std::function<void(FlowSettings &)> &change)
{
    if (mIsShowing)
        return;
    FlowSettings flow = mSettings.flow();
    change(flow);
    mSettings.setFlow(flow);
}

void ErosionDock::runOrPause()
{
    if (!mFlow || isSettling())
        return;
    if (isRunning())
        mFlow->pause();
    else
        mFlow->run();
}

void ErosionDock::step()
{
    if (mFlow && !isSettling() && !isRunning())
        mFlow->step();
}

void ErosionDock::settle()
{
    if (!mFlow || isSettling())
        return;
    mRefusal->hide();
    mFlow->pause();
    auto erosion = Erosion::create(mSettings.flow().erosion, mContext->document().terrain().materials);
    if (!erosion)
        return;
    delete mPanel;
    auto *panel = new JobPanel(mSettling->job(), widget());
    panel->setActivity(tr("Settling…"));
    mPanel = panel;
    mColumn->insertWidget(1, panel);
    mSettling->start(QCoreApplication::translate("Undo", "Settle"),
                     [erosion = std::make_shared<Erosion>(std::move(*erosion))](
                         TinEdit &edit, const model::Progress &progress) -> model::Result<void> {
                         if (auto done = erosion->settle(edit, progress); !done)
                             return model::fail(std::move(done.error()));
                         return {};
                     });
}

void ErosionDock::showSettings()
{
    mIsShowing = true;
    FlowSettings flow = mSettings.flow();
    mWhileDrawing->setChecked(flow.isOn);
    mRule->setCurrentIndex(int(flow.erosion.rule));
    mCoarse->setChecked(flow.erosion.hasCoarsePass);
    showNumber(*mAngle, flow.erosion.material.criticalAngles.front().degrees);
    for (const auto &[field, member] : mNumbers)
        showNumber(*field, member(flow));
    const bool hasLayers = mContext && mContext->document().tin().arrays().layerCount() > 0;
    setRowVisible(mAngle, !hasLayers);
    setRowVisible(mAngleFrom, hasLayers);
    mIsShowing = false;
}

void ErosionDock::showState()
{
    mRun->setText(isRunning() ? tr("&Pause") : tr("&Run"));
    mRun->setEnabled(mFlow && !isSettling());
    mStep->setEnabled(mFlow && !isSettling() && !isRunning());
    mSettle->setEnabled(mFlow && !isSettling());
    if (mPanel)
        mPanel->setVisible(isSettling());
    emit stateChanged();
}

void ErosionDock::showFigures()
{
    const QString none = QStringLiteral("–");
    if (!mFlow) {
        for (QLabel *value : mValues)
            value->setText(none);
        return;
    }
    const FlowFigures &figures = mFlow->figures();
    mValues[0]->setText(countText(figures.activeTriangles));
    mValues[1]->setText(tr("%1/s").arg(volumeText(figures.movedPerSecond)));
    mValues[2]->setText(volumeText(figures.movedVolume));
    mValues[3]->setText(figures.steepest ? tr("%1°").arg(numberText(*figures.steepest, 2)) : none);
    mValues[4]->setText(percentText(100 * figures.drift));
}

} // namespace views
