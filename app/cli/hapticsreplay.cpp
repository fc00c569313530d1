// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/haptics.h"

#include "app/cli/outputs.h"
#include "model/haptics/record/session.h"
#include "model/io/savefile.h"

namespace cli {

using namespace model::haptics;

namespace {

/// One line for each step.
model::Result<void> saveTable(const std::string &path, const std::vector<ServoSample> &samples)
{
    QByteArray table = "seconds,x,y,z,depth,force_x,force_y,force_z,law_x,law_y,law_z,buttons,state\n";
    for (const ServoSample &s : samples) {
        for (const double value :
             {seconds(s.now - samples.front().now), s.reading.position.x, s.reading.position.y, s.reading.position.z,
              s.depth, s.force.x, s.force.y, s.force.z, s.lawForce.x, s.lawForce.y, s.lawForce.z})
            table += QByteArray::number(value, 'g', 9) + ',';
        table += QByteArray::number(s.reading.buttons) + ',' + nameOf(s.state).toLatin1() + '\n';
    }
    return model::io::saveBytes(fromUtf8(path),
                                {reinterpret_cast<const std::uint8_t *>(table.constData()), std::size_t(table.size())});
}

struct ReplayOptions
{
    std::string input, table;

    model::Result<void> run(Console &console) const;
};

model::Result<void> ReplayOptions::run(Console &console) const
{
    if (!table.empty())
        if (auto checked = checkOutputs({{"--csv", table}}, {}); !checked)
            return checked;
    const auto recording = openRecording(input);
    if (!recording)
        return model::fail(recording.error());
    const auto replayed = replay(*recording);
    if (!replayed) {
        model::Error error = replayed.error();
        return model::fail(std::move(error).in(input));
    }
    if (!table.empty())
        if (auto saved = saveTable(table, replayed->samples); !saved)
            return saved;
    console.data(
        {{"device", fromUtf8(recording->device)},
         {"seconds", replayed->duration},
         {"steps", double(replayed->steps)},
         {"lost_steps", double(recording->lostSamples)},
         {"identical", replayed->isIdentical()},
         {"different_steps", double(replayed->different)},
         {"first_different", double(replayed->firstDifferent)},
         {"largest_difference_n", replayed->largestDifference},
         {"largest_force_n", replayed->largestForce}},
        {QStringLiteral("%1: %2 s, %3 steps with %4, at most %5 N")
             .arg(fromUtf8(input))
             .arg(replayed->duration, 0, 'f', 2)
             .arg(replayed->steps)
             .arg(fromUtf8(recording->device))
             .arg(replayed->largestForce, 0, 'f', 2),
         replayed->isIdentical()
             ? QStringLiteral("every force is the recorded one, to the last bit")
             : QStringLiteral("%1 forces differ from step %2 on, by up to %3 N%4")
                   .arg(replayed->different)
                   .arg(replayed->firstDifferent)
                   .arg(replayed->largestDifference)
                   .arg(recording->lostSamples ? QStringLiteral("; %1 steps were lost").arg(recording->lostSamples)
                                               : QString())});
    return {};
}

struct Simulate
{
    std::string output;
    FeelOptions feel;

    model::Result<void> run(Console &console) const;
};

model::Result<void> Simulate::run(Console &console) const
{
    if (auto checked = checkOutputs({{"--output", output}}, {}); !checked)
        return checked;
    auto settings = feel.settings();
    if (!settings)
        return model::fail(std::move(settings).error());
    const auto terrain = feel.terrain(console, *settings);
    if (!terrain)
        return model::fail(terrain.error());
    SessionPlan plan;
    plan.settings = *settings;
    plan.trajectory = pressTrajectory();
    const Recording recording = simulateSession(*terrain, plan);
    if (auto saved = saveRecording(output, recording); !saved)
        return saved;
    console.outcome({{"output", fromUtf8(output)}}, QStringLiteral("%1: recorded").arg(fromUtf8(output)));
    return {};
}

} // namespace

void addHapticsReplay(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("replay", "Do a recorded session again, and compare every force");
    const auto options = std::make_shared<ReplayOptions>();
    command->add_option("FILE", options->input, "A recording (.haptics)")->required();
    command->add_option("--csv", options->table, "Write positions and forces as a table")->type_name("FILE.csv");
    onCall(*command, options, run);
}

void addHapticsSimulate(CLI::App &app, Run &run)
{
    CLI::App *command =
        app.add_subcommand("simulate", "Record a simulated hand that presses into the ground, ploughs and pulls out");
    const auto options = std::make_shared<Simulate>();
    command->add_option("-o,--output", options->output, "The recording to write")
        ->required()
        ->type_name("FILE.haptics");
    options->feel.addTo(*command);
    onCall(*command, options, run);
}

} // namespace cli
