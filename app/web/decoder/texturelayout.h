// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/basis/productanimation.h"
#include "model/mesh/trianglemesh.h"

#include <cstdint>
#include <vector>

namespace web {

// What the shaders of the page read (app/web/player/shaders.ts), laid out as the textures are, so that JavaScript only
// hands it on. Texel v of a texture is at column v mod width, row v / width.

inline constexpr std::uint32_t VertexColumns = 1024; ///< width of a texture with a texel for each vertex
inline constexpr std::uint32_t CornerColumns = 2048; ///< width of the texture of corners
inline constexpr std::uint32_t TexelValues = 4;      ///< a texel holds the coefficients of so many trajectories

/// `count` rounded up to whole rows.
std::size_t wholeRows(std::size_t count, std::uint32_t columns);
/// Layers of coefficients: TexelValues trajectories in each, the last filled up with zeros.
std::uint32_t layerCount(std::uint32_t rank);

/// The corners around each vertex, for normals.
struct VertexCorners
{
    std::vector<std::uint32_t> ranges; ///< a texel for each vertex: its first corner, and how many
    /// A texel for each corner of a triangle: the triangle's other two vertices, counter-clockwise.
    std::vector<std::uint32_t> others;
};
VertexCorners cornersOf(const model::Connectivity &connectivity);

/// The two vertices of each edge, each edge once.
std::vector<std::uint32_t> edgesOf(const model::Connectivity &connectivity);

/// Coefficients of the trajectories 4 layer ... 4 layer + 3, a texel for each vertex. Shape: see above.
std::vector<float> coefficientLayer(const model::codec::ProductAnimation &animation, std::uint32_t layer);

/// For each frame 1 + 4 layers texels (x, y, z, 0): the mean vertex minus `centre`, then the trajectories.
std::vector<float> basisRows(const model::codec::ProductAnimation &animation, const model::Vec3f &centre);

/// The positions of a frame minus `centre`, a texel (x, y, z, 0) for each vertex.
std::vector<float> frameTexels(const model::FrameSource &animation, std::uint32_t frame, const model::Vec3f &centre);

} // namespace web
