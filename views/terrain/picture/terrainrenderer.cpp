// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/picture/terrainrenderer.h"

#include "views/terrain/picture/constraintlines.h"
#include "views/terrain/picture/graintexture.h"
#include "views/terrain/picture/scalars.h"

#include <QVector3D>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace views {

using namespace model::terrain;

namespace {

constexpr double Degree = std::numbers::pi / 180;
constexpr double SteepestSlope = 60; ///< degrees, with the last colour
/// Side of a tile of grains, as a share of the terrain's longer side: grains as in a sandbox, whatever the terrain's
/// size.
constexpr float TileShare = 0.055f;
constexpr float LineHalfWidth = 0.9f;
const QVector4D ActiveColor(1.0f, 0.36f, 0.08f, 0.55f);

enum Unit { LightUnit, GrainUnit, LineColorUnit, HeightUnit, PaintUnit };

/// Squares along a side of the grid that stands for a terrain of more triangles than this while the camera moves.
constexpr int CoarseSquares = 200;
constexpr std::uint32_t CoarseFrom = 150000;

QVector3D toQt(model::Vec3f v)
{
    return {v.x, v.y, v.z};
}

std::array<float, 4> clipOf(const model::Matrix4 &matrix, const model::Box3f &box, int corner)
{
    const float p[4] = {corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                        corner & 4 ? box.max.z : box.min.z, 1};
    std::array<float, 4> clip{};
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column)
            clip[row] += matrix[column * 4 + row] * p[column];
    return clip;
}

bool contains(const model::Box3f &outer, const model::Box3f &inner)
{
    return inner.isEmpty() || (outer.min.x <= inner.min.x && outer.min.y <= inner.min.y && outer.min.z <= inner.min.z &&
                               outer.max.x >= inner.max.x && outer.max.y >= inner.max.y && outer.max.z >= inner.max.z);
}

/// Its numbers go to the GPU with the vertices.
bool isScalarOverlay(GroundOverlay overlay)
{
    return overlay == GroundOverlay::Thickness || overlay == GroundOverlay::CutAndFill ||
           overlay == GroundOverlay::Mask;
}

bool hasShadows(const TerrainStyle &style)
{
    return style.quality != GroundQuality::Low && style.look != GroundLook::Reference;
}

/// Room for digging and heaping, before the depth planes have to move.
model::Box3f roomy(model::Box3f box)
{
    const float room = 0.3f * box.size().y + 0.02f * box.diagonal();
    box.min.y -= room;
    box.max.y += room;
    return box;
}

} // namespace

bool isInView(const model::Matrix4 &matrix, const model::Box3f &box)
{
    // Out if all corners are beyond the same plane of the clip volume.
    int outside[6] = {};
    for (int corner = 0; corner < 8; ++corner) {
        const std::array<float, 4> clip = clipOf(matrix, box, corner);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            outside[2 * axis] += clip[axis] < -clip[3];
            outside[2 * axis + 1] += clip[axis] > clip[3];
        }
    }
    return std::none_of(std::begin(outside), std::end(outside), [](int count) { return count == 8; });
}

model::Vec3f sunDirection(const TerrainStyle &style)
{
    const double azimuth = style.sunAzimuth * Degree, elevation = style.sunElevation * Degree;
    return {float(std::sin(azimuth) * std::cos(elevation)), float(std::sin(elevation)),
            float(-std::cos(azimuth) * std::cos(elevation))};
}

TerrainRenderer::TerrainRenderer(QOpenGLFunctions_3_3_Core &gl, const Terrain &terrain, const GroundFrame &frame)
    : mGl(gl)
    , mTerrain(terrain)
    , mFrame(frame)
    , mBuffers(gl, terrain, frame)
    , mBackdrop(gl, mError)
    , mMaps(gl, frame, mError)
    , mLines(makeProgram({"terrain/lines.vert", "terrain/lines.frag", "terrain/lines.geom"}, {}, mError))
    , mFlat(makeProgram({"terrain/terrain.vert", "terrain/flat.frag", {}}, {}, mError))
{
    const std::vector<std::uint8_t> grains = makeGrains();
    mGl.glGenTextures(1, &mGrains);
    mGl.glBindTexture(GL_TEXTURE_2D, mGrains);
    mGl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, GrainSide, GrainSide, 0, GL_RGBA, GL_UNSIGNED_BYTE, grains.data());
    mGl.glGenerateMipmap(GL_TEXTURE_2D);
    mGl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    mGl.glBindTexture(GL_TEXTURE_2D, 0);
    mGl.glGenVertexArrays(1, &mEmptyArray);
    mGl.glGenBuffers(1, &mLineColors);
    mGl.glGenTextures(1, &mLineTexture);
}

TerrainRenderer::~TerrainRenderer()
{
    mGl.glDeleteTextures(1, &mGrains);
    mGl.glDeleteTextures(1, &mLineTexture);
    mGl.glDeleteBuffers(1, &mLineColors);
    mGl.glDeleteVertexArrays(1, &mEmptyArray);
}

void TerrainRenderer::note(const Edit &edit)
{
    mBuffers.note(edit);
    mAreLinesStale = true;
}

void TerrainRenderer::setReference(TerrainPtr reference)
{
    mReference = std::move(reference);
    if (std::exchange(mScalarOf, GroundOverlay::None) == GroundOverlay::CutAndFill)
        mIsAllChanged = true;
}

void TerrainRenderer::setMask(std::shared_ptr<const PaintMask> mask)
{
    mMask = std::move(mask);
    if (mScalarOf == GroundOverlay::Mask) {
        mScalarOf = GroundOverlay::None;
        mIsAllChanged = true;
    }
}

void TerrainRenderer::setActiveTriangles(const std::vector<TriangleId> &triangles)
{
    const TinArrays &tin = mTerrain.tin.arrays();
    std::vector<std::uint32_t> indices;
    indices.reserve(3 * triangles.size());
    for (const TriangleId t : triangles)
        if (tin.isTriangle(t) && !tin.isVoid(t))
            for (std::uint32_t i = 0; i < 3; ++i)
                indices.push_back(tin.vertex(cornerOf(t, i)));
    mBuffers.setExtra(TerrainBuffers::Extra::Triangles, indices);
    mIsAllChanged = true;
}

void TerrainRenderer::updateScalar(const TerrainStyle &style)
{
    const bool isScalar = isScalarOverlay(style.overlay);
    const GroundOverlay wanted = isScalar ? style.overlay : GroundOverlay::None;
    const bool isOther = wanted == GroundOverlay::Thickness && style.thicknessLayer != mScalarLayer;
    if (!isScalar || (wanted == mScalarOf && !isOther))
        return; // numbers that are there do no harm
    mScalarOf = wanted;
    mScalarLayer = style.thicknessLayer;
    mBuffers.setScalar(wanted == GroundOverlay::Thickness ? thicknessOf(mTerrain, style.thicknessLayer)
                       : wanted == GroundOverlay::Mask    ? protectionOf(mTerrain, mMask)
                                                          : heightOver(mTerrain, mReference));
}

void TerrainRenderer::upload(const TerrainStyle &style, double milliseconds)
{
    updateScalar(style);
    const GroundRange before = rangeOf(style.overlay);
    if (mBuffers.upload(milliseconds)) {
        mChanges.add(mBuffers.changedBox());
        mMaps.note(mBuffers.changedBox());
    }
    const GroundRange after = rangeOf(style.overlay);
    if (style.overlay != GroundOverlay::None && (after.low != before.low || after.high != before.high))
        mIsAllChanged = true;
}

model::Box3f TerrainRenderer::takeChanges()
{
    return std::exchange(mChanges, {});
}

bool TerrainRenderer::takeIsAllChanged()
{
    return std::exchange(mIsAllChanged, false) || !contains(mDepthBox, mBuffers.box());
}

GroundRange TerrainRenderer::rangeOf(GroundOverlay overlay) const
{
    const auto notEmpty = [](double low, double high) { return GroundRange{low, high > low ? high : low + 1}; };
    switch (overlay) {
    case GroundOverlay::Height:
        if (mBuffers.box().isEmpty())
            break;
        return notEmpty(double(mBuffers.box().min.y) + mFrame.middle().z,
                        double(mBuffers.box().max.y) + mFrame.middle().z);
    case GroundOverlay::Slope:
        return {0, SteepestSlope};
    case GroundOverlay::Humidity:
    case GroundOverlay::Mask:
        return {0, 100};
    case GroundOverlay::Thickness:
        return notEmpty(0, double(mBuffers.highestScalar()));
    case GroundOverlay::CutAndFill: {
        const double reach = double(std::max(-mBuffers.lowestScalar(), mBuffers.highestScalar()));
        return reach > 0 ? GroundRange{-reach, reach} : GroundRange{-1, 1};
    }
    case GroundOverlay::None:
        break;
    }
    return {};
}

double TerrainRenderer::contourInterval(const TerrainStyle &style) const
{
    if (style.contourInterval > 0)
        return style.contourInterval;
    return roundUp(mBuffers.box().isEmpty() ? 1 : double(mBuffers.box().size().y) / 20);
}

bool TerrainRenderer::canBeCoarse(const TerrainStyle &style) const
{
    return mTerrain.tin.triangleCount() > CoarseFrom && !mBuffers.hasMore() && !style.hasWireframe &&
           !isScalarOverlay(style.overlay);
}

QOpenGLShaderProgram &TerrainRenderer::groundProgram(const TerrainStyle &style, bool isCoarse)
{
    QByteArray defines;
    if (isCoarse)
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
    ShaderProgram &program = mGround[defines];
    if (!program)
        program = makeProgram({isCoarse ? "terrain/coarse.vert" : "terrain/terrain.vert", "terrain/terrain.frag",
                               style.hasWireframe ? QStringLiteral("terrain/edges.geom") : QString()},
                              defines, mError);
    return *program;
}

void TerrainRenderer::use(QOpenGLShaderProgram &program)
{
    program.bind();
    mGl.glUniformMatrix4fv(program.uniformLocation("uView"), 1, GL_FALSE, mView.data());
    mGl.glUniformMatrix4fv(program.uniformLocation("uProjection"), 1, GL_FALSE, mProjection.data());
}

void TerrainRenderer::setGround(QOpenGLShaderProgram &program, const TerrainPicture &picture)
{
    const TerrainStyle &style = picture.style;
    const bool hasMaps = hasShadows(style) && !mBuffers.hasMore();
    program.setUniformValue("uEye", toQt(picture.camera.position()));
    program.setUniformValue("uSun", toQt(sunDirection(style)));
    program.setUniformValue("uHalf", mFrame.halfX(), mFrame.halfY());
    program.setUniformValue("uTile", 2 * std::max(mFrame.halfX(), mFrame.halfY()) * TileShare);
    program.setUniformValue("uHasMaps", hasMaps);
    program.setUniformValue("uLight", int(LightUnit));
    program.setUniformValue("uGrains", int(GrainUnit));
    const double interval = style.hasContours ? contourInterval(style) : 0;
    program.setUniformValue("uContour", float(interval));
    // The lines lie at whole multiples from height 0, wherever the scene's middle is; each fifth is a thick one.
    program.setUniformValue("uContourPhase", interval > 0 ? float(std::fmod(mFrame.middle().z / interval, 5)) : 0.0f);
    if (style.overlay != GroundOverlay::None) {
        GroundRange range = rangeOf(style.overlay);
        if (style.overlay == GroundOverlay::Height) {
            range.low -= mFrame.middle().z;
            range.high -= mFrame.middle().z;
        } else if (style.overlay == GroundOverlay::Humidity) {
            range = {0, 1};
        }
        std::array<QVector3D, 9> colors;
        for (std::size_t i = 0; i < colors.size(); ++i) {
            const QRgb color = colorsOf(style.overlay)[i];
            colors[i] = QVector3D(float(qRed(color)), float(qGreen(color)), float(qBlue(color))) / 255;
        }
        program.setUniformValue("uKind", std::min(int(style.overlay), 4));
        program.setUniformValue("uRange", float(range.low), float(range.high));
        program.setUniformValueArray("uColors", colors.data(), int(colors.size()));
    }
    mGl.glActiveTexture(GL_TEXTURE0 + GrainUnit);
    mGl.glBindTexture(GL_TEXTURE_2D, mGrains);
    mGl.glActiveTexture(GL_TEXTURE0 + LightUnit);
    mGl.glBindTexture(GL_TEXTURE_2D, hasMaps ? mMaps.light() : 0);
}

QRect TerrainRenderer::partOf(const model::Box3f &box, QSize size) const
{
    const model::Matrix4 whole = model::multiply(mProjection, mView);
    float low[2] = {1, 1}, high[2] = {-1, -1};
    for (int corner = 0; corner < 8; ++corner) {
        const std::array<float, 4> clip = clipOf(whole, box, corner);
        if (clip[3] <= 0)
            return {};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const float place = std::clamp(clip[axis] / clip[3], -1.0f, 1.0f);
            low[axis] = std::min(low[axis], place);
            high[axis] = std::max(high[axis], place);
        }
    }
    constexpr int Edge = 4; // lines are wider than what they lie on
    const auto pixel = [](float place, int count) { return (place * 0.5f + 0.5f) * float(count); };
    const QPoint from(int(std::floor(pixel(low[0], size.width()))) - Edge,
                      int(std::floor(pixel(low[1], size.height()))) - Edge);
    const QPoint to(int(std::ceil(pixel(high[0], size.width()))) + Edge,
                    int(std::ceil(pixel(high[1], size.height()))) + Edge);
    return QRect(from, to).intersected(QRect(QPoint(0, 0), size));
}

void TerrainRenderer::draw(const TerrainPicture &picture, const model::Box3f *changes)
{
    const TerrainStyle &style = picture.style;
    model::Box3f wide = changes ? *changes : model::Box3f();
    const bool isLit = hasShadows(style) && !mBuffers.hasMore();
    if (isLit && !(picture.keepsShadows && mHasShadows)) {
        wide.add(mMaps.lightChanges());
        mMaps.updateHeights(mBuffers, style.quality == GroundQuality::High ? 1024 : 512);
        mMaps.updateLight(mBuffers.box(), sunDirection(style));
        if (changes && !wide.isEmpty())
            wide = GroundMaps::litBox(wide, mBuffers.box(), sunDirection(style));
    }
    mHasShadows = isLit;
    const bool isCoarse = picture.isCoarse && canBeCoarse(style);
    if (isCoarse)
        mMaps.updateHeights(mBuffers, std::max(mMaps.side(), 512));
    mGl.glBindFramebuffer(GL_FRAMEBUFFER, picture.framebuffer);
    const float aspect = float(picture.size.width()) / float(std::max(picture.size.height(), 1));
    mView = picture.camera.viewMatrix();
    if (!contains(mDepthBox, mBuffers.box()))
        mDepthBox = roomy(mBuffers.box());
    mProjection = picture.camera.projectionMatrix(aspect, mDepthBox);
    model::Matrix4 seen = model::multiply(mProjection, mView);
    QRect part;
    if (changes && !wide.isEmpty()) {
        part = partOf(wide, picture.size);
        if (!part.isEmpty()) { // for culling, the part fills the picture
            model::Matrix4 crop{};
            crop[0] = float(picture.size.width()) / float(part.width());
            crop[5] = float(picture.size.height()) / float(part.height());
            crop[10] = crop[15] = 1;
            crop[12] = float(picture.size.width() - 2 * part.x()) / float(part.width()) - 1;
            crop[13] = float(picture.size.height() - 2 * part.y()) / float(part.height()) - 1;
            seen = model::multiply(crop, seen);
        }
    }
    beginPicture(mGl, picture.size, part);
    if (!mError.isEmpty() || picture.size.isEmpty())
        return;
    mBackdrop.draw(aspect, style.isDark);
    QOpenGLShaderProgram &ground = groundProgram(style, isCoarse);
    if (!mError.isEmpty())
        return;
    use(ground);
    setGround(ground, picture);
    if (isCoarse)
        drawCoarsely(ground);
    else
        mBuffers.draw([&seen](const model::Box3f &box) { return isInView(seen, box); });
    if (style.hasActiveTriangles)
        drawActive();
    if (style.edges != GroundEdges::None)
        drawLines(picture);
    mGl.glUseProgram(0);
    mGl.glDisable(GL_SCISSOR_TEST);
}

void TerrainRenderer::drawCoarsely(QOpenGLShaderProgram &program)
{
    program.setUniformValue("uSquares", CoarseSquares);
    program.setUniformValue("uHeights", int(HeightUnit));
    program.setUniformValue("uPaint", int(PaintUnit));
    mGl.glActiveTexture(GL_TEXTURE0 + HeightUnit);
    mGl.glBindTexture(GL_TEXTURE_2D, mMaps.heights());
    mGl.glActiveTexture(GL_TEXTURE0 + PaintUnit);
    mGl.glBindTexture(GL_TEXTURE_2D, mMaps.paint());
    mGl.glActiveTexture(GL_TEXTURE0);
    mGl.glBindVertexArray(mEmptyArray);
    mGl.glDrawArrays(GL_TRIANGLES, 0, 6 * CoarseSquares * CoarseSquares);
    mGl.glBindVertexArray(0);
}

void TerrainRenderer::drawActive()
{
    use(*mFlat);
    mFlat->setUniformValue("uFlat", ActiveColor);
    mGl.glEnable(GL_BLEND);
    mBuffers.drawExtra(TerrainBuffers::Extra::Triangles);
    mGl.glDisable(GL_BLEND);
}

void TerrainRenderer::updateLines(const TerrainStyle &style)
{
    if (!mAreLinesStale && mLinesOf == style.edges)
        return;
    mAreLinesStale = false;
    mLinesOf = style.edges;
    const ConstraintLines lines =
        constraintLines(mTerrain.tin.arrays(), style.edges == GroundEdges::ConstrainedByOwner);
    mBuffers.setExtra(TerrainBuffers::Extra::Lines, lines.vertices);
    mGl.glBindBuffer(GL_TEXTURE_BUFFER, mLineColors);
    mGl.glBufferData(GL_TEXTURE_BUFFER, GLsizeiptr(lines.colors.size() * sizeof(std::uint32_t)), lines.colors.data(),
                     GL_DYNAMIC_DRAW);
    mGl.glBindBuffer(GL_TEXTURE_BUFFER, 0);
}

void TerrainRenderer::drawLines(const TerrainPicture &picture)
{
    updateLines(picture.style);
    use(*mLines);
    mLines->setUniformValue("uSize", float(picture.size.width()), float(picture.size.height()));
    mLines->setUniformValue("uHalfWidth", LineHalfWidth * picture.pixelRatio);
    mLines->setUniformValue("uLineColors", int(LineColorUnit));
    mGl.glActiveTexture(GL_TEXTURE0 + LineColorUnit);
    mGl.glBindTexture(GL_TEXTURE_BUFFER, mLineTexture);
    mGl.glTexBuffer(GL_TEXTURE_BUFFER, GL_R32UI, mLineColors);
    mGl.glEnable(GL_BLEND);
    mBuffers.drawExtra(TerrainBuffers::Extra::Lines);
    mGl.glDisable(GL_BLEND);
    mGl.glBindTexture(GL_TEXTURE_BUFFER, 0);
    mGl.glActiveTexture(GL_TEXTURE0);
}

} // namespace views
