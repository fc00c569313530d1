// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/coddyac/coddyaccodec.h"

#include "model/codec/basis/productanimation.h"
#include "model/codec/coddyac/coddyacencoder.h"
#include "model/codec/coddyac/coddyacsyntax.h"
#include "model/codec/coddyac/lanestage.h"
#include "model/codec/coddyac/parallelogramstage.h"
#include "model/codec/connectivity/vertexorder.h"
#include "model/codec/container/memorylimit.h"

namespace model::codec {

namespace {

// What the stages hold while they decode: residuals of three bands and a sum, a band, its order; two rows of a lane.
constexpr std::uint64_t ScratchPerVertex = 32;
constexpr std::uint64_t ScratchPerFrame = 3 * 16;

} // namespace

Result<EncodedAnimation> encodeCoddyac(const FrameSource &source, const CoddyacSettings &settings, bool keepOrder,
                                       const Progress &progress)
{
    const Result<CoddyacEncoder> encoder = CoddyacEncoder::prepare(source, settings.basisSize, progress.part(0, 0.7));
    if (!encoder)
        return fail(encoder.error());
    double squaredError = 0;
    return encoder->encode(settings, keepOrder, squaredError, progress.part(0.7, 1));
}

Result<std::shared_ptr<const DecodedAnimation>> decodeCoddyac(Bytes file, const Container &container,
                                                              const DecodeLimits &limits, const Progress &progress)
{
    using namespace coddyac;
    const bool keepsOrder = container.has(OrderTag);
    const Result<std::vector<Chunk>> parts =
        keepsOrder ? container.each({ParametersTag, ConnectivityTag, MeansTag, BasisTag, CoefficientsTag, OrderTag})
                   : container.each({ParametersTag, ConnectivityTag, MeansTag, BasisTag, CoefficientsTag});
    if (!parts)
        return fail(parts.error());
    const std::vector<Chunk> &chunks = *parts;
    const Header &header = container.header;

    Parameters parameters;
    ByteReader reader(chunks[0].payload, chunks[0].offset);
    SyntaxReader syntax(reader);
    parameterSyntax(syntax, parameters, header);
    if (!reader.requireEnd())
        return fail(reader.error());
    const std::uint64_t limit = limits.bytesFor(file.size());
    const std::uint64_t needed = ProductAnimation::neededBytes(header, parameters.rank) + file.size() +
                                 header.vertexCount * ScratchPerVertex + header.frameCount * ScratchPerFrame;
    if (const auto enough = requireMemory(container.chunks.front(), needed, limit); !enough)
        return fail(enough.error());

    Result<CodedConnectivity> coded =
        decodeConnectivity(chunks[1], header.vertexCount, header.triangleCount, limit - needed, progress.part(0, 0.2));
    if (!coded)
        return fail(std::move(coded).error());
    coded->corners = {};
    std::vector<std::uint32_t> places;
    if (keepsOrder) {
        Result<std::vector<std::uint32_t>> order = decodeVertexOrder(chunks[5], coded->neighbours);
        if (!order)
            return fail(std::move(order).error());
        places = std::move(*order);
        for (Triangle &t : coded->connectivity.triangles)
            for (std::uint32_t &v : t)
                v = places[v];
    }

    const CoddyacSteps steps(parameters.settings, parameters.unit, header.vertexCount);
    const auto animation = std::make_shared<ProductAnimation>(
        header, CompressionSettings{parameters.settings, keepsOrder}, parameters.rank, parameters.rank);
    animation->setConnectivity(std::move(coded->connectivity));
    const std::size_t rows = std::size_t(3) * header.frameCount;
    const auto means = decodeLanes(chunks[2], 1, rows, "means", progress.part(0.2, 0.21),
                                   [&](std::size_t, auto row) { animation->setMeans(row, 1 / steps.mean()); });
    if (!means)
        return fail(means.error());
    const auto basis =
        decodeLanes(chunks[3], parameters.rank, rows, "basis", progress.part(0.21, 0.4), [&](std::size_t k, auto row) {
            animation->setBasisRow(std::uint32_t(k), row, 1 / steps.basis(parameters.fineness[k]));
        });
    if (!basis)
        return fail(basis.error());
    std::vector<std::int32_t> placed(places.size());
    const auto coefficients = decodeByParallelograms(
        chunks[4], parameters.rank, coded->neighbours, progress.part(0.4, 1), [&](std::uint32_t k, auto row) {
            for (std::size_t v = 0; v < placed.size(); ++v)
                placed[places[v]] = row[v];
            animation->setCoefficientRow(k, keepsOrder ? std::span<const std::int32_t>(placed) : row,
                                         1 / steps.coefficient());
        });
    if (!coefficients)
        return fail(coefficients.error());
    if (!animation->isBounded())
        return fail(Error{ErrorCode::CorruptStream, {"coefficients"}, {}, Error::None, chunks[4].offset});
    animation->setFile(std::move(file), digestOf(chunks));
    progress.report(1);
    return animation;
}

} // namespace model::codec
