// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: S. Gumhold, W. Strasser, Real Time Compression of Triangle Mesh Connectivity, 1998 (the cut-border
// machine).
// Differs: tileencoder.cpp, which it mirrors step by step.
#include "model/io/terrain/tiles/tilecodec.h"

#include "model/base/outofmemory.h"
#include "model/base/parallel.h"
#include "model/io/terrain/tiles/surfaceheader.h"
#include "model/io/terrain/tiles/tilefront.h"
#include "model/io/terrain/tiles/tilegeometry.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <mutex>
#include <optional>

namespace model::io {

using namespace terrain;

namespace {

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
            id += std::uint64_t(unzigzag(outer.varUint()));
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
    for (VertexId v = 0; v < DomainCorners; ++v) {
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

Result<DecodedSurface> decodeSurface(std::span<const std::uint8_t> bytes, std::uint64_t memoryLimit,
                                     const Progress &progress)
{
    return catchBadAlloc([&] { return decode(bytes, memoryLimit, progress); });
}

} // namespace model::io
