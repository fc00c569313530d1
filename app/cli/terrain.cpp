// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/terrain.h"

#include "app/cli/outputs.h"
#include "model/io/terrain/newterrain.h"
#include "model/terrain/tin/build/restoretin.h"
#include "model/terrain/tin/validate.h"

#include <QFileInfo>
#include <QJsonArray>

#include <algorithm>
#include <cmath>

namespace cli {

using namespace model::terrain;

void TerrainInput::addTo(CLI::App &command)
{
    command.add_option("FILE", path, "A .terrain file")->required();
}

model::Result<model::io::TerrainFile> TerrainInput::read(Console &console) const
{
    auto file = model::io::openTerrain(fromUtf8(path), console.progress("Reading"));
    if (file && file->isNewer)
        console.note(QStringLiteral("%1 comes of a newer program; saving it may lose what this one does not know.")
                         .arg(fromUtf8(path)));
    return file;
}

void TerrainOutput::addTo(CLI::App &command)
{
    command.add_option("-o,--output", path, "The .terrain file to write")->required()->type_name("FILE.terrain");
}

model::Result<void> TerrainOutput::check() const
{
    if (endingOf(path) != QLatin1String("terrain"))
        return model::fail(model::ErrorCode::BadSetting, "--output", path, "a file that ends in .terrain");
    return checkOutputs({{"--output", path}}, {});
}

model::Result<void> TerrainOutput::save(Console &console, const model::io::TerrainFile &file, QJsonObject json,
                                        const QString &text) const
{
    const QString target = fromUtf8(path);
    if (auto saved = model::io::saveTerrain(target, file.terrain, file.extras, console.progress("Writing")); !saved)
        return saved;
    const double bytes = double(QFileInfo(target).size());
    json["output"] = target;
    json["bytes"] = bytes;
    json["vertices"] = double(file.terrain.tin.vertexCount());
    json["triangles"] = double(file.terrain.tin.triangleCount());
    console.outcome(json, QStringLiteral("%1: %2 vertices, %3%4")
                              .arg(target)
                              .arg(file.terrain.tin.vertexCount())
                              .arg(sizeText(bytes), text.isEmpty() ? text : QStringLiteral(", ") + text));
    return {};
}

namespace {

struct New
{
    TerrainOutput output;
    std::vector<double> size{100, 100}, origin{0, 0};
    double height = 0, spacing = 0;
    std::vector<std::string> layers;

    model::Result<void> run(Console &console) const;
};

/// `NAME:THICKNESS`
model::Result<model::io::NewTerrain::Layer> layerOf(const std::string &text)
{
    const std::size_t colon = text.rfind(':');
    bool isNumber = false;
    const double thickness = colon == text.npos ? 0 : fromUtf8(text.substr(colon + 1)).toDouble(&isNumber);
    for (const MaterialPreset preset : EveryMaterialPreset)
        if (colon != text.npos && text.substr(0, colon) == nameOf(preset) && isNumber && thickness >= 0 &&
            std::isfinite(thickness))
            return model::io::NewTerrain::Layer{material(preset), thickness};
    std::string names;
    for (const MaterialPreset preset : EveryMaterialPreset)
        names += std::string(names.empty() ? "" : ", ") + nameOf(preset);
    return model::fail(model::ErrorCode::BadSetting, "--layer", text, "MATERIAL:METRES with one of " + names);
}

model::Result<void> New::run(Console &console) const
{
    if (auto checked = output.check(); !checked)
        return checked;
    model::io::NewTerrain description{size[0], size[1], origin[0], origin[1], height, spacing, {}};
    for (const std::string &text : layers) {
        auto layer = layerOf(text);
        if (!layer)
            return model::fail(layer.error());
        description.layers.push_back(std::move(*layer));
    }
    auto terrain = model::io::makeTerrain(description);
    if (!terrain)
        return model::fail(terrain.error());
    const model::io::TerrainFile file{std::move(*terrain), {}, false};
    return output.save(console, file, {}, {});
}

struct Info
{
    TerrainInput input;
    model::Result<void> run(Console &console) const;
};

double areaOfGround(const TinArrays &tin)
{
    CompensatedSum sum;
    for (TriangleId t = 0; t < tin.triangleSlots(); ++t)
        if (tin.isTriangle(t) && !tin.isVoid(t))
            sum.add(areaOf(tin, t));
    return sum.value();
}

model::Result<void> Info::run(Console &console) const
{
    const auto file = input.read(console);
    if (!file)
        return model::fail(file.error());
    const Terrain &terrain = file->terrain;
    const TinArrays &tin = terrain.tin.arrays();
    const Rectangle domain = terrain.tin.domain();
    const GeoReference &place = terrain.geoReference;
    double lowest = INFINITY, highest = -INFINITY;
    std::uint32_t voids = 0;
    for (TriangleId t = 0; t < tin.triangleSlots(); ++t) {
        if (!tin.isTriangle(t))
            continue;
        voids += tin.isVoid(t);
        for (Corner c = cornerOf(t, 0); !tin.isVoid(t) && c <= cornerOf(t, 2); ++c) {
            lowest = std::min(lowest, tin.heights[tin.vertex(c)]);
            highest = std::max(highest, tin.heights[tin.vertex(c)]);
        }
    }
    const double bytes = double(QFileInfo(fromUtf8(input.path)).size());
    const double west = place.originX + domain.low.x, south = place.originY + domain.low.y;
    const double width = domain.high.x - domain.low.x, depth = domain.high.y - domain.low.y;
    const std::size_t constraints = constrainedEdges(tin).size();
    QJsonArray layers;
    QStringList layerTexts;
    for (std::uint32_t l = 0; l < tin.layerCount(); ++l) {
        const double volume = terrain.tin.layerVolume(l);
        layers.append(QJsonObject{{"material", fromUtf8(terrain.materialOf(l).name)}, {"volume", volume}});
        layerTexts << QStringLiteral("%1 %2 m3").arg(fromUtf8(terrain.materialOf(l).name)).arg(volume, 0, 'g', 6);
    }
    const QJsonObject json{
        {"vertices", double(terrain.tin.vertexCount())},
        {"triangles", double(terrain.tin.triangleCount())},
        {"void_triangles", double(voids)},
        {"constraints", double(constraints)},
        {"bytes", bytes},
        {"bytes_per_vertex", bytes / terrain.tin.vertexCount()},
        {"area", areaOfGround(tin)},
        {"lowest", lowest},
        {"highest", highest},
        {"origin", QJsonArray{place.originX, place.originY}},
        {"box", QJsonObject{{"min", QJsonArray{west, south}}, {"max", QJsonArray{west + width, south + depth}}}},
        {"unit", fromUtf8(place.unit)},
        {"crs", fromUtf8(place.crs)},
        {"layers", layers}};
    const QString crs = fromUtf8(place.crs);
    const qsizetype nameBegin = crs.indexOf(QLatin1Char('"')) + 1;
    QStringList text{
        QStringLiteral("vertices      %1").arg(terrain.tin.vertexCount()),
        QStringLiteral("triangles     %1, %2 of them void").arg(terrain.tin.triangleCount()).arg(voids),
        QStringLiteral("constraints   %1").arg(constraints),
        QStringLiteral("extent        %1 x %2, from %3, %4 (%5)")
            .arg(width, 0, 'g', 12)
            .arg(depth, 0, 'g', 12)
            .arg(west, 0, 'f', 3)
            .arg(south, 0, 'f', 3)
            .arg(fromUtf8(place.unit)),
        QStringLiteral("heights       %1 ... %2").arg(lowest).arg(highest),
        QStringLiteral("system        %1")
            .arg(crs.isEmpty() ? QStringLiteral("unknown")
                               : crs.mid(nameBegin, crs.indexOf(QLatin1Char('"'), nameBegin) - nameBegin)),
        QStringLiteral("layers        %1").arg(layerTexts.isEmpty() ? QStringLiteral("none") : layerTexts.join(", ")),
        QStringLiteral("file          %1, %2 bytes a vertex")
            .arg(sizeText(bytes))
            .arg(bytes / terrain.tin.vertexCount(), 0, 'f', 2)};
    console.data(json, text);
    return {};
}

struct Validate
{
    TerrainInput input;
    model::Result<void> run(Console &console) const;
};

model::Result<void> Validate::run(Console &console) const
{
    const auto file = input.read(console);
    if (!file)
        return model::fail(file.error());
    if (auto valid = model::terrain::validate(file->terrain); !valid)
        return model::fail(std::move(valid).error().in(input.path));
    console.data(
        {{"valid", true}, {"vertices", double(file->terrain.tin.vertexCount())}},
        {QStringLiteral("%1: valid, %2 vertices").arg(fromUtf8(input.path)).arg(file->terrain.tin.vertexCount())});
    return {};
}

struct Volume
{
    TerrainInput input;
    model::Result<void> run(Console &console) const;
};

model::Result<void> Volume::run(Console &console) const
{
    const auto file = input.read(console);
    if (!file)
        return model::fail(file.error());
    const Tin &tin = file->terrain.tin;
    const Ledger &ledger = tin.ledger();
    const double volume = tin.volume(), expected = ledger.expected();
    // Against what there is and what was handled: a terrain dug down to nothing still has its rounding.
    const double scale = std::max(
        {std::abs(volume), std::abs(ledger.start), ledger.added.value(), ledger.removed.value(), ledger.moved.value()});
    const double drift = scale > 0 ? std::abs(volume - expected) / scale : 0;
    const double area = areaOfGround(tin.arrays());
    const auto line = [](const char *name, double value, const char *unit) {
        return QStringLiteral("%1 %2 %3").arg(QLatin1String(name), -13).arg(value, 0, 'g', 15).arg(QLatin1String(unit));
    };
    console.data({{"volume", volume},
                  {"area", area},
                  {"added", ledger.added.value()},
                  {"removed", ledger.removed.value()},
                  {"moved", ledger.moved.value()},
                  {"pressed", ledger.pressed.value()},
                  {"drift_relative", drift}},
                 {line("volume", volume, "m3 above height 0"), line("area", area, "m2"),
                  line("added", ledger.added.value(), "m3"), line("removed", ledger.removed.value(), "m3"),
                  line("moved", ledger.moved.value(), "m3"), line("pressed", ledger.pressed.value(), "m3"),
                  line("drift", drift, "of it")});
    return {};
}

} // namespace

void addTerrainNew(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("new", "Make a flat terrain");
    const auto options = std::make_shared<New>();
    options->output.addTo(*command);
    command->add_option("--size", options->size, "Width and depth in metres (default: 100 100)")
        ->expected(2)
        ->check(finiteRange(1e-6, 1e9))
        ->type_name("W H");
    command->add_option("--origin", options->origin, "Where its corner lies in the world (default: 0 0)")
        ->expected(2)
        ->check(finiteRange(-1e12, 1e12))
        ->type_name("X Y");
    command->add_option("--height", options->height, "Height of the surface (default: 0)")
        ->check(finiteRange(-1e9, 1e9))
        ->type_name("Z");
    command->add_option("--spacing", options->spacing, "A vertex each so many metres (default: the four corners)")
        ->check(finiteRange(1e-6, 1e9))
        ->type_name("METRES");
    command
        ->add_option("--layer", options->layers,
                     "A layer of a material and its thickness; once for each, from the bedrock up\n"
                     "(dry sand, moist sand, mud, snow, gravel)")
        ->allow_extra_args(false)
        ->type_name("MATERIAL:METRES");
    command->footer(
        "Examples:\n"
        "  sandreel-cli terrain new -o box.terrain --size 10 10 --layer \"dry sand:1\"\n"
        "  sandreel-cli terrain new -o field.terrain --size 500 300 --spacing 2 --layer gravel:2 --layer snow:0.5");
    onCall(*command, options, run);
}

void addTerrainInfo(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("info", "Say what a terrain holds");
    const auto options = std::make_shared<Info>();
    options->input.addTo(*command);
    onCall(*command, options, run);
}

void addTerrainValidate(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("validate", "Check every rule that a terrain has to keep");
    const auto options = std::make_shared<Validate>();
    options->input.addTo(*command);
    command->footer("Exit code 0: valid; 3: not, and the first broken rule on standard error.");
    onCall(*command, options, run);
}

void addTerrainVolume(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("volume", "Measure a terrain, and what its ledger says of the edits");
    const auto options = std::make_shared<Volume>();
    options->input.addTo(*command);
    onCall(*command, options, run);
}

void addTerrain(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("terrain", "Make, import, change, measure and export terrains");
    command->require_subcommand(1);
    addTerrainNew(*command, run);
    addTerrainImport(*command, run);
    addTerrainExport(*command, run);
    addTerrainSimplify(*command, run);
    addTerrainInfo(*command, run);
    addTerrainValidate(*command, run);
    addTerrainVolume(*command, run);
    addTerrainRun(*command, run);
}

} // namespace cli
