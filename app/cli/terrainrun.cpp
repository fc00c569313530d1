// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/outputs.h"
#include "app/cli/terrain.h"
#include "model/io/filebuffer.h"
#include "model/io/terrain/terrainscript.h"

#include <QDir>
#include <QFileInfo>

namespace cli {

namespace {

struct RunScript
{
    std::string script, input;
    TerrainOutput output;

    model::Result<void> run(Console &console) const;
    model::Result<model::io::TerrainFile> start(Console &console, const model::io::TerrainScript &parsed) const;
};

model::Result<model::io::TerrainFile> RunScript::start(Console &console, const model::io::TerrainScript &parsed) const
{
    if (!input.empty())
        return TerrainInput{input}.read(console);
    if (const auto *const made = std::get_if<model::io::NewTerrain>(&parsed.start)) {
        auto terrain = model::io::makeTerrain(*made);
        if (!terrain)
            return model::fail(terrain.error());
        return model::io::TerrainFile{std::move(*terrain), {}, false};
    }
    const auto *const name = std::get_if<QString>(&parsed.start);
    if (!name)
        return model::fail(model::ErrorCode::BadSetting, "terrain", "nothing", "new, open or import; or --input");
    const QString path = QFileInfo(fromUtf8(script)).dir().filePath(*name);
    if (endingOf(path.toStdString()) == QLatin1String("terrain"))
        return TerrainInput{path.toStdString()}.read(console);
    auto imported = model::io::importTerrain(path, parsed.import, console.progress("Importing"));
    if (!imported)
        return model::fail(imported.error());
    model::io::TerrainFile file{std::move(imported->terrain), {}, false};
    file.extras.step = imported->step;
    return file;
}

model::Result<void> RunScript::run(Console &console) const
{
    if (auto checked = output.check(); !checked)
        return checked;
    if (auto checked = checkOutputs({{"--output", output.path}}, {script}); !checked)
        return checked;
    model::io::FileBuffer buffer;
    const auto text = buffer.load(fromUtf8(script));
    if (!text)
        return model::fail(text.error());
    const auto parsed = model::io::parseScript({reinterpret_cast<const std::uint8_t *>(text->data()), text->size()});
    if (!parsed)
        return model::fail(model::Error(parsed.error()).in(script));
    auto file = start(console, *parsed);
    if (!file)
        return model::fail(file.error());
    const auto report = model::io::runScript(*parsed, file->terrain, console.progress("Running"));
    if (!report)
        return model::fail(model::Error(report.error()).in(script));
    return output.save(console, *file,
                       {{"strokes", double(report->strokes)},
                        {"stamps", double(report->stamps)},
                        {"transfers", double(report->transfers)},
                        {"scooped", report->scooped}},
                       QStringLiteral("strokes: %1, transfers: %2").arg(report->strokes).arg(report->transfers));
}

} // namespace

void addTerrainRun(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("run", "Play a script of tools and erosion");
    const auto options = std::make_shared<RunScript>();
    command->add_option("SCRIPT", options->script, "A JSON file: docs/terrain-script.md")->required();
    command->add_option("-i,--input", options->input, "The terrain to start from (default: as the script says)")
        ->type_name("FILE.terrain");
    options->output.addTo(*command);
    command->footer("Examples:\n"
                    "  sandreel-cli terrain run track.json -o track.terrain\n"
                    "  sandreel-cli terrain run rake.json --input garden.terrain -o raked.terrain");
    onCall(*command, options, run);
}

} // namespace cli
