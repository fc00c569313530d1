// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/material/material.h"

#include "model/base/numbertext.h"

namespace model::terrain {

namespace {

Result<void> checkRange(const char *name, double value, double low, double high)
{
    if (value >= low && value <= high)
        return {};
    return fail(ErrorCode::BadSetting, name, numberText(value), numberText(low) + " ... " + numberText(high));
}

Result<void> checkCurve(std::span<const CriticalAngle> curve)
{
    if (curve.empty() || curve.size() > LargestCurve)
        return fail(ErrorCode::BadSetting, "criticalAngles", std::to_string(curve.size()) + " points",
                    "1 ... " + std::to_string(LargestCurve) + " points");
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const std::string name = "criticalAngles[" + std::to_string(i) + "]";
        const double low = i > 0 ? curve[i - 1].humidity : 0;
        if (const auto checked = checkRange((name + ".humidity").c_str(), curve[i].humidity, low, 1); !checked)
            return checked;
        if (i > 0 && curve[i].humidity == low)
            return fail(ErrorCode::BadSetting, name + ".humidity", numberText(low), "more than " + numberText(low));
        if (const auto checked =
                checkRange((name + ".degrees").c_str(), curve[i].degrees, SmallestCriticalAngle, LargestCriticalAngle);
            !checked)
            return checked;
    }
    return {};
}

/// Sand stands steeper with the first water, whose bridges hold its grains together, and flows when it is saturated.
const std::vector<CriticalAngle> SandCurve{{0, 30}, {0.1, 40}, {0.3, 45}, {0.6, 42}, {0.85, 30}, {1, 15}};

} // namespace

double criticalAngleAt(const Material &material, double humidity)
{
    const std::vector<CriticalAngle> &curve = material.criticalAngles;
    if (curve.empty())
        return Material().criticalAngles[0].degrees;
    if (!(humidity > curve.front().humidity))
        return curve.front().degrees;
    for (std::size_t i = 1; i < curve.size(); ++i)
        if (humidity <= curve[i].humidity) {
            const CriticalAngle &a = curve[i - 1], &b = curve[i];
            return a.degrees + (humidity - a.humidity) / (b.humidity - a.humidity) * (b.degrees - a.degrees);
        }
    return curve.back().degrees;
}

Result<void> check(const Material &material)
{
    if (const auto checked = checkCurve(material.criticalAngles); !checked)
        return checked;
    const struct
    {
        const char *name;
        double value, low, high;
    } ranges[] = {
        {"humidity", material.humidity, 0, 1},
        {"bulkDensity", material.bulkDensity, 1, 25000},
        {"compressibility", material.compressibility, 0, 0.95},
        {"insideSlope", material.insideSlope, SmallestCriticalAngle, 90},
        {"outsideSlope", material.outsideSlope, SmallestCriticalAngle, 90},
        {"roughness", material.roughness, 0, 1},
        {"liquidity", material.liquidity, 0.01, 1},
        {"compression", material.compression, 0, 1},
    };
    for (const auto &range : ranges)
        if (const auto checked = checkRange(range.name, range.value, range.low, range.high); !checked)
            return checked;
    return {};
}

const char *nameOf(MaterialPreset preset)
{
    switch (preset) {
    case MaterialPreset::DrySand:
        return "dry sand";
    case MaterialPreset::MoistSand:
        return "moist sand";
    case MaterialPreset::Mud:
        return "mud";
    case MaterialPreset::Snow:
        return "snow";
    case MaterialPreset::Gravel:
        return "gravel";
    case MaterialPreset::Custom:
        return "custom";
    }
    return "";
}

// Angles of repose and densities are common soil-mechanics values for loose heaps, in the middle of their ranges.
Material material(MaterialPreset preset)
{
    Material m;
    m.name = nameOf(preset);
    switch (preset) {
    case MaterialPreset::DrySand:
        m.criticalAngles = SandCurve;
        m.compression = 0.3;
        break;
    case MaterialPreset::MoistSand: // the same sand with water in it
        m.criticalAngles = SandCurve;
        m.humidity = 0.3;
        m.bulkDensity = 1800;
        m.insideSlope = 60;
        m.outsideSlope = 40;
        m.liquidity = 0.35;
        m.compression = 0.35;
        break;
    case MaterialPreset::Mud:
        m.criticalAngles = {{0, 38}, {0.4, 30}, {0.7, 18}, {1, 6}};
        m.humidity = 0.7;
        m.bulkDensity = 1900;
        m.compressibility = 0.15;
        m.insideSlope = 80;
        m.outsideSlope = 60;
        m.liquidity = 0.9;
        m.compression = 0.41;
        break;
    case MaterialPreset::Snow:
        m.criticalAngles = {{0, 38}, {0.15, 55}, {0.4, 45}, {1, 12}};
        m.humidity = 0.1;
        m.bulkDensity = 150;
        m.compressibility = 0.7;
        m.insideSlope = 85;
        m.outsideSlope = 75;
        m.roughness = 0.3;
        m.liquidity = 0.2;
        m.compression = 0.9;
        break;
    case MaterialPreset::Gravel: // too coarse for water to hold it
        m.criticalAngles = {{0, 37}, {1, 35}};
        m.bulkDensity = 1700;
        m.insideSlope = 50;
        m.outsideSlope = 35;
        m.roughness = 0.6;
        m.liquidity = 0.7;
        m.compression = 0.1;
        break;
    case MaterialPreset::Custom:
        break;
    }
    return m;
}

MaterialPreset presetOf(const Material &material)
{
    for (const MaterialPreset preset : EveryMaterialPreset) {
        Material named = terrain::material(preset);
        named.name = material.name;
        if (preset != MaterialPreset::Custom && named == material)
            return preset;
    }
    return MaterialPreset::Custom;
}

} // namespace model::terrain
