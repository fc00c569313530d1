// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/terrain.h"
#include "views/terrain/groundframe.h"

#include <QColor>

#include <vector>

namespace views {

// A vertex as the GPU has it, in three arrays: most edits change but one or two of them.

/// Where it is on the map, in the scene; see GroundFrame.
struct GroundPlace
{
    float x = 0, z = 0;
};
/// Its height and its unit normal.
struct GroundHeight
{
    float y = 0;
    std::int16_t normalX = 0, normalZ = 0; ///< x 32767; y is what is missing to 1
};
/// What the top layer looks like dry, sRGB, and its humidity x 255.
struct GroundPaint
{
    std::uint8_t red = 0, green = 0, blue = 0, humidity = 0;

    friend bool operator==(const GroundPaint &, const GroundPaint &) = default;
};
/// How far the sand there has slid since the terrain is shown, in steps of 1 / SlideSteps of what its detail travels
/// with it: x and z.
struct GroundSlide
{
    std::int16_t x = 0, z = 0;

    friend bool operator==(const GroundSlide &, const GroundSlide &) = default;
};
inline constexpr int SlideSteps = 256;
static_assert(sizeof(GroundSlide) == 4 && sizeof(GroundPlace) == 8 && sizeof(GroundHeight) == 8 &&
              sizeof(GroundPaint) == 4);

/// What a material looks like dry; told by its name if that is a preset's, else by what its parameters come nearest to.
QColor colorOf(const model::terrain::Material &material);
/// Of bedrock laid bare, and of terrains without layers.
QColor bedrockColor(bool hasLayers);

/// The unit normal at a vertex, in terrain axes, void triangles left out; upwards where there are none.
/// Triangles count by 1 / (square of the two edges): long flat neighbours of a steep wall do not wash it out.
/// Source: N. Max, Weights for Computing Vertex Normals from Facet Normals, 1999.
model::terrain::Point3 normalAt(const model::terrain::TinArrays &tin, model::terrain::VertexId v);

/// What a vertex' slide becomes when its height goes from `before` to that of `now`: the lines of equal height move by
/// the change over the slope, and sand goes down across them. Where it is too flat to slide, it does not.
/// \param reach  metres that the detail travels
GroundSlide slid(GroundSlide slide, float before, const GroundHeight &now, float reach);

/// Makes vertices for the GPU out of a terrain.
class GroundVertexMaker
{
public:
    GroundVertexMaker(const model::terrain::Terrain &terrain, const GroundFrame &frame);

    /// The colours are made anew, after the list of materials or that of layers changed.
    void updateColors();
    // Of a vertex that is there.
    GroundPlace place(model::terrain::VertexId v) const;
    GroundHeight height(model::terrain::VertexId v) const;
    GroundPaint paint(model::terrain::VertexId v) const;
    model::Vec3f position(model::terrain::VertexId v) const;
    /// The layer that lies open at a vertex; layerCount() where the bedrock does.
    static std::uint32_t topLayer(const model::terrain::TinArrays &tin, model::terrain::VertexId v);

private:
    const model::terrain::Terrain &mTerrain;
    const GroundFrame &mFrame;
    std::vector<QColor> mColors; ///< of each layer, then of the bedrock
};

} // namespace views
