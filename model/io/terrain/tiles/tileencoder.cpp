// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: S. Gumhold, W. Strasser, Real Time Compression of Triangle Mesh Connectivity, 1998 (the cut-border
// machine). Differs: tiles, each with triangles of its own; edges in the order in which they were made; no split is
// ever coded by its place on the border: a vertex or an edge met before is named.
#include "model/io/terrain/tiles/tilecodec.h"

#include "model/base/parallel.h"
#include "model/io/terrain/tiles/surfaceheader.h"
#include "model/io/terrain/tiles/tilefront.h"
#include "model/io/terrain/tiles/tilegeometry.h"
#include "model/terrain/tin/build/hilbert.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <unordered_map>

namespace model::io {

using namespace terrain;

namespace {

/// What all tiles share while they are encoded. Each writes what belongs to its own slots alone.
struct EncoderState
{
    const TinArrays &tin;
    Point2 step;
    std::vector<std::uint32_t> order;        ///< slots along the curve, the domain's corners left out
    std::vector<std::uint32_t> tileOf;       ///< of each slot
    std::vector<std::uint32_t> triangles;    ///< by tiles
    std::vector<std::uint32_t> trianglesEnd; ///< of each tile
    std::vector<std::uint32_t> tileOfTriangle;
    std::vector<std::uint32_t> localTriangle; ///< in its tile; None: not met yet
    std::vector<std::uint32_t> localVertex;   ///< of each slot in its own tile
    std::vector<VertexId> fileIds;

    std::uint32_t tileCount() const
    {
        return std::max<std::uint32_t>(1, std::uint32_t((order.size() + TileVertices - 1) / TileVertices));
    }
    std::uint32_t firstOf(std::uint32_t tile) const { return tile * TileVertices; }
    std::uint32_t endOf(std::uint32_t tile) const
    {
        return std::uint32_t(std::min<std::size_t>(order.size(), (tile + std::size_t(1)) * TileVertices));
    }
};

class TileEncoder
{
public:
    TileEncoder(EncoderState &state, std::uint32_t tile)
        : mState(state)
        , mTin(state.tin)
        , mTile(tile)
    {}

    /// Everything but the vertices of other tiles, whose numbers are not known before all have been here.
    void run()
    {
        const std::uint32_t begin = mTile > 0 ? mState.trianglesEnd[mTile - 1] : 0;
        for (std::uint32_t i = begin; i < mState.trianglesEnd[mTile]; ++i) {
            const TriangleId t = mState.triangles[i];
            if (mState.localTriangle[t] != None)
                continue;
            startAt(t);
            for (std::uint32_t e = mFront.take(); e != mFront.None; e = mFront.take())
                goOver(e);
        }
        // Vertices all of whose triangles belong to other tiles.
        for (std::uint32_t i = mState.firstOf(mTile); i < mState.endOf(mTile); ++i)
            if (mState.fileIds[mState.order[i]] == None)
                number(mState.order[i], {});
        writeVertices();
        mFront = {};
        mContexts = {};
        mFrontOf = {};
    }

    TileHeader header() const { return {mOwn.size(), mTriangleCount, 0}; }

    Bytes finish() const
    {
        ByteWriter out;
        out.varUint(mOps.size());
        writePacked(out, mOps);
        out.varUint(mReferences.data().size());
        writePacked(out, mReferences.data());
        ByteWriter outer;
        std::int64_t before = DomainCorners + std::int64_t(mState.endOf(mTile));
        for (const std::uint32_t slot : mOuter) {
            const std::int64_t id = mState.fileIds[slot];
            outer.varUint(zigzag(id - before));
            before = id;
        }
        out.varUint(mOuter.size());
        out.varUint(outer.data().size());
        writePacked(out, outer.data());
        out.u8(mHasVoids);
        if (mHasVoids)
            writePacked(out, mVoids);
        out.bytes(mVertices.data());
        return out.take();
    }

private:
    bool isOwn(std::uint32_t slot) const { return mState.tileOf[slot] == mTile; }
    std::uint32_t localOf(std::uint32_t slot) const
    {
        if (isOwn(slot))
            return mState.localVertex[slot];
        const auto found = mLocalOuter.find(slot);
        return found == mLocalOuter.end() ? None : found->second;
    }
    /// The number among the tile's own vertices, for a context.
    std::uint32_t ownOf(std::uint32_t slot) const
    {
        return isOwn(slot) && mState.fileIds[slot] != None
                   ? mState.fileIds[slot] - DomainCorners - mState.firstOf(mTile)
                   : TileContext::NoVertex;
    }
    void number(std::uint32_t slot, const TileContext &context)
    {
        mState.fileIds[slot] = DomainCorners + mState.firstOf(mTile) + std::uint32_t(mOwn.size());
        mOwn.push_back(slot);
        mContexts.push_back(context);
    }
    /// Says which vertex comes next. \returns its local number
    std::uint32_t writeVertex(std::uint32_t slot, const TileContext &context)
    {
        const std::uint32_t known = localOf(slot);
        if (known != None) {
            writeOp(TileOp::Vertex);
            mReferences.varUint(mLocalCount - 1 - known);
            return known;
        }
        if (isOwn(slot)) {
            writeOp(TileOp::New);
            mState.localVertex[slot] = mLocalCount;
            number(slot, context);
        } else {
            writeOp(TileOp::Outer);
            mLocalOuter.emplace(slot, mLocalCount);
            mOuter.push_back(slot);
        }
        return mLocalCount++;
    }
    void writeOp(TileOp op) { mOps.push_back(std::uint8_t(op)); }

    void emit(TriangleId t)
    {
        mState.localTriangle[t] = mTriangleCount;
        if (mTriangleCount % 8 == 0)
            mVoids.push_back(0);
        if (mTin.isVoid(t)) {
            mVoids.back() = std::uint8_t(mVoids.back() | 1 << mTriangleCount % 8);
            mHasVoids = 1;
        }
        ++mTriangleCount;
        mFrontOf.resize(3 * std::size_t(mTriangleCount));
    }
    /// Notes that the edge of the front made next is that of a corner.
    void note(Corner c, std::uint32_t e)
    {
        mFrontOf[3 * std::size_t(mState.localTriangle[triangleOf(c)]) + (c & 3)] = e;
    }

    void startAt(TriangleId t)
    {
        const std::uint32_t v[] = {mTin.vertex(cornerOf(t, 0)), mTin.vertex(cornerOf(t, 1)),
                                   mTin.vertex(cornerOf(t, 2))};
        std::uint32_t local[3];
        local[0] = writeVertex(v[0], {});
        local[1] = writeVertex(v[1], {ownOf(v[0]), TileContext::NoVertex, TileContext::NoVertex});
        local[2] = writeVertex(v[2], {ownOf(v[0]), ownOf(v[1]), TileContext::NoVertex});
        emit(t);
        const Corner tags[] = {cornerOf(t, 1), cornerOf(t, 0), cornerOf(t, 2)};
        const std::uint32_t starts[] = {local[0], local[2], local[1]};
        for (std::uint32_t i = 0; i < 3; ++i)
            note(tags[i], mFront.size() + i);
        mFront.start(tags, starts);
    }

    void goOver(std::uint32_t e)
    {
        const Corner c = mFront[e].tag, o = mTin.opposite(c);
        if (o == NoCorner || mState.tileOfTriangle[triangleOf(o)] != mTile) {
            writeOp(TileOp::Border);
            return mFront.end(e);
        }
        const TriangleId t = triangleOf(o);
        if (mState.localTriangle[t] != None) {
            const std::uint32_t f = mFrontOf[3 * std::size_t(mState.localTriangle[t]) + (o & 3)];
            writeOp(TileOp::Join);
            mReferences.varUint(mFront.size() - 1 - f);
            return mFront.join(e, f);
        }
        // The triangle a-b-x: the corner of b faces the edge from a to x, the corner of a that from x to b.
        const Corner first = previous(o), second = next(o);
        const std::uint32_t left = mFront[e].before, right = mFront[e].after;
        const bool endsLeft = mFront.isOpen(left) && mFront[left].tag == mTin.opposite(first);
        const bool endsRight = mFront.isOpen(right) && mFront[right].tag == mTin.opposite(second);
        const std::uint32_t a = mTin.vertex(next(o)), b = mTin.vertex(previous(o)), x = mTin.vertex(o);
        if (endsLeft && endsRight) {
            writeOp(TileOp::Close);
            emit(t);
            mFront.close(e);
        } else if (endsLeft) {
            writeOp(TileOp::Left);
            emit(t);
            note(second, mFront.size());
            mFront.endLeft(e, second, localOf(x));
        } else if (endsRight) {
            writeOp(TileOp::Right);
            emit(t);
            note(first, mFront.size());
            mFront.endRight(e, first, localOf(a));
        } else {
            const std::uint32_t local = writeVertex(x, {ownOf(a), ownOf(b), ownOf(mTin.vertex(c))});
            emit(t);
            note(first, mFront.size());
            note(second, mFront.size() + 1);
            mFront.open(e, first, localOf(a), second, local);
        }
    }

    void writeVertices()
    {
        const std::size_t count = mOwn.size();
        std::vector<double> numbers(count);
        const auto column = [&](auto value, double base) {
            for (std::size_t i = 0; i < count; ++i)
                numbers[i] = value(mOwn[i]);
            return toFixedPoint(numbers, base);
        };
        const FixedPoint x = column([&](std::uint32_t v) { return mTin.points[v].x; }, mState.step.x);
        const FixedPoint y = column([&](std::uint32_t v) { return mTin.points[v].y; }, mState.step.y);
        const FixedPoint z = column([&](std::uint32_t v) { return mTin.heights[v]; }, 1);
        for (const FixedPoint *const plane : {&x, &y}) {
            writeFixedPoint(mVertices, *plane);
            writePredicted(mVertices, *plane,
                           [&](std::size_t i) { return predictAcross(plane->multiples, i, mContexts[i]); });
        }
        const auto prediction = [&](HeightPrediction kind) {
            return [&, kind](std::size_t i) {
                return predictHeight(kind, x.multiples, y.multiples, z.multiples, i, mContexts[i]);
            };
        };
        const auto bitsOf = [&](auto predict) {
            std::uint64_t bits = 0;
            for (std::size_t i = 0; i < count; ++i)
                bits += std::uint64_t(std::bit_width(std::uint64_t(std::abs(z.multiples[i] - predict(i)))));
            return bits;
        };
        const HeightPrediction kind =
            bitsOf(prediction(HeightPrediction::Plane)) < bitsOf(prediction(HeightPrediction::Mean))
                ? HeightPrediction::Plane
                : HeightPrediction::Mean;
        mVertices.u8(std::uint8_t(kind));
        writeFixedPoint(mVertices, z);
        writePredicted(mVertices, z, prediction(kind));
        for (std::uint32_t l = 0; l < mTin.layerCount(); ++l) {
            const FixedPoint thickness = column([&](std::uint32_t v) { return mTin.sample(v, l).thickness; }, 1);
            writeFixedPoint(mVertices, thickness);
            writePredicted(mVertices, thickness,
                           [&](std::size_t i) { return predictMean(thickness.multiples, i, mContexts[i]); });
            std::vector<std::uint32_t> humidities(count), residuals(count);
            for (std::size_t i = 0; i < count; ++i) {
                humidities[i] = std::bit_cast<std::uint32_t>(mTin.sample(mOwn[i], l).humidity);
                residuals[i] = humidities[i] ^ predictBits(humidities, i, mContexts[i]);
            }
            writeWords(mVertices, residuals);
        }
    }

    EncoderState &mState;
    const TinArrays &mTin;
    const std::uint32_t mTile;
    TileFront<Corner> mFront;
    std::uint32_t mTriangleCount = 0, mLocalCount = 0;
    std::unordered_map<std::uint32_t, std::uint32_t> mLocalOuter;
    std::vector<std::uint32_t> mFrontOf; ///< of each corner of the tile's triangles
    std::vector<std::uint32_t> mOwn, mOuter;
    std::vector<TileContext> mContexts;
    Bytes mOps, mVoids;
    ByteWriter mReferences, mVertices;
    std::uint8_t mHasVoids = 0;
};

EncoderState makeState(const TinArrays &tin, const Rectangle &domain, Point2 step)
{
    EncoderState state{tin, {step.x > 0 ? step.x : 1, step.y > 0 ? step.y : 1}, {}, {}, {}, {}, {}, {}, {}, {}};
    std::vector<Point3> points;
    std::vector<std::uint32_t> slots;
    for (VertexId v = DomainCorners; v < tin.vertexSlots(); ++v)
        if (tin.isVertex(v)) {
            points.push_back({tin.points[v].x, tin.points[v].y, 0});
            slots.push_back(v);
        }
    state.order = hilbertOrder(points, domain);
    for (std::uint32_t &place : state.order)
        place = slots[place];
    state.tileOf.assign(tin.vertexSlots(), None);
    for (std::size_t i = 0; i < state.order.size(); ++i)
        state.tileOf[state.order[i]] = std::uint32_t(i / TileVertices);
    state.fileIds.assign(tin.vertexSlots(), None);
    for (VertexId v = 0; v < DomainCorners; ++v)
        state.fileIds[v] = v;
    state.localVertex.assign(tin.vertexSlots(), None);
    state.localTriangle.assign(tin.triangleSlots(), None);

    // A triangle belongs to the first of the tiles of its vertices.
    state.tileOfTriangle.assign(tin.triangleSlots(), None);
    std::vector<std::uint32_t> &ends = state.trianglesEnd;
    ends.assign(state.tileCount() + std::size_t(1), 0);
    for (TriangleId t = 0; t < tin.triangleSlots(); ++t) {
        if (!tin.isTriangle(t))
            continue;
        std::uint32_t tile = None;
        for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c)
            tile = std::min(tile, state.tileOf[tin.vertex(c)]);
        state.tileOfTriangle[t] = tile == None ? 0 : tile;
        ++ends[state.tileOfTriangle[t] + 1];
    }
    for (std::size_t tile = 1; tile < ends.size(); ++tile)
        ends[tile] += ends[tile - 1];
    state.triangles.resize(ends.back());
    for (TriangleId t = 0; t < tin.triangleSlots(); ++t)
        if (tin.isTriangle(t))
            state.triangles[ends[state.tileOfTriangle[t]]++] = t;
    return state;
}

} // namespace

Result<Bytes> encodeSurface(const TinArrays &tin, const Rectangle &domain, Point2 step, std::vector<VertexId> *fileIds,
                            const Progress &progress)
{
    EncoderState state = makeState(tin, domain, step);
    std::vector<TileEncoder> encoders;
    for (std::uint32_t tile = 0; tile < state.tileCount(); ++tile)
        encoders.emplace_back(state, tile);
    std::vector<TileHeader> headers(encoders.size());
    std::vector<Bytes> tiles(encoders.size());
    std::atomic<std::size_t> done = 0;
    const auto forEachTile = [&](auto work) {
        parallelFor(encoders.size(), [&](std::size_t tile) {
            if (progress.isCancelled())
                return;
            work(tile);
            progress.report(double(++done) / (2 * double(encoders.size())));
        });
    };
    forEachTile([&](std::size_t tile) { encoders[tile].run(); });
    forEachTile([&](std::size_t tile) {
        headers[tile] = encoders[tile].header();
        tiles[tile] = encoders[tile].finish();
        headers[tile].bytes = tiles[tile].size();
    });
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    SurfaceHeader header;
    header.domain = domain;
    header.layers = tin.totals.layers;
    for (VertexId v = 0; v < DomainCorners; ++v) {
        header.cornerHeights[v] = tin.heights[v];
        for (std::uint32_t l = 0; l < tin.layerCount(); ++l)
            header.cornerSamples[v][l] = tin.sample(v, l);
    }
    header.vertices = state.order.size() + DomainCorners;
    header.triangles = state.triangles.size();
    header.tiles = tiles.size();
    ByteWriter out;
    writeHeader(out, header, headers);
    for (const Bytes &tile : tiles)
        out.bytes(tile);
    if (fileIds)
        *fileIds = std::move(state.fileIds);
    return out.take();
}

} // namespace model::io
