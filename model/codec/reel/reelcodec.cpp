// SPDX-License-Identifier: GPL-3.0-or-later
// Based on:
// - L. Vasa, V. Skala: CODDYAC: Connectivity driven dynamic mesh compression, 2007 (principal trajectories,
// coefficients
//   predicted over the mesh)
// - L. Vasa, V. Skala: COBRA: Compression of the basis for PCA represented animations, 2009 (steps of the basis)
// Differs: README.md, "reel".
#include "model/codec/reel/reelcodec.h"

#include "model/codec/connectivity/vertexorder.h"
#include "model/codec/container/memorylimit.h"
#include "model/codec/reel/reeldecoder.h"

#include <numeric>

namespace model::codec {

namespace {

/// Residuals that are known.
struct KnownResiduals
{
    RangeEncoder &coder;
    const std::int32_t *next;

    template <class Model, class... Expectation>
    std::int32_t operator()(Model &model, const typename Model::Contexts &contexts, std::size_t set,
                            const Expectation &...)
    {
        return model.code(coder, contexts, set, *next++);
    }
};

struct KnownSource
{
    RangeEncoder &coder;
    const ReelChoice &choice;
    KnownResiduals basisResiduals{coder, choice.basis.data()};
    KnownResiduals coefficientResiduals{coder, choice.coefficients.data()};

    TrajectoryStart start(ClusterLabelCoder &labels, StepCoder &steps, std::uint32_t k)
    {
        return codeStart(coder, labels, steps, {choice.labels[k], choice.stepExponents[k]});
    }
    KnownResiduals &basis() { return basisResiduals; }
    KnownResiduals &coefficients() { return coefficientResiduals; }
    bool hasRunOut() const { return false; }
};

} // namespace

Result<EncodedAnimation> assembleReel(const FrameSource &source, const ReelEncoder &encoder, const ReelChoice &choice,
                                      bool keepOrder, const Progress &progress)
{
    const EncodedConnectivity &connectivity = encoder.connectivity();
    const Header header = headerOf(source, CodecId::Reel);

    const ReelNodes nodes{encoder.vertexNodes(), encoder.frameNodes()};
    std::vector<Point> places;
    std::vector<double> means;
    RangeEncoder shape, bands;
    if (!codeShape(KnownResiduals{shape, choice.shape.data()}, KnownResiduals{shape, choice.means.data()}, nodes,
                   choice.parameters, places, means, [&] { return !progress.isCancelled(); }))
        return fail(ErrorCode::Cancelled);
    TrajectoryWalk walk(nodes, choice.clusters, choice.parameters, places);
    KnownSource known{bands, choice};
    while (walk.done() < choice.parameters.basisSize) {
        if (progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        walk.next(known);
        progress.report(double(walk.done()) / double(choice.parameters.basisSize));
    }

    ContainerWriter writer(header);
    writer.chunk(ReelParametersTag, reelParametersPayload(choice.parameters, header));
    writer.chunk(ReelConnectivityTag, connectivity.bytes);
    std::vector<std::uint32_t> permutation = connectivity.permutation;
    if (keepOrder) {
        writer.chunk(ReelOrderTag, encodeVertexOrder(permutation, connectivity.coded.neighbours));
        std::iota(permutation.begin(), permutation.end(), 0u);
    }
    if (choice.clusters.count > 1) {
        RangeEncoder coder;
        Clusters clusters = choice.clusters;
        codeClusters(coder, clusters, clusters.labels.size());
        writer.chunk(ReelClustersTag, coder.finish());
    }
    writer.chunk(ReelShapeTag, shape.finish());
    writer.chunk(ReelBandsTag, bands.finish());
    return EncodedAnimation{writer.finish(), std::move(permutation)};
}

Result<EncodedAnimation> encodeReel(const FrameSource &source, const ReelSettings &settings, bool keepOrder,
                                    const Progress &progress)
{
    const Result<FrameStack> frames = FrameStack::gather(source, progress.part(0, 0.1));
    if (!frames)
        return fail(frames.error());
    Result<EncodedConnectivity> connectivity = encodeConnectivity(source.connectivity(), progress.part(0.1, 0.15));
    if (!connectivity)
        return fail(connectivity.error());
    Result<ReelEncoder> encoder = ReelEncoder::prepare(*frames, std::move(*connectivity), progress.part(0.15, 0.3));
    if (!encoder)
        return fail(encoder.error());
    const Result<ReelChoice> choice = encoder->choose(settings, progress.part(0.3, 0.9));
    if (!choice)
        return fail(choice.error());
    return assembleReel(source, *encoder, *choice, keepOrder, progress.part(0.9, 1));
}

Result<std::shared_ptr<const DecodedAnimation>> decodeReel(Bytes file, const Container &container,
                                                           const DecodeLimits &limits, const Progress &progress)
{
    const Result<std::vector<Chunk>> parts =
        container.each({ReelParametersTag, ReelConnectivityTag, ReelShapeTag, ReelBandsTag});
    if (!parts)
        return fail(parts.error());
    const std::vector<Chunk> &chunks = *parts;
    const Result<std::optional<Chunk>> order = container.optional(ReelOrderTag);
    if (!order)
        return fail(order.error());
    const Result<std::optional<Chunk>> clusters = container.optional(ReelClustersTag);
    if (!clusters)
        return fail(clusters.error());

    ReelDecoder decoder(container.header);
    const std::uint64_t limit = limits.bytesFor(file.size());
    const Result<void> opened =
        decoder.readParameters(chunks[0])
            .and_then(
                [&] { return requireMemory(container.chunks.front(), decoder.neededBytes() + file.size(), limit); })
            .and_then([&] {
                return decoder.readConnectivity(chunks[1], limit - file.size() - WorkingMemory, progress.part(0, 0.3));
            })
            .and_then([&] { return *order ? decoder.readOrder(**order) : Result<void>(); })
            .and_then([&] { return *clusters ? decoder.readClusters(**clusters, chunks[2]) : Result<void>(); })
            .and_then([&] { return decoder.readShape(chunks[2], progress.part(0.3, 0.4)); })
            .and_then(
                [&] { return decoder.readBands(chunks[3].payload, chunks[3].offset, true, progress.part(0.4, 1)); });
    if (!opened)
        return fail(opened.error());
    progress.report(1);
    return decoder.animation(std::move(file), container);
}

} // namespace model::codec
