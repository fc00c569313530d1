// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tools/paintmask.h"
#include "views/terrain/picture/groundshading.h"
#include "views/terrain/picture/terrainbuffers.h"

#include <optional>

namespace views {

/// How far the drawing of a part of a picture has come; see TerrainRenderer::drawPart().
struct PartProgress
{
    bool isDone = false;
    bool isBegun = false;
    std::uint32_t chunk = 0, active = 0, line = 0; ///< what comes next
    std::uint32_t drawnChunks = 0;                 ///< by the last step
    model::Matrix4 view{}, projection{};
    model::Matrix4 seen{}; ///< view and projection; the part fills the clip volume
};

/// Draws a terrain, in pieces of any size: where the processor draws, a whole picture takes longer than a person should
/// wait. Made, used and destroyed with the same context current.
class TerrainRenderer final
{
public:
    using TerrainPtr = std::shared_ptr<const model::terrain::Terrain>;

    /// \param mapPieces  see GroundMaps
    TerrainRenderer(QOpenGLFunctions_3_3_Core &gl, const model::terrain::Terrain &terrain, const GroundFrame &frame,
                    int mapPieces);
    ~TerrainRenderer();

    /// The driver's words if a shader did not compile; then drawPart() only clears.
    const QString &error() const { return mError; }

    /// Another terrain from now on, with nothing that was set for the one before; programs and textures stay. The frame
    /// is that of the new one already. The one before may be gone.
    void setTerrain(const model::terrain::Terrain &terrain);

    const TerrainBuffers &buffers() const { return *mBuffers; }
    void note(const model::terrain::Edit &edit);
    void noteMaterials() { mBuffers->noteAll(); }
    /// What CutAndFill compares with; null: nothing differs.
    void setReference(TerrainPtr reference);
    /// What the overlay Mask shows; null: nothing is protected.
    void setMask(std::shared_ptr<const model::terrain::PaintMask> mask);
    /// Triangles drawn as active; those that have gone meanwhile are left out.
    void setActiveTriangles(const std::vector<model::terrain::TriangleId> &triangles);

    /// Sends what the picture will need, see TerrainBuffers::upload().
    void upload(const TerrainStyle &style, double milliseconds);
    /// The box of what uploads changed since it was last asked. Empty: nothing.
    model::Box3f takeChanges();
    /// Changes outside the box of changes: everything has to be drawn anew.
    bool takeIsAllChanged();

    /// Heights and light, which a picture is made with, have to be brought up to date before it is drawn.
    bool hasMapWork(const TerrainPicture &picture) const;
    /// One step of that. \returns where the light of the picture changes; empty: nowhere
    model::Box3f stepMaps(const TerrainPicture &picture);
    /// A coarse picture can be drawn: the grid's heights are there, or no grid is needed.
    bool canBeCoarse() const { return !isLarge() || mMaps.hasHeights(); }
    /// The heights of the maps are those of the ground.
    bool hasHeights() const { return mMaps.hasHeights() && !mMaps.areHeightsStale(); }
    /// The light is not that of the ground, for keepsShadows.
    bool hasLateShadows(const TerrainStyle &style) const;

    /// Draws the next triangles of a part of a picture: `mostChunks` of TerrainBuffers::ChunkSize, or as many lines.
    /// \param framebuffer  of the picture's size; only the part is cleared and drawn into
    /// \param part         pixels from the lower left
    void drawPart(const TerrainPicture &picture, GLuint framebuffer, const QRect &part, PartProgress &progress,
                  std::uint32_t mostChunks);
    /// Pixels from the lower left that show a box; the whole picture if they cannot be told.
    QRect partOf(const TerrainPicture &picture, const model::Box3f &box) const;

    /// The values at the ends of an overlay's colours: metres, degrees, per cent.
    GroundRange rangeOf(GroundOverlay overlay) const;
    /// Metres between contours.
    double contourInterval(const TerrainStyle &style) const;

private:
    bool isLarge() const;
    bool wantsLight(const TerrainPicture &picture) const;
    void updateScalar(const TerrainStyle &style);
    void updateLines(const TerrainStyle &style);
    void begin(const TerrainPicture &picture, const QRect &part, PartProgress &progress);
    void use(QOpenGLShaderProgram &program, const PartProgress &progress);
    bool drawGround(const TerrainPicture &picture, PartProgress &progress, std::uint32_t mostChunks);
    bool drawActive(PartProgress &progress, std::uint32_t most);
    bool drawLines(const TerrainPicture &picture, PartProgress &progress, std::uint32_t most);

    QOpenGLFunctions_3_3_Core &mGl;
    const model::terrain::Terrain *mTerrain;
    const GroundFrame &mFrame;
    QString mError;
    std::optional<TerrainBuffers> mBuffers; ///< always there
    Backdrop mBackdrop;
    GroundMaps mMaps;
    GroundShading mShading;
    ShaderProgram mLines, mFlat;
    GLuint mLineColors = 0, mLineTexture = 0;
    TerrainPtr mReference;
    std::shared_ptr<const model::terrain::PaintMask> mMask;
    GroundOverlay mScalarOf = GroundOverlay::None;
    int mScalarLayer = -1;
    GroundEdges mLinesOf = GroundEdges::None;
    bool mAreLinesStale = true;
    model::Box3f mChanges;
    bool mIsAllChanged = true;
};

/// True if a box may be seen by a camera with this view-projection matrix.
bool isInView(const model::Matrix4 &matrix, const model::Box3f &box);

} // namespace views
