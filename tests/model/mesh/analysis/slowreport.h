// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/faces.h"

#include <map>
#include <set>

namespace tests {

/// What a mesh consists of, straight from the definitions: sets and searches, nothing of the product's structures.
struct SlowReport
{
    struct Component
    {
        std::set<std::uint32_t> vertices;
        std::set<std::array<std::uint32_t, 2>> edges;
        std::set<std::uint32_t> faces;
        std::set<std::array<std::uint32_t, 2>> borderEdges;
        bool isManifold = true, isOrientable = true;
    };
    std::map<std::array<std::uint32_t, 2>, std::vector<std::uint32_t>> sidesOf; ///< of each edge its faces, once a side
    std::vector<Component> components;                                          ///< in the order of their first faces
    std::set<std::uint32_t> manyFans, isolated, degenerate;
    std::set<std::array<std::uint32_t, 2>> crowded, inconsistent;
    std::size_t duplicates = 0;
};
SlowReport slowReport(const model::Faces &faces);

} // namespace tests
