// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/outputs.h"
#include "app/cli/terrain.h"
#include "model/io/terrain/terrainexport.h"
#include "model/io/terrain/terrainimport.h"
#include "model/terrain/simplify/simplifytin.h"

#include <QJsonArray>

namespace cli {

namespace {

struct Import
{
    std::string source;
    TerrainOutput output;
    model::io::TerrainImportOptions options;
    std::string noData, rawSize, rawType = "uint16";

    model::Result<void> run(Console &console);
    model::Result<void> readRawOptions();
};

model::Result<void> Import::readRawOptions()
{
    if (!rawSize.empty()) {
        const QStringList parts = fromUtf8(rawSize).split(QLatin1Char('x'));
        bool isColumns = false, isRows = false;
        if (parts.size() == 2) {
            options.raw.columns = parts[0].toUInt(&isColumns);
            options.raw.rows = parts[1].toUInt(&isRows);
        }
        if (!isColumns || !isRows)
            return model::fail(model::ErrorCode::BadSetting, "--raw-size", rawSize, "COLUMNSxROWS");
    } else if (endingOf(source) == QLatin1String("raw")) {
        return model::fail(model::ErrorCode::BadSetting, "--raw-size", "nothing", "COLUMNSxROWS, for a .raw file");
    }
    if (!noData.empty()) {
        bool isNumber = false;
        options.raster.noData = fromUtf8(noData).toDouble(&isNumber);
        if (!isNumber)
            return model::fail(model::ErrorCode::BadSetting, "--nodata", noData, "a number");
    }
    return {};
}

model::Result<void> Import::run(Console &console)
{
    if (auto checked = output.check().and_then([&] { return readRawOptions(); }); !checked)
        return checked;
    if (auto checked = checkOutputs({{"--output", output.path}}, {source}); !checked)
        return checked;
    auto imported = model::io::importTerrain(fromUtf8(source), options, console.progress("Importing"));
    if (!imported)
        return model::fail(imported.error());
    model::io::TerrainFile file{std::move(imported->terrain), {}, false};
    file.extras.step = imported->step;
    if (file.terrain.geoReference.unit.find("degree") != std::string::npos)
        console.note(QStringLiteral(
            "The coordinates are degrees and the heights are not: slopes and volumes mean nothing. Project "
            "the model first, for instance with gdalwarp."));
    return output.save(console, file,
                       {{"samples", double(imported->samples)},
                        {"voids", double(imported->voids)},
                        {"duplicates", double(imported->duplicates)},
                        {"max_error", options.maxError}},
                       QStringLiteral("from %1 samples").arg(imported->samples));
}

struct Export
{
    TerrainInput input;
    std::string target;
    model::io::TerrainExportOptions options;

    model::Result<void> run(Console &console) const;
};

model::Result<void> Export::run(Console &console) const
{
    const QString path = fromUtf8(target);
    const auto format = model::io::terrainFormatOf(path);
    if (!format)
        return model::fail(model::ErrorCode::BadSetting, "--output", target,
                           "a file that ends in ." + model::io::terrainExportEndings().join(", .").toStdString());
    if (auto checked = checkOutputs({{"--output", target}}, {input.path}); !checked)
        return checked;
    const auto file = input.read(console);
    if (!file)
        return model::fail(file.error());
    const auto exported = model::io::exportTerrain(path, *format, file->terrain, file->extras.step, options,
                                                   console.progress("Exporting"));
    if (!exported)
        return model::fail(exported.error());
    QJsonObject json{{"output", path}};
    QString text;
    switch (*format) {
    case model::io::TerrainFormat::Obj:
    case model::io::TerrainFormat::Ply:
    case model::io::TerrainFormat::Stl:
        json["vertices"] = double(exported->vertices);
        json["triangles"] = double(exported->triangles);
        text = QStringLiteral("%1 vertices, %2 triangles").arg(exported->vertices).arg(exported->triangles);
        break;
    case model::io::TerrainFormat::Png16:
        json["height_scale"] = exported->scale.scale;
        json["height_offset"] = exported->scale.offset;
        [[fallthrough]];
    case model::io::TerrainFormat::AsciiGrid:
    case model::io::TerrainFormat::GeoTiff:
        json["columns"] = double(exported->columns);
        json["rows"] = double(exported->rows);
        text = QStringLiteral("%1 x %2 cells").arg(exported->columns).arg(exported->rows);
        if (*format == model::io::TerrainFormat::Png16)
            text += QStringLiteral(", height = value * %1 + %2")
                        .arg(exported->scale.scale, 0, 'g', 12)
                        .arg(exported->scale.offset, 0, 'g', 12);
        break;
    case model::io::TerrainFormat::Contours:
        json["lines"] = double(exported->lines);
        text = QStringLiteral("%1 lines").arg(exported->lines);
        break;
    }
    console.outcome(json, QStringLiteral("%1: %2").arg(path, text));
    return {};
}

struct Simplify
{
    TerrainInput input;
    TerrainOutput output;
    double maxError = 0;

    model::Result<void> run(Console &console) const;
};

model::Result<void> Simplify::run(Console &console) const
{
    if (auto checked = output.check(); !checked)
        return checked;
    auto file = input.read(console);
    if (!file)
        return model::fail(file.error());
    const std::uint32_t before = file->terrain.tin.vertexCount();
    auto tin =
        model::terrain::simplifyTin(file->terrain.tin, maxError, model::terrain::None, console.progress("Simplifying"));
    if (!tin)
        return model::fail(tin.error());
    file->terrain.tin = std::move(*tin);
    return output.save(console, *file, {{"vertices_before", double(before)}, {"max_error", maxError}},
                       QStringLiteral("of %1 vertices").arg(before));
}

} // namespace

void addTerrainImport(CLI::App &app, Run &run)
{
    using namespace model::io;
    CLI::App *command = app.add_subcommand("import", "Turn an elevation model into a .terrain file");
    const auto options = std::make_shared<Import>();
    command
        ->add_option("SOURCE", options->source,
                     "A raster (GeoTIFF, ESRI ASCII grid, 16-bit PNG, RAW and others), points\n"
                     "(.xyz, .txt, .csv, .pts) or a mesh (.obj, .ply, .stl)")
        ->required();
    options->output.addTo(*command);
    command
        ->add_option(
            "--max-error", options->options.maxError,
            "The farthest that the terrain may lie from any sample, vertically (default: 0,\nevery sample is kept)")
        ->check(finiteRange(0, 1e9))
        ->type_name("METRES");
    command->add_option("--nodata", options->noData, "The value of cells that are void (default: as the file says)")
        ->type_name("VALUE");
    command
        ->add_option("--cell", options->options.raster.cellSize,
                     "Size of a cell, for files that do not say (default: 1)")
        ->check(finiteRange(1e-9, 1e9))
        ->type_name("METRES");
    command
        ->add_option("--height-scale", options->options.raster.heightScale,
                     "Heights are multiplied by this (0.3048: feet)")
        ->check(finiteRange(-1e9, 1e9))
        ->type_name("FACTOR");
    command->add_option("--height-offset", options->options.raster.heightOffset, "Then this is added to them")
        ->check(finiteRange(-1e9, 1e9))
        ->type_name("METRES");
    command->add_option("--band", options->options.raster.band, "Band of a raster, counted from 1")
        ->check(CLI::PositiveNumber)
        ->type_name("N");
    command->add_option("--crs", options->options.crs, "Coordinate system, for files that do not say: EPSG:5514 or WKT")
        ->type_name("CRS");
    const std::map<std::string, UpAxis> axes{{"z", UpAxis::Z}, {"y", UpAxis::Y}};
    command->add_option("--up", options->options.up, "Which axis of a mesh is up (default: z)")
        ->transform(CLI::CheckedTransformer(axes, CLI::ignore_case).description(""))
        ->type_name("z|y");
    command->add_option("--raw-size", options->rawSize, "Size of a .raw file")->type_name("COLUMNSxROWS");
    const std::map<std::string, RawType> types{{"uint8", RawType::Uint8},     {"uint16", RawType::Uint16},
                                               {"int16", RawType::Int16},     {"uint32", RawType::Uint32},
                                               {"float32", RawType::Float32}, {"float64", RawType::Float64}};
    command->add_option("--raw-type", options->options.raw.type, "Its numbers (default: uint16)")
        ->transform(CLI::CheckedTransformer(types, CLI::ignore_case).description(""))
        ->type_name("uint8|uint16|int16|uint32|float32|float64");
    command->add_flag("--raw-big-endian", options->options.raw.isBigEndian, "Their highest byte is first");
    command->footer(
        "Examples:\n"
        "  sandreel-cli terrain import dem.tif -o dem.terrain --max-error 0.5\n"
        "  sandreel-cli terrain import feet.png -o hills.terrain --cell 90 --height-scale 0.3048 --max-error 5\n"
        "  sandreel-cli terrain import scan.xyz -o scan.terrain --crs EPSG:5514\n"
        "  sandreel-cli terrain import hill.obj -o hill.terrain --up y");
    onCall(*command, options, run);
}

void addTerrainExport(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("export", "Write a terrain for other programs");
    const auto options = std::make_shared<Export>();
    options->input.addTo(*command);
    command
        ->add_option("-o,--output", options->target,
                     "A mesh (.obj, .ply, .stl), a raster (.asc, .tif, .png with 16 bits) or contours\n"
                     "(.geojson)")
        ->required()
        ->type_name("FILE");
    command->add_option("--cell", options->options.cell, "Cell of a raster (default: that of the import)")
        ->check(finiteRange(1e-9, 1e9))
        ->type_name("METRES");
    command->add_option("--interval", options->options.interval, "Between contours (default: 10)")
        ->check(finiteRange(1e-9, 1e9))
        ->type_name("METRES");
    command->add_flag("--world", options->options.isWorld, "Meshes in world coordinates (.obj, .ply)");
    command->footer("Examples:\n"
                    "  sandreel-cli terrain export hills.terrain -o hills.tif --cell 10\n"
                    "  sandreel-cli terrain export hills.terrain -o hills.ply --world\n"
                    "  sandreel-cli terrain export hills.terrain -o lines.geojson --interval 5");
    onCall(*command, options, run);
}

void addTerrainSimplify(CLI::App &app, Run &run)
{
    CLI::App *command = app.add_subcommand("simplify", "Take out vertices that the surface does not need");
    const auto options = std::make_shared<Simplify>();
    options->input.addTo(*command);
    options->output.addTo(*command);
    command->add_option("--max-error", options->maxError, "The farthest that the surface may move anywhere, vertically")
        ->check(finiteRange(0, 1e9))
        ->required()
        ->type_name("METRES");
    onCall(*command, options, run);
}

} // namespace cli
