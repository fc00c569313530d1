// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: S. Gumhold, W. Strasser, Real Time Compression of Triangle Mesh Connectivity, 1998 (the cut-border
// machine). Differs: tiles, each with triangles of its own; edges in the order in which they were made; no split is
// ever coded by its place on the border: a vertex or an edge met before is named.
#include "model/io/terrain/tilecodec.h"

#include "model/base/outofmemory.h"
#include "model/base/parallel.h"
#include "model/io/terrain/tilefront.h"
#include "model/io/terrain/tilegeometry.h"
#include "model/terrain/tin/hilbert.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <unordered_map>

namespace model::io {

using namespace terrain;

namespace {

/// Vertices of a tile as we write it: a tile's arrays fit into the processor's second cache.
constexpr std::uint32_t TileVertices = 1 << 14;
/// And the most that a reader takes.
constexpr std::uint32_t MaxTileVertices = 1 << 20;
constexpr std::uint32_t MaxTileTriangles = 8 * MaxTileVertices;
constexpr std::uint32_t MaxVertices = (std::uint32_t(1) << 28) - 1;
/// The corners of the domain come first and belong to no tile.
constexpr std::uint32_t Corners = 4;

struct SurfaceHeader
{
    Rectangle domain;
    double cornerHeights[Corners] = {};
    LayerTable layers;
    LayerSample cornerSamples[Corners][MaxLayers];
    std::uint64_t vertices = Corners; ///< those of the domain's corners included
    std::uint64_t triangles = 0;
    std::uint64_t tiles = 0;
};

struct TileHeader
{
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
    std::uint64_t bytes = 0;
};

void writeHeader(ByteWriter &out, const SurfaceHeader &header, std::span<const TileHeader> tiles)
{
    for (const double value : {header.domain.low.x, header.domain.low.y, header.domain.high.x, header.domain.high.y})
        out.f64(value);
    for (const double height : header.cornerHeights)
        out.f64(height);
    out.u8(std::uint8_t(header.layers.count));
    for (std::uint32_t l = 0; l < header.layers.count; ++l)
        out.u8(header.layers.materials[l]);
    for (const auto &samples : header.cornerSamples)
        for (std::uint32_t l = 0; l < header.layers.count; ++l) {
            out.f64(samples[l].thickness);
            out.f32(samples[l].humidity);
        }
    out.varUint(header.vertices);
    out.varUint(header.triangles);
    out.varUint(header.tiles);
    for (const TileHeader &tile : tiles) {
        out.varUint(tile.vertices);
        out.varUint(tile.triangles);
        out.varUint(tile.bytes);
    }
}

bool readHeader(ByteReader &in, SurfaceHeader &header, std::vector<TileHeader> &tiles)
{
    for (double *const value :
         {&header.domain.low.x, &header.domain.low.y, &header.domain.high.x, &header.domain.high.y})
        *value = in.f64();
    for (double &height : header.cornerHeights)
        height = in.f64();
    header.layers.count = in.u8();
    if (!in.require(header.layers.count <= MaxLayers, "layer count", header.layers.count, "at most 12"))
        return false;
    for (std::uint32_t l = 0; l < header.layers.count; ++l)
        header.layers.materials[l] = in.u8();
    for (auto &samples : header.cornerSamples)
        for (std::uint32_t l = 0; l < header.layers.count; ++l) {
            samples[l].thickness = in.f64();
            samples[l].humidity = in.f32();
        }
    header.vertices = in.varUint();
    header.triangles = in.varUint();
    header.tiles = in.varUint();
    if (!in.require(header.vertices >= Corners && header.vertices <= MaxVertices, "vertex count", header.vertices,
                    "4 ... 268435455") ||
        !in.require(header.triangles >= 2 && header.triangles <= 2 * std::uint64_t(MaxVertices), "triangle count",
                    header.triangles, "2 ... 536870910") ||
        !in.require(header.tiles >= 1 && header.tiles <= in.left(), "tile count", header.tiles,
                    "at most the bytes left"))
        return false;
    std::uint64_t vertices = Corners, triangles = 0, bytes = 0;
    tiles.resize(std::size_t(header.tiles));
    for (TileHeader &tile : tiles) {
        tile.vertices = in.varUint();
        tile.triangles = in.varUint();
        tile.bytes = in.varUint();
        if (!in.require(tile.vertices <= MaxTileVertices, "vertex count", tile.vertices, "at most 1048576") ||
            !in.require(tile.triangles <= MaxTileTriangles, "triangle count", tile.triangles, "at most 8388608") ||
            !in.require(tile.bytes <= in.left(), "tile size", tile.bytes, "at most the bytes left"))
            return false;
        vertices += tile.vertices;
        triangles += tile.triangles;
        bytes += tile.bytes;
    }
    return in.require(vertices == header.vertices, "vertex count", header.vertices, "the sum of the tiles'") &&
           in.require(triangles == header.triangles, "triangle count", header.triangles, "the sum of the tiles'") &&
           in.require(bytes == in.left(), "tile size", bytes, "all of the bytes left");
}

/// How the first of the tile's vertices and triangles are numbered in the file.
struct TilePlace
{
    std::uint32_t firstVertex = Corners;
    std::uint32_t firstTriangle = 0;
};

std::int64_t signOf(std::uint64_t value)
{
    return std::int64_t(value >> 1) ^ -std::int64_t(value & 1);
}
std::uint64_t unsign(std::int64_t value)
{
    return std::uint64_t(value) << 1 ^ std::uint64_t(value >> 63);
}

/// What predicts a coordinate of vertex i from those before it.
template <class Predict>
void writePredicted(ByteWriter &out, const FixedPoint &numbers, Predict predict)
{
    std::vector<std::uint32_t> residuals(numbers.multiples.size());
    for (std::size_t i = 0; i < residuals.size(); ++i)
        residuals[i] = zigzag(std::int32_t(std::uint32_t(numbers.multiples[i]) - std::uint32_t(predict(i))));
    writeWords(out, residuals);
}
template <class Predict>
bool readPredicted(ByteReader &in, std::size_t count, FixedPoint &numbers, Predict predict)
{
    std::vector<std::uint32_t> residuals;
    if (!readWords(in, count, residuals))
        return false;
    numbers.multiples.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        numbers.multiples[i] = std::int32_t(std::uint32_t(unzigzag(residuals[i])) + std::uint32_t(predict(i)));
    return true;
}

// Encoding

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
        std::int64_t before = Corners + std::int64_t(mState.endOf(mTile));
        for (const std::uint32_t slot : mOuter) {
            const std::int64_t id = mState.fileIds[slot];
            outer.varUint(unsign(id - before));
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
        return isOwn(slot) && mState.fileIds[slot] != None ? mState.fileIds[slot] - Corners - mState.firstOf(mTile)
                                                           : TileContext::NoVertex;
    }
    void number(std::uint32_t slot, const TileContext &context)
    {
        mState.fileIds[slot] = Corners + mState.firstOf(mTile) + std::uint32_t(mOwn.size());
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
    for (VertexId v = Corners; v < tin.vertexSlots(); ++v)
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
    for (VertexId v = 0; v < Corners; ++v)
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

Result<Bytes> encode(const TinArrays &tin, const Rectangle &domain, Point2 step, std::vector<VertexId> *fileIds,
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
    for (VertexId v = 0; v < Corners; ++v) {
        header.cornerHeights[v] = tin.heights[v];
        for (std::uint32_t l = 0; l < tin.layerCount(); ++l)
            header.cornerSamples[v][l] = tin.sample(v, l);
    }
    header.vertices = state.order.size() + Corners;
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

// Decoding

class TileDecoder
{
public:
    TileDecoder(std::span<const std::uint8_t> bytes, std::uint64_t offset, const TileHeader &header, TilePlace place,
                TinArrays &tin)
        : mIn(bytes, offset)
        , mOffset(offset)
        , mHeader(header)
        , mPlace(place)
        , mTin(tin)
    {}

    bool run()
    {
        if (!readStreams())
            return false;
        while (mTriangleCount < mHeader.triangles) {
            if (!startTriangle())
                return false;
            for (std::uint32_t e = mFront.take(); e != mFront.None; e = mFront.take())
                if (!goOver(e))
                    return false;
        }
        if (mNextOp != mOps.size() || !mReferences.requireEnd() || mNextOuter != mOuter.size())
            return corrupt();
        // Vertices that no triangle of the tile has.
        mContexts.resize(std::size_t(mHeader.vertices));
        placeTriangles();
        return readVertices() && mIn.requireEnd();
    }

    Error error() const { return mIn.error(); }

private:
    bool corrupt()
    {
        mIn.setError(Error{ErrorCode::CorruptStream, {"triangles"}, {}, Error::None, mOffset});
        return false;
    }

    bool readStreams()
    {
        const std::uint64_t ops = mIn.varUint();
        if (!mIn.require(ops <= 6 * mHeader.triangles, "step count", ops, "at most six for a triangle") ||
            !readPacked(mIn, std::size_t(ops), mOps))
            return false;
        const std::uint64_t references = mIn.varUint();
        if (!mIn.require(references <= 5 * ops, "reference size", references, "at most five bytes for a step") ||
            !readPacked(mIn, std::size_t(references), mReferenceBytes))
            return false;
        mReferences = ByteReader(mReferenceBytes, mOffset);
        const std::uint64_t outers = mIn.varUint(), outerSize = mIn.varUint();
        Bytes outerBytes;
        if (!mIn.require(outers <= ops, "outer vertex count", outers, "at most the steps") ||
            !mIn.require(outerSize <= 5 * outers, "outer vertex size", outerSize, "at most five bytes for a vertex") ||
            !readPacked(mIn, std::size_t(outerSize), outerBytes))
            return false;
        ByteReader outer(outerBytes, mOffset);
        std::uint64_t id = mPlace.firstVertex + mHeader.vertices;
        for (std::uint64_t i = 0; i < outers; ++i) {
            id += std::uint64_t(signOf(outer.varUint()));
            const bool isOwn = id >= mPlace.firstVertex && id < mPlace.firstVertex + mHeader.vertices;
            if (!outer.ok() || isOwn || id >= mTin.points.size())
                return corrupt();
            mOuter.push_back(std::uint32_t(id));
        }
        if (!outer.requireEnd())
            return corrupt();
        const std::uint8_t hasVoids = mIn.u8();
        if (!mIn.require(hasVoids <= 1, "void mark", hasVoids, "0 or 1"))
            return false;
        mVoids.assign(std::size_t(mHeader.triangles + 7) / 8, 0);
        return !hasVoids || readPacked(mIn, mVoids.size(), mVoids);
    }

    /// The next step; Last + 1 if there is none.
    std::uint8_t nextOp() { return mNextOp < mOps.size() ? mOps[mNextOp++] : std::uint8_t(TileOp::Last) + 1; }

    /// The vertex that `op` says. None: `op` does not say one, or there is none.
    std::uint32_t readVertex(std::uint8_t op, const TileContext &context)
    {
        const auto localCount = std::uint32_t(mIdOfLocal.size());
        switch (TileOp(op)) {
        case TileOp::New:
            if (mContexts.size() == mHeader.vertices)
                return None;
            mIdOfLocal.push_back(mPlace.firstVertex + std::uint32_t(mContexts.size()));
            mContexts.push_back(context);
            return localCount;
        case TileOp::Outer:
            if (mNextOuter == mOuter.size())
                return None;
            mIdOfLocal.push_back(mOuter[mNextOuter++]);
            return localCount;
        case TileOp::Vertex: {
            const std::uint64_t back = mReferences.varUint();
            return mReferences.ok() && back < localCount ? localCount - 1 - std::uint32_t(back) : None;
        }
        default:
            return None;
        }
    }
    std::uint32_t ownOf(std::uint32_t local) const
    {
        const std::uint32_t own = mIdOfLocal[local] - mPlace.firstVertex;
        return own < mContexts.size() ? own : TileContext::NoVertex;
    }

    TriangleId emit(std::uint32_t a, std::uint32_t b, std::uint32_t c)
    {
        const TriangleId t = mPlace.firstTriangle + mTriangleCount;
        VertexId *const v = mTin.triangleVertices.data() + 3 * std::size_t(t);
        v[0] = a;
        v[1] = b;
        v[2] = c;
        for (std::uint32_t i = 0; i < 3; ++i)
            mTin.opposites[slotOf(cornerOf(t, i))] = NoCorner;
        mTin.triangleFlags[t] = mVoids[mTriangleCount / 8] >> mTriangleCount % 8 & 1 ? VoidTriangle : 0;
        ++mTriangleCount;
        return t;
    }
    void link(Corner a, Corner b)
    {
        mTin.opposites[slotOf(a)] = b;
        mTin.opposites[slotOf(b)] = a;
    }

    bool startTriangle()
    {
        std::uint32_t local[3];
        TileContext context;
        for (std::uint32_t i = 0; i < 3; ++i) {
            local[i] = readVertex(nextOp(), context);
            if (local[i] == None)
                return corrupt();
            (i == 0 ? context.a : context.b) = ownOf(local[i]);
        }
        const TriangleId t = emit(local[0], local[1], local[2]);
        const Corner tags[] = {cornerOf(t, 1), cornerOf(t, 0), cornerOf(t, 2)};
        const std::uint32_t starts[] = {local[0], local[2], local[1]};
        mFront.start(tags, starts);
        return true;
    }

    bool goOver(std::uint32_t e)
    {
        const Corner c = mFront[e].tag;
        const std::uint8_t op = nextOp();
        if (op == std::uint8_t(TileOp::Border)) {
            mFront.end(e);
            return true;
        }
        if (op == std::uint8_t(TileOp::Join)) {
            const std::uint64_t back = mReferences.varUint();
            const std::uint32_t f = mFront.size() - 1 - std::uint32_t(back);
            if (!mReferences.ok() || back >= mFront.size() || f == e || !mFront.isOpen(f))
                return corrupt();
            link(c, mFront[f].tag);
            mFront.join(e, f);
            return true;
        }
        if (op > std::uint8_t(TileOp::Last) || mTriangleCount == mHeader.triangles)
            return corrupt();
        const std::uint32_t a = mTin.vertex(previous(c)), b = mTin.vertex(next(c));
        const std::uint32_t left = mFront[e].before, right = mFront[e].after;
        const bool endsLeft = op == std::uint8_t(TileOp::Left) || op == std::uint8_t(TileOp::Close);
        const bool endsRight = op == std::uint8_t(TileOp::Right) || op == std::uint8_t(TileOp::Close);
        if ((endsLeft && (left == e || !mFront.isOpen(left))) || (endsRight && (right == e || !mFront.isOpen(right))) ||
            (endsLeft && endsRight && left == right))
            return corrupt();
        std::uint32_t x = None;
        if (endsLeft)
            x = mTin.vertex(previous(mFront[left].tag));
        else if (endsRight)
            x = mTin.vertex(next(mFront[right].tag));
        else
            x = readVertex(op, {ownOf(a), ownOf(b), ownOf(mTin.vertex(c))});
        if (x == None || x == a || x == b)
            return corrupt();
        const TriangleId t = emit(a, b, x);
        const Corner first = cornerOf(t, 1), second = cornerOf(t, 0);
        link(cornerOf(t, 2), c);
        if (endsLeft)
            link(first, mFront[left].tag);
        if (endsRight)
            link(second, mFront[right].tag);
        if (endsLeft && endsRight)
            mFront.close(e);
        else if (endsLeft)
            mFront.endLeft(e, second, x);
        else if (endsRight)
            mFront.endRight(e, first, a);
        else
            mFront.open(e, first, a, second, x);
        return true;
    }

    /// From the tile's numbers of vertices to those of the file.
    void placeTriangles()
    {
        for (std::size_t i = 3 * std::size_t(mPlace.firstTriangle);
             i < 3 * std::size_t(mPlace.firstTriangle + mTriangleCount); ++i)
            mTin.triangleVertices[i] = mIdOfLocal[mTin.triangleVertices[i]];
    }

    bool readVertices()
    {
        const auto count = std::size_t(mHeader.vertices);
        FixedPoint x, y, z;
        for (FixedPoint *const plane : {&x, &y})
            if (!readFixedPoint(mIn, count, *plane) || !readPredicted(mIn, count, *plane, [&](std::size_t i) {
                    return predictAcross(plane->multiples, i, mContexts[i]);
                }))
                return false;
        const std::uint8_t kind = mIn.u8();
        if (!mIn.require(kind <= std::uint8_t(HeightPrediction::Plane), "height prediction", kind, "0 or 1") ||
            !readFixedPoint(mIn, count, z) || !readPredicted(mIn, count, z, [&](std::size_t i) {
                return predictHeight(HeightPrediction(kind), x.multiples, y.multiples, z.multiples, i, mContexts[i]);
            }))
            return false;
        std::size_t nextX = 0, nextY = 0, nextZ = 0;
        for (std::size_t i = 0; i < count; ++i) {
            mTin.points[mPlace.firstVertex + i] = {numberAt(x, i, nextX), numberAt(y, i, nextY)};
            mTin.heights[mPlace.firstVertex + i] = numberAt(z, i, nextZ);
        }
        for (std::uint32_t l = 0; l < mTin.layerCount(); ++l) {
            FixedPoint thickness;
            std::vector<std::uint32_t> humidities;
            if (!readFixedPoint(mIn, count, thickness) ||
                !readPredicted(mIn, count, thickness,
                               [&](std::size_t i) { return predictMean(thickness.multiples, i, mContexts[i]); }) ||
                !readWords(mIn, count, humidities))
                return false;
            std::size_t next = 0;
            for (std::size_t i = 0; i < count; ++i) {
                humidities[i] ^= predictBits(humidities, i, mContexts[i]);
                const std::size_t slot = mTin.layerSlot(VertexId(mPlace.firstVertex + i), l);
                mTin.thicknesses[slot] = numberAt(thickness, i, next);
                mTin.humidities[slot] = std::bit_cast<float>(humidities[i]);
            }
        }
        return true;
    }

    ByteReader mIn;
    ByteReader mReferences{{}};
    const std::uint64_t mOffset;
    const TileHeader mHeader;
    const TilePlace mPlace;
    TinArrays &mTin;
    TileFront<Corner> mFront;
    Bytes mOps, mReferenceBytes, mVoids;
    std::vector<std::uint32_t> mOuter;
    std::vector<std::uint32_t> mIdOfLocal; ///< of each vertex met so far, in the file
    std::vector<TileContext> mContexts;    ///< of each vertex of the tile met so far
    std::size_t mNextOp = 0, mNextOuter = 0;
    std::uint32_t mTriangleCount = 0;
};

/// Joins the edges between tiles. What is left without an opposite is the border of the domain, or an error that
/// restoreTin() sees.
void linkTiles(TinArrays &tin)
{
    struct Open
    {
        std::uint64_t edge;
        Corner corner;
    };
    std::mutex mutex;
    std::vector<Open> open;
    parallelRanges(tin.triangleSlots(), 1 << 16, [&](std::size_t begin, std::size_t end) {
        std::vector<Open> here;
        for (TriangleId t = TriangleId(begin); t < end; ++t)
            for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c)
                if (tin.opposites[slotOf(c)] == NoCorner) {
                    const std::uint64_t a = tin.vertex(next(c)), b = tin.vertex(previous(c));
                    here.push_back({std::min(a, b) << 32 | std::max(a, b), c});
                }
        const std::lock_guard lock(mutex);
        open.insert(open.end(), here.begin(), here.end());
    });
    std::sort(open.begin(), open.end(),
              [](const Open &a, const Open &b) { return a.edge != b.edge ? a.edge < b.edge : a.corner < b.corner; });
    for (std::size_t i = 0; i + 1 < open.size(); ++i)
        if (open[i].edge == open[i + 1].edge) {
            tin.opposites[slotOf(open[i].corner)] = open[i + 1].corner;
            tin.opposites[slotOf(open[i + 1].corner)] = open[i].corner;
            ++i;
        }
}

Result<DecodedSurface> decode(std::span<const std::uint8_t> bytes, std::uint64_t memoryLimit, const Progress &progress)
{
    ByteReader in(bytes);
    SurfaceHeader header;
    std::vector<TileHeader> tiles;
    if (!readHeader(in, header, tiles))
        return fail(in.error());
    const std::uint64_t VertexBytes = 16 + 8 + 8 + 4 + 4 + 12 * header.layers.count, TriangleBytes = 12 + 12 + 1;
    const std::uint64_t wanted = header.vertices * VertexBytes + header.triangles * TriangleBytes;
    if (wanted > memoryLimit)
        return fail(ErrorCode::LimitExceeded, "memory", std::to_string(wanted), std::to_string(memoryLimit));
    DecodedSurface result{{}, header.domain};
    TinArrays &tin = result.arrays;
    tin.totals.layers = header.layers;
    tin.resizeVertices(std::size_t(header.vertices));
    tin.resizeTriangles(std::size_t(header.triangles));
    const Point2 low = header.domain.low, high = header.domain.high;
    const Point2 corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
    for (VertexId v = 0; v < Corners; ++v) {
        tin.points[v] = corners[v];
        tin.heights[v] = header.cornerHeights[v];
        for (std::uint32_t l = 0; l < tin.layerCount(); ++l) {
            tin.thicknesses[tin.layerSlot(v, l)] = header.cornerSamples[v][l].thickness;
            tin.humidities[tin.layerSlot(v, l)] = header.cornerSamples[v][l].humidity;
        }
    }
    std::vector<TilePlace> places(tiles.size());
    std::vector<std::uint64_t> offsets(tiles.size(), in.offset());
    for (std::size_t i = 1; i < tiles.size(); ++i) {
        places[i] = {places[i - 1].firstVertex + std::uint32_t(tiles[i - 1].vertices),
                     places[i - 1].firstTriangle + std::uint32_t(tiles[i - 1].triangles)};
        offsets[i] = offsets[i - 1] + tiles[i - 1].bytes;
    }
    std::mutex mutex;
    std::optional<Error> error;
    std::atomic<std::size_t> done = 0;
    parallelFor(tiles.size(), [&](std::size_t i) {
        if (progress.isCancelled())
            return;
        TileDecoder decoder(bytes.subspan(std::size_t(offsets[i]), std::size_t(tiles[i].bytes)), offsets[i], tiles[i],
                            places[i], tin);
        const bool isSound = decoder.run();
        progress.report(double(++done) / double(tiles.size()));
        if (isSound)
            return;
        // Of several the first in the file, whatever the threads do.
        const std::lock_guard lock(mutex);
        if (Error found = decoder.error(); !error || found.offset < error->offset)
            error = std::move(found);
    });
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    if (error)
        return fail(std::move(*error));
    linkTiles(tin);
    return result;
}

} // namespace

Result<Bytes> encodeSurface(const TinArrays &tin, const Rectangle &domain, Point2 step, std::vector<VertexId> *fileIds,
                            const Progress &progress)
{
    return encode(tin, domain, step, fileIds, progress);
}

Result<DecodedSurface> decodeSurface(std::span<const std::uint8_t> bytes, std::uint64_t memoryLimit,
                                     const Progress &progress)
{
    return catchBadAlloc([&] { return decode(bytes, memoryLimit, progress); });
}

} // namespace model::io
