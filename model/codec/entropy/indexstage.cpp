// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/entropy/indexstage.h"

#include "model/codec/container/streams.h"
#include "model/codec/container/syntax.h"
#include "model/codec/entropy/integercoder.h"

#include <memory>

namespace model::codec {

namespace {

constexpr unsigned ClassBits = 5; // residuals of less than 2^31
// Enough that learning the statistics anew costs little, few enough that two threads have work on 67k triangles.
constexpr std::uint64_t TrianglesPerStream = 1u << 14;
constexpr std::uint64_t MinTrianglesPerStream = 1u << 10;
constexpr std::uint64_t CancelInterval = 4096; // triangles

struct Parameters
{
    std::uint64_t trianglesPerStream = TrianglesPerStream;
};

template <class Stream, class Fields>
bool parameterSyntax(Stream &s, Fields &p) // FORMAT.md 5.1
{
    return s.varUint(p.trianglesPerStream) &&
           s.require(p.trianglesPerStream >= MinTrianglesPerStream && p.trianglesPerStream <= MaxTriangles,
                     "triangles per stream", p.trianglesPerStream, "2^10 ... 2^30");
}

/// The models and the history of one stream; predict and contexts for both directions.
class IndexModel
{
public:
    template <class Coder>
    std::int64_t code(Coder &coder, unsigned corner, std::int64_t index = 0)
    {
        Lane &lane = mLanes[corner];
        const std::uint64_t recent = lane.magnitude + mLast;
        const std::int64_t residual =
            codeInteger(coder, mModels[corner], sizeContext(recent), signContext(lane.residual), index - lane.index);
        lane.index += residual;
        lane.residual = residual;
        lane.magnitude = std::uint64_t(residual < 0 ? -residual : residual);
        mLast = lane.magnitude;
        return lane.index;
    }

private:
    /// The same corner of the triangle before: its index is the prediction.
    struct Lane
    {
        std::int64_t index = 0;
        std::int64_t residual = 0;
        std::uint64_t magnitude = 0;
    };
    std::array<Lane, 3> mLanes;
    std::uint64_t mLast = 0;
    std::array<IntegerModels<ClassBits>, 3> mModels;
};

Bytes encodeTriangles(std::span<const Triangle> triangles, const Progress &progress)
{
    RangeEncoder coder;
    const auto model = std::make_unique<IndexModel>();
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (t % CancelInterval == 0 && progress.isCancelled())
            return {};
        for (unsigned corner = 0; corner < 3; ++corner)
            model->code(coder, corner, triangles[t][corner]);
    }
    return coder.finish();
}

/// \returns false if the stream is corrupt or the work was cancelled
bool decodeTriangles(std::span<const std::uint8_t> stream, std::uint32_t vertexCount, std::span<Triangle> triangles,
                     const Progress &progress)
{
    RangeDecoder coder(stream);
    const auto model = std::make_unique<IndexModel>();
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (t % CancelInterval == 0 && (progress.isCancelled() || coder.isBad()))
            return false;
        for (unsigned corner = 0; corner < 3; ++corner) {
            const std::int64_t index = model->code(coder, corner);
            if (index < 0 || index >= std::int64_t(vertexCount))
                return false;
            triangles[t][corner] = std::uint32_t(index);
        }
    }
    return coder.isAtEnd();
}

} // namespace

Result<Bytes> encodeIndices(const Connectivity &connectivity, const Progress &progress)
{
    const Parameters parameters;
    const std::span<const Triangle> triangles = connectivity.triangles;
    const auto streams = encodeStreams(triangles.size(), parameters.trianglesPerStream, progress,
                                       [&](std::size_t begin, std::size_t count) {
                                           return encodeTriangles(triangles.subspan(begin, count), progress);
                                       });
    if (!streams)
        return fail(streams.error());
    SyntaxWriter syntax;
    parameterSyntax(syntax, parameters);
    ByteWriter out;
    out.bytes(syntax.take());
    writeStreams(out, *streams);
    return out.take();
}

Result<Connectivity> decodeIndices(const Chunk &chunk, std::uint32_t vertexCount, std::uint32_t triangleCount,
                                   const Progress &progress)
{
    Parameters parameters;
    ByteReader reader(chunk.payload, chunk.offset);
    SyntaxReader syntax(reader);
    parameterSyntax(syntax, parameters);
    if (!reader.ok())
        return fail(reader.error());
    const std::uint64_t perStream = parameters.trianglesPerStream;
    const std::vector<StreamView> streams = readStreams(reader, streamCount(triangleCount, perStream));
    if (!reader.requireEnd())
        return fail(reader.error());

    Connectivity connectivity{vertexCount, std::vector<Triangle>(triangleCount)};
    const std::span<Triangle> triangles = connectivity.triangles;
    const auto decoded = decodeStreams(streams, "connectivity", progress, [&](std::size_t i, auto stream) {
        const std::size_t begin = i * perStream;
        const std::size_t count = std::min<std::size_t>(perStream, triangles.size() - begin);
        return decodeTriangles(stream, vertexCount, triangles.subspan(begin, count), progress);
    });
    if (!decoded)
        return fail(decoded.error());
    return connectivity;
}

} // namespace model::codec
