// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/coddyac/lanestage.h"

#include "model/codec/coddyac/mixedinteger.h"

#include <memory>

namespace model::codec {

namespace {

/// Prediction and contexts of rows, one value after another, for both directions.
class LaneModel
{
public:
    explicit LaneModel(std::size_t columns)
        : mBefore(columns)
        , mRow(columns)
    {}

    void startRow()
    {
        mLanes = {};
        mOthers = mRun = 0;
        mBefore.swap(mRow);
        mNext = 0;
    }

    template <class Coder>
    std::int64_t code(Coder &coder, std::int64_t value = 0)
    {
        Lane &lane = mLanes[mNext % 3];
        if (mNext % 3 == 0)
            mOthers = 0;
        const std::int64_t predicted = mNext < 3 ? 0 : mNext < 6 ? lane.last : 2 * lane.last - lane.older;
        const std::uint64_t recent = 2 * lane.sizes[0] + lane.sizes[1] + lane.sizes[2];
        const MixedIntegerModel<Inputs>::Contexts contexts{
            sizeClass(recent) * 16 + sizeClass(2 * mOthers),
            sizeClass(2 * lane.sizes[0]) * 16 + sizeClass(2 * lane.sizes[1]),
            sizeClass(mRun / 8) * 16 + sizeClass(recent),
            sizeClass(mBefore[mNext]) * 16 + sizeClass(recent + 2 * mOthers),
            sizeClass(lane.run / 4) * 16 + sizeClass(mOthers),
        };
        const std::int64_t residual =
            mResiduals.code(coder, contexts, lane.signs[0] * 3 + lane.signs[1], value - predicted);
        const std::uint64_t size = std::uint64_t(residual < 0 ? -residual : residual);
        lane.older = lane.last;
        lane.last = predicted + residual;
        lane.sizes = {size, lane.sizes[0], lane.sizes[1]};
        lane.signs = {signContext(residual), lane.signs[0]};
        lane.run += size * 16 / 8 - lane.run / 8;
        mRun += size * 16 / 16 - mRun / 16;
        mOthers += size;
        mRow[mNext++] = std::uint32_t(std::min<std::uint64_t>(size, 0xffffffff));
        return lane.last;
    }

private:
    static constexpr std::size_t Inputs = 5;
    struct Lane
    {
        std::int64_t last = 0, older = 0;
        std::array<std::uint64_t, 3> sizes{}; ///< of the residuals before
        std::array<std::uint32_t, 2> signs{};
        std::uint64_t run = 0; ///< 16 times their mean
    };
    std::array<Lane, 3> mLanes;
    std::uint64_t mOthers = 0; ///< residuals of the frame's other coordinates
    std::uint64_t mRun = 0;
    std::vector<std::uint32_t> mBefore, mRow; ///< residuals of the row before, and of this one
    std::size_t mNext = 0;
    MixedIntegerModel<Inputs> mResiduals;
};

} // namespace

Bytes encodeLanes(std::size_t columns, std::span<const std::int64_t> values)
{
    RangeEncoder coder;
    const auto model = std::make_unique<LaneModel>(columns);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i % columns == 0)
            model->startRow();
        model->code(coder, values[i]);
    }
    return coder.finish();
}

Result<void> decodeLanes(const Chunk &chunk, std::size_t rows, std::size_t columns, std::string_view stage,
                         const Progress &progress,
                         const std::function<void(std::size_t, std::span<const std::int64_t>)> &row)
{
    RangeDecoder coder(chunk.payload);
    const auto model = std::make_unique<LaneModel>(columns);
    const auto corrupt = [&] {
        return fail(Error{ErrorCode::CorruptStream, {std::string(stage)}, {}, Error::None, chunk.offset});
    };
    std::vector<std::int64_t> values(columns);
    for (std::size_t r = 0; r < rows; ++r) {
        if (progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        model->startRow();
        for (std::int64_t &value : values) {
            value = model->code(coder);
            if (value > MaxLaneValue || value < -MaxLaneValue || coder.isBad())
                return corrupt();
        }
        row(r, values);
        progress.report(double(r + 1) / double(rows));
    }
    if (!coder.isAtEnd())
        return corrupt();
    return {};
}

} // namespace model::codec
