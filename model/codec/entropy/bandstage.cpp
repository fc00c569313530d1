// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/entropy/bandstage.h"

#include "model/codec/container/streams.h"
#include "model/codec/container/syntax.h"
#include "model/codec/entropy/integercoder.h"

#include <memory>

namespace model::codec {

namespace {

// Values that a stream should hold at least: learning its statistics anew must cost little.
constexpr std::uint64_t ValuesPerStream = 1u << 15;
constexpr std::size_t CancelInterval = 8192; // values

struct Parameters
{
    std::uint64_t rowsPerStream = 1;
};

template <class Stream, class Fields>
bool parameterSyntax(Stream &s, Fields &p) // FORMAT.md 5.3
{
    return s.varUint(p.rowsPerStream) && s.require(p.rowsPerStream >= 1 && p.rowsPerStream <= 65535, "rows per stream",
                                                   p.rowsPerStream, "1 ... 65535");
}

std::uint64_t magnitudeOf(std::int64_t value)
{
    return value < 0 ? 0 - std::uint64_t(value) : std::uint64_t(value);
}

/// The models of one stream and the history of one row; prediction and contexts for both directions.
template <unsigned ClassBits>
class BandModel
{
public:
    explicit BandModel(std::uint32_t stride)
        : mStride(stride)
    {}

    void startRow()
    {
        mLanes = {};
        mLast = 0;
        mNext = 0;
    }

    template <class Coder>
    std::int64_t code(Coder &coder, std::int64_t value = 0)
    {
        Lane &lane = mLanes[mNext];
        mNext = mNext + 1 == mStride ? 0 : mNext + 1;
        const std::uint64_t expected = (2 * lane.magnitude + lane.older + mLast) / 2;
        const std::int64_t residual =
            codeInteger(coder, mModels, sizeContext(expected), signContext(lane.residual), value - lane.value);
        // What leaves 64 bits comes back at the other end of them, where no value is allowed.
        lane.value = std::int64_t(std::uint64_t(lane.value) + std::uint64_t(residual));
        lane.residual = residual;
        lane.older = lane.magnitude;
        lane.magnitude = magnitudeOf(residual);
        mLast = lane.magnitude;
        return lane.value;
    }

private:
    struct Lane
    {
        std::int64_t value = 0; ///< the prediction
        std::int64_t residual = 0;
        std::uint64_t magnitude = 0;
        std::uint64_t older = 0;
    };
    std::array<Lane, 3> mLanes;
    std::uint64_t mLast = 0;
    std::uint32_t mStride;
    std::uint32_t mNext = 0;
    IntegerModels<ClassBits> mModels;
};
using NarrowModel = BandModel<5>;
using WideModel = BandModel<6>;

Bytes encodeRows(const Bands &shape, std::span<const std::int32_t> values, const Progress &progress)
{
    RangeEncoder coder;
    const auto model = std::make_unique<NarrowModel>(shape.stride);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i % CancelInterval == 0 && progress.isCancelled())
            return {};
        if (i % shape.columns == 0)
            model->startRow();
        model->code(coder, values[i]);
    }
    return coder.finish();
}

/// One row of a stream. \returns false if it is corrupt or the work was cancelled
bool decodeRow(RangeDecoder &coder, NarrowModel &model, std::span<std::int32_t> row, const Progress &progress)
{
    model.startRow();
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (i % CancelInterval == 0 && (progress.isCancelled() || coder.isBad()))
            return false;
        const std::int64_t value = model.code(coder);
        if (value > MaxBandValue || value < -MaxBandValue)
            return false;
        row[i] = std::int32_t(value);
    }
    return !coder.isBad();
}

} // namespace

Result<Bytes> encodeBands(const Bands &shape, std::span<const std::int32_t> values, const Progress &progress)
{
    Parameters parameters;
    parameters.rowsPerStream = std::clamp<std::uint64_t>(ValuesPerStream / shape.columns, 1, 65535);
    const auto streams =
        encodeStreams(shape.rows, parameters.rowsPerStream, progress, [&](std::size_t begin, std::size_t count) {
            return encodeRows(shape, values.subspan(begin * shape.columns, count * shape.columns), progress);
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

Result<void> decodeBands(const Chunk &chunk, const Bands &shape, std::string_view stage, const Progress &progress,
                         const std::function<void(std::uint32_t, std::span<const std::int32_t>)> &row)
{
    Parameters parameters;
    ByteReader reader(chunk.payload, chunk.offset);
    SyntaxReader syntax(reader);
    parameterSyntax(syntax, parameters);
    if (!reader.ok())
        return fail(reader.error());
    const std::uint64_t perStream = parameters.rowsPerStream;
    const std::vector<StreamView> streams = readStreams(reader, streamCount(shape.rows, perStream));
    if (!reader.requireEnd())
        return fail(reader.error());
    return decodeStreams(streams, stage, progress, [&](std::size_t i, auto stream) {
        RangeDecoder coder(stream);
        const auto model = std::make_unique<NarrowModel>(shape.stride);
        std::vector<std::int32_t> values(shape.columns);
        const std::uint64_t end = std::min<std::uint64_t>(shape.rows, (i + 1) * perStream);
        for (std::uint64_t r = i * perStream; r < end; ++r) {
            if (!decodeRow(coder, *model, values, progress))
                return false;
            row(std::uint32_t(r), values);
        }
        return coder.isAtEnd();
    });
}

Bytes encodeMeans(std::span<const std::int64_t> values)
{
    RangeEncoder coder;
    const auto model = std::make_unique<WideModel>(3);
    for (const std::int64_t value : values)
        model->code(coder, value);
    return coder.finish();
}

Result<std::vector<std::int64_t>> decodeMeans(const Chunk &chunk, std::size_t count)
{
    RangeDecoder coder(chunk.payload);
    const auto model = std::make_unique<WideModel>(3);
    std::vector<std::int64_t> values;
    values.reserve(count);
    bool good = true;
    for (std::size_t i = 0; i < count && good; ++i) {
        values.push_back(model->code(coder));
        good = values.back() >= -MaxMeanValue && values.back() <= MaxMeanValue && !coder.isBad();
    }
    if (!good || !coder.isAtEnd())
        return fail(Error{ErrorCode::CorruptStream, {"means"}, {}, Error::None, chunk.offset});
    return values;
}

} // namespace model::codec
