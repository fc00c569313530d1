// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/camera.h"
#include "views/terrain/terrainbuffers.h"
#include "views/terrain/terrainstyle.h"
#include "views/viewport/glpicture.h"

namespace views {

/// Draws a terrain into the framebuffer that is bound. Made, used and destroyed with the same context current.
class TerrainRenderer final
{
public:
    TerrainRenderer(QOpenGLFunctions_3_3_Core &gl, const model::terrain::Terrain &terrain, const GroundFrame &frame);

    /// The driver's words if a shader did not compile; then draw() only clears.
    const QString &error() const { return mError; }

    TerrainBuffers &buffers() { return mBuffers; }

    /// \param size  in pixels of the framebuffer
    void draw(const model::OrbitCamera &camera, QSize size, const TerrainStyle &style);

private:
    void use(const ShaderProgram &program, const model::OrbitCamera &camera, const TerrainStyle &style);

    QOpenGLFunctions_3_3_Core &mGl;
    QString mError;
    TerrainBuffers mBuffers;
    Backdrop mBackdrop;
    ShaderProgram mGround;
    model::Matrix4 mView{};
    model::Matrix4 mProjection{};
};

/// True if a box may be seen by a camera with this view-projection matrix.
bool isInView(const model::Matrix4 &matrix, const model::Box3f &box);

/// Towards the sun, unit, in the scene's axes.
model::Vec3f sunDirection(const TerrainStyle &style);

} // namespace views
