// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/picture/terrainbuffers.h"

#include <QElapsedTimer>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <limits>
#include <utility>

namespace views {

using namespace model::terrain;

namespace {

/// Clean slots that are sent along rather than begin another call.
constexpr std::uint32_t HeightGap = 4, PaintGap = 8, TriangleGap = 3;
/// Slots sent between two looks at the clock.
constexpr std::uint32_t Portion = 4096;
/// The same of vertices that moved: the normals around a portion are sent with it, so that of several some go twice.
constexpr std::uint32_t MovedPortion = 16384;
/// Room for what strokes and erosion will add, as a share.
constexpr double Headroom = 0.25;
/// Edits that wrote more than this share of everything are sent like a new terrain, in portions.
constexpr double LargeShare = 0.25;
/// Of the terrain's longer side: some grains and streaks long, see GroundShading.
constexpr float ReachShare = 0.012f;

} // namespace

TerrainBuffers::TerrainBuffers(QOpenGLFunctions_3_3_Core &gl, const Terrain &terrain, const GroundFrame &frame)
    : mGl(gl)
    , mTerrain(terrain)
    , mMaker(terrain, frame)
    , mReach(slideReach(frame))
{
    mGl.glGenBuffers(BufferCount, mBuffers);
    mGl.glGenVertexArrays(ArrayCount, mArrays);
}

TerrainBuffers::~TerrainBuffers()
{
    mGl.glDeleteVertexArrays(ArrayCount, mArrays);
    mGl.glDeleteBuffers(BufferCount, mBuffers);
}

float TerrainBuffers::slideReach(const GroundFrame &frame)
{
    return ReachShare * 2 * std::max(frame.halfX(), frame.halfY());
}

void TerrainBuffers::note(const Edit &edit)
{
    const auto add = [&edit](TinPart part, DirtySlots &dirty) {
        for (const SlotRange &range : edit.dirtyRanges(part))
            for (std::uint32_t i = 0; i < range.count; ++i)
                dirty.add(range.first + i);
    };
    add(TinPart::Points, mPlaced);
    add(TinPart::Heights, mRaised);
    if (edit.isValuesOnly()) {
        mIsSliding.resize(vertexSlots());
        for (const SlotRange &range : edit.dirtyRanges(TinPart::Heights))
            std::fill_n(mIsSliding.begin() + std::ptrdiff_t(range.first), range.count, true);
    }
    add(TinPart::Layers, mPainted);
    add(TinPart::Triangles, mTriangles);
}

void TerrainBuffers::noteAll()
{
    mMaker.updateColors();
    mIsWhole = true;
    mNextVertex = 0;
    for (DirtySlots *dirty : {&mPlaced, &mRaised, &mTurned, &mPainted, &mSlid})
        dirty->clear();
}

void TerrainBuffers::setScalar(std::function<float(VertexId)> scalar)
{
    mScalar = std::move(scalar);
    mLowestScalar = mHighestScalar = 0;
    noteAll();
}

bool TerrainBuffers::grow(Buffer buffer, std::size_t wanted, std::size_t slotBytes)
{
    std::size_t &capacity = mCapacities[buffer];
    if (wanted <= capacity)
        return false;
    const std::size_t next = wanted + std::size_t(double(wanted) * Headroom) + 1024;
    GLuint grown = 0;
    mGl.glGenBuffers(1, &grown);
    mGl.glBindBuffer(GL_COPY_WRITE_BUFFER, grown);
    mGl.glBufferData(GL_COPY_WRITE_BUFFER, GLsizeiptr(next * slotBytes), nullptr, GL_DYNAMIC_DRAW);
    if (capacity > 0) { // from GPU to GPU
        mGl.glBindBuffer(GL_COPY_READ_BUFFER, mBuffers[buffer]);
        mGl.glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, GLsizeiptr(capacity * slotBytes));
    }
    mGl.glDeleteBuffers(1, &mBuffers[buffer]);
    mBuffers[buffer] = grown;
    capacity = next;
    return true;
}

void TerrainBuffers::makeRoom()
{
    bool hasGrown = grow(Places, vertexSlots(), sizeof(GroundPlace));
    hasGrown |= grow(Heights, vertexSlots(), sizeof(GroundHeight));
    hasGrown |= grow(Slides, vertexSlots(), sizeof(GroundSlide));
    hasGrown |= grow(Paints, vertexSlots(), sizeof(GroundPaint));
    hasGrown |= mScalar && grow(Scalars, vertexSlots(), sizeof(float));
    hasGrown |= grow(Triangles, triangleSlots(), 3 * sizeof(std::uint32_t));
    if (hasGrown)
        describeArrays();
    mPaint.resize(vertexSlots());
    mSentHeights.resize(vertexSlots());
    mSlides.resize(vertexSlots());
    mIsSliding.resize(vertexSlots());
    mBoxes.resize((triangleSlots() + ChunkSize - 1) / ChunkSize);
}

void TerrainBuffers::describeArrays()
{
    const struct
    {
        Buffer buffer;
        GLint count;
        GLenum type;
        GLboolean isShare;
        std::size_t stride, offset;
    } attributes[] = {
        {Places, 2, GL_FLOAT, GL_FALSE, sizeof(GroundPlace), 0},
        {Heights, 1, GL_FLOAT, GL_FALSE, sizeof(GroundHeight), offsetof(GroundHeight, y)},
        {Heights, 2, GL_SHORT, GL_TRUE, sizeof(GroundHeight), offsetof(GroundHeight, normalX)},
        {Paints, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(GroundPaint), 0},
        {Scalars, 1, GL_FLOAT, GL_FALSE, sizeof(float), 0},
        {Slides, 2, GL_SHORT, GL_FALSE, sizeof(GroundSlide), 0},
    };
    for (const auto &[array, indices] : {std::pair(TriangleArray, Triangles), std::pair(ExtraLineArray, ExtraLines),
                                         std::pair(ExtraTriangleArray, ExtraTriangles)}) {
        mGl.glBindVertexArray(mArrays[array]);
        mGl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, mBuffers[indices]);
        GLuint location = 0;
        for (const auto &[buffer, count, type, isShare, stride, offset] : attributes) {
            if (mCapacities[buffer] > 0) { // nothing may be read from a buffer that was never filled
                mGl.glBindBuffer(GL_ARRAY_BUFFER, mBuffers[buffer]);
                mGl.glVertexAttribPointer(location, count, type, isShare, GLsizei(stride),
                                          reinterpret_cast<const void *>(offset));
                mGl.glEnableVertexAttribArray(location);
            }
            ++location;
        }
    }
    mGl.glBindVertexArray(0);
}

template <class Value, class Make>
void TerrainBuffers::send(Buffer buffer, SlotRange range, Make make)
{
    const std::size_t bytes = range.count * sizeof(Value);
    mStaging.resize(bytes);
    for (std::uint32_t i = 0; i < range.count; ++i) {
        const Value value = make(range.first + i);
        std::memcpy(mStaging.data() + i * sizeof(Value), &value, sizeof(Value));
    }
    mGl.glBindBuffer(GL_COPY_WRITE_BUFFER, mBuffers[buffer]);
    mGl.glBufferSubData(GL_COPY_WRITE_BUFFER, GLintptr(range.first * sizeof(Value)), GLsizeiptr(bytes),
                        mStaging.data());
    mCount.total += bytes;
    mCount.last += bytes;
}

void TerrainBuffers::sendScalars(SlotRange range)
{
    send<float>(Scalars, range, [&](VertexId v) {
        const float number = tin().isVertex(v) ? mScalar(v) : 0;
        mLowestScalar = std::min(mLowestScalar, number);
        mHighestScalar = std::max(mHighestScalar, number);
        return number;
    });
}

void TerrainBuffers::sendAll(SlotRange range)
{
    const auto orNothing = [&](auto make) {
        return
            [this, make](VertexId v) { return tin().isVertex(v) ? (mMaker.*make)(v) : decltype((mMaker.*make)(v)){}; };
    };
    send<GroundPlace>(Places, range, orNothing(&GroundVertexMaker::place));
    send<GroundHeight>(Heights, range, [&](VertexId v) {
        const GroundHeight height = tin().isVertex(v) ? mMaker.height(v) : GroundHeight{};
        mSentHeights[v] = height.y;
        return height;
    });
    send<GroundSlide>(Slides, range, [&](VertexId v) { return mSlides[v]; });
    send<GroundPaint>(Paints, range,
                      [&](VertexId v) { return mPaint[v] = tin().isVertex(v) ? mMaker.paint(v) : GroundPaint{}; });
    if (mScalar)
        sendScalars(range);
}

void TerrainBuffers::sendPaint(const std::vector<SlotRange> &ranges)
{
    DirtySlots different;
    for (const SlotRange &range : ranges)
        for (VertexId v = range.first; v < range.first + range.count; ++v) {
            if (!tin().isVertex(v))
                continue;
            const GroundPaint paint = mMaker.paint(v);
            if (paint == mPaint[v])
                continue;
            mPaint[v] = paint;
            mChangedBox.add(mMaker.position(v));
            different.add(v);
        }
    for (const SlotRange &range : different.take(None, PaintGap))
        send<GroundPaint>(Paints, range, [&](VertexId v) { return mPaint[v]; });
}

void TerrainBuffers::sendTriangles(SlotRange range)
{
    using Indices = std::array<std::uint32_t, 3>;
    send<Indices>(Triangles, range, [&](TriangleId t) {
        Indices indices{};
        if (!tin().isTriangle(t) || tin().isVoid(t))
            return indices;
        for (std::uint32_t k = 0; k < 3; ++k) {
            indices[k] = tin().vertex(cornerOf(t, k));
            mBoxes[t / ChunkSize].add(mMaker.position(indices[k]));
        }
        return indices;
    });
    for (std::uint32_t chunk = range.first / ChunkSize; chunk <= (range.first + range.count - 1) / ChunkSize; ++chunk) {
        mBox.add(mBoxes[chunk]);
        noteHeights(mBoxes[chunk]);
    }
}

void TerrainBuffers::noteHeights(const model::Box3f &chunk)
{
    mChangedLow = std::min(mChangedLow, chunk.min.y);
    mChangedHigh = std::max(mChangedHigh, chunk.max.y);
}

void TerrainBuffers::addToBoxes(VertexId v)
{
    const model::Vec3f position = mMaker.position(v);
    mBox.add(position);
    forEachCornerAround(tin(), v, [&](Corner c) {
        mBoxes[triangleOf(c) / ChunkSize].add(position);
        noteHeights(mBoxes[triangleOf(c) / ChunkSize]);
    });
}

void TerrainBuffers::sendHeights(std::uint32_t vertices)
{
    for (const SlotRange &range : mTurned.take(vertices, HeightGap))
        send<GroundHeight>(Heights, range, [&](VertexId v) {
            if (!tin().isVertex(v))
                return GroundHeight{};
            mChangedBox.add(mMaker.position(v));
            const GroundHeight height = mMaker.height(v);
            addSlide(v, height);
            return height;
        });
    for (const SlotRange &range : mSlid.take(vertices, PaintGap))
        send<GroundSlide>(Slides, range, [&](VertexId v) { return mSlides[v]; });
}

void TerrainBuffers::addSlide(VertexId v, const GroundHeight &height)
{
    const float before = std::exchange(mSentHeights[v], height.y);
    if (!mIsSliding[v] || before == height.y)
        return;
    mIsSliding[v] = false;
    const GroundSlide slide = slid(mSlides[v], before, height, mReach);
    if (slide == mSlides[v])
        return;
    mSlides[v] = slide;
    mSlid.add(v);
}

/// New vertices have slid as far as those around them, or detail would be torn between them.
void TerrainBuffers::startSlides()
{
    std::vector<std::pair<VertexId, GroundSlide>> before;
    mPlaced.forEach([&](VertexId v) {
        if (!tin().isVertex(v))
            return;
        before.emplace_back(v, std::exchange(mSlides[v], {}));
        mIsSliding[v] = false;
    });
    for (const auto &[v, slide] : before) {
        int x = 0, z = 0, count = 0;
        forEachCornerAround(tin(), v, [&](Corner c) {
            const GroundSlide &other = mSlides[tin().vertex(next(c))];
            x += other.x;
            z += other.z;
            ++count;
        });
        if (count > 0)
            mSlides[v] = {std::int16_t(x / count), std::int16_t(z / count)};
        if (!(mSlides[v] == slide))
            mSlid.add(v);
    }
}

void TerrainBuffers::noteRing(VertexId v)
{
    mTurned.add(v);
    forEachCornerAround(tin(), v, [&](Corner c) {
        mTurned.add(tin().vertex(next(c)));
        mTurned.add(tin().vertex(previous(c)));
    });
}

void TerrainBuffers::sendNew(std::uint32_t vertices, std::uint32_t triangles)
{
    // Other normals, which go with those of what moved: around what has another place, and at triangles that are new.
    // Vertices that have gone need no sending.
    startSlides();
    mPlaced.forEach([&](VertexId v) {
        if (!tin().isVertex(v))
            return;
        noteRing(v);
        if (v < vertices)
            addToBoxes(v);
    });
    mTriangles.forEach([&](TriangleId t) {
        if (tin().isTriangle(t))
            for (std::uint32_t k = 0; k < 3; ++k)
                mTurned.add(tin().vertex(cornerOf(t, k)));
    });
    for (const SlotRange &range : mPlaced.take(vertices, HeightGap)) {
        send<GroundPlace>(Places, range,
                          [&](VertexId v) { return tin().isVertex(v) ? mMaker.place(v) : GroundPlace{}; });
        if (mScalar)
            sendScalars(range);
    }
    sendPaint(mPainted.take(vertices, 0));
    for (const SlotRange &range : mTriangles.take(triangles, TriangleGap))
        sendTriangles(range);
}

void TerrainBuffers::sendMoved(std::uint32_t vertices, std::uint32_t most)
{
    std::vector<SlotRange> moved = mRaised.take(vertices, mScalar ? PaintGap : 0, most);
    for (const SlotRange &range : moved)
        for (VertexId v = range.first; v < range.first + range.count; ++v) {
            if (!tin().isVertex(v))
                continue;
            noteRing(v);
            addToBoxes(v);
        }
    sendHeights(vertices);
    if (mScalar)
        for (const SlotRange &range : moved)
            sendScalars(range);
}

bool TerrainBuffers::upload(double milliseconds)
{
    const std::uint32_t vertices = vertexSlots(), triangles = triangleSlots();
    mChangedBox = {};
    mChangedLow = std::numeric_limits<float>::max();
    mChangedHigh = std::numeric_limits<float>::lowest();
    if (mPlaced.count() + mPainted.count() > LargeShare * vertices || mTriangles.count() > LargeShare * triangles) {
        noteAll();
        mNextTriangle = 0;
        mTriangles.clear();
    }
    if (!mIsWhole && mPlaced.count() + mRaised.count() + mPainted.count() + mTriangles.count() == 0)
        return false;
    mCount.last = 0;
    makeRoom();
    mNextVertex = std::min(mNextVertex, vertices);
    mNextTriangle = std::min(mNextTriangle, triangles);
    QElapsedTimer clock;
    clock.start();
    // What a whole upload has not come to yet waits for it.
    sendNew(mIsWhole ? mNextVertex : vertices, mIsWhole ? mNextTriangle : triangles);
    do
        sendMoved(mIsWhole ? mNextVertex : vertices, MovedPortion);
    while (mRaised.count() > 0 && double(clock.nsecsElapsed()) * 1e-6 < milliseconds);
    if (!mChangedBox.isEmpty()) {
        mChangedBox.min.y = std::min(mChangedBox.min.y, mChangedLow);
        mChangedBox.max.y = std::max(mChangedBox.max.y, mChangedHigh);
    }
    if (!mIsWhole) {
        mNextVertex = vertices;
        mNextTriangle = mDrawable = triangles;
        return true;
    }
    while (mNextVertex < vertices || mNextTriangle < triangles) {
        if (mNextVertex < vertices) {
            const std::uint32_t count = std::min(Portion, vertices - mNextVertex);
            sendAll({mNextVertex, count});
            mNextVertex += count;
        } else {
            const std::uint32_t count = std::min(Portion, triangles - mNextTriangle);
            sendTriangles({mNextTriangle, count});
            mNextTriangle += count;
        }
        if (double(clock.nsecsElapsed()) * 1e-6 > milliseconds)
            break;
    }
    mIsWhole = mNextVertex < vertices || mNextTriangle < triangles;
    mDrawable = std::max(std::min(mDrawable, triangles), mNextTriangle);
    mChangedBox = mBox;
    return true;
}

TerrainBuffers::DrawnChunks TerrainBuffers::draw(const std::function<bool(const model::Box3f &)> &isVisible,
                                                 std::uint32_t first, std::uint32_t most)
{
    mGl.glBindVertexArray(mArrays[TriangleArray]);
    std::uint32_t begin = 0, end = 0; // slots to draw that are not drawn yet
    const auto flush = [&] {
        if (begin < end)
            mGl.glDrawElements(GL_TRIANGLES, GLsizei(3 * (end - begin)), GL_UNSIGNED_INT,
                               reinterpret_cast<const void *>(std::size_t(begin) * 3 * sizeof(std::uint32_t)));
    };
    DrawnChunks drawn{first, 0};
    for (; drawn.next < chunkCount() && drawn.count < most; ++drawn.next) {
        const model::Box3f &box = mBoxes[drawn.next];
        if (box.isEmpty() || !isVisible(box))
            continue;
        ++drawn.count;
        const std::uint32_t slot = drawn.next * ChunkSize;
        if (slot != end) {
            flush();
            begin = slot;
        }
        end = std::min(slot + ChunkSize, mDrawable);
    }
    flush();
    mGl.glBindVertexArray(0);
    return drawn;
}

void TerrainBuffers::setExtra(Extra extra, const std::vector<std::uint32_t> &indices)
{
    mExtraCounts[int(extra)] = GLsizei(indices.size());
    mGl.glBindBuffer(GL_COPY_WRITE_BUFFER, mBuffers[extra == Extra::Lines ? ExtraLines : ExtraTriangles]);
    mGl.glBufferData(GL_COPY_WRITE_BUFFER, GLsizeiptr(indices.size() * sizeof(std::uint32_t)), indices.data(),
                     GL_DYNAMIC_DRAW);
}

std::uint32_t TerrainBuffers::extraCount(Extra extra) const
{
    return std::uint32_t(mExtraCounts[int(extra)]) / (extra == Extra::Lines ? 2 : 3);
}

std::uint32_t TerrainBuffers::drawExtra(Extra extra, std::uint32_t first, std::uint32_t most)
{
    const bool isLines = extra == Extra::Lines;
    const std::uint32_t corners = isLines ? 2 : 3;
    const std::uint32_t count = std::min(most, extraCount(extra) - first);
    if (count == 0 || mCapacities[Places] == 0)
        return extraCount(extra);
    mGl.glBindVertexArray(mArrays[isLines ? ExtraLineArray : ExtraTriangleArray]);
    mGl.glDrawElements(isLines ? GL_LINES : GL_TRIANGLES, GLsizei(corners * count), GL_UNSIGNED_INT,
                       reinterpret_cast<const void *>(std::size_t(corners) * first * sizeof(std::uint32_t)));
    mGl.glBindVertexArray(0);
    return first + count;
}

} // namespace views
