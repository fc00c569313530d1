// SPDX-License-Identifier: GPL-3.0-or-later
// Based on:
// - L. Vasa, V. Skala: CODDYAC: Connectivity driven dynamic mesh compression, 2007 (principal trajectories,
// coefficients
//   predicted over the mesh)
// - L. Vasa, V. Skala: COBRA: Compression of the basis for PCA represented animations, 2009 (steps of the basis)
// Differs: README.md, "reel".
#include "model/codec/reel/reelcodec.h"

#include "model/base/digest.h"
#include "model/codec/connectivity/vertexorder.h"
#include "model/codec/productanimation.h"

#include <cmath>
#include <numeric>

namespace model::codec {

namespace {

// A constant trajectory for each axis, whose coefficients are the rest shape.
constexpr std::uint32_t ShapeRank = 3;

/// Residuals that are known (encoder) or read (decoder).
template <class Coder>
struct Residuals
{
    Coder &coder;
    const std::int32_t *next = nullptr; ///< none: they are read

    template <class Model, class... Expectation>
    std::int32_t operator()(Model &model, const typename Model::Contexts &contexts, std::size_t set,
                            const Expectation &...)
    {
        return model.code(coder, contexts, set, next ? *next++ : 0);
    }
};

struct ReelNodes
{
    const CoarseToFine &vertices;
    const CoarseToFine &frames;
};

/// The rest shape and the mean vertices. \param goOn  false: stop
template <class Coder, class GoOn>
bool codeShape(Coder &coder, const ReelNodes &nodes, const ReelParameters &p, const ReelChoice *choice,
               std::vector<Point> &places, std::vector<double> &means, GoOn &&goOn) // FORMAT.md 13.6
{
    ShapeCoder shape(nodes.vertices, levelRatio(p.shapeRatio));
    if (!shape.codeAll(Residuals<Coder>{coder, choice ? choice->shape.data() : nullptr}, goOn))
        return false;
    places = shape.places();

    BandCoder bands(nodes.frames, krigingWeights(nodes.frames, framePlaces(nodes.frames)),
                    {3, levelRatio(p.basisRatio), TimeRidge});
    Residuals<Coder> residuals{coder, choice ? choice->means.data() : nullptr};
    means.resize(3 * nodes.frames.size());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!goOn())
            return false;
        bands.nextBand(residuals);
        for (std::size_t node = 0; node < nodes.frames.size(); ++node)
            means[3 * nodes.frames.vertices[node] + axis] =
                double(p.origin[axis]) + bands.value(node, axis) * meanStep(p);
    }
    return goOn();
}

/// Trajectory after trajectory, each followed by the coefficients of all vertices: whatever comes later only adds
/// detail. \param done  called with each k and its decoded entries
template <class Coder, class Done, class GoOn>
bool codeBands(Coder &coder, const ReelNodes &nodes, const ReelParameters &p, const std::vector<Point> &places,
               const ReelChoice *choice, Done &&done, GoOn &&goOn) // FORMAT.md 13.7
{
    BandCoder basis(nodes.frames, krigingWeights(nodes.frames, framePlaces(nodes.frames)),
                    {std::size_t(3) * p.basisSize, levelRatio(p.basisRatio), TimeRidge});
    BandCoder coefficients(nodes.vertices, krigingWeights(nodes.vertices, places),
                           {p.basisSize, levelRatio(p.coefficientRatio), MeshRidge});
    Residuals<Coder> basisResiduals{coder, choice ? choice->basis.data() : nullptr};
    Residuals<Coder> coefficientResiduals{coder, choice ? choice->coefficients.data() : nullptr};
    StepCoder steps;
    for (std::uint32_t k = 0; k < p.basisSize; ++k) {
        const std::int32_t exponent = steps.code(coder, choice ? choice->stepExponents[k] : 0);
        for (int axis = 0; axis < 3; ++axis)
            basis.nextBand(basisResiduals);
        if (!goOn())
            return false;
        coefficients.nextBand(coefficientResiduals);
        if (!goOn())
            return false;
        done(k, stepOfExponent(exponent), basis, coefficients);
    }
    return true;
}

Bytes parametersPayload(const ReelParameters &parameters, const Header &header)
{
    SyntaxWriter syntax;
    reelSyntax(syntax, parameters, header);
    return syntax.take();
}

tl::unexpected<Error> corrupt(std::string_view stage, const Chunk &chunk)
{
    return fail(Error{ErrorCode::CorruptStream, {std::string(stage)}, {}, Error::None, chunk.offset});
}

std::uint64_t neededBytes(const Header &header, const ReelParameters &p)
{
    // What coarseToFine() holds of a vertex with its six neighbours, and needs while it works.
    constexpr std::uint64_t BytesOfNode = 400;
    const std::uint64_t vertices = header.vertexCount, frames = header.frameCount;
    return ProductAnimation::neededBytes(header, p.basisSize + ShapeRank) + (vertices + frames) * BytesOfNode +
           BandCoder::neededBytes(vertices, p.basisSize) + BandCoder::neededBytes(frames, 3 * p.basisSize) +
           ShapeCoder::neededBytes(vertices);
}

} // namespace

EncodedAnimation assembleReel(const FrameSource &source, const ReelEncoder &encoder, const ReelChoice &choice,
                              bool keepOrder)
{
    const EncodedConnectivity &connectivity = encoder.connectivity();
    Header header;
    header.codec = std::uint8_t(CodecId::Reel);
    header.vertexCount = source.vertexCount();
    header.triangleCount = std::uint32_t(connectivity.coded.connectivity.triangles.size());
    header.frameCount = source.frameCount();
    header.frameRate = source.frameRate();
    header.creator = creatorName();
    header.name = source.name();

    const ReelNodes nodes{encoder.vertexNodes(), encoder.frameNodes()};
    const auto always = [] { return true; };
    std::vector<Point> places;
    std::vector<double> means;
    RangeEncoder shape, bands;
    codeShape(shape, nodes, choice.parameters, &choice, places, means, always);
    codeBands(
        bands, nodes, choice.parameters, places, &choice, [](auto &&...) {}, always);

    ContainerWriter writer(header);
    writer.chunk(ReelParametersTag, parametersPayload(choice.parameters, header));
    writer.chunk(ReelConnectivityTag, connectivity.bytes);
    std::vector<std::uint32_t> permutation = connectivity.permutation;
    if (keepOrder) {
        writer.chunk(ReelOrderTag, encodeVertexOrder(permutation, connectivity.coded.neighbours));
        std::iota(permutation.begin(), permutation.end(), 0u);
    }
    writer.chunk(ReelShapeTag, shape.finish());
    writer.chunk(ReelBandsTag, bands.finish());
    return {writer.finish(), std::move(permutation)};
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
    EncodedAnimation encoded = assembleReel(source, *encoder, *choice, keepOrder);
    progress.report(1);
    return encoded;
}

Result<std::shared_ptr<const DecodedAnimation>> decodeReel(Bytes file, const Container &container,
                                                           const DecodeLimits &limits, const Progress &progress)
{
    std::vector<Chunk> chunks;
    std::uint64_t digest = 0;
    for (const std::string_view tag : {ReelParametersTag, ReelConnectivityTag, ReelShapeTag, ReelBandsTag}) {
        Result<Chunk> chunk = container.only(tag);
        if (!chunk)
            return fail(std::move(chunk).error());
        digest = digestOfArray(chunk->payload, digest);
        chunks.push_back(std::move(*chunk));
    }
    const bool keepsOrder = container.has(ReelOrderTag);
    if (keepsOrder) {
        Result<Chunk> chunk = container.only(ReelOrderTag);
        if (!chunk)
            return fail(std::move(chunk).error());
        digest = digestOfArray(chunk->payload, digest);
        chunks.push_back(std::move(*chunk));
    }
    const Header &header = container.header;
    ReelParameters p;
    ByteReader reader(chunks[0].payload, chunks[0].offset);
    SyntaxReader syntax(reader);
    reelSyntax(syntax, p, header);
    if (!reader.requireEnd())
        return fail(reader.error());
    const std::uint64_t needed = neededBytes(header, p) + file.size();
    const std::uint64_t limit = limits.bytesFor(file.size());
    if (needed > limit)
        return fail(ErrorCode::LimitExceeded, "memory", std::to_string(needed), std::to_string(limit));

    Result<CodedConnectivity> connectivity =
        decodeConnectivity(chunks[1], header.vertexCount, header.triangleCount, limit, progress.part(0, 0.1));
    if (!connectivity)
        return fail(std::move(connectivity).error());
    const Result<CoarseToFine> vertices = coarseToFine(connectivity->connectivity, progress.part(0.1, 0.3));
    if (!vertices)
        return fail(vertices.error());
    const CoarseToFine frames = coarseToFineInTime(header.frameCount);
    // Where each node's vertex is shown.
    std::vector<std::uint32_t> shown = vertices->vertices;
    if (keepsOrder) {
        const auto places = decodeVertexOrder(chunks[4], connectivity->neighbours);
        if (!places)
            return fail(places.error());
        for (std::uint32_t &vertex : shown)
            vertex = (*places)[vertex];
        for (Triangle &triangle : connectivity->connectivity.triangles)
            for (std::uint32_t &vertex : triangle)
                vertex = (*places)[vertex];
    }
    const ReelNodes nodes{*vertices, frames};

    CompressionSettings settings;
    settings.method = ReelSettings{p.wantedStep, p.wantedBasisSize};
    settings.keepOrder = keepsOrder;
    const auto animation = std::make_shared<ProductAnimation>(header, settings, p.basisSize, p.basisSize + ShapeRank);
    animation->setConnectivity(std::move(connectivity->connectivity));

    std::vector<Point> places;
    std::vector<double> means;
    RangeDecoder shape(chunks[2].payload);
    const bool wholeShape =
        codeShape(shape, nodes, p, nullptr, places, means, [&] { return !shape.isBad() && !progress.isCancelled(); });
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    if (!wholeShape || !shape.isAtEnd())
        return corrupt("shape", chunks[2]);
    bool isFinite = true;
    const auto finite = [&](double value) {
        isFinite = isFinite && std::isfinite(float(value));
        return value;
    };
    const double shapeScale = shapeStep(p) / std::sqrt(double(header.frameCount));
    for (std::uint32_t axis = 0; axis < ShapeRank; ++axis) {
        for (std::uint32_t frame = 0; frame < header.frameCount; ++frame)
            animation->setBasis(axis, 3 * std::size_t(frame) + axis, 1);
        for (std::size_t node = 0; node < places.size(); ++node)
            animation->setCoefficient(axis, shown[node], finite(places[node][axis] * shapeScale));
    }
    for (const double mean : means)
        finite(mean);
    animation->setMeans(std::move(means));
    if (!isFinite)
        return corrupt("shape", chunks[2]);
    progress.report(0.4);

    RangeDecoder bands(chunks[3].payload);
    const bool wholeBands = codeBands(
        bands, nodes, p, places, nullptr,
        [&](std::uint32_t k, double basisStep, const BandCoder &basis, const BandCoder &coefficients) {
            for (std::size_t node = 0; node < frames.size(); ++node)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    animation->setBasis(ShapeRank + k, 3 * std::size_t(frames.vertices[node]) + axis,
                                        finite(basis.value(node, 3 * std::size_t(k) + axis) * basisStep));
            for (std::size_t node = 0; node < vertices->size(); ++node)
                animation->setCoefficient(ShapeRank + k, shown[node], finite(coefficients.value(node, k) * p.step));
            progress.report(0.4 + 0.6 * double(k + 1) / double(p.basisSize));
        },
        [&] { return !bands.isBad() && isFinite && !progress.isCancelled(); });
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    if (!wholeBands || !isFinite || !bands.isAtEnd())
        return corrupt("bands", chunks[3]);
    animation->setFile(std::move(file), digest);
    progress.report(1);
    return animation;
}

} // namespace model::codec
