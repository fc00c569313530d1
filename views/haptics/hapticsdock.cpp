// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/haptics/hapticsdock.h"

#include "views/dialogs/inputline.h"
#include "views/dialogs/numberfield.h"
#include "views/dialogs/quantitytext.h"
#include "views/docks/terrain/dockform.h"
#include "views/haptics/hapticssession.h"
#include "views/haptics/hapticstexts.h"
#include "views/haptics/latenessplot.h"
#include "views/haptics/traceplot.h"
#include "views/sculpt/materialtitles.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace views {

using namespace model::haptics;
using model::terrain::EveryMaterialPreset;
using model::terrain::MaterialPreset;

namespace {

/// Between two renewals of what is shown in words; plots get every sample.
constexpr int ShowMilliseconds = 100;
constexpr double LargestGain = 2;
/// Quiet curves are drawn over so much: N, mm.
constexpr double LeastForces = 1, LeastPositions = 10;
/// Red that white text is read on.
constexpr const char *StopStyle = "QPushButton { background-color: #c01c28; color: white; font-weight: bold; "
                                  "border: 1px solid #7d1119; border-radius: 4px; padding: 8px; }"
                                  "QPushButton:hover, QPushButton:focus { background-color: #e01b24; }"
                                  "QPushButton:focus { border: 2px solid palette(highlight); }"
                                  "QPushButton:pressed { background-color: #8f141d; }";

std::vector<TracePlot::Curve> axes(const QString (&names)[3])
{
    return {{names[0], QColor(0xc0, 0x2c, 0x2c), QColor(0xff, 0x8a, 0x80)},
            {names[1], QColor(0x1f, 0x7a, 0x33), QColor(0x7f, 0xd8, 0x8f)},
            {names[2], QColor(0x1a, 0x5f, 0xb4), QColor(0x82, 0xb8, 0xf5)}};
}

QString vectorText(model::Vec3d v, int decimals)
{
    return QStringLiteral("%1 · %2 · %3")
        .arg(numberText(v.x, decimals), numberText(v.y, decimals), numberText(v.z, decimals));
}

} // namespace

HapticsDock::HapticsDock(HapticsSession &session, QWidget *parent)
    : QDockWidget(parent)
    , mSession(session)
{
    setObjectName(QStringLiteral("hapticsDock"));
    build();
    mSinceShown.start();
    connect(&session.finder(), &DeviceFinder::changed, this, &HapticsDock::showDevices);
    connect(&session, &HapticsSession::chosenChanged, this, [this] {
        mRefusal.clear();
        for (TracePlot *plot : {mForces, mPositions})
            plot->clear();
        showDevices();
        showForces();
        showNow();
    });
    connect(&session, &HapticsSession::forcesChanged, this, &HapticsDock::showForces);
    connect(&session, &HapticsSession::feelChanged, this, &HapticsDock::showFeel);
    connect(&session, &HapticsSession::stepped, this, &HapticsDock::takeSamples);
    connect(&session, &HapticsSession::refused, this, [this](const QString &reason) {
        mRefusal = reason;
        showHint();
    });
    connect(this, &QDockWidget::visibilityChanged, this, [this](bool isSeen) {
        mIsSeen = isSeen;
        mSession.finder().setWatching(isSeen || mSession.service().isOpen());
        if (isSeen)
            showNow();
    });
}

void HapticsDock::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::LanguageChange)
        build();
    QDockWidget::changeEvent(event);
}

void HapticsDock::build()
{
    setWindowTitle(tr("Haptics"));
    auto *content = new QWidget;
    auto *column = new QVBoxLayout(content);
    column->addWidget(makeDevice(content));
    column->addWidget(makeFeel(content));
    column->addWidget(makeFigures(content));
    column->addStretch();
    auto *scroll = new QScrollArea;
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus); // the fields in it have the focus
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(content);
    scroll->setMinimumWidth(content->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width());

    auto *all = new QWidget;
    auto *rows = new QVBoxLayout(all);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(makeSwitches(all));
    rows->addWidget(scroll);
    QWidget *const before = widget();
    setWidget(all);
    delete before;
    showDevices();
    showForces();
    showFeel();
    showNow();
}

QWidget *HapticsDock::makeSwitches(QWidget *parent)
{
    auto *part = new QWidget(parent);
    auto *column = new QVBoxLayout(part);
    mStop = new QPushButton(tr("STOP"), part);
    mStop->setObjectName(QStringLiteral("stop"));
    mStop->setStyleSheet(QLatin1String(StopStyle));
    mStop->setToolTip(tr("Forces off, at once. Escape does the same anywhere in the program."));
    mStop->setAccessibleName(tr("Stop all forces"));
    connect(mStop, &QPushButton::clicked, this, [this] { mSession.setForces(false); });
    mWanted = new QCheckBox(tr("&Forces"), part);
    mWanted->setObjectName(QStringLiteral("forces"));
    mWanted->setToolTip(tr("Let the device push. Forces begin in the air and rise over two seconds."));
    connect(mWanted, &QCheckBox::clicked, this, [this](bool isOn) {
        mSession.setForces(isOn);
        showForces(); // it may not have been possible
    });
    mState = new QLabel(part);
    mState->setObjectName(QStringLiteral("state"));
    mState->setAccessibleName(tr("State of the forces"));
    mState->setWordWrap(true);
    // Two lines, so that nothing below it moves when the text does.
    mState->setMinimumHeight(2 * mState->fontMetrics().lineSpacing());
    mState->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    column->addWidget(mStop);
    column->addWidget(mWanted);
    column->addWidget(mState);
    return part;
}

QWidget *HapticsDock::makeDevice(QWidget *parent)
{
    auto *box = new QGroupBox(tr("Device"), parent);
    auto *column = new QVBoxLayout(box);
    mDevice = new QComboBox(box);
    mDevice->setObjectName(QStringLiteral("device"));
    mDevice->setAccessibleName(tr("Device"));
    mDevice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    mDevice->setMinimumContentsLength(16);
    connect(mDevice, &QComboBox::activated, this,
            [this](int row) { mSession.choose(mDevice->itemData(row).toString()); });
    mHint = new HintLabel(box);
    mHint->setObjectName(QStringLiteral("deviceHint"));
    mHint->setWordWrap(true);
    column->addWidget(mDevice);
    column->addWidget(mHint);
    return box;
}

QWidget *HapticsDock::makeFeel(QWidget *parent)
{
    auto *box = new QGroupBox(tr("Feel"), parent);
    auto *form = new QFormLayout(box);
    const auto change = [this](auto set) {
        FeelSettings feel = mSession.feel();
        set(feel);
        mSession.setFeel(feel);
    };
    mMaterial = new QComboBox(box);
    mMaterial->setObjectName(QStringLiteral("material"));
    mMaterial->addItem(tr("As the Ground Is"));
    for (const MaterialPreset preset : EveryMaterialPreset)
        if (preset != MaterialPreset::Custom)
            mMaterial->addItem(titleOf(preset), int(preset));
    mMaterial->setToolTip(tr("What the ground feels like; what it is does not change."));
    connect(mMaterial, &QComboBox::activated, this, [this, change](int row) {
        change([&](FeelSettings &feel) {
            feel.material = row == 0 ? std::nullopt : std::optional(MaterialPreset(mMaterial->itemData(row).toInt()));
        });
    });
    addRow(*form, tr("Material:"), mMaterial);
    mLaw = new QComboBox(box);
    mLaw->setObjectName(QStringLiteral("law"));
    for (const LawKind law : EveryLaw) {
        mLaw->addItem(titleOf(law), int(law));
        mLaw->setItemData(mLaw->count() - 1, hintOf(law), Qt::ToolTipRole);
    }
    connect(mLaw, &QComboBox::activated, this, [this, change](int row) {
        change([&](FeelSettings &feel) { feel.law = LawKind(mLaw->itemData(row).toInt()); });
    });
    addRow(*form, tr("Force law:"), mLaw);
    const auto number = [&](const QString &label, const QString &hint, const QString &unit, NumberRange range,
                            double step, double FeelSettings::*member) {
        auto *field = new NumberField(QString(label).remove(QLatin1Char(':')), range);
        field->setStep(step);
        field->setToolTip(hint);
        connect(field, &NumberField::changed, this, [field, change, member] {
            if (const auto value = field->value())
                change([&](FeelSettings &feel) { feel.*member = *value; });
        });
        addRow(*form, label, field, unit);
        return field;
    };
    mGain = number(tr("Gain:"), tr("The force of the ground, times this"), QStringLiteral("×"), {0, LargestGain, 2},
                   0.1, &FeelSettings::gain);
    mGain->setObjectName(QStringLiteral("gain"));
    mMaxForce = number(tr("At most:"), tr("No force is above this, nor above what the device is made for"),
                       QStringLiteral("N"), {0, HardForceLimit, 1}, 0.5, &FeelSettings::maxForce);
    mMaxForce->setObjectName(QStringLiteral("maxForce"));
    return box;
}

QWidget *HapticsDock::makeFigures(QWidget *parent)
{
    auto *box = new QGroupBox(tr("Now"), parent);
    auto *column = new QVBoxLayout(box);
    auto *form = new QFormLayout;
    column->addLayout(form);
    mPosition = addFact(*form, tr("Position:"));
    mPosition->setToolTip(tr("Of the hand, in millimetres: right, away, up"));
    mForce = addFact(*form, tr("Force:"));
    mForce->setToolTip(tr("On the hand, in newtons: right, away, up"));
    mRate = addFact(*form, tr("Rate:"));
    mRate->setToolTip(tr("Steps of the servo in a second, of a thousand that are due"));
    mLate = addFact(*form, tr("Lateness:"));
    mLate->setToolTip(tr("99 of 100 steps began no later than this"));
    const QString names[] = {tr("right"), tr("away"), tr("up")};
    mForces = new TracePlot(tr("Force (N)"), axes(names), LeastForces, box);
    mPositions = new TracePlot(tr("Position (mm)"), axes(names), LeastPositions, box);
    mLateness = new LatenessPlot(box);
    for (QWidget *plot : std::initializer_list<QWidget *>{mForces, mPositions, mLateness})
        column->addWidget(plot);
    return box;
}

void HapticsDock::showDevices()
{
    const QSignalBlocker blocker(mDevice);
    mDevice->clear();
    mDevice->addItem(tr("None"), QString());
    for (const FoundDevice &device : mSession.finder().devices())
        mDevice->addItem(titleOf(device), QString::fromStdString(device.id));
    const QString &chosen = mSession.chosen();
    if (mDevice->findData(chosen) < 0) // it may come back
        mDevice->addItem(tr("%1 (unplugged)").arg(QString::fromStdString(mSession.service().capabilities()->name)),
                         chosen);
    mDevice->setCurrentIndex(mDevice->findData(chosen));
    showHint();
}

void HapticsDock::showHint()
{
    if (!mRefusal.isEmpty())
        return mHint->showRefusal(mRefusal);
    const std::vector<FoundDevice> &devices = mSession.finder().devices();
    QString hint;
    for (const FoundDevice &device : devices)
        if (QString::fromStdString(device.id) == mSession.chosen() || (hint.isEmpty() && !device.isAllowed))
            hint = hintOf(device);
    if (hint.isEmpty())
        hint = tr("Choose the simulated device to feel the ground with the mouse, or plug one in.");
    mHint->showHint(hint);
}

void HapticsDock::showForces()
{
    const Capabilities *const device = mSession.service().capabilities();
    const bool canPush = device && device->hasForce && mSession.hasTerrain();
    mWanted->setEnabled(canPush);
    mWanted->setChecked(mSession.wantsForces());
    mSession.finder().setWatching(mIsSeen || mSession.service().isOpen());
    mState->setText(stateText(device, mSession.now()));
}

void HapticsDock::showFeel()
{
    const FeelSettings &feel = mSession.feel();
    mLaw->setCurrentIndex(mLaw->findData(int(feel.law)));
    mLaw->setToolTip(hintOf(feel.law));
    mMaterial->setCurrentIndex(feel.material ? mMaterial->findData(int(*feel.material)) : 0);
    showNumber(*mGain, feel.gain);
    showNumber(*mMaxForce, feel.maxForce);
}

void HapticsDock::takeSamples()
{
    if (!mIsSeen)
        return;
    for (const ServoSample &sample : mSession.samples()) {
        const model::Vec3d p = sample.reading.position * 1000, f = sample.force;
        const double at = seconds(sample.now);
        mForces->add(at, {f.x, f.y, f.z});
        mPositions->add(at, {p.x, p.y, p.z});
    }
    if (mSinceShown.elapsed() >= ShowMilliseconds)
        showNow();
}

void HapticsDock::showNow()
{
    mSinceShown.restart();
    const HapticsService &service = mSession.service();
    const Histogram *const lateness = service.lateness();
    mState->setText(stateText(service.capabilities(), mSession.now()));
    mLateness->setLateness(lateness);
    if (!lateness) {
        for (QLabel *fact : {mPosition, mForce, mRate, mLate})
            fact->setText(QStringLiteral("–"));
        return;
    }
    const ServoSample &now = mSession.now();
    const Punctuality punctuality = service.punctuality();
    mPosition->setText(tr("%1 mm").arg(vectorText(now.reading.position * 1000, 0)));
    mForce->setText(tr("%1 N").arg(vectorText(now.force, 2)));
    mRate->setText(tr("%1 Hz, %2 skipped").arg(numberText(punctuality.stepRate(), 0), countText(punctuality.missed)));
    mLate->setText(tr("%1 µs").arg(countText(std::uint64_t(lateness->percentile(0.99).count() / 1000))));
}

} // namespace views
