// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commands.h"
#include "model/haptics/service/hapticsservice.h"

namespace cli {

void addHaptics(CLI::App &app, Run &run);

// Its sub-commands.
void addHapticsList(CLI::App &app, Run &run);
void addHapticsMonitor(CLI::App &app, Run &run);
void addHapticsBench(CLI::App &app, Run &run);
void addHapticsReplay(CLI::App &app, Run &run);
void addHapticsSimulate(CLI::App &app, Run &run);

/// `--law`, `--material`, `--gain`, `--max-force`, `--ground`: what is felt, in every sub-command that feels.
struct FeelOptions
{
    std::string law = "granular", material = "dry sand", ground;
    double gain = 1, maxForce = 4;

    void addTo(CLI::App &command);
    model::Result<model::haptics::ServoSettings> settings() const;
    /// The file's terrain, or two metres of level ground; `settings` put the hand in its middle.
    model::Result<model::terrain::Terrain> terrain(Console &console, model::haptics::ServoSettings &settings) const;
};

/// "waiting", "stale snapshot", ...
QString nameOf(model::haptics::SafetyState state);
QString nameOf(model::haptics::SafetyCause cause);
/// `p50`, `p99`, `p999` and `max`, microseconds.
QJsonObject percentilesOf(const model::haptics::Histogram &histogram);

model::Result<model::haptics::Recording> openRecording(const std::string &path);
model::Result<void> saveRecording(const std::string &path, const model::haptics::Recording &recording);

} // namespace cli
