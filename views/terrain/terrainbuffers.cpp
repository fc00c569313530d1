// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/terrainbuffers.h"

#include <QElapsedTimer>

#include <algorithm>
#include <cstddef>

namespace views {

using namespace model::terrain;

namespace {

/// Clean slots that are sent along rather than begin another call.
constexpr std::uint32_t VertexGap = 6, TriangleGap = 10;
/// Slots sent between two looks at the clock.
constexpr std::uint32_t Portion = 4096;
/// Room for what strokes and erosion will add, as a share.
constexpr double Headroom = 0.25;
/// Edits that wrote more than this share of everything are sent like a new terrain, in portions.
constexpr double LargeShare = 0.25;

} // namespace

TerrainBuffers::TerrainBuffers(QOpenGLFunctions_3_3_Core &gl, const Terrain &terrain, const GroundFrame &frame)
    : mGl(gl)
    , mTerrain(terrain)
    , mFrame(frame)
    , mMaker(terrain, frame)
{
    mGl.glGenBuffers(BufferCount, mBuffers);
    mGl.glGenVertexArrays(ArrayCount, mArrays);
}

TerrainBuffers::~TerrainBuffers()
{
    mGl.glDeleteVertexArrays(ArrayCount, mArrays);
    mGl.glDeleteBuffers(BufferCount, mBuffers);
}

void TerrainBuffers::note(const Edit &edit)
{
    const auto add = [&edit](TinPart part, DirtySlots &dirty) {
        for (const SlotRange &range : edit.dirtyRanges(part))
            for (std::uint32_t i = 0; i < range.count; ++i)
                dirty.add(range.first + i);
    };
    add(TinPart::Points, mMoved);
    add(TinPart::Heights, mMoved);
    add(TinPart::Layers, mRepainted);
    add(TinPart::Triangles, mTriangles);
}

void TerrainBuffers::noteAll()
{
    mMaker.updateColors();
    mIsWhole = true;
    mNextVertex = 0;
    mMoved.take(0, 0);
    mRepainted.take(0, 0);
}

void TerrainBuffers::setScalar(std::function<float(VertexId)> scalar)
{
    mScalar = std::move(scalar);
    mScalarCapacity = 0;
    if (mVertexCapacity > 0)
        describeArrays();
    noteAll();
}

bool TerrainBuffers::grow(Buffer buffer, std::size_t used, std::size_t wanted, std::size_t slotBytes,
                          std::size_t &capacity)
{
    if (wanted <= capacity)
        return false;
    const std::size_t next = wanted + std::size_t(double(wanted) * Headroom) + 1024;
    GLuint grown = 0;
    mGl.glGenBuffers(1, &grown);
    mGl.glBindBuffer(GL_COPY_WRITE_BUFFER, grown);
    mGl.glBufferData(GL_COPY_WRITE_BUFFER, GLsizeiptr(next * slotBytes), nullptr, GL_DYNAMIC_DRAW);
    if (const std::size_t kept = std::min(used, capacity)) { // from GPU to GPU
        mGl.glBindBuffer(GL_COPY_READ_BUFFER, mBuffers[buffer]);
        mGl.glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, GLsizeiptr(kept * slotBytes));
    }
    mGl.glDeleteBuffers(1, &mBuffers[buffer]);
    mBuffers[buffer] = grown;
    capacity = next;
    return true;
}

void TerrainBuffers::makeRoom()
{
    const bool grewVertices = grow(Vertices, mVertexCapacity, vertexSlots(), sizeof(GroundVertex), mVertexCapacity);
    const bool grewScalars = mScalar && grow(Scalars, mScalarCapacity, vertexSlots(), sizeof(float), mScalarCapacity);
    const bool grewTriangles =
        grow(Triangles, mTriangleCapacity, triangleSlots(), 3 * sizeof(std::uint32_t), mTriangleCapacity);
    if (grewVertices || grewScalars || grewTriangles)
        describeArrays();
    mBoxes.resize((triangleSlots() + ChunkSize - 1) / ChunkSize);
}

void TerrainBuffers::describeArrays()
{
    constexpr GLsizei Stride = sizeof(GroundVertex);
    const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void *>(bytes); };
    for (const auto &[array, indices] : {std::pair(TriangleArray, Triangles), std::pair(OtherArray, Others)}) {
        mGl.glBindVertexArray(mArrays[array]);
        mGl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, mBuffers[indices]);
        mGl.glBindBuffer(GL_ARRAY_BUFFER, mBuffers[Vertices]);
        mGl.glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, Stride, offset(offsetof(GroundVertex, position)));
        mGl.glVertexAttribPointer(1, 2, GL_SHORT, GL_TRUE, Stride, offset(offsetof(GroundVertex, normalX)));
        mGl.glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, Stride, offset(offsetof(GroundVertex, red)));
        for (GLuint location = 0; location < 3; ++location)
            mGl.glEnableVertexAttribArray(location);
        if (mScalarCapacity > 0) {
            mGl.glBindBuffer(GL_ARRAY_BUFFER, mBuffers[Scalars]);
            mGl.glVertexAttribPointer(3, 1, GL_FLOAT, GL_FALSE, sizeof(float), nullptr);
            mGl.glEnableVertexAttribArray(3);
        } else {
            mGl.glDisableVertexAttribArray(3);
        }
    }
    mGl.glBindVertexArray(0);
}

void TerrainBuffers::send(Buffer buffer, std::size_t offset, const void *data, std::size_t bytes)
{
    mGl.glBindBuffer(GL_COPY_WRITE_BUFFER, mBuffers[buffer]);
    mGl.glBufferSubData(GL_COPY_WRITE_BUFFER, GLintptr(offset), GLsizeiptr(bytes), data);
    mCount.total += bytes;
    mCount.last += bytes;
}

void TerrainBuffers::sendVertices(SlotRange range)
{
    mStaging.resize(range.count);
    for (std::uint32_t i = 0; i < range.count; ++i) {
        const VertexId v = range.first + i;
        mStaging[i] = mMaker.make(v);
        if (tin().isVertex(v))
            mChangedBox.add(mStaging[i].position);
    }
    send(Vertices, range.first * sizeof(GroundVertex), mStaging.data(), mStaging.size() * sizeof(GroundVertex));
    if (!mScalar)
        return;
    mScalarStaging.resize(range.count);
    for (std::uint32_t i = 0; i < range.count; ++i)
        mScalarStaging[i] = tin().isVertex(range.first + i) ? mScalar(range.first + i) : 0;
    send(Scalars, range.first * sizeof(float), mScalarStaging.data(), mScalarStaging.size() * sizeof(float));
}

void TerrainBuffers::sendTriangles(SlotRange range)
{
    mIndexStaging.resize(3 * std::size_t(range.count));
    for (std::uint32_t i = 0; i < range.count; ++i) {
        const TriangleId t = range.first + i;
        const bool isDrawn = tin().isTriangle(t) && !tin().isVoid(t);
        model::Box3f &box = mBoxes[t / ChunkSize];
        for (std::uint32_t k = 0; k < 3; ++k) {
            const VertexId v = isDrawn ? tin().vertex(cornerOf(t, k)) : 0;
            mIndexStaging[3 * i + k] = v;
            if (isDrawn)
                box.add(mFrame.toScene(tin().points[v].x, tin().points[v].y, tin().heights[v]));
        }
    }
    mBox.add(mBoxes[range.first / ChunkSize]);
    mBox.add(mBoxes[(range.first + range.count - 1) / ChunkSize]);
    send(Triangles, range.first * 3 * sizeof(std::uint32_t), mIndexStaging.data(),
         mIndexStaging.size() * sizeof(std::uint32_t));
}

void TerrainBuffers::addToBoxes(VertexId v, model::Vec3f position)
{
    mBox.add(position);
    forEachCornerAround(tin(), v, [&](Corner c) { mBoxes[triangleOf(c) / ChunkSize].add(position); });
}

void TerrainBuffers::noteRing(VertexId v)
{
    mRepainted.add(v);
    forEachCornerAround(tin(), v, [&](Corner c) {
        mRepainted.add(tin().vertex(next(c)));
        mRepainted.add(tin().vertex(previous(c)));
    });
}

bool TerrainBuffers::upload(double milliseconds)
{
    const std::uint32_t vertices = vertexSlots(), triangles = triangleSlots();
    mChangedBox = {};
    if (mMoved.count() + mRepainted.count() > LargeShare * vertices || mTriangles.count() > LargeShare * triangles) {
        noteAll();
        if (mTriangles.count() > 0)
            mNextTriangle = 0;
        mTriangles.take(0, 0);
    }
    if (!mIsWhole && mMoved.count() + mRepainted.count() + mTriangles.count() == 0)
        return false;
    mCount.last = 0;
    makeRoom();

    for (const VertexId v : mMoved.all()) {
        if (!tin().isVertex(v)) {
            mRepainted.add(v);
            continue;
        }
        noteRing(v);
        if (v < mNextVertex)
            addToBoxes(v, mFrame.toScene(tin().points[v].x, tin().points[v].y, tin().heights[v]));
    }
    mMoved.take(0, 0);
    for (const TriangleId t : mTriangles.all())
        if (tin().isTriangle(t) && !tin().isVoid(t))
            for (std::uint32_t k = 0; k < 3; ++k)
                mRepainted.add(tin().vertex(cornerOf(t, k)));
    mNextVertex = std::min(mNextVertex, vertices);
    mNextTriangle = std::min(mNextTriangle, triangles);
    // What a whole upload has not come to yet waits for it.
    for (const SlotRange &range : mRepainted.take(mIsWhole ? mNextVertex : vertices, VertexGap))
        sendVertices(range);
    for (const SlotRange &range : mTriangles.take(mIsWhole ? mNextTriangle : triangles, TriangleGap))
        sendTriangles(range);
    if (!mIsWhole) {
        mNextVertex = vertices;
        mNextTriangle = mDrawable = triangles;
        return true;
    }
    QElapsedTimer clock;
    clock.start();
    while (mNextVertex < vertices || mNextTriangle < triangles) {
        if (mNextVertex < vertices) {
            const std::uint32_t count = std::min(Portion, vertices - mNextVertex);
            sendVertices({mNextVertex, count});
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

void TerrainBuffers::draw(const std::function<bool(const model::Box3f &)> &isVisible)
{
    mGl.glBindVertexArray(mArrays[TriangleArray]);
    std::uint32_t begin = 0, end = 0; // slots to draw that are not drawn yet
    const auto flush = [&] {
        if (begin < end)
            mGl.glDrawElements(GL_TRIANGLES, GLsizei(3 * (end - begin)), GL_UNSIGNED_INT,
                               reinterpret_cast<const void *>(std::size_t(begin) * 3 * sizeof(std::uint32_t)));
    };
    for (std::uint32_t first = 0; first < mDrawable; first += ChunkSize) {
        const model::Box3f &box = mBoxes[first / ChunkSize];
        if (box.isEmpty() || !isVisible(box))
            continue;
        if (first != end) {
            flush();
            begin = first;
        }
        end = std::min(first + ChunkSize, mDrawable);
    }
    flush();
    mGl.glBindVertexArray(0);
}

void TerrainBuffers::setIndices(const std::vector<std::uint32_t> &indices)
{
    mIndexCount = GLsizei(indices.size());
    mGl.glBindVertexArray(0);
    mGl.glBindBuffer(GL_COPY_WRITE_BUFFER, mBuffers[Others]);
    mGl.glBufferData(GL_COPY_WRITE_BUFFER, GLsizeiptr(indices.size() * sizeof(std::uint32_t)), indices.data(),
                     GL_DYNAMIC_DRAW);
}

void TerrainBuffers::drawIndices(GLenum mode)
{
    if (mIndexCount == 0 || mVertexCapacity == 0)
        return;
    mGl.glBindVertexArray(mArrays[OtherArray]);
    mGl.glDrawElements(mode, mIndexCount, GL_UNSIGNED_INT, nullptr);
    mGl.glBindVertexArray(0);
}

} // namespace views
