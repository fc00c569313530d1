// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/coddyac/parallelogramstage.h"

#include "model/codec/coddyac/mixedinteger.h"

#include <memory>

namespace model::codec {

namespace {

/// Contexts of the residuals, one after another, for both directions.
class BandModel
{
public:
    explicit BandModel(std::span<const VertexNeighbours> neighbours)
        : mNeighbours(neighbours)
        , mBands{Residuals(neighbours.size()), Residuals(neighbours.size()), Residuals(neighbours.size())}
        , mSums(neighbours.size())
    {}

    void startBand()
    {
        std::rotate(mBands.begin(), mBands.end() - 1, mBands.end());
        mLast = mOlder = mRun = 0;
    }

    template <class Coder>
    std::int64_t code(Coder &coder, std::uint32_t vertex, std::int64_t residual = 0)
    {
        const VertexNeighbours &n = mNeighbours[vertex];
        const auto at = [](const Residuals &band, std::uint32_t v) {
            return v == NoVertex ? std::uint64_t(0) : std::uint64_t(band[v] < 0 ? -std::int64_t(band[v]) : band[v]);
        };
        const Residuals &band = mBands[0];
        const std::uint64_t left = at(band, n.left), right = at(band, n.right), opposite = at(band, n.opposite);
        const std::uint64_t near = 2 * left + 2 * right + opposite;
        const std::uint64_t one = at(mBands[1], vertex), two = at(mBands[2], vertex);
        const std::uint64_t around = at(mBands[1], n.left) + at(mBands[1], n.right) + at(mBands[1], n.opposite);
        const std::uint32_t kind = n.isNone() ? 0 : n.left == n.right ? 1 : 2;
        const MixedIntegerModel<Inputs>::Contexts contexts{
            sizeClass(near) * 16 + sizeClass(2 * one + two),
            sizeContext((2 * near + 6 * one + 3 * two + 2 * mLast) / 4) * 3 + kind,
            sizeClass(2 * left + right) * 16 + sizeClass(mRun / 8),
            sizeClass(2 * mLast + mOlder) * 16 + sizeClass(mRun / 8),
            sizeClass(2 * one) * 16 + sizeClass(around),
            sizeClass(mSums[vertex] / 4) * 16 + sizeClass(mRun / 8),
        };
        const auto sign = [&](std::uint32_t v) { return v == NoVertex ? 0 : signContext(band[v]); };
        const std::uint32_t signs = sign(n.left) * 9 + sign(n.right) * 3 + (vertex == 0 ? 0 : sign(vertex - 1));
        residual = mResiduals.code(coder, contexts, signs, residual);
        mBands[0][vertex] = std::int32_t(std::clamp<std::int64_t>(residual, -MaxBandValue, MaxBandValue));
        const std::uint64_t size = at(band, vertex);
        mOlder = mLast;
        mLast = size;
        mRun += size - mRun / 16;
        mSums[vertex] += std::uint32_t(4 * size) - mSums[vertex] / 4;
        return residual;
    }

private:
    static constexpr std::size_t Inputs = 6;
    using Residuals = std::vector<std::int32_t>;

    std::span<const VertexNeighbours> mNeighbours;
    std::array<Residuals, 3> mBands;  ///< of this band and the two before it
    std::vector<std::uint32_t> mSums; ///< 16 times the mean over the bands before, the latest counting most
    std::uint64_t mLast = 0, mOlder = 0;
    std::uint64_t mRun = 0; ///< 16 times the mean over the vertices before
    MixedIntegerModel<Inputs> mResiduals;
};

constexpr std::size_t CancelInterval = 8192; // values

} // namespace

Result<Bytes> encodeByParallelograms(std::size_t rank, std::span<const std::int32_t> values,
                                     std::span<const VertexNeighbours> neighbours, const Progress &progress)
{
    RangeEncoder coder;
    const auto model = std::make_unique<BandModel>(neighbours);
    for (std::size_t k = 0; k < rank; ++k) {
        const auto band = values.subspan(k * neighbours.size(), neighbours.size());
        model->startBand();
        for (std::uint32_t v = 0; v < band.size(); ++v) {
            if (v % CancelInterval == 0 && progress.isCancelled())
                return fail(ErrorCode::Cancelled);
            model->code(coder, v, band[v] - predictedByNeighbours(band, v, neighbours[v]));
        }
        progress.report(double(k + 1) / double(rank));
    }
    return coder.finish();
}

Result<void> decodeByParallelograms(const Chunk &chunk, std::size_t rank, std::span<const VertexNeighbours> neighbours,
                                    const Progress &progress,
                                    const std::function<void(std::uint32_t, std::span<const std::int32_t>)> &row)
{
    RangeDecoder coder(chunk.payload);
    const auto model = std::make_unique<BandModel>(neighbours);
    const auto corrupt = [&] {
        return fail(Error{ErrorCode::CorruptStream, {"coefficients"}, {}, Error::None, chunk.offset});
    };
    std::vector<std::int32_t> band(neighbours.size());
    for (std::size_t k = 0; k < rank; ++k) {
        model->startBand();
        for (std::uint32_t v = 0; v < band.size(); ++v) {
            if (v % CancelInterval == 0) {
                if (progress.isCancelled())
                    return fail(ErrorCode::Cancelled);
                if (coder.isBad())
                    return corrupt();
            }
            const std::int64_t value = predictedByNeighbours(band, v, neighbours[v]) + model->code(coder, v);
            if (value > MaxBandValue || value < -MaxBandValue)
                return corrupt();
            band[v] = std::int32_t(value);
        }
        row(std::uint32_t(k), band);
        progress.report(double(k + 1) / double(rank));
    }
    if (!coder.isAtEnd())
        return corrupt();
    return {};
}

} // namespace model::codec
