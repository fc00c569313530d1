// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/viewport/scenerenderer.h"

#include "views/viewport/errorcolors.h"

#include <QColor>
#include <QVector3D>
#include <QVector4D>

#include <cmath>

namespace views {

namespace {

struct Colors
{
    QColor surface, backSide, edge, wire, grid;
};

const Colors &colorsFor(bool isDark)
{
    static const Colors dark{
        {222, 188, 138}, {112, 134, 168}, {28, 24, 20, 190}, {236, 205, 158, 220}, {190, 205, 230, 80}};
    static const Colors light{
        {214, 172, 116}, {112, 134, 168}, {40, 30, 20, 190}, {70, 52, 32, 220}, {70, 80, 100, 110}};
    return isDark ? dark : light;
}

/// 1, 2 or 5 times a power of ten, at most `length`.
float roundCell(float length)
{
    const float power = std::pow(10.0f, std::floor(std::log10(length)));
    for (const float step : {5.0f, 2.0f})
        if (power * step <= length)
            return power * step;
    return power;
}

} // namespace

SceneRenderer::SceneRenderer(QOpenGLFunctions_3_3_Core &gl)
    : mGl(gl)
    , mMesh(gl)
    , mBackdrop(gl, mError)
{
    mSurface = makeProgram({"surface.vert", "surface.frag", {}}, {}, mError);
    mSurfaceWithEdges = makeProgram({"surface.vert", "surface.frag", {}}, "#define EDGES\n", mError);
    mWire = makeProgram({"surface.vert", "surface.frag", {}}, "#define EDGES\n#define WIRE\n", mError);
    mPoints = makeProgram({"points.vert", "points.frag", {}}, {}, mError);
    mGrid = makeProgram({"grid.vert", "grid.frag", {}}, {}, mError);
    mGl.glGenVertexArrays(1, &mEmptyArray);
}

SceneRenderer::~SceneRenderer()
{
    mGl.glDeleteVertexArrays(1, &mEmptyArray);
}

void SceneRenderer::upload(const FrameData &frame, const model::FrameSourcePtr &source)
{
    mMesh.upload(frame, source);
    mHasMesh = true;
}

void SceneRenderer::draw(const model::OrbitCamera &camera, QSize size, const model::Box3f &scene,
                         const ViewStyle &style)
{
    setPictureState(mGl, size);
    clearPicture(mGl);
    if (!mError.isEmpty() || size.isEmpty())
        return;
    const float aspect = float(size.width()) / float(size.height());
    model::Box3f visible = scene;
    if (!scene.isEmpty() && style.hasGrid) { // the floor goes on around the animation
        const float reach = scene.diagonal();
        visible.add(scene.center() - model::Vec3f{reach, 0, reach});
        visible.add(scene.center() + model::Vec3f{reach, 0, reach});
    }
    mView = camera.viewMatrix();
    mProjection = camera.projectionMatrix(aspect, visible);
    mBackdrop.draw(aspect, style.isDark);
    if (mHasMesh)
        drawMesh(style);
    if (style.hasGrid && !scene.isEmpty() && scene.diagonal() > 0)
        drawGrid(scene, style);
    mGl.glUseProgram(0);
}

void SceneRenderer::use(const ShaderProgram &program, const ViewStyle &style)
{
    const Colors &colors = colorsFor(style.isDark);
    program->bind();
    mGl.glUniformMatrix4fv(program->uniformLocation("uView"), 1, GL_FALSE, mView.data());
    mGl.glUniformMatrix4fv(program->uniformLocation("uProjection"), 1, GL_FALSE, mProjection.data());
    program->setUniformValue("uSurface", linear(colors.surface).toVector3D());
    program->setUniformValue("uBackSide", linear(colors.backSide).toVector3D());
    program->setUniformValue("uErrorRange", mMesh.hasErrors() ? style.errorRange : 0.0f);
    std::array<QVector3D, ErrorColors.size()> map;
    for (std::size_t i = 0; i < map.size(); ++i)
        map[i] = linear(QColor(ErrorColors[i])).toVector3D();
    program->setUniformValueArray("uErrorColors", map.data(), int(map.size()));
}

void SceneRenderer::drawMesh(const ViewStyle &style)
{
    if (style.drawMode == DrawMode::Points) {
        use(mPoints, style);
        mPoints->setUniformValue("uPointSize", 3.5f * style.pixelRatio);
        mMesh.drawPoints(style.pointDensity);
        return;
    }
    const bool hasEdges = style.drawMode != DrawMode::Shaded && mMesh.canDrawCorners();
    if (!hasEdges) {
        use(mSurface, style);
        mMesh.drawTriangles();
        return;
    }
    const bool isWire = style.drawMode == DrawMode::Wireframe;
    const Colors &colors = colorsFor(style.isDark);
    const ShaderProgram &program = isWire ? mWire : mSurfaceWithEdges;
    use(program, style);
    program->setUniformValue("uTriangles", 0);
    program->setUniformValue("uPositions", 1);
    program->setUniformValue("uNormals", 2);
    program->setUniformValue("uErrors", 3);
    program->setUniformValue("uHasErrors", mMesh.hasErrors());
    program->setUniformValue("uEdge", linear(isWire ? colors.wire : colors.edge));
    program->setUniformValue("uEdgeHalfWidth", 0.55f * style.pixelRatio);
    if (isWire) { // lines of one colour over each other look the same in any order: no depth needed
        mGl.glEnable(GL_BLEND);
        mGl.glDisable(GL_DEPTH_TEST);
    }
    mMesh.drawCorners();
    mGl.glDisable(GL_BLEND);
    mGl.glEnable(GL_DEPTH_TEST);
}

void SceneRenderer::drawGrid(const model::Box3f &scene, const ViewStyle &style)
{
    const model::Vec3f middle{scene.center().x, scene.min.y, scene.center().z};
    const float reach = scene.diagonal();
    use(mGrid, style);
    mGrid->setUniformValue("uMiddle", QVector3D(middle.x, middle.y, middle.z));
    mGrid->setUniformValue("uReach", reach);
    mGrid->setUniformValue("uCell", roundCell(reach / 10));
    mGrid->setUniformValue("uLine", linear(colorsFor(style.isDark).grid));
    mGrid->setUniformValue("uLineHalfWidth", 0.5f * style.pixelRatio);
    mGl.glEnable(GL_BLEND);
    mGl.glDepthMask(GL_FALSE);
    mGl.glBindVertexArray(mEmptyArray);
    mGl.glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    mGl.glBindVertexArray(0);
    mGl.glDepthMask(GL_TRUE);
    mGl.glDisable(GL_BLEND);
}

} // namespace views
