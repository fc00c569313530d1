// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

#include <array>
#include <cstdint>
#include <vector>

namespace views {

/// Parts of a mesh that are marked in one colour: vertices as balls, edges as tubes, faces filled.
struct MeshMarks
{
    QColor color;
    std::vector<std::uint32_t> vertices;
    std::vector<std::array<std::uint32_t, 2>> edges;
    std::vector<std::uint32_t> faces;
};

} // namespace views
