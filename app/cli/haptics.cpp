// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/haptics.h"

#include "app/cli/outputs.h"
#include "model/io/savefile.h"
#include "model/io/terrain/terrainfile.h"

#include <QFile>
#include <QJsonArray>

#include <algorithm>

namespace cli {

using namespace model::haptics;

namespace {

/// Metres of hand for the shorter side of a terrain.
constexpr double HandWidth = 0.4;

/// What helps against "permission denied".
QString permissionHint()
{
    return QStringLiteral("This user may not open it. Install the udev rule %1 (it comes with the program; "
                          "copy it to /etc/udev/rules.d), then plug the device in again.")
        .arg(QLatin1String(UdevRuleName));
}

struct List
{
    model::Result<void> run(Console &console) const;
};

model::Result<void> List::run(Console &console) const
{
    HapticsService service;
    QJsonArray devices;
    QStringList lines;
    bool hasForbidden = false;
    for (const FoundDevice &found : service.devices()) {
        const QString kind = QLatin1String(model::haptics::nameOf(found.kind));
        QJsonObject device{{"id", fromUtf8(found.id)},
                           {"kind", kind},
                           {"name", fromUtf8(found.name)},
                           {"allowed", found.isAllowed},
                           {"force", found.kind != DeviceKind::SpaceMouse},
                           {"experimental", found.kind == DeviceKind::ForceFeedback}};
        if (found.kind != DeviceKind::Simulated) {
            device["path"] = fromUtf8(found.hid.path);
            device["vendor"] = found.hid.vendor;
            device["product"] = found.hid.product;
        }
        devices.append(device);
        lines << QStringLiteral("%1  %2%3%4")
                     .arg(fromUtf8(found.id), -28)
                     .arg(fromUtf8(found.name),
                          found.kind == DeviceKind::SpaceMouse      ? QStringLiteral(" (moves the tool, no force)")
                          : found.kind == DeviceKind::ForceFeedback ? QStringLiteral(" (experimental)")
                                                                    : QString(),
                          found.isAllowed ? QString() : QStringLiteral(" (no permission)"));
        hasForbidden |= !found.isAllowed;
    }
    console.data({{"devices", devices}}, lines);
    if (hasForbidden)
        console.note(permissionHint());
    return {};
}

} // namespace

void FeelOptions::addTo(CLI::App &command)
{
    command.add_option("--law", law, "How ground becomes force: granular (default), 2009, 2009-along-motion")
        ->type_name("NAME");
    command
        .add_option("--material", material,
                    "What is felt without --ground: dry sand (default), moist sand, mud, snow, gravel")
        ->type_name("NAME");
    command.add_option("--ground", ground, "A .terrain file to feel, its middle under the device's")
        ->type_name("FILE.terrain");
    command.add_option("--gain", gain, "Of the law's force (default: 1)")->check(finiteRange(0, 2))->type_name("0..2");
    command.add_option("--max-force", maxForce, "Newtons (default: 4)")
        ->check(finiteRange(0, HardForceLimit))
        ->type_name("0..10");
}

model::Result<ServoSettings> FeelOptions::settings() const
{
    ServoSettings settings;
    const auto kind = lawNamed(law);
    if (!kind)
        return model::fail(model::ErrorCode::BadSetting, "--law", law, "granular, 2009, 2009-along-motion");
    settings.law = *kind;
    settings.gain = gain;
    settings.limits.userForce = maxForce;
    settings.workspace.toolRadius = 0.01;
    if (!ground.empty())
        return settings;
    for (const model::terrain::MaterialPreset preset : model::terrain::EveryMaterialPreset)
        if (material == model::terrain::nameOf(preset) && preset != model::terrain::MaterialPreset::Custom) {
            const model::terrain::Material felt = model::terrain::material(preset);
            settings.overridesFeel = true;
            settings.feel = feelOf(felt, felt.humidity);
            return settings;
        }
    return model::fail(model::ErrorCode::BadSetting, "--material", material, "dry sand, moist sand, mud, snow, gravel");
}

model::Result<model::terrain::Terrain> FeelOptions::terrain(Console &console, ServoSettings &settings) const
{
    if (ground.empty())
        return model::terrain::Terrain(model::terrain::Tin({{-1, -1}, {1, 1}}));
    auto file = model::io::openTerrain(fromUtf8(ground), console.progress("Reading"));
    if (!file)
        return model::fail(std::move(file).error());
    const model::terrain::Tin &tin = file->terrain.tin;
    const model::terrain::Rectangle domain = tin.domain();
    const model::terrain::Point2 middle{(domain.low.x + domain.high.x) / 2, (domain.low.y + domain.high.y) / 2};
    settings.workspace.origin = {middle.x, middle.y, tin.heightAt(middle)};
    settings.workspace.scale = std::min(domain.high.x - domain.low.x, domain.high.y - domain.low.y) / HandWidth;
    settings.workspace.toolRadius = 0.01 * settings.workspace.scale;
    return std::move(file->terrain);
}

QString nameOf(SafetyState state)
{
    switch (state) {
    case SafetyState::Stopped:
        return QStringLiteral("stopped");
    case SafetyState::Waiting:
        return QStringLiteral("waiting");
    case SafetyState::Rising:
        return QStringLiteral("rising");
    case SafetyState::On:
        return QStringLiteral("on");
    case SafetyState::Fading:
        return QStringLiteral("fading");
    }
    return {};
}

QString nameOf(SafetyCause cause)
{
    switch (cause) {
    case SafetyCause::None:
        return QStringLiteral("none");
    case SafetyCause::Stopped:
        return QStringLiteral("stopped by the user");
    case SafetyCause::StaleSnapshot:
        return QStringLiteral("stale snapshot");
    case SafetyCause::LateLoop:
        return QStringLiteral("late loop");
    case SafetyCause::DeviceSilent:
        return QStringLiteral("device silent");
    case SafetyCause::DeviceLost:
        return QStringLiteral("device lost");
    case SafetyCause::BadNumber:
        return QStringLiteral("bad number");
    }
    return {};
}

QJsonObject percentilesOf(const Histogram &histogram)
{
    const auto microseconds = [](Time time) { return double(time.count()) / 1000; };
    return {{"p50", microseconds(histogram.percentile(0.5))},
            {"p99", microseconds(histogram.percentile(0.99))},
            {"p999", microseconds(histogram.percentile(0.999))},
            {"max", microseconds(histogram.longest())}};
}

model::Result<Recording> openRecording(const std::string &path)
{
    QFile file(fromUtf8(path));
    if (!file.exists())
        return model::fail(model::Error{model::ErrorCode::NotFound, {}, path, model::Error::None, model::Error::None});
    const auto cannot = [&](model::ErrorCode code) {
        return model::fail(
            model::Error{code, {file.errorString().toStdString()}, path, model::Error::None, model::Error::None});
    };
    if (!file.open(QIODevice::ReadOnly))
        return cannot(model::ErrorCode::CannotOpen);
    const QByteArray bytes = file.read(qint64(LargestRecording) + 1);
    if (file.error() != QFileDevice::NoError)
        return cannot(model::ErrorCode::CannotRead);
    auto recording =
        readRecording({reinterpret_cast<const std::uint8_t *>(bytes.constData()), std::size_t(bytes.size())});
    if (!recording)
        return model::fail(std::move(recording).error().in(path));
    return recording;
}

model::Result<void> saveRecording(const std::string &path, const Recording &recording)
{
    return model::io::saveBytes(fromUtf8(path), writeRecording(recording));
}

void addHapticsList(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("list", "List the devices that can be felt with or moved by");
    onCall(*command, std::make_shared<List>(), run);
}

void addHaptics(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("haptics", "Find, watch and measure haptic devices");
    command->require_subcommand(1);
    addHapticsList(*command, run);
    addHapticsMonitor(*command, run);
    addHapticsBench(*command, run);
    addHapticsReplay(*command, run);
    addHapticsSimulate(*command, run);
}

} // namespace cli
