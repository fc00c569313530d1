// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/terrain.h"
#include "views/terrain/groundframe.h"

#include <QColor>

#include <vector>

namespace views {

/// A vertex as the GPU has it.
struct GroundVertex
{
    model::Vec3f position;                     ///< in the scene, see GroundFrame
    std::int16_t normalX = 0, normalZ = 0;     ///< of the unit normal, x 32767; y is what is missing to 1
    std::uint8_t red = 0, green = 0, blue = 0; ///< of the dry top layer, sRGB
    std::uint8_t humidity = 0;                 ///< of the top layer, x 255
};
static_assert(sizeof(GroundVertex) == 20);

/// What a material looks like dry; told by its name if that is a preset's, else by what its parameters come nearest to.
QColor colorOf(const model::terrain::Material &material);
/// Of bedrock laid bare, and of terrains without layers.
QColor bedrockColor(bool hasLayers);

/// The unit normal at a vertex, in terrain axes, void triangles left out; upwards where there are none.
/// Triangles count by 1 / (square of the two edges): long flat neighbours of a steep wall do not wash it out.
/// Source: N. Max, Weights for Computing Vertex Normals from Facet Normals, 1999.
model::terrain::Point3 normalAt(const model::terrain::TinArrays &tin, model::terrain::VertexId v);

/// Makes vertices for the GPU out of a terrain.
class GroundVertexMaker
{
public:
    GroundVertexMaker(const model::terrain::Terrain &terrain, const GroundFrame &frame);

    /// The colours are made anew, after the list of materials or that of layers changed.
    void updateColors();
    /// A free slot becomes a point in the middle.
    GroundVertex make(model::terrain::VertexId v) const;
    /// The layer that lies open at a vertex; layerCount() where the bedrock does.
    static std::uint32_t topLayer(const model::terrain::TinArrays &tin, model::terrain::VertexId v);

private:
    const model::terrain::Terrain &mTerrain;
    const GroundFrame &mFrame;
    std::vector<QColor> mColors; ///< of each layer, then of the bedrock
};

} // namespace views
