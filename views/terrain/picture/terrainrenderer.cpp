// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/picture/terrainrenderer.h"

#include "views/terrain/picture/constraintlines.h"
#include "views/terrain/picture/scalars.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace views {

using namespace model::terrain;

namespace {

constexpr double SteepestSlope = 60; ///< degrees, with the last colour
constexpr float LineHalfWidth = 0.9f;
const QVector4D ActiveColor(1.0f, 0.36f, 0.08f, 0.55f);
constexpr int LineColorUnit = 0;

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

int mapSideFor(const TerrainStyle &style)
{
    return style.quality == GroundQuality::High ? 1024 : 512;
}

/// Maps a part of the clip volume to all of it.
model::Matrix4 cropTo(const QRect &part, QSize size)
{
    model::Matrix4 crop{};
    crop[0] = float(size.width()) / float(part.width());
    crop[5] = float(size.height()) / float(part.height());
    crop[10] = crop[15] = 1;
    crop[12] = float(size.width() - 2 * part.x()) / float(part.width()) - 1;
    crop[13] = float(size.height() - 2 * part.y()) / float(part.height()) - 1;
    return crop;
}

model::Matrix4 projectionOf(const TerrainPicture &picture, const model::Box3f &box)
{
    const float aspect = float(picture.size.width()) / float(std::max(picture.size.height(), 1));
    return picture.camera.projectionMatrix(aspect, box);
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

TerrainRenderer::TerrainRenderer(QOpenGLFunctions_3_3_Core &gl, const Terrain &terrain, const GroundFrame &frame,
                                 int mapPieces)
    : mGl(gl)
    , mTerrain(&terrain)
    , mFrame(frame)
    , mBuffers(std::in_place, gl, terrain, frame)
    , mBackdrop(gl, mError)
    , mMaps(gl, frame, mapPieces, mError)
    , mShading(gl, frame, mError)
    , mLines(makeProgram({"terrain/lines.vert", "terrain/lines.frag", "terrain/lines.geom"}, {}, mError))
    , mFlat(makeProgram({"terrain/terrain.vert", "terrain/flat.frag", {}}, {}, mError))
{
    mGl.glGenBuffers(1, &mLineColors);
    mGl.glGenTextures(1, &mLineTexture);
}

TerrainRenderer::~TerrainRenderer()
{
    mGl.glDeleteTextures(1, &mLineTexture);
    mGl.glDeleteBuffers(1, &mLineColors);
}

void TerrainRenderer::setTerrain(const Terrain &terrain)
{
    mTerrain = &terrain;
    mBuffers.emplace(mGl, terrain, mFrame);
    mMaps.restart();
    mReference.reset();
    mMask.reset();
    mScalarOf = GroundOverlay::None;
    mLinesOf = GroundEdges::None;
    mAreLinesStale = mIsAllChanged = true;
    mChanges = {};
}

void TerrainRenderer::note(const Edit &edit)
{
    mBuffers->note(edit);
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
    const TinArrays &tin = mTerrain->tin.arrays();
    std::vector<std::uint32_t> indices;
    indices.reserve(3 * triangles.size());
    for (const TriangleId t : triangles)
        if (tin.isTriangle(t) && !tin.isVoid(t))
            for (std::uint32_t i = 0; i < 3; ++i)
                indices.push_back(tin.vertex(cornerOf(t, i)));
    mBuffers->setExtra(TerrainBuffers::Extra::Triangles, indices);
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
    mBuffers->setScalar(wanted == GroundOverlay::Thickness ? thicknessOf(*mTerrain, style.thicknessLayer)
                        : wanted == GroundOverlay::Mask    ? protectionOf(*mTerrain, mMask)
                                                           : heightOver(*mTerrain, mReference));
}

void TerrainRenderer::upload(const TerrainStyle &style, double milliseconds)
{
    updateScalar(style);
    const GroundRange before = rangeOf(style.overlay);
    if (mBuffers->upload(milliseconds)) {
        mChanges.add(mBuffers->changedBox());
        mMaps.note(mBuffers->changedBox());
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
    return std::exchange(mIsAllChanged, false);
}

GroundRange TerrainRenderer::rangeOf(GroundOverlay overlay) const
{
    const auto notEmpty = [](double low, double high) { return GroundRange{low, high > low ? high : low + 1}; };
    switch (overlay) {
    case GroundOverlay::Height:
        if (mBuffers->box().isEmpty())
            break;
        return notEmpty(double(mBuffers->box().min.y) + mFrame.middle().z,
                        double(mBuffers->box().max.y) + mFrame.middle().z);
    case GroundOverlay::Slope:
        return {0, SteepestSlope};
    case GroundOverlay::Humidity:
    case GroundOverlay::Mask:
        return {0, 100};
    case GroundOverlay::Thickness:
        return notEmpty(0, double(mBuffers->highestScalar()));
    case GroundOverlay::CutAndFill: {
        const double reach = double(std::max(-mBuffers->lowestScalar(), mBuffers->highestScalar()));
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
    return roundUp(mBuffers->box().isEmpty() ? 1 : double(mBuffers->box().size().y) / 20);
}

bool TerrainRenderer::isLarge() const
{
    return mTerrain->tin.triangleCount() > GroundShading::gridTriangles();
}

bool TerrainRenderer::wantsLight(const TerrainPicture &picture) const
{
    return hasShadows(picture.style) && !(picture.keepsShadows && mMaps.hasLight());
}

bool TerrainRenderer::hasLateShadows(const TerrainStyle &style) const
{
    return hasShadows(style) && !mMaps.lightChanges().isEmpty();
}

bool TerrainRenderer::hasMapWork(const TerrainPicture &picture) const
{
    if (mBuffers->hasMore())
        return false;
    const bool isLit = wantsLight(picture);
    if (mMaps.side() != mapSideFor(picture.style) || mMaps.areHeightsStale())
        return isLit || (isLarge() && picture.isCoarse);
    return isLit && (mMaps.isLightStale() || !mMaps.isAimedAt(sunDirection(picture.style)));
}

model::Box3f TerrainRenderer::stepMaps(const TerrainPicture &picture)
{
    mMaps.setSide(mapSideFor(picture.style));
    if (mMaps.areHeightsStale()) {
        mMaps.stepHeights(*mBuffers);
        return {};
    }
    const model::Box3f lit = mMaps.aimLight(mBuffers->box(), sunDirection(picture.style));
    if (mMaps.isLightStale())
        mMaps.stepLight();
    return lit;
}

QRect TerrainRenderer::partOf(const TerrainPicture &picture, const model::Box3f &box) const
{
    const QRect all(QPoint(0, 0), picture.size);
    const model::Matrix4 whole = model::multiply(projectionOf(picture, mBuffers->box()), picture.camera.viewMatrix());
    float low[2] = {1, 1}, high[2] = {-1, -1};
    for (int corner = 0; corner < 8; ++corner) {
        const std::array<float, 4> clip = clipOf(whole, box, corner);
        if (clip[3] <= 0)
            return all;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const float place = std::clamp(clip[axis] / clip[3], -1.0f, 1.0f);
            low[axis] = std::min(low[axis], place);
            high[axis] = std::max(high[axis], place);
        }
    }
    constexpr int Edge = 4; // lines are wider than what they lie on
    const auto pixel = [](float place, int count) { return (place * 0.5f + 0.5f) * float(count); };
    const QPoint from(int(std::floor(pixel(low[0], all.width()))) - Edge,
                      int(std::floor(pixel(low[1], all.height()))) - Edge);
    const QPoint to(int(std::ceil(pixel(high[0], all.width()))) + Edge,
                    int(std::ceil(pixel(high[1], all.height()))) + Edge);
    return QRect(from, to).intersected(all);
}

void TerrainRenderer::begin(const TerrainPicture &picture, const QRect &part, PartProgress &progress)
{
    progress.isBegun = true;
    progress.view = picture.camera.viewMatrix();
    progress.projection = projectionOf(picture, mBuffers->box());
    progress.seen = model::multiply(cropTo(part, picture.size), model::multiply(progress.projection, progress.view));
    clearPicture(mGl);
    if (mError.isEmpty())
        mBackdrop.draw(float(picture.size.width()) / float(std::max(picture.size.height(), 1)), picture.style.isDark);
}

void TerrainRenderer::use(QOpenGLShaderProgram &program, const PartProgress &progress)
{
    program.bind();
    mGl.glUniformMatrix4fv(program.uniformLocation("uView"), 1, GL_FALSE, progress.view.data());
    mGl.glUniformMatrix4fv(program.uniformLocation("uProjection"), 1, GL_FALSE, progress.projection.data());
}

void TerrainRenderer::drawPart(const TerrainPicture &picture, GLuint framebuffer, const QRect &part,
                               PartProgress &progress, std::uint32_t mostChunks)
{
    mGl.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    setPictureState(mGl, picture.size, part);
    if (!progress.isBegun)
        begin(picture, part, progress);
    const std::uint32_t most = std::min(mostChunks, 1u << 16) * TerrainBuffers::ChunkSize; // of lines and triangles
    if (!mError.isEmpty()) {
        progress.isDone = true;
    } else if (drawGround(picture, progress, mostChunks)) {
        const TerrainStyle &style = picture.style;
        const bool hasActive = style.hasActiveTriangles && !picture.isCoarse;
        const bool hasLines = style.edges != GroundEdges::None && !picture.isCoarse;
        progress.isDone =
            (!hasActive || drawActive(progress, most)) && (!hasLines || drawLines(picture, progress, most));
    }
    mGl.glUseProgram(0);
    mGl.glDisable(GL_SCISSOR_TEST);
}

// These draw the next of their things. True if there are no more.

bool TerrainRenderer::drawGround(const TerrainPicture &picture, PartProgress &progress, std::uint32_t mostChunks)
{
    progress.drawnChunks = 0;
    if (progress.chunk >= mBuffers->chunkCount())
        return true;
    const bool isGrid = picture.isCoarse && isLarge() && mMaps.hasHeights();
    const GroundShading::Scene scene{picture,
                                     mMaps,
                                     hasShadows(picture.style) && mMaps.hasLight() && !mBuffers->hasMore(),
                                     isGrid,
                                     rangeOf(picture.style.overlay),
                                     picture.style.hasContours ? contourInterval(picture.style) : 0};
    QOpenGLShaderProgram *program = mShading.use(scene);
    if (!program)
        return true;
    use(*program, progress);
    if (isGrid) {
        mShading.drawGrid(*program, mMaps);
        progress.chunk = mBuffers->chunkCount();
        return true;
    }
    const TerrainBuffers::DrawnChunks drawn = mBuffers->draw(
        [&](const model::Box3f &box) { return isInView(progress.seen, box); }, progress.chunk, mostChunks);
    progress.chunk = drawn.next;
    progress.drawnChunks = drawn.count;
    return progress.chunk >= mBuffers->chunkCount();
}

bool TerrainRenderer::drawActive(PartProgress &progress, std::uint32_t most)
{
    use(*mFlat, progress);
    mFlat->setUniformValue("uFlat", ActiveColor);
    mGl.glEnable(GL_BLEND);
    progress.active = mBuffers->drawExtra(TerrainBuffers::Extra::Triangles, progress.active, most);
    mGl.glDisable(GL_BLEND);
    return progress.active >= mBuffers->extraCount(TerrainBuffers::Extra::Triangles);
}

void TerrainRenderer::updateLines(const TerrainStyle &style)
{
    if (!mAreLinesStale && mLinesOf == style.edges)
        return;
    mAreLinesStale = false;
    mLinesOf = style.edges;
    const ConstraintLines lines =
        constraintLines(mTerrain->tin.arrays(), style.edges == GroundEdges::ConstrainedByOwner);
    mBuffers->setExtra(TerrainBuffers::Extra::Lines, lines.vertices);
    mGl.glBindBuffer(GL_TEXTURE_BUFFER, mLineColors);
    mGl.glBufferData(GL_TEXTURE_BUFFER, GLsizeiptr(lines.colors.size() * sizeof(std::uint32_t)), lines.colors.data(),
                     GL_DYNAMIC_DRAW);
    mGl.glBindBuffer(GL_TEXTURE_BUFFER, 0);
}

bool TerrainRenderer::drawLines(const TerrainPicture &picture, PartProgress &progress, std::uint32_t most)
{
    updateLines(picture.style);
    use(*mLines, progress);
    mLines->setUniformValue("uSize", float(picture.size.width()), float(picture.size.height()));
    mLines->setUniformValue("uHalfWidth", LineHalfWidth * picture.pixelRatio);
    mLines->setUniformValue("uFirstLine", GLint(progress.line));
    mLines->setUniformValue("uLineColors", LineColorUnit);
    mGl.glActiveTexture(GL_TEXTURE0 + LineColorUnit);
    mGl.glBindTexture(GL_TEXTURE_BUFFER, mLineTexture);
    mGl.glTexBuffer(GL_TEXTURE_BUFFER, GL_R32UI, mLineColors);
    mGl.glEnable(GL_BLEND);
    progress.line = mBuffers->drawExtra(TerrainBuffers::Extra::Lines, progress.line, most);
    mGl.glDisable(GL_BLEND);
    mGl.glBindTexture(GL_TEXTURE_BUFFER, 0);
    return progress.line >= mBuffers->extraCount(TerrainBuffers::Extra::Lines);
}

} // namespace views
