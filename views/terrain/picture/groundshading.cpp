// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/picture/groundshading.h"

#include "views/terrain/picture/graintexture.h"

#include <QVector3D>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace views {

namespace {

constexpr double Degree = std::numbers::pi / 180;
/// Side of a tile of grains, as a share of the terrain's longer side: grains as in a sandbox, whatever the terrain's
/// size.
constexpr float TileShare = 0.055f;

enum Unit { LightUnit, GrainUnit, HeightUnit, PaintUnit, NumberUnit };

QVector3D toQt(model::Vec3f v)
{
    return {v.x, v.y, v.z};
}

} // namespace

model::Vec3f sunDirection(const TerrainStyle &style)
{
    const double azimuth = style.sunAzimuth * Degree, elevation = style.sunElevation * Degree;
    return {float(std::sin(azimuth) * std::cos(elevation)), float(std::sin(elevation)),
            float(-std::cos(azimuth) * std::cos(elevation))};
}

GroundShading::GroundShading(QOpenGLFunctions_3_3_Core &gl, const GroundFrame &frame, QString &error)
    : mGl(gl)
    , mFrame(frame)
    , mError(error)
{
    const std::vector<std::uint8_t> grains = makeGrains();
    mGl.glGenTextures(1, &mGrains);
    mGl.glBindTexture(GL_TEXTURE_2D, mGrains);
    mGl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, GrainSide, GrainSide, 0, GL_RGBA, GL_UNSIGNED_BYTE, grains.data());
    mGl.glGenerateMipmap(GL_TEXTURE_2D);
    mGl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    mGl.glBindTexture(GL_TEXTURE_2D, 0);
    mGl.glGenVertexArrays(1, &mEmptyArray);
}

GroundShading::~GroundShading()
{
    mGl.glDeleteTextures(1, &mGrains);
    mGl.glDeleteVertexArrays(1, &mEmptyArray);
}

QOpenGLShaderProgram *GroundShading::programFor(const TerrainStyle &style, bool isGrid)
{
    QByteArray defines;
    if (isGrid)
        defines += "#define COARSE\n";
    if (style.overlay != GroundOverlay::None) {
        defines += "#define OVERLAY\n";
    } else {
        if (style.quality != GroundQuality::Low || style.look == GroundLook::Reference)
            defines += "#define DETAIL\n";
        if (style.look == GroundLook::Reference)
            defines += "#define REFERENCE\n";
        else if (style.quality == GroundQuality::High)
            defines += "#define TRIPLANAR\n";
    }
    if (style.hasWireframe)
        defines += "#define EDGES\n";
    ShaderProgram &program = mPrograms[defines];
    if (!program)
        program = makeProgram({isGrid ? "terrain/coarse.vert" : "terrain/terrain.vert", "terrain/terrain.frag",
                               style.hasWireframe ? QStringLiteral("terrain/edges.geom") : QString()},
                              defines, mError);
    return mError.isEmpty() ? program.get() : nullptr;
}

void GroundShading::setOverlay(QOpenGLShaderProgram &program, const Scene &scene)
{
    const GroundOverlay overlay = scene.picture.style.overlay;
    GroundRange range = scene.range;
    if (overlay == GroundOverlay::Height) {
        range.low -= mFrame.middle().z;
        range.high -= mFrame.middle().z;
    } else if (overlay == GroundOverlay::Humidity) {
        range = {0, 1};
    }
    std::array<QVector3D, 9> colors;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const QRgb color = colorsOf(overlay)[i];
        colors[i] = QVector3D(float(qRed(color)), float(qGreen(color)), float(qBlue(color))) / 255;
    }
    program.setUniformValue("uKind", std::min(int(overlay), 4));
    program.setUniformValue("uRange", float(range.low), float(range.high));
    program.setUniformValueArray("uColors", colors.data(), int(colors.size()));
}

QOpenGLShaderProgram *GroundShading::use(const Scene &scene)
{
    TerrainStyle style = scene.picture.style;
    style.hasWireframe &= !scene.picture.isCoarse;
    QOpenGLShaderProgram *program = programFor(style, scene.isGrid);
    if (!program)
        return nullptr;
    program->bind();
    program->setUniformValue("uEye", toQt(scene.picture.camera.position()));
    program->setUniformValue("uSun", toQt(sunDirection(style)));
    program->setUniformValue("uHalf", mFrame.halfX(), mFrame.halfY());
    program->setUniformValue("uTile", 2 * std::max(mFrame.halfX(), mFrame.halfY()) * TileShare);
    program->setUniformValue("uSlideReach", TerrainBuffers::slideReach(mFrame));
    program->setUniformValue("uHasMaps", scene.hasShadows);
    program->setUniformValue("uLight", int(LightUnit));
    program->setUniformValue("uGrains", int(GrainUnit));
    program->setUniformValue("uContour", float(scene.contourInterval));
    // The lines lie at whole multiples from height 0, wherever the scene's middle is; each fifth is a thick one.
    const double phase = scene.contourInterval > 0 ? std::fmod(mFrame.middle().z / scene.contourInterval, 5) : 0.0;
    program->setUniformValue("uContourPhase", float(phase));
    if (style.overlay != GroundOverlay::None)
        setOverlay(*program, scene);
    mGl.glActiveTexture(GL_TEXTURE0 + GrainUnit);
    mGl.glBindTexture(GL_TEXTURE_2D, mGrains);
    mGl.glActiveTexture(GL_TEXTURE0 + LightUnit);
    mGl.glBindTexture(GL_TEXTURE_2D, scene.hasShadows ? scene.maps.light() : 0);
    return program;
}

void GroundShading::drawGrid(QOpenGLShaderProgram &program, const GroundMaps &maps)
{
    program.setUniformValue("uSquares", GridSquares);
    program.setUniformValue("uHeights", int(HeightUnit));
    program.setUniformValue("uPaint", int(PaintUnit));
    program.setUniformValue("uNumbers", int(NumberUnit));
    for (const auto &[unit, texture] : {std::pair(HeightUnit, maps.heights()), std::pair(PaintUnit, maps.paint()),
                                        std::pair(NumberUnit, maps.numbers())}) {
        mGl.glActiveTexture(GLenum(GL_TEXTURE0 + unit));
        mGl.glBindTexture(GL_TEXTURE_2D, texture);
    }
    mGl.glActiveTexture(GL_TEXTURE0);
    mGl.glBindVertexArray(mEmptyArray);
    mGl.glDrawArrays(GL_TRIANGLES, 0, GLsizei(3 * gridTriangles()));
    mGl.glBindVertexArray(0);
}

} // namespace views
