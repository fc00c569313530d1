// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/haptics.h"

#include "app/cli/outputs.h"
#include "model/terrain/tools/stroke.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>

#include <cmath>
#include <thread>

namespace cli {

using namespace model::haptics;
using namespace std::chrono_literals;

namespace {

/// Between two snapshots of the ground.
constexpr auto SnapshotPeriod = 10ms;

/// Shows the ground to the servo, and calls `each(seconds)` after each time, until `seconds` are over or Ctrl+C.
template <class Each>
void feelFor(Console &console, HapticsService &service, const model::terrain::Terrain &terrain, double length,
             Each each)
{
    const Time begin = monotonicNow();
    for (Time now = begin; seconds(now - begin) < length && !console.isInterrupted(); now = monotonicNow()) {
        service.publishGround(terrain);
        each(seconds(now - begin));
        std::this_thread::sleep_for(SnapshotPeriod);
    }
}

/// How old the ground is that each step feels: `shown` are the times of the patches, in the order of their ids.
void addAges(Histogram &ages, std::span<const ServoSample> samples, const std::vector<Time> &shown)
{
    for (const ServoSample &sample : samples)
        if (sample.patch > 0 && sample.patch <= shown.size())
            ages.add(sample.now - shown[sample.patch - 1]);
}

/// A print of the tool where it is pressed in, as an editor makes it while one strokes.
void stamp(model::terrain::Terrain &terrain, const ServoSettings &settings, const ServoSample &sample,
           model::terrain::ToolMemory &memory)
{
    const model::terrain::Point3 tool = settings.workspace.toTerrain(sample.reading.position);
    if (sample.reading.buttons == 0 || sample.depth <= 0)
        return;
    model::terrain::Imprint imprint;
    imprint.radius = settings.workspace.toolRadius;
    imprint.level = tool.z;
    (void)model::terrain::draw(terrain.tin, {imprint, {{{tool.x, tool.y}, 1, 0}}, {}}, model::terrain::None, memory);
}

struct Bench
{
    double length = 30;
    bool strokes = false;
    FeelOptions feel;

    model::Result<void> run(Console &console) const;
};

model::Result<void> Bench::run(Console &console) const
{
    auto settings = feel.settings();
    if (!settings)
        return model::fail(std::move(settings).error());
    auto terrain = feel.terrain(console, *settings);
    if (!terrain)
        return model::fail(terrain.error());

    auto device = std::make_unique<SimulatedDevice>();
    device->follow(pressTrajectory());
    device->holdWith({});
    HapticsService service;
    PeriodicThread bareTimer([](Time) {}); // what the machine can do, in the same run
    service.openSimulated(std::move(device));
    service.setSettings(*settings);
    service.setForces(true);
    bareTimer.start();
    Histogram ages;
    std::vector<ServoSample> samples;
    std::vector<Time> shown;
    model::terrain::ToolMemory memory;
    feelFor(console, service, *terrain, length, [&](double) {
        shown.push_back(service.shownAt());
        samples.clear();
        service.drain(samples);
        addAges(ages, samples, shown);
        if (strokes)
            stamp(*terrain, service.settings(), service.latest(), memory);
    });
    const Punctuality punctuality = service.punctuality();
    const auto microseconds = [](Time time) { return QString::number(double(time.count()) / 1000, 'f', 0); };
    const auto line = [&](const char *name, const Histogram &histogram) {
        return QStringLiteral("%1 p50 %2, p99 %3, p99.9 %4, longest %5 us")
            .arg(QLatin1String(name), -12)
            .arg(microseconds(histogram.percentile(0.5)), microseconds(histogram.percentile(0.99)),
                 microseconds(histogram.percentile(0.999)), microseconds(histogram.longest()));
    };
    console.data({{"seconds", seconds(punctuality.elapsed)},
                  {"rate_hz", punctuality.rate()},
                  {"steps_hz", punctuality.stepRate()},
                  {"steps", double(punctuality.steps)},
                  {"missed_ticks", double(punctuality.missed)},
                  {"real_time", punctuality.isRealTime},
                  {"snapshot_age_us", percentilesOf(ages)},
                  {"lateness_us", percentilesOf(*service.lateness())},
                  {"bare_timer_us", percentilesOf(bareTimer.lateness())},
                  {"step_us", percentilesOf(*service.stepTimes())}},
                 {QStringLiteral("rate         %1 Hz of deadlines, %2 Hz of steps; %3 missed in %4 s")
                      .arg(punctuality.rate(), 0, 'f', 2)
                      .arg(punctuality.stepRate(), 0, 'f', 2)
                      .arg(punctuality.missed)
                      .arg(seconds(punctuality.elapsed), 0, 'f', 1),
                  QStringLiteral("priority     %1").arg(punctuality.isRealTime ? "real time" : "normal"),
                  line("lateness", *service.lateness()), line("bare timer", bareTimer.lateness()),
                  line("step", *service.stepTimes()), line("ground's age", ages)});
    return {};
}

struct Monitor
{
    std::string device = "simulated", script, record;
    double length = 0; ///< 0: until Ctrl+C
    bool wantsForces = false, wantsLight = false;
    FeelOptions feel;

    model::Result<void> run(Console &console) const;
    model::Result<void> open(HapticsService &service) const;
};

/// The simulated device with its trajectory, or a real one by its id.
model::Result<void> Monitor::open(HapticsService &service) const
{
    if (device == "simulated") {
        Trajectory trajectory = pressTrajectory();
        if (!script.empty()) {
            QFile file(fromUtf8(script));
            if (!file.open(QIODevice::ReadOnly))
                return model::fail(model::Error{model::ErrorCode::CannotOpen,
                                                {file.errorString().toStdString()},
                                                script,
                                                model::Error::None,
                                                model::Error::None});
            const QByteArray text = file.readAll();
            auto parsed = parseTrajectory({text.constData(), std::size_t(text.size())});
            if (!parsed)
                return model::fail(std::move(parsed).error().in(script));
            trajectory = std::move(*parsed);
        }
        auto simulated = std::make_unique<SimulatedDevice>();
        simulated->follow(std::move(trajectory));
        simulated->holdWith({});
        service.openSimulated(std::move(simulated));
        return {};
    }
    std::string ids;
    for (const FoundDevice &found : service.devices()) {
        if (found.id == device)
            return service.open(found);
        ids += (ids.empty() ? "" : ", ") + found.id;
    }
    return model::fail(model::ErrorCode::BadSetting, "--device", device, ids);
}

model::Result<void> Monitor::run(Console &console) const
{
    if (!record.empty())
        if (auto checked = checkOutputs({{"--record", record}}, {}); !checked)
            return checked;
    auto settings = feel.settings();
    if (!settings)
        return model::fail(std::move(settings).error());
    const auto terrain = feel.terrain(console, *settings);
    if (!terrain)
        return model::fail(terrain.error());
    HapticsService service;
    if (auto opened = open(service); !opened)
        return opened;
    service.setSettings(*settings);
    if (!record.empty())
        service.startRecording();
    if (SpaceMouse *const mouse = service.spaceMouse())
        mouse->setLight(wantsLight);
    service.setForces(wantsForces);

    constexpr double LinePeriod = 0.1;
    double nextLine = 0;
    std::vector<ServoSample> samples;
    feelFor(console, service, *terrain, length > 0 ? length : INFINITY, [&](double now) {
        samples.clear();
        service.drain(samples);
        if (now < nextLine)
            return;
        nextLine += LinePeriod;
        const ServoSample s = service.latest();
        const model::Vec3d p = s.reading.position, f = s.force;
        QJsonObject json{{"time", now},
                         {"connected", s.reading.isConnected},
                         {"position", QJsonArray{p.x, p.y, p.z}},
                         {"buttons", double(s.reading.buttons)},
                         {"force", QJsonArray{f.x, f.y, f.z}},
                         {"depth", s.depth},
                         {"state", nameOf(s.state)},
                         {"cause", nameOf(s.cause)}};
        QString battery;
        if (const SpaceMouse *const mouse = service.spaceMouse(); mouse && mouse->state().battery >= 0) {
            json["battery"] = mouse->state().battery;
            battery = QStringLiteral("  battery %1 %").arg(mouse->state().battery);
        }
        const QString text = QStringLiteral("%1 s  %2  at %3 %4 %5 mm  buttons %6  force %7 %8 %9 N  %10%11")
                                 .arg(now, 6, 'f', 1)
                                 .arg(s.reading.isConnected ? "connected" : "gone     ")
                                 .arg(1000 * p.x, 6, 'f', 1)
                                 .arg(1000 * p.y, 6, 'f', 1)
                                 .arg(1000 * p.z, 6, 'f', 1)
                                 .arg(s.reading.buttons)
                                 .arg(f.x, 5, 'f', 2)
                                 .arg(f.y, 5, 'f', 2)
                                 .arg(f.z, 5, 'f', 2)
                                 .arg(s.cause == SafetyCause::None ? nameOf(s.state) : nameOf(s.cause), battery);
        // One object a line, so that a reader need not wait for the end.
        console.line(console.isJson() ? QString::fromUtf8(QJsonDocument(json).toJson(QJsonDocument::Compact)) : text);
        console.flush();
    });
    service.close();
    if (!record.empty())
        return saveRecording(record, service.stopRecording());
    return {};
}

} // namespace

void addHapticsBench(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("bench", "Measure how well this machine keeps 1000 steps a second");
    const auto options = std::make_shared<Bench>();
    command->add_option("--seconds", options->length, "How long (default: 30)")
        ->check(finiteRange(0.1, 86400))
        ->type_name("S");
    command->add_flag("--stroke", options->strokes, "Stamp the ground where the tool is pressed in");
    options->feel.addTo(*command);
    command->footer("A thread that only sleeps runs beside the servo: its lateness is what the machine itself adds.\n"
                    "Deadlines that have passed are skipped and counted, never made up for.");
    onCall(*command, options, run);
}

void addHapticsMonitor(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("monitor", "Show what a device says and feels, ten times a second");
    const auto options = std::make_shared<Monitor>();
    command->add_option("--device", options->device, "As \"haptics list\" names it (default: simulated)")
        ->type_name("ID");
    command->add_option("--seconds", options->length, "How long (default: until Ctrl+C)")
        ->check(finiteRange(0, 86400))
        ->type_name("S");
    command
        ->add_option("--script", options->script, "Where the simulated hand goes: lines of \"seconds x y z [buttons]\"")
        ->type_name("FILE");
    command->add_flag("--forces", options->wantsForces, "Let the device push (else it is only watched)");
    command->add_flag("--light", options->wantsLight, "Switch the light of a SpaceMouse on");
    command->add_option("--record", options->record, "Record the session")->type_name("FILE.haptics");
    options->feel.addTo(*command);
    command->footer("Examples:\n"
                    "  sandreel-cli haptics monitor --forces --material \"moist sand\" --seconds 10\n"
                    "  sandreel-cli haptics monitor --device spacemouse:/dev/hidraw3 --light");
    onCall(*command, options, run);
}

} // namespace cli
