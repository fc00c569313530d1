// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/direct/framecoder.h"

#include "model/codec/direct/deflateresiduals.h"
#include "model/codec/direct/residualcoders.h"

#include <cmath>
#include <optional>
#include <variant>

namespace model::codec {

namespace {

constexpr std::size_t CancelInterval = 4096; // vertices

/// One frame, in either direction. \param now  an encoder's frame, or where a decoder puts it
/// \param weights  of the predictor N; a decoder gets them here
/// \returns false if the stream is corrupt or the work was cancelled
template <class Residuals>
bool codeFrame(Residuals &residuals, const FrameShape &shape, const MeshWalk &walk, const FrameHistory &history,
               bool isFirst, FeatureWeights weights, std::span<Cell> now, const Progress *progress)
{
    const std::int32_t most = std::int32_t(shape.resolution) - 1;
    const bool usesNeighbours = shape.predictor == Predictor::Neighbours;
    const std::size_t count = featureCount(history);
    residuals.startFrame(isFirst);
    if (usesNeighbours)
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t i = 0; i < count; ++i)
                weights[axis][i] = residuals.weight(axis, i, weights[axis][i]);

    bool isGood = true;
    Features features{};
    for (std::size_t place = 0; place < now.size(); ++place) {
        if (progress && place % CancelInterval == 0 && progress->isCancelled())
            return false;
        const std::uint32_t v = walk.vertex(place);
        Cell expected;
        if (usesNeighbours) {
            takeFeatures(walk, place, history, now, features);
            for (std::size_t axis = 0; axis < 3; ++axis)
                expected[axis] =
                    weighted(features[axis], weights[axis], count) + (history.last.data() ? history.last[v][axis] : 0);
        } else {
            expected = fixedPrediction(shape.predictor, walk, place, history, now);
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int32_t prediction = std::clamp(expected[axis], 0, most);
            const std::int64_t value =
                std::int64_t(prediction) + residuals.residual(place, axis, now[v][axis] - prediction);
            isGood = isGood && value >= 0 && value <= most;
            now[v][axis] = std::int32_t(std::clamp<std::int64_t>(value, 0, most));
        }
    }
    return residuals.endFrame() && isGood;
}

/// \returns false if the work was cancelled
template <class Residuals>
bool encodeAll(Residuals &residuals, const FrameShape &shape, const MeshWalk &walk, std::span<const Cell> reference,
               std::span<const std::span<const Cell>> frames, const Progress &progress)
{
    std::vector<Cell> now;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        FrameHistory history{i > 0 ? frames[i - 1] : reference, {}, {}};
        if (i > 1)
            history.second = frames[i - 2];
        if (i > 2)
            history.third = frames[i - 3];
        FeatureWeights weights{};
        if (progress.isCancelled())
            return false;
        if (shape.predictor == Predictor::Neighbours)
            weights = fittedWeights(walk, history, frames[i], progress);
        now.assign(frames[i].begin(), frames[i].end());
        if (!codeFrame(residuals, shape, walk, history, i == 0, weights, now, &progress))
            return false;
    }
    return true;
}

} // namespace

Bytes encodeFrames(const FrameShape &shape, const MeshWalk &walk, std::span<const Cell> reference,
                   std::span<const std::span<const Cell>> frames, const Progress &progress)
{
    if (shape.entropy == Entropy::Range) {
        const auto residuals = std::make_unique<RangeResiduals<RangeEncoder>>(walk);
        return encodeAll(*residuals, shape, walk, reference, frames, progress) ? residuals->coder().finish() : Bytes();
    }
    DeflateWriter residuals(walk);
    return encodeAll(residuals, shape, walk, reference, frames, progress) ? residuals.finish() : Bytes();
}

class FrameDecoder::Impl
{
public:
    Impl(const FrameShape &shape, const MeshWalk &walk, std::span<const Cell> reference,
         std::span<const std::uint8_t> stream)
        : mShape(shape)
        , mWalk(walk)
        , mReference(reference)
    {
        if (shape.entropy == Entropy::Range)
            mRange.emplace(walk, stream);
        else
            mDeflate.emplace(walk, stream);
    }

    bool next(FrameHistory history, std::span<Cell> now)
    {
        const bool isFirst = std::exchange(mIsFirst, false);
        if (isFirst)
            history = {mReference, {}, {}};
        return mRange ? codeFrame(*mRange, mShape, mWalk, history, isFirst, {}, now, nullptr)
                      : codeFrame(*mDeflate, mShape, mWalk, history, isFirst, {}, now, nullptr);
    }
    bool isAtEnd() { return mRange ? mRange->coder().isAtEnd() : mDeflate->isAtEnd(); }

private:
    const FrameShape mShape;
    const MeshWalk &mWalk;
    const std::span<const Cell> mReference;
    bool mIsFirst = true;
    std::optional<RangeResiduals<RangeDecoder>> mRange;
    std::optional<DeflateReader> mDeflate;
};

FrameDecoder::FrameDecoder(const FrameShape &shape, const MeshWalk &walk, std::span<const Cell> reference,
                           std::span<const std::uint8_t> stream)
    : mImpl(std::make_unique<Impl>(shape, walk, reference, stream))
{}

FrameDecoder::~FrameDecoder() = default;

bool FrameDecoder::next(std::span<const Cell> last, std::span<const Cell> second, std::span<const Cell> third,
                        std::span<Cell> now)
{
    return mImpl->next({last, second, third}, now);
}

bool FrameDecoder::isAtEnd()
{
    return mImpl->isAtEnd();
}

std::uint64_t FrameDecoder::neededBytes(Entropy entropy, std::uint64_t vertices)
{
    constexpr std::uint64_t InflateWindow = 64 << 10;
    return sizeof(Impl) + (entropy == Entropy::Range ? 2 * sizeof(Cell) * vertices : InflateWindow + 15 * vertices);
}

} // namespace model::codec
