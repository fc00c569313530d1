// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/haptics/hapticstexts.h"

#include <QCoreApplication>

namespace views {

using namespace model::haptics;

namespace {

struct HapticsTexts
{
    Q_DECLARE_TR_FUNCTIONS(views::HapticsTexts)
};

QString causeText(SafetyCause cause)
{
    switch (cause) {
    case SafetyCause::None:
        return {};
    case SafetyCause::Stopped:
        return HapticsTexts::tr("Forces are off.");
    case SafetyCause::StaleSnapshot:
        return HapticsTexts::tr("No force: the window was busy for too long.");
    case SafetyCause::LateLoop:
        return HapticsTexts::tr("No force: the machine was too late.");
    case SafetyCause::DeviceSilent:
        return HapticsTexts::tr("No force: the device says nothing.");
    case SafetyCause::DeviceLost:
        return HapticsTexts::tr("No force: the device is unplugged.");
    case SafetyCause::BadNumber:
        return HapticsTexts::tr("No force: a number was not one. Switch forces off and on.");
    }
    return {};
}

} // namespace

QString titleOf(LawKind law)
{
    switch (law) {
    case LawKind::Granular:
        return HapticsTexts::tr("Granular");
    case LawKind::Reference2009:
        return HapticsTexts::tr("2009, Averaged");
    case LawKind::Reference2009AlongMotion:
        return HapticsTexts::tr("2009, Along the Motion");
    }
    return {};
}

QString hintOf(LawKind law)
{
    switch (law) {
    case LawKind::Granular:
        return HapticsTexts::tr("Resists more with depth, gives way, and holds the tool when it is wet.");
    case LawKind::Reference2009:
        return HapticsTexts::tr(
            "An older model, to compare: a spring above the ground, and the mean of all directions.");
    case LawKind::Reference2009AlongMotion:
        return HapticsTexts::tr("An older model, to compare: it trembles when the tool hardly moves.");
    }
    return {};
}

QString titleOf(const FoundDevice &device)
{
    if (device.kind == DeviceKind::Simulated)
        return HapticsTexts::tr("Simulated Device");
    const QString name = QString::fromStdString(device.name);
    return device.isAllowed ? name : HapticsTexts::tr("%1 (no permission)").arg(name);
}

QString hintOf(const FoundDevice &device)
{
    if (!device.isAllowed)
        return HapticsTexts::tr("You have no permission to use this device. Copy %1, which comes with Sandreel, to "
                                "/etc/udev/rules.d, and plug the device in again.")
            .arg(QLatin1String(UdevRuleName));
    switch (device.kind) {
    case DeviceKind::Simulated:
        return HapticsTexts::tr("The mouse moves the tool, the wheel or Page Up and Page Down lift it and press it "
                                "in, the left button draws. Ctrl and the wheel zoom.");
    case DeviceKind::SpaceMouse:
        return HapticsTexts::tr("It moves the tool while its cap is pushed; a button draws. It has no force.");
    case DeviceKind::ForceFeedback:
        return HapticsTexts::tr("Experimental: nobody has tried every stick. Hold it loosely.");
    }
    return {};
}

QString stateText(const Capabilities *device, const ServoSample &sample)
{
    if (!device)
        return HapticsTexts::tr("No device.");
    if (!sample.reading.isConnected)
        return HapticsTexts::tr("The device is unplugged. Plug it in to go on.");
    if (!device->hasForce)
        return HapticsTexts::tr("The device moves the tool.");
    switch (sample.state) {
    case SafetyState::Stopped:
        return causeText(sample.cause == SafetyCause::None ? SafetyCause::Stopped : sample.cause);
    case SafetyState::Waiting:
        return sample.cause == SafetyCause::None ? HapticsTexts::tr("Lift the tool: forces begin in the air.")
                                                 : causeText(sample.cause);
    case SafetyState::Rising:
        return HapticsTexts::tr("Forces are rising.");
    case SafetyState::On:
        return HapticsTexts::tr("Forces are on.");
    case SafetyState::Fading:
        return sample.cause == SafetyCause::None ? HapticsTexts::tr("Forces fade.") : causeText(sample.cause);
    }
    return {};
}

} // namespace views
