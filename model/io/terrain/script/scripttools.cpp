// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/script/scripttools.h"

#include "model/io/terrain/materialjson.h"
#include "model/terrain/tools/svgpath.h"

namespace model::io {

using namespace terrain;

namespace {

/// The error of a check that knows the setting, with the way to it.
void report(ScriptErrors &errors, const std::string &path, const Result<void> &checked)
{
    if (checked)
        return;
    Error error = checked.error();
    if (error.args.empty())
        error.args.emplace_back();
    error.args[0] = path + (error.args[0].empty() ? "" : ": ") + error.args[0];
    errors.report(std::move(error));
}

Mask readMask(ScriptObject object)
{
    Mask mask;
    mask.lowestSlope = object.number("lowest_slope", mask.lowestSlope);
    mask.highestSlope = object.number("highest_slope", mask.highestSlope);
    mask.slopeBlend = object.number("slope_blend", mask.slopeBlend);
    mask.lowestHeight = object.number("lowest_height", mask.lowestHeight);
    mask.highestHeight = object.number("highest_height", mask.highestHeight);
    mask.heightBlend = object.number("height_blend", mask.heightBlend);
    object.finish();
    return mask;
}

Brush readBrush(ScriptObject &object)
{
    Brush brush;
    brush.radius = object.number("radius", brush.radius);
    brush.falloff = Falloff(
        object.choice("falloff", std::size_t(brush.falloff), {"constant", "linear", "smooth", "sphere", "tip"}));
    brush.spacing = object.number("spacing", brush.spacing);
    brush.detail = object.number("detail", brush.detail);
    brush.doesPressureScaleRadius = object.flag("pressure_scales_radius", brush.doesPressureScaleRadius);
    brush.doesPressureScaleStrength = object.flag("pressure_scales_strength", brush.doesPressureScaleStrength);
    brush.mask = readMask(object.object("mask"));
    return brush;
}

Outline readOutline(ScriptObject &object)
{
    const QJsonValue value = object.take("outline");
    const std::string path = object.pathOf("outline");
    if (value.isUndefined() || value == QLatin1String("disc"))
        return Outline::disc();
    if (value == QLatin1String("square"))
        return Outline::square();
    if (value == QLatin1String("wedge"))
        return Outline::wedge();
    Result<Outline> outline = fail(ErrorCode::Cancelled);
    if (value.isArray()) {
        std::vector<Point2> points;
        const QJsonArray list = value.toArray();
        for (const QJsonValue &point : list)
            points.push_back({point[0].toDouble(std::numeric_limits<double>::quiet_NaN()),
                              point[1].toDouble(std::numeric_limits<double>::quiet_NaN())});
        outline = Outline::polygon(std::move(points));
    } else if (value.isString()) {
        outline = outlineFromSvgPath(value.toString().toStdString());
    }
    if (outline)
        return *outline;
    if (outline.error().code == ErrorCode::Cancelled)
        object.errors().report(path, value, "disc, square, wedge, SVG path data or a list of points");
    else
        report(object.errors(), path, fail(outline.error()));
    return Outline::disc();
}

Imprint readImprint(ScriptObject &object)
{
    Imprint tool;
    tool.outline = readOutline(object);
    tool.radius = object.number("radius", tool.radius);
    tool.depth = object.number("depth", tool.depth);
    tool.level = object.optionalNumber("level");
    tool.gap = object.number("gap", tool.gap);
    tool.spacing = object.number("spacing", tool.spacing);
    tool.rotation = object.number("rotation", tool.rotation);
    tool.doesFollowDirection = object.flag("follows_direction", tool.doesFollowDirection);
    tool.doesPressureScaleDepth = object.flag("pressure_scales_depth", tool.doesPressureScaleDepth);
    tool.isRimOfMaterial = !object.has("rim");
    ScriptObject rim = object.object("rim");
    tool.rim.criticalAngle = rim.number("critical_angle", tool.rim.criticalAngle);
    tool.rim.compressibility = rim.number("compressibility", tool.rim.compressibility);
    tool.rim.crest = rim.number("crest", tool.rim.crest);
    tool.rim.directedSpeed = rim.number("directed_speed", tool.rim.directedSpeed);
    rim.finish();
    tool.mask = readMask(object.object("mask"));
    return tool;
}

Rake readRake(ScriptObject &object)
{
    Rake tool;
    tool.width = object.number("width", tool.width);
    tool.tines = object.count("tines", tool.tines, 1, 1000);
    tool.depth = object.number("depth", tool.depth);
    tool.spacing = object.number("spacing", tool.spacing);
    tool.mask = readMask(object.object("mask"));
    return tool;
}

Breakline readBreakline(ScriptObject &object)
{
    Breakline tool;
    tool.spacing = object.number("spacing", tool.spacing);
    tool.height = object.optionalNumber("height");
    tool.crossing = Crossing(object.choice("crossing", std::size_t(tool.crossing), {"refuse", "release", "split"}));
    return tool;
}

/// A tool of a brush and some numbers.
template <class T>
T brushed(ScriptObject &object, std::initializer_list<std::pair<const char *, double T::*>> numbers)
{
    T tool;
    tool.brush = readBrush(object);
    for (const auto &[key, member] : numbers)
        tool.*member = object.number(key, tool.*member);
    return tool;
}

constexpr const char *ToolNames[] = {"imprint", "rake", "raise",   "lower", "flatten",   "smooth", "noise",
                                     "ramp",    "pour", "restore", "scoop", "breakline", "moisten"};

Tool readTool(ScriptObject &object)
{
    if (!object.has("tool"))
        object.errors().report(object.pathOf("tool"), QJsonValue(QJsonValue::Undefined), "the name of a tool");
    const std::string name =
        ToolNames[object.choice("tool", 0, std::vector<const char *>(std::begin(ToolNames), std::end(ToolNames)))];
    if (name == "rake")
        return readRake(object);
    if (name == "raise")
        return brushed<Raise>(object, {{"height", &Raise::height}});
    if (name == "lower")
        return brushed<Lower>(object, {{"depth", &Lower::depth}});
    if (name == "flatten") {
        Flatten tool = brushed<Flatten>(object, {{"strength", &Flatten::strength}});
        tool.level = object.optionalNumber("level");
        return tool;
    }
    if (name == "smooth")
        return brushed<Smooth>(object, {{"strength", &Smooth::strength}});
    if (name == "noise") {
        Noise tool = brushed<Noise>(object, {{"amplitude", &Noise::amplitude}, {"wavelength", &Noise::wavelength}});
        tool.octaves = object.count("octaves", tool.octaves, 0, 100);
        tool.seed = object.count("seed", tool.seed, 0, 0xffffffff);
        return tool;
    }
    if (name == "ramp") {
        Ramp tool;
        tool.brush = readBrush(object);
        tool.from = object.optionalNumber("from");
        tool.to = object.optionalNumber("to");
        return tool;
    }
    if (name == "pour")
        return brushed<Pour>(object, {{"volume", &Pour::volume}});
    if (name == "restore")
        return brushed<Restore>(object, {{"strength", &Restore::strength}});
    if (name == "scoop")
        return brushed<Scoop>(object, {{"depth", &Scoop::depth}});
    if (name == "breakline")
        return readBreakline(object);
    if (name == "moisten")
        return brushed<Moisten>(object, {{"humidity", &Moisten::humidity}, {"strength", &Moisten::strength}});
    return readImprint(object);
}

Symmetry readSymmetry(ScriptObject object)
{
    Symmetry symmetry;
    symmetry.kind = Symmetry::Kind(object.choice("kind", 0, {"off", "mirror x", "mirror y", "mirror both", "radial"}));
    const std::vector<double> centre = object.numbers("centre", 2, {0, 0});
    symmetry.centre = {centre[0], centre[1]};
    symmetry.copies = object.count("copies", symmetry.copies, 1, 64);
    object.finish();
    return symmetry;
}

} // namespace

Stroke readStroke(ScriptObject &object)
{
    Stroke stroke{readTool(object), {}, {}};
    object.forEach("path", [&](const QJsonValue &value, const std::string &path) {
        const QJsonArray numbers = value.toArray();
        const bool isPoint =
            numbers.size() >= 2 && numbers.size() <= 4 &&
            std::all_of(numbers.begin(), numbers.end(), [](const QJsonValue &n) { return n.isDouble(); });
        if (!isPoint)
            return object.errors().report(path, value, "[x, y], [x, y, pressure] or [x, y, pressure, speed]");
        stroke.path.push_back(
            {{numbers[0].toDouble(), numbers[1].toDouble()}, numbers[2].toDouble(1), numbers[3].toDouble(0)});
    });
    stroke.symmetry = readSymmetry(object.object("symmetry"));
    // A reference is the terrain as the script found it, which is not there yet.
    if (object.errors().isEmpty() && !std::holds_alternative<Restore>(stroke.tool))
        report(object.errors(), object.path(), check(stroke));
    return stroke;
}

Material readScriptMaterial(const QJsonValue &value, const std::string &path, ScriptErrors &errors)
{
    Material result;
    std::vector<const char *> names;
    for (const MaterialPreset preset : EveryMaterialPreset)
        names.push_back(nameOf(preset));
    if (value.isString()) {
        QJsonObject object{{"preset", value}};
        ScriptObject wrapped(object, path, errors);
        return material(EveryMaterialPreset[wrapped.choice("preset", 0, names)]);
    }
    ScriptObject object(value, path, errors);
    if (object.has("preset"))
        result = material(EveryMaterialPreset[object.choice("preset", 0, names)]);
    for (const QString &key : jsonOf(result).keys())
        object.take(key.toUtf8().constData());
    object.finish();
    report(errors, path, readMaterial(value.toObject(), result));
    return result;
}

ErosionSettings readErosion(ScriptObject &object)
{
    ErosionSettings settings;
    settings.rule = ErosionRule(object.choice("rule", std::size_t(settings.rule), {"face", "edge"}));
    settings.relaxation = object.number("relaxation", settings.relaxation);
    settings.startAngle = object.number("start_angle", settings.startAngle);
    settings.sweepsPerSecond = object.number("sweeps_per_second", settings.sweepsPerSecond);
    settings.longestEdge = object.number("longest_edge", settings.longestEdge);
    settings.flatError = object.number("flat_error", settings.flatError);
    settings.flatAngle = object.number("flat_angle", settings.flatAngle);
    settings.hasCoarsePass = object.flag("coarse_pass", settings.hasCoarsePass);
    if (object.has("material"))
        settings.material = readScriptMaterial(object.take("material"), object.pathOf("material"), object.errors());
    report(object.errors(), object.path(), check(settings));
    return settings;
}

} // namespace model::io
