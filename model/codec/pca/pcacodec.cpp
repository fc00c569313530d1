// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/pca/pcacodec.h"

#include "model/codec/basis/principalbasis.h"
#include "model/codec/basis/productanimation.h"
#include "model/codec/container/memorylimit.h"
#include "model/codec/container/syntax.h"
#include "model/codec/entropy/bandstage.h"
#include "model/codec/entropy/indexstage.h"
#include "model/codec/framestack.h"

#include <algorithm>
#include <numeric>

namespace model::codec {

namespace {

constexpr std::string_view ConnectivityTag = "INDX";
constexpr std::string_view ParametersTag = "PCAP";
constexpr std::string_view MeansTag = "MEAN";
constexpr std::string_view BasisTag = "BASE";
constexpr std::string_view CoefficientsTag = "COEF";

struct Parameters
{
    double resolution = 0;
    std::uint32_t wantedBasisSize = 0;
    std::uint32_t rank = 0;
};

template <class Stream, class Fields>
bool parameterSyntax(Stream &s, Fields &p, const Header &header) // FORMAT.md 3.5
{
    using Limits = PcaSettings;
    return s.f64(p.resolution) &&
           s.requireReal(p.resolution, Limits::MinResolution, Limits::MaxResolution, "resolution") &&
           s.varUint(p.wantedBasisSize) &&
           s.require(p.wantedBasisSize >= Limits::MinBasisSize && p.wantedBasisSize <= Limits::MaxBasisSize,
                     "wanted basis size", p.wantedBasisSize, "1 ... 1000") &&
           s.varUint(p.rank) &&
           s.require(p.rank <= std::min<std::uint64_t>(
                                   {p.wantedBasisSize, header.vertexCount, std::uint64_t(3) * header.frameCount}),
                     "basis size", p.rank, "0 ... wanted, vertices, 3 x frames");
}

Bands basisShape(const Header &header, std::uint32_t rank)
{
    return {rank, 3 * header.frameCount, 3};
}

Bands coefficientShape(const Header &header, std::uint32_t rank)
{
    return {rank, header.vertexCount, 1};
}

} // namespace

Result<Bytes> assemblePca(const FrameSource &source, const PcaSettings &settings, const QuantizedPca &pca,
                          const Bytes &indices, const Progress &progress)
{
    const Header header = headerOf(source, CodecId::Pca);
    const Bytes means = encodeMeans(pca.means);
    const Result<Bytes> basis = encodeBands(basisShape(header, pca.rank), pca.basis, progress.part(0, 0.1));
    const Result<Bytes> coefficients =
        encodeBands(coefficientShape(header, pca.rank), pca.coefficients, progress.part(0.1, 1));
    if (!basis || !coefficients)
        return fail(ErrorCode::Cancelled);

    SyntaxWriter syntax;
    const Parameters parameters{settings.resolution, settings.basisSize, pca.rank};
    parameterSyntax(syntax, parameters, header);
    ContainerWriter writer(header);
    writer.chunk(ParametersTag, syntax.take());
    writer.chunk(ConnectivityTag, indices);
    writer.chunk(MeansTag, means);
    writer.chunk(BasisTag, *basis);
    writer.chunk(CoefficientsTag, *coefficients);
    return writer.finish();
}

Result<EncodedAnimation> encodePca(const FrameSource &source, const PcaSettings &settings, const Progress &progress)
{
    const Result<FrameStack> frames = FrameStack::gather(source, progress.part(0, 0.1));
    if (!frames)
        return fail(frames.error());
    const Result<QuantizedPca> pca = quantizedPca(*frames, settings, progress.part(0.1, 0.85));
    if (!pca)
        return fail(pca.error());
    const Result<Bytes> indices = encodeIndices(source.connectivity(), progress.part(0.85, 0.9));
    if (!indices)
        return fail(indices.error());
    Result<Bytes> bytes = assemblePca(source, settings, *pca, *indices, progress.part(0.9, 1));
    if (!bytes)
        return fail(bytes.error());
    EncodedAnimation encoded{std::move(*bytes), std::vector<std::uint32_t>(source.vertexCount())};
    std::iota(encoded.permutation.begin(), encoded.permutation.end(), 0u);
    progress.report(1);
    return encoded;
}

Result<std::shared_ptr<const DecodedAnimation>> decodePca(Bytes file, const Container &container,
                                                          const DecodeLimits &limits, const Progress &progress)
{
    const Result<std::vector<Chunk>> parts =
        container.each({ParametersTag, ConnectivityTag, MeansTag, BasisTag, CoefficientsTag});
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
    const std::uint64_t needed = ProductAnimation::neededBytes(header, parameters.rank) + file.size();
    if (const auto enough = requireMemory(container.chunks.front(), needed, limits.bytesFor(file.size())); !enough)
        return fail(enough.error());

    const PcaSettings settings{parameters.wantedBasisSize, parameters.resolution};
    const auto animation =
        std::make_shared<ProductAnimation>(header, CompressionSettings{settings}, parameters.rank, parameters.rank);
    const auto means = decodeMeans(chunks[2], std::size_t(3) * header.frameCount);
    if (!means)
        return fail(means.error());
    animation->setMeans(*means, settings.resolution);
    Result<Connectivity> connectivity =
        decodeIndices(chunks[1], header.vertexCount, header.triangleCount, progress.part(0, 0.2));
    if (!connectivity)
        return fail(std::move(connectivity).error());
    animation->setConnectivity(std::move(*connectivity));
    const auto basis =
        decodeBands(chunks[3], basisShape(header, parameters.rank), "basis", progress.part(0.2, 0.3),
                    [&](std::uint32_t k, auto row) { animation->setBasisRow(k, row, settings.resolution); });
    if (!basis)
        return fail(basis.error());
    const auto coefficients =
        decodeBands(chunks[4], coefficientShape(header, parameters.rank), "coefficients", progress.part(0.3, 1),
                    [&](std::uint32_t k, auto row) { animation->setCoefficientRow(k, row, settings.resolution); });
    if (!coefficients)
        return fail(coefficients.error());
    if (!animation->isBounded())
        return fail(Error{ErrorCode::CorruptStream, {"coefficients"}, {}, Error::None, chunks[4].offset});
    animation->setFile(std::move(file), digestOf(chunks));
    progress.report(1);
    return animation;
}

} // namespace model::codec
