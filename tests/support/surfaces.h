// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/trianglemesh.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tests {

// Connectivities without positions, for what only looks at how triangles meet.

/// columns x rows squares of two triangles. Across (the last column meets the first) it may close, or close with a
/// twist; along it may close.
enum class Closing { Open, Closed, Twisted };
model::Connectivity sheet(std::uint32_t columns, std::uint32_t rows, Closing across = Closing::Open,
                          Closing along = Closing::Open);

/// `mesh` without some triangles; the vertices stay.
model::Connectivity without(const model::Connectivity &mesh, const std::vector<std::uint32_t> &triangles);
/// The same with about one of `oneOf` triangles taken away at random.
model::Connectivity withRandomHoles(const model::Connectivity &mesh, std::uint32_t oneOf, std::uint32_t seed = 1);
/// Both, side by side.
model::Connectivity together(const model::Connectivity &a, const model::Connectivity &b);
/// Both, joined at a triangle of each that is taken out.
model::Connectivity connectedSum(const model::Connectivity &a, std::uint32_t triangleOfA, const model::Connectivity &b,
                                 std::uint32_t triangleOfB);
/// The triangles in another order, each turned to another first corner.
model::Connectivity shuffled(const model::Connectivity &mesh, std::uint32_t seed = 1);
/// Random triangles over few vertices: everything that can be wrong.
model::Connectivity soup(std::uint32_t vertices, std::uint32_t triangles, std::uint32_t seed = 1);
/// One triangle after another around two rails that wind `columns` to a turn: long, narrow, one border.
model::Connectivity spiral(std::uint32_t triangles, std::uint32_t columns);

struct NamedSurface
{
    std::string name;
    model::Connectivity mesh;
    struct Facts
    {
        std::int64_t components, borders, genus;
    };
    std::optional<Facts> facts; ///< of oriented manifolds
};
/// Every kind of surface, and every mesh of tests/support/meshes.h.
const std::vector<NamedSurface> &namedSurfaces();

/// The triangles turned so that the smallest index is first, sorted: equal for equal sets of oriented triangles.
std::vector<model::Triangle> canonical(std::vector<model::Triangle> triangles);
/// The triangles with each index i replaced by names[i].
std::vector<model::Triangle> renamed(std::vector<model::Triangle> triangles, const std::vector<std::uint32_t> &names);

} // namespace tests
