// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/query/disc.h"
#include "model/terrain/tin/tinedit.h"
#include "model/terrain/tools/paintmask.h"
#include "model/terrain/tools/strokepath.h"

#include <limits>
#include <memory>

namespace model::terrain {

/// How a tool's strength falls from the centre of its disc to the rim.
enum class Falloff : std::uint8_t {
    Constant,
    Linear,
    Smooth, ///< flat at the centre and at the rim
    Sphere, ///< a hemisphere: steep at the rim
    Tip,    ///< steep at the centre
};

/// 1 at the centre, where `t` is 0, and for all but Constant 0 at the rim, where it is 1; 0 beyond.
double weightOf(Falloff falloff, double t);

/// Where a tool works: between two slopes and between two heights, and half as much half a blend outside; and where
/// nobody painted.
struct Mask
{
    static constexpr double NoLimit = std::numeric_limits<double>::infinity();

    double lowestSlope = 0, highestSlope = 90; ///< degrees
    double slopeBlend = 0;                     ///< degrees over which the mask ends
    double lowestHeight = -NoLimit, highestHeight = NoLimit;
    double heightBlend = 0; ///< metres
    /// What is painted as protected is left alone, whatever its slope and height; null: nothing is.
    std::shared_ptr<const PaintMask> paint = nullptr;

    bool isEverywhere() const;
    /// 0 ... 1, without what is painted.
    double weightOf(double slope, double height) const;
    /// How far what is painted leaves a place open: 0 ... 1.
    double openAt(Point2 p) const { return paint ? 1 - paint->at(p) : 1; }
    double weightAt(const TinArrays &tin, VertexId v) const;
    /// \error BadSetting  a limit that is no number, or a blend below 0
    Result<void> check() const;

    friend bool operator==(const Mask &, const Mask &) = default;
};

/// The slope of the surface at a vertex, in degrees: of the mean of its triangles' gradients by their areas.
double slopeAt(const TinArrays &tin, VertexId v);

/// What all tools have that work on the vertices under a disc.
struct Brush
{
    double radius = 1; ///< metres
    Falloff falloff = Falloff::Smooth;
    double spacing = 0.25; ///< between stamps, in radii
    double detail = 0.125; ///< vertices are added where they are farther apart than this, in radii; 0: none
    Mask mask;
    bool doesPressureScaleRadius = false;
    bool doesPressureScaleStrength = true;

    double radiusAt(const StampPose &pose) const { return doesPressureScaleRadius ? radius * pose.pressure : radius; }
    double strengthAt(const StampPose &pose) const { return doesPressureScaleStrength ? pose.pressure : 1; }
    /// \error BadSetting  a radius or spacing that is not above 0, a detail outside 0.01 ... 1 that is not 0, or what
    ///                    Mask::check() says
    Result<void> check() const;

    friend bool operator==(const Brush &, const Brush &) = default;
};

/// \error BadSetting  unless `value` is a number from `low` to `high`
Result<void> checkSetting(const char *name, double value, double low, double high);

/// Settings in metres stay below this: sums of many strokes stay far from overflow.
inline constexpr double LargestSetting = 1e9;

/// A vertex under a brush, and how much of the brush's strength it gets: above 0, at most 1.
struct BrushVertex
{
    VertexId vertex;
    double weight;
};

/// Memory that tools work with; keep one for many strokes.
class ToolMemory
{
public:
    DiscSearch disc;
    std::vector<BrushVertex> brushed;
    std::vector<VertexId> inserted;
};

/// Adds vertices to the disc until none is much farther from its neighbours than `spacing`. They lie on a lattice that
/// is the same for the whole plane: where a stroke passed, the next one adds nothing. The volume stays.
/// \param closed  where none is added, if there is one: all that is fully protected
void refineDisc(TinEdit &edit, Point2 centre, double radius, double spacing, ToolMemory &memory,
                const PaintMask *closed = nullptr);

/// The vertices under a brush, refined first, with weights of falloff, mask and pressure; in `memory.brushed`.
void gather(TinEdit &edit, const Brush &brush, const StampPose &pose, ToolMemory &memory);

} // namespace model::terrain
