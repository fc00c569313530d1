// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/viewport/scenerenderer.h"

#include "views/viewport/errorcolors.h"

#include <QColor>
#include <QFile>
#include <QVector3D>
#include <QVector4D>

#include <cmath>

namespace views {

namespace {

struct Colors
{
    QColor top, bottom, surface, backSide, edge, wire, grid;
};

const Colors &colorsFor(bool isDark)
{
    static const Colors dark{{66, 75, 90},      {21, 24, 30},         {222, 188, 138},    {112, 134, 168},
                             {28, 24, 20, 190}, {236, 205, 158, 220}, {190, 205, 230, 80}};
    static const Colors light{{250, 251, 253},   {186, 194, 206},   {214, 172, 116},   {112, 134, 168},
                              {40, 30, 20, 190}, {70, 52, 32, 220}, {70, 80, 100, 110}};
    return isDark ? dark : light;
}

float toLinear(float encoded)
{
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

QVector4D linear(const QColor &color)
{
    return {toLinear(color.redF()), toLinear(color.greenF()), toLinear(color.blueF()), color.alphaF()};
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
{
    mBackground = makeProgram("fullscreen.vert", "background.frag");
    mSurface = makeProgram("surface.vert", "surface.frag");
    mSurfaceWithEdges = makeProgram("surface.vert", "surface.frag", "#define EDGES\n");
    mWire = makeProgram("surface.vert", "surface.frag", "#define EDGES\n#define WIRE\n");
    mPoints = makeProgram("points.vert", "points.frag");
    mGrid = makeProgram("grid.vert", "grid.frag");
    mGl.glGenVertexArrays(1, &mEmptyArray);
}

SceneRenderer::~SceneRenderer()
{
    mGl.glDeleteVertexArrays(1, &mEmptyArray);
}

SceneRenderer::Program SceneRenderer::makeProgram(const QString &vertexFile, const QString &fragmentFile,
                                                  const QByteArray &defines)
{
    const auto contents = [](const QString &name) {
        QFile file(":/shaders/" + name);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    const QByteArray start = "#version 330 core\n" + defines;
    auto program = std::make_unique<QOpenGLShaderProgram>();
    const bool isGood = program->addShaderFromSourceCode(QOpenGLShader::Vertex, start + contents(vertexFile)) &&
                        program->addShaderFromSourceCode(QOpenGLShader::Fragment,
                                                         start + contents("lighting.glsl") + contents(fragmentFile)) &&
                        program->link();
    if (!isGood && mError.isEmpty())
        mError = vertexFile + ", " + fragmentFile + ": " + program->log();
    return program;
}

void SceneRenderer::upload(const FrameData &frame, const model::FrameSourcePtr &source)
{
    mMesh.upload(frame, source);
    mHasMesh = true;
}

void SceneRenderer::draw(const model::OrbitCamera &camera, QSize size, const model::Box3f &scene,
                         const ViewStyle &style)
{
    resetState(size);
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
    drawBackground(aspect, style);
    if (mHasMesh)
        drawMesh(style);
    if (style.hasGrid && !scene.isEmpty() && scene.diagonal() > 0)
        drawGrid(scene, style);
    mGl.glUseProgram(0);
}

void SceneRenderer::resetState(QSize size)
{
    // QPainter leaves its own state behind after each overlay; multisampling in particular stays off.
    mGl.glViewport(0, 0, size.width(), size.height());
    mGl.glDisable(GL_SCISSOR_TEST);
    mGl.glDisable(GL_STENCIL_TEST);
    mGl.glDisable(GL_BLEND);
    mGl.glDisable(GL_CULL_FACE);
    mGl.glEnable(GL_MULTISAMPLE);
    mGl.glEnable(GL_DEPTH_TEST);
    mGl.glEnable(GL_PROGRAM_POINT_SIZE);
    mGl.glDepthFunc(GL_LEQUAL);
    mGl.glDepthMask(GL_TRUE);
    mGl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    mGl.glClearColor(0.1f, 0.1f, 0.12f, 1);
    mGl.glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    // The alpha of the picture stays 1: a window would show through otherwise.
    mGl.glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
}

void SceneRenderer::use(const Program &program, const ViewStyle &style)
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

void SceneRenderer::drawBackground(float aspect, const ViewStyle &style)
{
    const Colors &colors = colorsFor(style.isDark);
    mGl.glDepthMask(GL_FALSE);
    mGl.glDisable(GL_DEPTH_TEST);
    mBackground->bind();
    mBackground->setUniformValue("uTop", linear(colors.top).toVector3D());
    mBackground->setUniformValue("uBottom", linear(colors.bottom).toVector3D());
    mBackground->setUniformValue("uAspect", aspect);
    mGl.glBindVertexArray(mEmptyArray);
    mGl.glDrawArrays(GL_TRIANGLES, 0, 3);
    mGl.glBindVertexArray(0);
    mGl.glEnable(GL_DEPTH_TEST);
    mGl.glDepthMask(GL_TRUE);
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
    const Program &program = isWire ? mWire : mSurfaceWithEdges;
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
