// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tools/brush.h"

#include <functional>
#include <memory>
#include <optional>

namespace model::terrain {

/// Adds material: `height` metres at the centre of each stamp.
struct Raise
{
    Brush brush;
    double height = 0.1;
};
/// Takes material away: `depth` metres at the centre of each stamp.
struct Lower
{
    Brush brush;
    double depth = 0.1;
};
/// Draws the surface towards one level.
struct Flatten
{
    Brush brush;
    double strength = 0.5;       ///< how much of the way one stamp goes, 0 ... 1
    std::optional<double> level; ///< none: the height where the stroke begins
};
/// Moves material from higher vertices to their lower neighbours.
struct Smooth
{
    Brush brush;
    double strength = 0.5; ///< 0 ... 1
};
/// Adds hills and hollows of a given size.
struct Noise
{
    Brush brush;
    double amplitude = 0.1;  ///< metres, of one stamp
    double wavelength = 0.5; ///< metres, of the largest hills
    std::uint32_t octaves = 3;
    std::uint32_t seed = 1;
};
/// A surface to go back to: a function of x and y, or a TIN, whose own vertices then come back too.
struct ReferenceSurface
{
    std::function<double(Point2)> height;
    std::shared_ptr<const Tin> tin; ///< if there is one, it goes before the function
};
/// Draws the surface towards another one.
struct Restore
{
    Brush brush;
    double strength = 1; ///< how much of the way one stamp goes, 0 ... 1
    ReferenceSurface reference;
};
/// Adds exactly this much material with each stamp.
struct Pour
{
    Brush brush;
    double volume = 0.01; ///< cubic metres
};
/// Takes material out, and the stroke's report says how much.
struct Scoop
{
    Brush brush;
    double depth = 0.1; ///< metres at the centre of each stamp
};
/// Wets what lies at the surface, or lets it dry: its critical angle changes, its volume does not. Nothing happens
/// where there are no layers.
struct Moisten
{
    Brush brush;
    double humidity = 0.5; ///< 0 dry ... 1 saturated: what the surface comes to
    double strength = 0.5; ///< how much of the way one stamp goes, 0 ... 1
};

// One stamp of each; `near` what the heights were where the stroke began. Settings are checked before a stroke.
void stamp(TinEdit &edit, const Raise &tool, const StampPose &pose, ToolMemory &memory);
void stamp(TinEdit &edit, const Lower &tool, const StampPose &pose, ToolMemory &memory);
void stamp(TinEdit &edit, const Flatten &tool, const StampPose &pose, double level, ToolMemory &memory);
void stamp(TinEdit &edit, const Smooth &tool, const StampPose &pose, ToolMemory &memory);
void stamp(TinEdit &edit, const Noise &tool, const StampPose &pose, ToolMemory &memory);
void stamp(TinEdit &edit, const Restore &tool, const StampPose &pose, ToolMemory &memory);
void stamp(TinEdit &edit, const Pour &tool, const StampPose &pose, ToolMemory &memory);
void stamp(TinEdit &edit, const Scoop &tool, const StampPose &pose, ToolMemory &memory);
void stamp(TinEdit &edit, const Moisten &tool, const StampPose &pose, ToolMemory &memory);

Result<void> check(const Raise &tool);
Result<void> check(const Lower &tool);
Result<void> check(const Flatten &tool);
Result<void> check(const Smooth &tool);
Result<void> check(const Noise &tool);
Result<void> check(const Restore &tool);
Result<void> check(const Pour &tool);
Result<void> check(const Scoop &tool);
Result<void> check(const Moisten &tool);

/// Smooth noise between -1 and 1, the same everywhere for the same seed; `p` in wavelengths of the largest hills.
double noiseAt(Point2 p, std::uint32_t octaves, std::uint32_t seed);

} // namespace model::terrain
