// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace views {

/// How much work goes into the picture of the ground.
enum class GroundQuality : std::uint8_t { Low, Medium, High };

/// What a picture of a terrain looks like, apart from terrain and camera.
struct TerrainStyle
{
    GroundQuality quality = GroundQuality::Medium;
    bool isDark = true;      ///< background
    float sunAzimuth = 305;  ///< degrees clockwise from north, where the light comes from
    float sunElevation = 32; ///< degrees above the horizon, above 0

    friend bool operator==(const TerrainStyle &, const TerrainStyle &) = default;
};

} // namespace views
