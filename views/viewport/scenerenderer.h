// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/camera.h"
#include "views/viewport/drawmode.h"
#include "views/viewport/glpicture.h"
#include "views/viewport/meshbuffers.h"

#include <QSize>

namespace views {

/// What a picture of a mesh looks like, apart from mesh and camera.
struct ViewStyle
{
    DrawMode drawMode = DrawMode::Shaded;
    double pointDensity = 1; ///< share of the vertices drawn as points, 0..1
    bool isDark = true;      ///< background
    bool hasGrid = true;     ///< on the floor
    float errorRange = 0;    ///< the vertex error that has the last colour of the map; 0: not coloured by errors
    float pixelRatio = 1;    ///< lines and points keep their size on high-DPI screens
};

/// Draws a mesh into the framebuffer that is bound. Made, used and destroyed with the same context current.
class SceneRenderer final
{
public:
    explicit SceneRenderer(QOpenGLFunctions_3_3_Core &gl);
    ~SceneRenderer();

    /// The driver's words if a shader did not compile; then draw() only clears.
    const QString &error() const { return mError; }

    void upload(const FrameData &frame, const model::FrameSourcePtr &source);
    void clearMesh() { mHasMesh = false; }

    /// \param size   in pixels of the framebuffer
    /// \param scene  what the animation fills over all frames; places floor and depth planes
    void draw(const model::OrbitCamera &camera, QSize size, const model::Box3f &scene, const ViewStyle &style);

private:
    void drawMesh(const ViewStyle &style);
    void drawGrid(const model::Box3f &scene, const ViewStyle &style);
    /// Makes `program` the current one, with camera and colours set.
    void use(const ShaderProgram &program, const ViewStyle &style);

    QOpenGLFunctions_3_3_Core &mGl;
    QString mError;
    MeshBuffers mMesh;
    Backdrop mBackdrop;
    bool mHasMesh = false;
    ShaderProgram mSurface, mSurfaceWithEdges, mWire, mPoints, mGrid;
    GLuint mEmptyArray = 0;
    model::Matrix4 mView{};
    model::Matrix4 mProjection{};
};

} // namespace views
