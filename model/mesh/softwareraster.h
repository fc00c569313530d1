// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/progress.h"
#include "model/mesh/camera.h"
#include "model/mesh/trianglemesh.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace model {

/// 8-bit RGBA, row after row from the top, not premultiplied (alpha is 255).
struct Picture
{
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba; ///< #width*height*4
};

struct RasterStyle
{
    std::array<std::uint8_t, 3> backgroundTop{58, 66, 79};
    std::array<std::uint8_t, 3> backgroundBottom{24, 27, 33};
    std::array<std::uint8_t, 3> surface{214, 178, 120};
    bool wireframe = false; ///< edges over the surface
    /// #V: where the colour of each vertex is on `palette`, 0 its first and 1 its last; empty: all is `surface`.
    std::span<const float> places;
    std::span<const std::array<std::uint8_t, 3>> palette; ///< at equal distances, at least 2
};

/// Draws a mesh without a GPU or a window: for pictures on the command line, thumbnails and previews. Smooth shading
/// by vertex normals, both sides lit, z-buffer, 2 x 2 samples a pixel; the same bytes on every machine of one compiler.
/// \param width, height  1..16384
/// \returns  a picture in which anything may be missing once the work is cancelled
Picture drawMesh(std::span<const Vec3f> positions, std::span<const Triangle> triangles, const OrbitCamera &camera,
                 int width, int height, const RasterStyle &style = {}, const Progress &progress = Progress());

} // namespace model
