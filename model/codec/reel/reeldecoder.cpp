// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/reel/reeldecoder.h"

#include "model/base/digest.h"
#include "model/codec/connectivity/vertexorder.h"

#include <algorithm>
#include <cmath>

namespace model::codec {

namespace {

// A constant trajectory for each axis, whose coefficients are the rest shape.
constexpr std::uint32_t ShapeRank = 3;
// The range decoder's first bytes.
constexpr std::size_t StartBytes = 4;
// More than the start of a trajectory can take: fourteen decisions and three times direct bits, no more than two bytes
// each.
constexpr std::size_t MostStartBytes = 48;

tl::unexpected<Error> corrupt(std::string_view stage, std::uint64_t offset)
{
    return fail(Error{ErrorCode::CorruptStream, {std::string(stage)}, {}, Error::None, offset});
}

/// Residuals of a stream that is all there.
struct ReadResiduals
{
    RangeDecoder &coder;

    template <class Model, class... Expectation>
    std::int32_t operator()(Model &model, const typename Model::Contexts &contexts, std::size_t set,
                            const Expectation &...)
    {
        return model.code(coder, contexts, set);
    }
};

/// Residuals of a stream that is still coming. Near its present end each is taken back if it read beyond: the zeros
/// there are not the stream's.
class ComingResiduals
{
public:
    explicit ComingResiduals(RangeDecoder &coder)
        : mCoder(coder)
    {}

    template <class Model, class... Expectation>
    std::int32_t operator()(Model &model, const typename Model::Contexts &contexts, std::size_t set,
                            const Expectation &...)
    {
        if (mCoder.left() >= Model::MostBytes)
            return model.code(mCoder, contexts, set);
        const RangeDecoder before = mCoder;
        const typename Model::Memory memory = model.remember(contexts, set);
        const std::int32_t value = model.code(mCoder, contexts, set);
        if (!mCoder.hasReadPastEnd())
            return value;
        mCoder = before;
        model.restore(contexts, set, memory);
        mHasRunOut = true;
        return 0;
    }
    bool hasRunOut() const { return mHasRunOut; }

private:
    RangeDecoder &mCoder;
    bool mHasRunOut = false;
};

struct WholeSource
{
    RangeDecoder &coder;

    TrajectoryStart start(ClusterLabelCoder &labels, StepCoder &steps, std::uint32_t)
    {
        return codeStart(coder, labels, steps);
    }
    ReadResiduals basis() { return {coder}; }
    ReadResiduals coefficients() { return {coder}; }
    bool hasRunOut() const { return false; }
};

struct ComingSource
{
    RangeDecoder &coder;
    bool ranOut = false;

    TrajectoryStart start(ClusterLabelCoder &labels, StepCoder &steps, std::uint32_t)
    {
        if (coder.left() >= MostStartBytes)
            return codeStart(coder, labels, steps);
        const RangeDecoder before = coder;
        ClusterLabelCoder labelsAfter = labels;
        StepCoder stepsAfter = steps;
        const TrajectoryStart result = codeStart(coder, labelsAfter, stepsAfter);
        ranOut = coder.hasReadPastEnd();
        if (ranOut) {
            coder = before;
        } else {
            labels = std::move(labelsAfter);
            steps = stepsAfter;
        }
        return result;
    }
    ComingResiduals basis() { return ComingResiduals(coder); }
    ComingResiduals coefficients() { return ComingResiduals(coder); }
    bool hasRunOut() const { return ranOut; }
};

} // namespace

Bytes reelParametersPayload(const ReelParameters &parameters, const Header &header)
{
    SyntaxWriter syntax;
    reelSyntax(syntax, parameters, header);
    return syntax.take();
}

ReelDecoder::ReelDecoder(Header header)
    : mHeader(std::move(header))
{}

Result<void> ReelDecoder::readParameters(const Chunk &chunk)
{
    ByteReader reader(chunk.payload, chunk.offset);
    SyntaxReader syntax(reader);
    reelSyntax(syntax, mParameters, mHeader);
    if (!reader.requireEnd())
        return fail(reader.error());
    return {};
}

std::uint64_t ReelDecoder::neededBytes() const
{
    // What coarseToFine() holds of a vertex with its six neighbours, and needs while it works; later, with clusters,
    // the same again of their own nodes takes the place of the latter.
    constexpr std::uint64_t BytesOfNode = 430;
    const std::uint64_t vertices = mHeader.vertexCount, frames = mHeader.frameCount, rank = mParameters.basisSize;
    // The triangles once more, and their sides while neighbours are looked for.
    const std::uint64_t triangles = mHeader.triangleCount * std::uint64_t(sizeof(Triangle) + 6 * sizeof(std::uint32_t));
    return ProductAnimation::neededBytes(mHeader, std::uint32_t(rank) + ShapeRank) + triangles +
           (vertices + frames) * BytesOfNode + BandCoder::neededBytes(vertices, rank) +
           BandCoder::neededBytes(frames, 3 * rank) + ShapeCoder::neededBytes(vertices);
}

Result<void> ReelDecoder::readConnectivity(const Chunk &chunk, std::uint64_t memoryLimit, const Progress &progress)
{
    Result<CodedConnectivity> connectivity =
        decodeConnectivity(chunk, mHeader.vertexCount, mHeader.triangleCount, memoryLimit, progress.part(0, 0.3));
    if (!connectivity)
        return fail(std::move(connectivity).error());
    connectivity->corners = {};
    Result<CoarseToFine> vertices = coarseToFine(connectivity->connectivity, progress.part(0.3, 1));
    if (!vertices)
        return fail(std::move(vertices).error());
    mConnectivity = std::move(connectivity->connectivity);
    mNeighbours = std::move(connectivity->neighbours);
    mVertices = std::move(*vertices);
    mFrames = coarseToFineInTime(mHeader.frameCount);
    return {};
}

Result<void> ReelDecoder::readOrder(const Chunk &chunk)
{
    Result<std::vector<std::uint32_t>> places = decodeVertexOrder(chunk, mNeighbours);
    if (!places)
        return fail(std::move(places).error());
    mOrder = std::move(*places);
    return {};
}

Result<void> ReelDecoder::readClusters(const Chunk &chunk, const std::optional<Chunk> &next)
{
    const std::vector<std::uint32_t> components = componentsOf(*mVertices);
    const std::size_t count = components.empty() ? 0 : 1 + *std::max_element(components.begin(), components.end());
    RangeDecoder coder(chunk.payload);
    if (!codeClusters(coder, mClusters, count) || !coder.isAtEnd() || hasShape() ||
        (next && next->offset < chunk.offset))
        return corrupt("clusters", chunk.offset);
    return {};
}

Result<void> ReelDecoder::readShape(const Chunk &chunk, const Progress &progress)
{
    const ReelNodes nodes{*mVertices, mFrames};
    RangeDecoder coder(chunk.payload);
    const bool whole = codeShape(ReadResiduals{coder}, ReadResiduals{coder}, nodes, mParameters, mPlaces, mMeans,
                                 [&] { return !coder.isBad() && !progress.isCancelled(); });
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    if (!whole || !coder.isAtEnd() || !startBounds())
        return corrupt("shape", chunk.offset);
    mWalk.emplace(nodes, mClusters, mParameters, mPlaces);
    return {};
}

Result<void> ReelDecoder::readBands(std::span<const std::uint8_t> payload, std::uint64_t offset, bool isWhole,
                                    const Progress &progress)
{
    if (!mBands) {
        if (!isWhole && payload.size() < StartBytes)
            return {};
        mBands.emplace(payload);
        mAtLastEnd = mBands;
    }
    mBands->extend(payload);
    ComingSource coming{*mBands};
    WholeSource all{*mBands};
    while (mWalk->done() < mParameters.basisSize) {
        if (progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        const bool done = isWhole ? mWalk->next(all) : mWalk->next(coming);
        // What was read of a stream that is still coming is in it, so that only its values can tell.
        if (mBands->isBad() || mWalk->isBad() || (done && !addLastToBounds()))
            return corrupt("bands", offset);
        if (!done)
            return {};
        mAtLastEnd = mBands;
        mBandEnds.push_back(mBands->position());
        progress.report(double(mWalk->done()) / double(mParameters.basisSize));
    }
    if (isWhole && !mBands->isAtEnd())
        return corrupt("bands", offset);
    return {};
}

bool ReelDecoder::startBounds()
{
    const double scale = shapeStep(mParameters) / std::sqrt(double(mHeader.frameCount));
    Point largest{};
    bool isBounded = true;
    for (const Point &place : mPlaces)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double size = std::fabs(place[axis] * scale);
            isBounded = isBounded && size <= MostCoordinate; // not a number is not
            largest[axis] = std::max(largest[axis], size);
        }
    mBounds.clear();
    for (const double mean : mMeans) {
        mBounds.push_back(std::fabs(mean) + largest[mBounds.size() % 3]);
        isBounded = isBounded && mBounds.back() <= MostCoordinate;
    }
    return isBounded;
}

bool ReelDecoder::addLastToBounds()
{
    const std::uint32_t k = mWalk->done() - 1;
    double largest = 0;
    bool isBounded = true;
    for (std::size_t i = 0; i < mWalk->members(k).size(); ++i) {
        const double size = std::fabs(mWalk->coefficient(k, i));
        isBounded = isBounded && size <= MostCoordinate;
        largest = std::max(largest, size);
    }
    for (std::size_t node = 0; node < mFrames.size(); ++node)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double size = std::fabs(mWalk->basisValue(k, node, axis));
            double &bound = mBounds[3 * std::size_t(mFrames.vertices[node]) + axis];
            bound += size * largest;
            isBounded = isBounded && size <= MostCoordinate && bound <= MostCoordinate;
        }
    return isBounded;
}

std::shared_ptr<const DecodedAnimation> ReelDecoder::animation(Bytes file, const Container &container) const
{
    CompressionSettings settings;
    settings.method = ReelSettings{mParameters.wantedStep, mParameters.wantedBasisSize};
    settings.keepOrder = hasOrder();
    const std::uint32_t rank = bandCount();
    const auto animation = std::make_shared<ProductAnimation>(mHeader, settings, rank, rank + ShapeRank);
    Connectivity connectivity = mConnectivity;
    if (mOrder)
        for (Triangle &triangle : connectivity.triangles)
            for (std::uint32_t &vertex : triangle)
                vertex = (*mOrder)[vertex];
    animation->setConnectivity(std::move(connectivity));

    const double shapeScale = shapeStep(mParameters) / std::sqrt(double(mHeader.frameCount));
    const auto shown = [&](std::size_t node) {
        const std::uint32_t coded = mVertices->vertices[node];
        return mOrder ? (*mOrder)[coded] : coded;
    };
    for (std::size_t node = 0; node < mVertices->size(); ++node)
        for (std::uint32_t axis = 0; axis < ShapeRank; ++axis)
            animation->setCoefficient(axis, shown(node), mPlaces[node][axis] * shapeScale);
    for (std::uint32_t k = 0; k < rank; ++k)
        for (std::size_t i = 0; i < mWalk->members(k).size(); ++i)
            animation->setCoefficient(ShapeRank + k, shown(mWalk->members(k)[i]), mWalk->coefficient(k, i));
    for (std::size_t node = 0; node < mFrames.size(); ++node)
        for (std::uint32_t axis = 0; axis < 3; ++axis) {
            const std::size_t row = 3 * std::size_t(mFrames.vertices[node]) + axis;
            animation->setBasis(axis, row, 1);
            for (std::uint32_t k = 0; k < rank; ++k)
                animation->setBasis(ShapeRank + k, row, mWalk->basisValue(k, node, axis));
        }
    animation->setMeans(mMeans);
    animation->setPrefixBytes(prefixBytes(container));
    std::uint64_t digest = 0;
    for (const std::string_view tag :
         {ReelParametersTag, ReelConnectivityTag, ReelShapeTag, ReelBandsTag, ReelOrderTag, ReelClustersTag})
        if (container.has(tag))
            digest = digestOfArray(container.only(tag)->payload, digest);
    animation->setFile(std::move(file), digest);
    return animation;
}

std::vector<std::uint64_t> ReelDecoder::prefixBytes(const Container &container) const
{
    const auto endOf = [&](std::string_view tag) {
        const Chunk chunk = *container.only(tag);
        return chunk.offset + chunk.payload.size() + CrcLength;
    };
    std::vector<std::uint64_t> bytes{
        std::max({endOf(ReelParametersTag), endOf(ReelConnectivityTag), endOf(ReelShapeTag)})};
    const Chunk bands = *container.only(ReelBandsTag);
    for (const std::uint64_t end : mBandEnds)
        bytes.push_back(std::max(bytes[0], end <= bands.payload.size() ? bands.offset + end : endOf(ReelBandsTag)));
    return bytes;
}

Bytes ReelDecoder::parametersSoFar() const
{
    ReelParameters parameters = mParameters;
    parameters.basisSize = bandCount();
    return reelParametersPayload(parameters, mHeader);
}

Bytes ReelDecoder::bandsSoFar(std::span<const std::uint8_t> payload) const
{
    if (!mAtLastEnd)
        return RangeEncoder().finish();
    RangeDecoder ended = *mAtLastEnd;
    ended.extend(payload);
    return ended.endedHere();
}

} // namespace model::codec
