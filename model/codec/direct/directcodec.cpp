// SPDX-License-Identifier: GPL-3.0-or-later
// Based on:
// - a thesis' system for compressing mesh animations by quantised positions (reference 001, chapter 3): cells, the
//   predictions A, B and C, deflate or a range coder
// - J. Rossignac, A. Szymczak, L. Ibarria: Dynapack, space-time compression of the 3D animations of triangle meshes,
//   2003 (parallelograms of motions)
// Differs: groups of frames for random access; the grid is centred; the predictor N weighs several guesses as fits the
// frame.
#include "model/codec/direct/directcodec.h"

#include "model/codec/container/memorylimit.h"
#include "model/codec/container/streams.h"
#include "model/codec/container/syntax.h"
#include "model/codec/direct/directanimation.h"
#include "model/codec/entropy/indexstage.h"
#include "model/codec/framestack.h"

#include <limits>
#include <numeric>

namespace model::codec {

namespace {

constexpr std::string_view ParametersTag = "DIRP";
constexpr std::string_view ConnectivityTag = "INDX";
constexpr std::string_view FramesTag = "FRMS";

// Longer groups are smaller files and slower jumps. At resolution 4096, against one group for all: dance 16 frames
// +10 %, 32 +5 %; samba 15 % and 9 %; a jump at 35k vertices takes as long as up to 32 frames.
constexpr std::uint32_t FramesPerGroup = 32;

struct Parameters
{
    std::uint32_t resolution = 0;
    std::uint8_t predictor = 0;
    std::uint8_t entropy = 0;
    std::uint32_t framesPerGroup = 0;
    double cell = 0;
    std::array<double, 3> origin{};
};

template <class Stream, class Fields>
bool parameterSyntax(Stream &s, Fields &p) // FORMAT.md 11.1
{
    using Limits = DirectSettings;
    constexpr double Most = std::numeric_limits<float>::max();
    return s.varUint(p.resolution) &&
           s.require(p.resolution >= Limits::MinResolution && p.resolution <= Limits::MaxResolution, "resolution",
                     p.resolution, "1 ... 2^24") &&
           s.u8(p.predictor) &&
           s.require(p.predictor <= std::uint8_t(Predictor::Neighbours), "predictor", p.predictor, "0 ... 4") &&
           s.u8(p.entropy) &&
           s.require(p.entropy <= std::uint8_t(Entropy::Range), "entropy coder", p.entropy, "0, 1") &&
           s.varUint(p.framesPerGroup) &&
           s.require(p.framesPerGroup >= 1 && p.framesPerGroup <= 65535, "frames per group", p.framesPerGroup,
                     "1 ... 65535") &&
           s.f64(p.cell) && s.requireReal(p.cell, 0, 2 * Most, "cell") && s.f64(p.origin[0]) &&
           s.requireReal(p.origin[0], -Most, Most, "origin") && s.f64(p.origin[1]) &&
           s.requireReal(p.origin[1], -Most, Most, "origin") && s.f64(p.origin[2]) &&
           s.requireReal(p.origin[2], -Most, Most, "origin");
}

/// Quantised frames begin ... end-1.
std::vector<std::vector<Cell>> quantised(const FrameStack &frames, const CellGrid &grid, std::size_t begin,
                                         std::size_t end)
{
    std::vector<std::vector<Cell>> result;
    for (std::size_t f = begin; f < end; ++f) {
        std::vector<Cell> &cells = result.emplace_back();
        cells.reserve(frames.vertexCount());
        for (const Vec3f p : frames.frame(f))
            cells.push_back(grid.cellOf(p));
    }
    return result;
}

} // namespace

Result<DirectEncoder> DirectEncoder::prepare(const FrameSource &source, const Progress &progress)
{
    Result<FrameStack> frames = FrameStack::gather(source, progress.part(0, 0.6));
    if (!frames)
        return fail(std::move(frames).error());
    Result<Bytes> indices = encodeIndices(source.connectivity(), progress.part(0.6, 1));
    if (!indices)
        return fail(std::move(indices).error());
    return DirectEncoder(source, std::move(*frames), std::move(*indices));
}

const MeshWalk &DirectEncoder::walkFor(Predictor predictor)
{
    const bool isGrowing = predictor == Predictor::Neighbours;
    std::optional<MeshWalk> &walk = isGrowing ? mGrowing : mInFileOrder;
    if (!walk)
        walk.emplace(mSource->connectivity(), isGrowing ? MeshWalk::Order::Growing : MeshWalk::Order::File);
    return *walk;
}

/// A stream for each group of frames.
Result<std::vector<Bytes>> DirectEncoder::encodeGroups(const DirectSettings &settings, const Progress &progress)
{
    const CellGrid grid = CellGrid::around(mFrames, settings.resolution);
    const FrameShape shape{settings.resolution, settings.predictor, settings.entropy};
    const MeshWalk &walk = walkFor(settings.predictor);
    const std::vector<Cell> first = std::move(quantised(mFrames, grid, 0, 1).front());
    return encodeStreams(mFrames.frameCount(), FramesPerGroup, progress, [&](std::size_t begin, std::size_t count) {
        const auto cells = quantised(mFrames, grid, begin, begin + count);
        const std::vector<std::span<const Cell>> views(cells.begin(), cells.end());
        const auto before = begin > 0 ? std::span<const Cell>(first) : std::span<const Cell>();
        return encodeFrames(shape, walk, before, views, progress);
    });
}

Result<EncodedAnimation> DirectEncoder::encode(const DirectSettings &settings, const Progress &progress)
{
    const Result<std::vector<Bytes>> groups = encodeGroups(settings, progress);
    if (!groups)
        return fail(groups.error());
    return assembled(settings, *groups);
}

EncodedAnimation DirectEncoder::assembled(const DirectSettings &settings, const std::vector<Bytes> &groups) const
{
    const Header header = headerOf(*mSource, CodecId::Direct);
    const CellGrid grid = CellGrid::around(mFrames, settings.resolution);
    const Parameters parameters{settings.resolution,
                                std::uint8_t(settings.predictor),
                                std::uint8_t(settings.entropy),
                                FramesPerGroup,
                                grid.cell,
                                grid.origin};
    SyntaxWriter syntax;
    parameterSyntax(syntax, parameters);
    ByteWriter streams;
    writeStreams(streams, groups);
    ContainerWriter writer(header);
    writer.chunk(ParametersTag, syntax.take());
    writer.chunk(ConnectivityTag, mIndices);
    writer.chunk(FramesTag, streams.data());
    EncodedAnimation encoded{writer.finish(), std::vector<std::uint32_t>(mSource->vertexCount())};
    std::iota(encoded.permutation.begin(), encoded.permutation.end(), 0u);
    return encoded;
}

Result<EncodedAnimation> encodeDirect(const FrameSource &source, const DirectSettings &settings,
                                      const Progress &progress)
{
    Result<DirectEncoder> encoder = DirectEncoder::prepare(source, progress.part(0, 0.15));
    if (!encoder)
        return fail(std::move(encoder).error());
    Result<EncodedAnimation> encoded = encoder->encode(settings, progress.part(0.15, 1));
    progress.report(1);
    return encoded;
}

Result<std::shared_ptr<const DecodedAnimation>> decodeDirect(Bytes file, const Container &container,
                                                             const DecodeLimits &limits, const Progress &progress)
{
    DirectAnimation::Parts parts;
    const Result<std::vector<Chunk>> found = container.each({ParametersTag, ConnectivityTag, FramesTag});
    if (!found)
        return fail(found.error());
    const std::vector<Chunk> &chunks = *found;
    parts.digest = digestOf(chunks);
    const Header &header = container.header;

    Parameters parameters;
    ByteReader reader(chunks[0].payload, chunks[0].offset);
    SyntaxReader syntax(reader);
    parameterSyntax(syntax, parameters);
    if (!reader.requireEnd())
        return fail(reader.error());
    const Entropy entropy = Entropy(parameters.entropy);
    const std::uint64_t needed = DirectAnimation::neededBytes(header, entropy, parameters.framesPerGroup) + file.size();
    if (const auto enough = requireMemory(container.chunks.front(), needed, limits.bytesFor(file.size())); !enough)
        return fail(enough.error());

    ByteReader groups(chunks[2].payload, chunks[2].offset);
    for (const StreamView &view : readStreams(groups, streamCount(header.frameCount, parameters.framesPerGroup)))
        parts.groups.push_back(view.data);
    if (!groups.requireEnd())
        return fail(groups.error());
    Result<Connectivity> connectivity =
        decodeIndices(chunks[1], header.vertexCount, header.triangleCount, progress.part(0, 0.5));
    if (!connectivity)
        return fail(std::move(connectivity).error());

    parts.header = header;
    parts.settings = {parameters.resolution, Predictor(parameters.predictor), entropy};
    parts.grid = {parameters.origin, parameters.cell, parameters.resolution};
    parts.framesPerGroup = parameters.framesPerGroup;
    parts.connectivity = std::move(*connectivity);
    parts.file = std::move(file);
    const auto animation = std::make_shared<DirectAnimation>(std::move(parts));
    if (!animation->decodeFirstFrame())
        return fail(Error{ErrorCode::CorruptStream, {"frames"}, {}, Error::None, chunks[2].offset});
    progress.report(1);
    return animation;
}

} // namespace model::codec
