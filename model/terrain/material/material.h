// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"

#include <span>
#include <string>
#include <vector>

namespace model::terrain {

/// How steep a material stands at one humidity.
struct CriticalAngle
{
    double humidity = 0; ///< 0 dry ... 1 saturated
    double degrees = 30;

    friend bool operator==(const CriticalAngle &, const CriticalAngle &) = default;
};

/// Angles that erosion can work with: flatter, nothing would ever rest; steeper, nothing would ever move.
inline constexpr double SmallestCriticalAngle = 0.5, LargestCriticalAngle = 85;
inline constexpr std::size_t LargestCurve = 64;

/// What a layer is made of. A plain value; check() says whether it makes sense.
///
/// The last five parameters are those of R. W. Sumner, J. F. O'Brien, J. K. Hodgins, Animating Sand, Mud, and Snow,
/// 1999: how a body that is pressed into the ground shapes it.
struct Material
{
    std::string name;
    /// Ascending in humidity; straight lines between the points, and constant beyond the first and the last.
    std::vector<CriticalAngle> criticalAngles{{0, 30}};
    double humidity = 0;        ///< of what is poured, 0 ... 1
    double bulkDensity = 1600;  ///< kg/m3, loose, as it is poured
    double compressibility = 0; ///< the share of its volume that a load can press out of it, 0 ... below 1

    double insideSlope = 45;  ///< degrees: how steep the wall of a print stands ...
    double outsideSlope = 25; ///< ... and the rim outside it
    double roughness = 0.2;   ///< how uneven the rim is, 0 ... 1
    double liquidity = 0.5;   ///< the share of what is too steep that flows in one step, above 0 ... 1
    double compression = 0;   ///< the share of what a print displaces that goes down instead of into the rim, 0 ... 1

    friend bool operator==(const Material &, const Material &) = default;
};

/// The steepest slope at which the material rests, in degrees. Humidities beyond 0 ... 1 count as the nearest.
double criticalAngleAt(const Material &material, double humidity);

/// \error BadSetting  args: the parameter (as its member is called), its value, the allowed range
Result<void> check(const Material &material);

enum class MaterialPreset : std::uint8_t { DrySand, MoistSand, Mud, Snow, Gravel, Custom };
inline constexpr MaterialPreset EveryMaterialPreset[] = {MaterialPreset::DrySand, MaterialPreset::MoistSand,
                                                         MaterialPreset::Mud,     MaterialPreset::Snow,
                                                         MaterialPreset::Gravel,  MaterialPreset::Custom};

/// The name by which files and scripts know a preset: "dry sand". It is also the name of the material.
const char *nameOf(MaterialPreset preset);
/// The preset with exactly these parameters; Custom if there is none. The name does not count.
MaterialPreset presetOf(const Material &material);
Material material(MaterialPreset preset);

} // namespace model::terrain
