// SPDX-License-Identifier: GPL-3.0-or-later
// Based on:
// - J. Rossignac: Edgebreaker: Connectivity Compression for Triangle Meshes, 1999
// - J. Rossignac, A. Safonova, A. Szymczak: 3D Compression Made Simple: Edgebreaker on a Corner-Table, 2001
// - C. Touma, C. Gotsman: Triangle Mesh Compression, 1998 (loops of open edges; S with the place of its vertex)
// Differs: the place of the vertex of an S is stored, so that the decoder goes forward, in one pass, and its contexts
// are what lies around the gate; a handle needs nothing else. A part with a border starts with a hole. See the README.
#include "model/codec/connectivity/connectivitystage.h"

#include "model/codec/connectivity/meshsource.h"

#include <numeric>

namespace model::codec {

namespace {

/// Which vertices of the cut mesh are one. FORMAT.md 12.6.
class WeldModel
{
public:
    /// \param wanted  the vertex that this one is welded to, or `count` if it is a new one
    /// \returns       the same; more than `count` if the stream is corrupt
    template <class Coder>
    std::uint32_t code(Coder &coder, std::uint32_t count, std::uint32_t wanted)
    {
        mWasCopy = codeCounted(coder, mIsCopy[mWasCopy], wanted != count);
        if (!mWasCopy)
            return count;
        const std::int64_t step = mSteps.codeSigned(coder, std::int64_t(wanted) - std::int64_t(mLast));
        const std::uint64_t vertex = std::uint64_t(mLast) + std::uint64_t(step);
        if (vertex >= count)
            return count + 1;
        mLast = std::uint32_t(vertex);
        return mLast;
    }

private:
    std::array<CountedBit, 2> mIsCopy;
    CountedInteger mSteps;
    std::uint32_t mLast = 0;
    bool mWasCopy = false;
};

/// Puts together what both sides return from what was walked.
template <class Walk>
CodedConnectivity assembled(Walk &walk, std::vector<std::uint32_t> welded, std::uint32_t usedCount,
                            std::uint32_t vertexCount)
{
    CodedConnectivity coded;
    const std::uint32_t cutCount = std::uint32_t(walk.mNeighbours.size());
    coded.connectivity.vertexCount = vertexCount;
    coded.connectivity.triangles.resize(walk.mVertices.size() / 3);
    for (std::size_t t = 0; t < coded.connectivity.triangles.size(); ++t) {
        Triangle &triangle = coded.connectivity.triangles[t];
        std::copy_n(walk.mVertices.begin() + std::ptrdiff_t(3 * t), 3, triangle.begin());
        if (!welded.empty())
            for (std::uint32_t &vertex : triangle)
                vertex = welded[vertex];
        if (!walk.mFlipped.empty() && walk.mFlipped[t])
            std::swap(triangle[1], triangle[2]);
    }
    coded.neighbours = std::move(walk.mNeighbours);
    if (!welded.empty()) {
        std::uint32_t next = 0;
        for (std::uint32_t cut = 0; cut < cutCount; ++cut) {
            if (welded[cut] != next)
                continue;
            VertexNeighbours n = coded.neighbours[cut];
            if (!n.isNone())
                n = {welded[n.left], welded[n.right], welded[n.opposite]};
            coded.neighbours[next++] = n;
        }
    }
    coded.neighbours.resize(usedCount);
    coded.neighbours.resize(vertexCount);
    coded.corners = CornerTable(cutCount, std::move(walk.mVertices), std::move(walk.mOpposites));
    coded.welded = std::move(welded);
    return coded;
}

} // namespace

Result<EncodedConnectivity> encodeConnectivity(const Connectivity &connectivity, const Progress &progress)
{
    return encodeConnectivityWatched(connectivity, progress, nullptr);
}

Result<EncodedConnectivity> encodeConnectivityWatched(const Connectivity &connectivity, const Progress &progress,
                                                      WalkObserver *observer)
{
    if (connectivity.triangles.size() > MaxCodedTriangles)
        return fail(ErrorCode::LimitExceeded, "triangles", std::to_string(connectivity.triangles.size()),
                    std::to_string(MaxCodedTriangles));
    ManifoldCut whole = cutIntoManifold(connectivity);
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    progress.report(0.3);

    QueuedCoder coder;
    MeshSource source(std::move(whole), observer);
    const ManifoldCut &cut = source.cut();
    EdgeBreaker walk(coder, source, std::uint32_t(connectivity.triangles.size()), connectivity.vertexCount,
                     ~std::uint64_t(0));
    WeldModel model;
    const QueuedCoder::Hold hold(coder);
    if (!walk.run(progress.part(0.3, 0.9)))
        return fail(ErrorCode::Cancelled);

    // Names of the input's vertices, in the order in which the first copy of each was met.
    EncodedConnectivity encoded;
    const std::vector<std::uint32_t> order = source.takeOrder();
    std::vector<std::uint32_t> names(connectivity.vertexCount, NoVertex);
    std::vector<std::uint32_t> welded;
    coder.direct(1, !cut.copied.empty());
    encoded.permutation.reserve(connectivity.vertexCount);
    for (const std::uint32_t vertex : order) {
        const std::uint32_t count = std::uint32_t(encoded.permutation.size());
        std::uint32_t &name = names[cut.inputVertex(vertex)];
        if (!cut.copied.empty())
            welded.push_back(model.code(coder, count, std::min(name, count)));
        if (name == NoVertex) {
            name = count;
            encoded.permutation.push_back(cut.inputVertex(vertex));
        }
    }
    const std::uint32_t usedCount = std::uint32_t(encoded.permutation.size());
    for (std::uint32_t v = 0; v < connectivity.vertexCount; ++v)
        if (names[v] == NoVertex)
            encoded.permutation.push_back(v);
    encoded.coded = assembled(walk, std::move(welded), usedCount, connectivity.vertexCount);
    encoded.bytes = coder.finish();
    progress.report(1);
    return encoded;
}

Result<CodedConnectivity> decodeConnectivity(const Chunk &chunk, std::uint32_t vertexCount, std::uint32_t triangleCount,
                                             std::uint64_t memoryLimit, const Progress &progress)
{
    const auto corrupt = [&] {
        return fail(Error{ErrorCode::CorruptStream, {"connectivity"}, {}, Error::None, chunk.offset});
    };
    const auto tooLarge = [&](std::uint64_t needed) {
        return fail(Error{ErrorCode::LimitExceeded,
                          {"memory", std::to_string(needed), std::to_string(memoryLimit)},
                          {},
                          Error::None,
                          chunk.offset});
    };
    // Both meshes and what is turned, and the neighbours of the vertices and their names.
    const std::uint64_t fixed = std::uint64_t(triangleCount) * (24 + sizeof(Triangle) + 1) +
                                std::uint64_t(vertexCount) * (sizeof(VertexNeighbours) + 1 + sizeof(std::uint32_t));
    if (triangleCount > MaxCodedTriangles || fixed > memoryLimit)
        return tooLarge(fixed);

    RangeDecoder coder(chunk.payload);
    NoSource source;
    EdgeBreaker walk(coder, source, triangleCount, vertexCount, memoryLimit - fixed);
    if (!walk.run(progress.part(0, 0.9)))
        return progress.isCancelled()      ? fail(ErrorCode::Cancelled)
               : walk.memoryLimitReached() ? tooLarge(memoryLimit + 1)
                                           : corrupt();

    std::vector<std::uint32_t> welded;
    WeldModel model;
    std::uint32_t usedCount = std::uint32_t(walk.mNeighbours.size());
    if (coder.direct(1, 0) != 0) {
        usedCount = 0;
        welded.reserve(walk.mNeighbours.size());
        for (std::size_t i = 0; i < walk.mNeighbours.size(); ++i) {
            welded.push_back(model.code(coder, usedCount, 0));
            if (welded.back() > usedCount)
                return corrupt();
            usedCount += welded.back() == usedCount;
        }
    }
    if (usedCount > vertexCount || !coder.isAtEnd())
        return corrupt();
    CodedConnectivity coded = assembled(walk, std::move(welded), usedCount, vertexCount);
    progress.report(1);
    return coded;
}

} // namespace model::codec
