// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commands.h"
#include "model/io/terrain/terrainfile.h"

namespace cli {

// The sub-commands of `sandreel-cli terrain`.
void addTerrainNew(CLI::App &app, Run &run);
void addTerrainInfo(CLI::App &app, Run &run);
void addTerrainValidate(CLI::App &app, Run &run);
void addTerrainVolume(CLI::App &app, Run &run);
void addTerrainImport(CLI::App &app, Run &run);
void addTerrainExport(CLI::App &app, Run &run);
void addTerrainSimplify(CLI::App &app, Run &run);
void addTerrainRun(CLI::App &app, Run &run);

/// The file that a sub-command reads: `FILE.terrain`.
struct TerrainInput
{
    std::string path;

    void addTo(CLI::App &command);
    /// Says so if the file comes of a newer program.
    model::Result<model::io::TerrainFile> read(Console &console) const;
};

/// The file that one writes: `-o FILE.terrain`.
struct TerrainOutput
{
    std::string path;

    void addTo(CLI::App &command);
    /// Before the work: a wrong ending, a folder that is not there. `input` may be the same file.
    model::Result<void> check() const;
    /// Saves, unless it was interrupted before. `json` and `text` say what else there is to say.
    model::Result<void> save(Console &console, const model::io::TerrainFile &file, QJsonObject json,
                             const QString &text) const;
};

} // namespace cli
