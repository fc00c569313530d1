// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace views {

/// How much work goes into the picture of the ground: plain shading; shadows, hidden sky and grains; grains on steep
/// walls too, ripples and glints.
enum class GroundQuality : std::uint8_t { Low, Medium, High };

/// Sand as it looks outside, or the recipe of the references: a bump map and the middle of the histogram stretched.
enum class GroundLook : std::uint8_t { Sand, Reference };

/// What the colours of the ground tell; None: what it is made of.
enum class GroundOverlay : std::uint8_t { None, Height, Slope, Humidity, Thickness, CutAndFill, Mask };
inline constexpr GroundOverlay EveryGroundOverlay[] = {
    GroundOverlay::None,      GroundOverlay::Height,     GroundOverlay::Slope, GroundOverlay::Humidity,
    GroundOverlay::Thickness, GroundOverlay::CutAndFill, GroundOverlay::Mask};

/// The edges that are drawn on the ground.
enum class GroundEdges : std::uint8_t {
    None,
    Constrained,        ///< red
    ConstrainedByOwner, ///< a colour for each stamp
};

/// What a picture of a terrain looks like, apart from terrain and camera.
struct TerrainStyle
{
    GroundQuality quality = GroundQuality::Medium;
    GroundLook look = GroundLook::Sand;
    GroundOverlay overlay = GroundOverlay::None;
    int thicknessLayer = -1; ///< Thickness: of this layer; below 0, of all of them together
    bool hasWireframe = false;
    GroundEdges edges = GroundEdges::None;
    bool hasContours = false;
    double contourInterval = 0; ///< metres; 0: some twenty of them, round
    bool hasActiveTriangles = false;
    bool hasLegend = true;
    bool isDark = true;      ///< background
    float sunAzimuth = 305;  ///< degrees clockwise from north, where the light comes from
    float sunElevation = 30; ///< degrees above the horizon, above 0

    friend bool operator==(const TerrainStyle &, const TerrainStyle &) = default;
};

} // namespace views
