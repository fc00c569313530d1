// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/camera.h"
#include "model/terrain/tools/paintmask.h"
#include "views/terrain/groundcolors.h"
#include "views/terrain/picture/groundmaps.h"
#include "views/terrain/picture/terrainbuffers.h"
#include "views/terrain/terrainstyle.h"
#include "views/viewport/glpicture.h"

#include <map>

namespace views {

/// A picture to be drawn.
struct TerrainPicture
{
    model::OrbitCamera camera;
    GLuint framebuffer = 0;
    QSize size; ///< of the framebuffer, pixels
    TerrainStyle style;
    float pixelRatio = 1; ///< lines keep their width on high-DPI screens
    /// Shadows stay as they are where the ground has changed: they cost more than the ground itself where the processor
    /// draws. The next picture without this brings them up to date.
    bool keepsShadows = false;
    /// A grid stands for the terrain, if it is large: for a camera that moves, where the processor draws.
    bool isCoarse = false;
};

/// Draws a terrain. Made, used and destroyed with the same context current.
class TerrainRenderer final
{
public:
    using TerrainPtr = std::shared_ptr<const model::terrain::Terrain>;

    TerrainRenderer(QOpenGLFunctions_3_3_Core &gl, const model::terrain::Terrain &terrain, const GroundFrame &frame);
    ~TerrainRenderer();

    /// The driver's words if a shader did not compile; then draw() only clears.
    const QString &error() const { return mError; }

    const TerrainBuffers &buffers() const { return mBuffers; }
    void note(const model::terrain::Edit &edit);
    void noteMaterials() { mBuffers.noteAll(); }
    /// What CutAndFill compares with; null: nothing differs.
    void setReference(TerrainPtr reference);
    /// What the overlay Mask shows; null: nothing is protected.
    void setMask(std::shared_ptr<const model::terrain::PaintMask> mask);
    /// Triangles drawn as active; those that have gone meanwhile are left out.
    void setActiveTriangles(const std::vector<model::terrain::TriangleId> &triangles);

    /// Sends what the picture will need, see TerrainBuffers::upload().
    void upload(const TerrainStyle &style, double milliseconds);
    /// Draws, anew only where uploads since takeChanges() changed something if `changes` says so.
    void draw(const TerrainPicture &picture, const model::Box3f *changes = nullptr);
    /// The box of what uploads changed since it was last asked. Empty: nothing.
    model::Box3f takeChanges();
    /// Changes outside the box of changes: everything has to be drawn anew.
    bool takeIsAllChanged();

    /// Shadows are not up to date, for keepsShadows.
    bool hasLateShadows() const { return mHasShadows && !mMaps.lightChanges().isEmpty(); }

    /// The values at the ends of an overlay's colours: metres, degrees, per cent.
    GroundRange rangeOf(GroundOverlay overlay) const;
    /// Metres between contours.
    double contourInterval(const TerrainStyle &style) const;

private:
    void updateScalar(const TerrainStyle &style);
    void updateLines(const TerrainStyle &style);
    QOpenGLShaderProgram &groundProgram(const TerrainStyle &style, bool isCoarse);
    bool canBeCoarse(const TerrainStyle &style) const;
    void drawCoarsely(QOpenGLShaderProgram &program);
    void use(QOpenGLShaderProgram &program);
    void setGround(QOpenGLShaderProgram &program, const TerrainPicture &picture);
    void drawLines(const TerrainPicture &picture);
    void drawActive();
    /// Pixels from the lower left that show a box; empty if they cannot be told.
    QRect partOf(const model::Box3f &box, QSize size) const;

    QOpenGLFunctions_3_3_Core &mGl;
    const model::terrain::Terrain &mTerrain;
    const GroundFrame &mFrame;
    QString mError;
    TerrainBuffers mBuffers;
    Backdrop mBackdrop;
    GroundMaps mMaps;
    std::map<QByteArray, ShaderProgram> mGround; ///< by their defines
    ShaderProgram mLines, mFlat;
    GLuint mGrains = 0, mLineColors = 0, mLineTexture = 0, mEmptyArray = 0;
    TerrainPtr mReference;
    std::shared_ptr<const model::terrain::PaintMask> mMask;
    GroundOverlay mScalarOf = GroundOverlay::None;
    int mScalarLayer = -1;
    GroundEdges mLinesOf = GroundEdges::None;
    bool mAreLinesStale = true;
    model::Box3f mChanges;
    bool mIsAllChanged = true;
    bool mHasShadows = false; ///< of the last picture
    model::Box3f mDepthBox;   ///< places the depth planes
    model::Matrix4 mView{}, mProjection{};
};

/// True if a box may be seen by a camera with this view-projection matrix.
bool isInView(const model::Matrix4 &matrix, const model::Box3f &box);

/// Towards the sun, unit, in the scene's axes.
model::Vec3f sunDirection(const TerrainStyle &style);

} // namespace views
