// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/ids.h"

namespace model::terrain {

inline constexpr std::uint32_t MaxLayers = 12;

/// The mobile layers of a terrain. Layer 0 lies on the bedrock, the last one on top.
struct LayerTable
{
    std::uint32_t count = 0;                ///< 0: a surface without materials
    std::uint8_t materials[MaxLayers] = {}; ///< of each layer: an index into the terrain's list of materials

    friend constexpr bool operator==(const LayerTable &, const LayerTable &) = default;
};

/// One layer at one vertex.
struct LayerSample
{
    double thickness = 0; ///< metres, at least 0
    float humidity = 0;   ///< 0 dry ... 1 saturated

    friend constexpr bool operator==(const LayerSample &, const LayerSample &) = default;
};

} // namespace model::terrain
