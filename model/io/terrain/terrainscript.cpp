// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/terrainscript.h"

#include "model/io/terrain/script/scripttools.h"
#include "model/terrain/simplify/simplifytin.h"

#include <QJsonDocument>

#include <algorithm>
#include <cmath>

namespace model::io {

using namespace terrain;

namespace {

constexpr std::uint32_t MostRepetitions = 1'000'000;
constexpr int DeepestRepeat = 8;

std::vector<ScriptStep> readSteps(ScriptObject &object, int depth);

ErosionStep readErosionStep(ScriptObject object, bool isTimed)
{
    ErosionStep step;
    if (isTimed) {
        step.seconds = object.number("seconds", 1, 0, 1e9);
        const double transfers = object.number("transfers", 0, 0, 1e18);
        if (transfers > 0)
            step.budget.transfers = std::uint64_t(transfers);
    }
    step.settings = readErosion(object);
    object.finish();
    return step;
}

ScriptStep readStep(const QJsonValue &value, const std::string &path, ScriptErrors &errors, int depth)
{
    ScriptObject object(value, path, errors);
    if (object.has("stroke")) {
        ScriptObject stroke = object.object("stroke");
        StrokeStep step{readStroke(stroke), std::nullopt};
        if (stroke.has("owner"))
            step.owner = stroke.count("owner", 0, 0, VoidOwner - 1);
        stroke.finish();
        object.finish();
        return step;
    }
    if (object.has("erode") || object.has("settle")) {
        const bool isTimed = object.has("erode");
        ErosionStep step = readErosionStep(object.object(isTimed ? "erode" : "settle"), isTimed);
        object.finish();
        return step;
    }
    if (object.has("material")) {
        MaterialStep step;
        QJsonObject material = object.take("material").toObject();
        ScriptObject index(material, object.pathOf("material"), errors);
        step.index = index.count("index", 0, 0, std::uint32_t(LargestMaterialList) - 1);
        material.remove("index");
        step.material = readScriptMaterial(material, object.pathOf("material"), errors);
        object.finish();
        return step;
    }
    if (object.has("add_layer")) {
        ScriptObject layer = object.object("add_layer");
        AddLayerStep step;
        if (layer.has("layer"))
            step.layer = layer.count("layer", 0, 0, MaxLayers);
        if (layer.isNumber("material") || !layer.has("material"))
            step.material = layer.count("material", 0, 0, std::uint32_t(LargestMaterialList) - 1);
        else
            step.material = readScriptMaterial(layer.take("material"), layer.pathOf("material"), errors);
        step.sample.thickness = layer.number("thickness", 0, 0, 1e9);
        step.sample.humidity = float(layer.number("humidity", 0, 0, 1));
        layer.finish();
        object.finish();
        return step;
    }
    if (object.has("remove_layer")) {
        const RemoveLayerStep step{object.count("remove_layer", 0, 0, MaxLayers - 1)};
        object.finish();
        return step;
    }
    if (object.has("simplify")) {
        ScriptObject simplify = object.object("simplify");
        const SimplifyStep step{simplify.number("max_error", 0, 0, 1e9)};
        simplify.finish();
        object.finish();
        return step;
    }
    if (object.has("validate")) {
        object.flag("validate", true);
        object.finish();
        return ValidateStep{};
    }
    if (object.has("repeat")) {
        RepeatStep step;
        step.count = object.count("repeat", 1, 0, MostRepetitions);
        if (depth == DeepestRepeat)
            errors.report(path, value, "at most 8 repeats in one another");
        else
            step.steps = readSteps(object, depth + 1);
        object.finish();
        return step;
    }
    errors.report(path, value,
                  "stroke, erode, settle, material, add_layer, remove_layer, simplify, validate or repeat");
    return ValidateStep{};
}

std::vector<ScriptStep> readSteps(ScriptObject &object, int depth)
{
    std::vector<ScriptStep> steps;
    object.forEach("steps", [&](const QJsonValue &value, const std::string &path) {
        if (object.errors().isEmpty())
            steps.push_back(readStep(value, path, object.errors(), depth));
    });
    return steps;
}

NewTerrain readNew(ScriptObject object)
{
    NewTerrain result;
    const std::vector<double> size = object.numbers("size", 2, {100, 100}),
                              origin = object.numbers("origin", 2, {0, 0});
    result.width = size[0];
    result.depth = size[1];
    if (!(result.width > 0 && result.depth > 0))
        object.errors().report(object.pathOf("size"), QJsonArray{size[0], size[1]}, "above 0");
    result.originX = origin[0];
    result.originY = origin[1];
    result.height = object.number("height", 0);
    result.spacing = object.number("spacing", 0, 0);
    object.forEach("layers", [&](const QJsonValue &value, const std::string &path) {
        ScriptObject layer(value, path, object.errors());
        NewTerrain::Layer read;
        read.thickness = layer.number("thickness", 1, 0, 1e9);
        read.material = readScriptMaterial(layer.take("material"), layer.pathOf("material"), object.errors());
        layer.finish();
        result.layers.push_back(std::move(read));
    });
    object.finish();
    return result;
}

void readStart(ScriptObject object, TerrainScript &script)
{
    if (object.has("new")) {
        script.start = readNew(object.object("new"));
    } else if (object.has("open") || object.has("import")) {
        const char *const key = object.has("open") ? "open" : "import";
        script.start = QString::fromStdString(object.text(key));
        script.import.maxError = object.number("max_error", 0, 0, 1e9);
        script.import.raster.cellSize = object.number("cell", 1, 1e-9, 1e9);
        script.import.raster.heightScale = object.number("height_scale", 1);
        script.import.raster.noData = object.optionalNumber("nodata");
    } else {
        object.errors().report(object.path(), QJsonValue(), "new, open or import");
    }
    object.finish();
}

/// Carries out steps, and knows where in the script it is.
class Player
{
public:
    Player(Terrain &terrain, const Progress &progress)
        : mTerrain(terrain)
        , mProgress(progress)
    {}

    Result<void> play(const std::vector<ScriptStep> &steps, const std::string &path, bool isTop)
    {
        for (std::size_t i = 0; i < steps.size(); ++i) {
            if (mProgress.isCancelled())
                return fail(ErrorCode::Cancelled);
            const std::string at = path + "steps[" + std::to_string(i) + "]";
            if (auto done = std::visit([&](const auto &step) { return carryOut(step, at); }, steps[i]); !done)
                return done;
            if (isTop)
                mProgress.report(double(i + 1) / double(steps.size()));
        }
        return {};
    }

    const ScriptReport &report() const { return mReport; }

private:
    static tl::unexpected<Error> failAt(const std::string &path, Error error)
    {
        if (error.code == ErrorCode::BadSetting && !error.args.empty())
            error.args[0] = path + ": " + error.args[0];
        return fail(std::move(error));
    }

    Point2 inDomain(Point2 p) const
    {
        const Rectangle &domain = mTerrain.tin.domain();
        return {std::clamp(p.x, domain.low.x, domain.high.x), std::clamp(p.y, domain.low.y, domain.high.y)};
    }

    Result<void> carryOut(const StrokeStep &step, const std::string &path)
    {
        Stroke stroke = step.stroke;
        if (auto *const restore = std::get_if<Restore>(&stroke.tool)) {
            if (!mStart)
                mStart = std::make_shared<const Tin>(mTerrain.tin);
            restore->reference.tin = mStart;
        } else if (!mStart) {
            // The terrain as the script found it, for a restore that comes later.
            mStart = std::make_shared<const Tin>(mTerrain.tin);
        }
        if (auto *const imprint = std::get_if<Imprint>(&stroke.tool); imprint && imprint->isRimOfMaterial)
            if (const Material *const material = mTerrain.topMaterialAt(inDomain(stroke.path.front().at)))
                imprint->rim = rimOf(*material, imprint->rim);
        auto done = draw(mTerrain.tin, stroke, step.owner.value_or(terrain::None), mMemory);
        if (!done)
            return failAt(path, done.error());
        ++mReport.strokes;
        mReport.stamps += done->report.stamps;
        if (std::holds_alternative<Scoop>(stroke.tool))
            mReport.scooped += done->report.removed;
        return {};
    }

    Result<void> carryOut(const ErosionStep &step, const std::string &path)
    {
        auto erosion = Erosion::create(step.settings, mTerrain.materials);
        if (!erosion)
            return failAt(path, erosion.error());
        TinEdit edit(mTerrain.tin);
        Result<ErosionStatistics> done = fail(ErrorCode::Cancelled);
        if (step.seconds) {
            erosion->activateAll(mTerrain.tin);
            done = erosion->run(edit, *step.seconds, step.budget);
        } else {
            done = erosion->settle(edit, mProgress.part(0, 0));
        }
        if (!done)
            return failAt(path, done.error());
        mReport.transfers += done->transfers;
        edit.commit();
        return {};
    }

    Result<void> carryOut(const MaterialStep &step, const std::string &path)
    {
        if (step.index > mTerrain.materials.size())
            return fail(ErrorCode::BadSetting, path + ".material.index", std::to_string(step.index),
                        "at most " + std::to_string(mTerrain.materials.size()));
        mTerrain.materials.resize(std::max<std::size_t>(mTerrain.materials.size(), step.index + std::size_t(1)));
        mTerrain.materials[step.index] = step.material;
        return {};
    }

    /// In the list of materials; its length if it is not there.
    std::size_t placeOf(const Material &material) const
    {
        const auto &list = mTerrain.materials;
        return std::size_t(std::find(list.begin(), list.end(), material) - list.begin());
    }

    Result<void> carryOut(const AddLayerStep &step, const std::string &path)
    {
        const std::uint32_t layers = mTerrain.tin.arrays().layerCount(), layer = step.layer.value_or(layers);
        if (layers == MaxLayers || layer > layers)
            return fail(ErrorCode::BadSetting, path + ".add_layer.layer", std::to_string(layer),
                        "at most " + std::to_string(std::min(layers, MaxLayers - 1)));
        const auto *const named = std::get_if<Material>(&step.material);
        const std::size_t place = named ? placeOf(*named) : std::get<std::uint32_t>(step.material);
        if (place >= (named ? LargestMaterialList : mTerrain.materials.size()))
            return fail(ErrorCode::BadSetting, path + ".add_layer.material", std::to_string(place),
                        "below " + std::to_string(named ? LargestMaterialList : mTerrain.materials.size()));
        if (place == mTerrain.materials.size())
            mTerrain.materials.push_back(*named);
        TinEdit edit(mTerrain.tin);
        edit.addLayer(layer, std::uint8_t(place));
        for (VertexId v = 0; v < mTerrain.tin.arrays().vertexSlots(); ++v)
            if (mTerrain.tin.arrays().isVertex(v))
                edit.setLayer(v, layer, step.sample);
        edit.commit();
        return {};
    }

    Result<void> carryOut(const RemoveLayerStep &step, const std::string &path)
    {
        const std::uint32_t layers = mTerrain.tin.arrays().layerCount();
        if (step.layer >= layers)
            return fail(ErrorCode::BadSetting, path + ".remove_layer", std::to_string(step.layer),
                        "below " + std::to_string(layers));
        TinEdit edit(mTerrain.tin);
        edit.removeLayer(step.layer);
        edit.commit();
        return {};
    }

    Result<void> carryOut(const SimplifyStep &step, const std::string &)
    {
        Result<Tin> tin = simplifyTin(mTerrain.tin, step.maxError, terrain::None, mProgress.part(0, 0));
        if (!tin)
            return fail(tin.error());
        mTerrain.tin = std::move(*tin);
        return {};
    }

    Result<void> carryOut(const ValidateStep &, const std::string &) { return validate(mTerrain); }

    Result<void> carryOut(const RepeatStep &step, const std::string &path)
    {
        for (std::uint32_t i = 0; i < step.count; ++i)
            if (auto done = play(step.steps, path + '.', false); !done)
                return done;
        return {};
    }

    Terrain &mTerrain;
    const Progress mProgress;
    ScriptReport mReport;
    ToolMemory mMemory;
    std::shared_ptr<const Tin> mStart;
};

} // namespace

Result<TerrainScript> parseScript(std::span<const std::uint8_t> json)
{
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(
        QByteArray(reinterpret_cast<const char *>(json.data()), qsizetype(json.size())), &error);
    if (error.error != QJsonParseError::NoError)
        return fail(fail(ErrorCode::SyntaxError, "JSON", error.errorString().toStdString())
                        .value()
                        .atByte(std::uint64_t(error.offset)));
    ScriptErrors errors;
    TerrainScript script;
    ScriptObject object(document.isObject() ? QJsonValue(document.object()) : QJsonValue(document.array()), "", errors);
    if (object.has("terrain"))
        readStart(object.object("terrain"), script);
    object.text("comment");
    script.steps = readSteps(object, 0);
    object.finish();
    if (!errors.isEmpty())
        return fail(errors.first());
    return script;
}

Result<ScriptReport> runScript(const TerrainScript &script, Terrain &terrain, const Progress &progress)
{
    Player player(terrain, progress);
    if (auto done = player.play(script.steps, "", true); !done)
        return fail(done.error());
    return player.report();
}

} // namespace model::io
