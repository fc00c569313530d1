// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/terrainrenderer.h"

#include <QVector3D>

#include <cmath>
#include <numbers>

namespace views {

namespace {

constexpr float Degree = std::numbers::pi_v<float> / 180;

QVector3D toQt(model::Vec3f v)
{
    return {v.x, v.y, v.z};
}

} // namespace

bool isInView(const model::Matrix4 &matrix, const model::Box3f &box)
{
    // Out if all corners are beyond the same plane of the clip volume.
    int outside[6] = {};
    for (int corner = 0; corner < 8; ++corner) {
        const float p[4] = {corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                            corner & 4 ? box.max.z : box.min.z, 1};
        float clip[4] = {};
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t column = 0; column < 4; ++column)
                clip[row] += matrix[column * 4 + row] * p[column];
        for (int axis = 0; axis < 3; ++axis) {
            outside[2 * axis] += clip[axis] < -clip[3];
            outside[2 * axis + 1] += clip[axis] > clip[3];
        }
    }
    for (const int count : outside)
        if (count == 8)
            return false;
    return true;
}

model::Vec3f sunDirection(const TerrainStyle &style)
{
    const float azimuth = style.sunAzimuth * Degree, elevation = style.sunElevation * Degree;
    return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation), -std::cos(azimuth) * std::cos(elevation)};
}

TerrainRenderer::TerrainRenderer(QOpenGLFunctions_3_3_Core &gl, const model::terrain::Terrain &terrain,
                                 const GroundFrame &frame)
    : mGl(gl)
    , mBuffers(gl, terrain, frame)
    , mBackdrop(gl, mError)
    , mGround(makeProgram({"terrain/terrain.vert", "terrain/terrain.frag", {}}, {}, mError))
{}

void TerrainRenderer::use(const ShaderProgram &program, const model::OrbitCamera &camera, const TerrainStyle &style)
{
    program->bind();
    mGl.glUniformMatrix4fv(program->uniformLocation("uView"), 1, GL_FALSE, mView.data());
    mGl.glUniformMatrix4fv(program->uniformLocation("uProjection"), 1, GL_FALSE, mProjection.data());
    program->setUniformValue("uEye", toQt(camera.position()));
    program->setUniformValue("uSun", toQt(sunDirection(style)));
}

void TerrainRenderer::draw(const model::OrbitCamera &camera, QSize size, const TerrainStyle &style)
{
    beginPicture(mGl, size);
    if (!mError.isEmpty() || size.isEmpty())
        return;
    const float aspect = float(size.width()) / float(size.height());
    mView = camera.viewMatrix();
    mProjection = camera.projectionMatrix(aspect, mBuffers.box());
    mBackdrop.draw(aspect, style.isDark);
    const model::Matrix4 whole = model::multiply(mProjection, mView);
    use(mGround, camera, style);
    mBuffers.draw([&whole](const model::Box3f &box) { return isInView(whole, box); });
    mGl.glUseProgram(0);
}

} // namespace views
