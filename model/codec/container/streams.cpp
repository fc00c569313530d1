// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/container/streams.h"

#include "model/base/parallel.h"

#include <algorithm>
#include <atomic>

namespace model::codec {

void writeStreams(ByteWriter &out, std::span<const Bytes> streams)
{
    for (const Bytes &stream : streams)
        out.varUint(stream.size());
    for (const Bytes &stream : streams)
        out.bytes(stream);
}

Result<std::vector<Bytes>> encodeStreams(std::uint64_t total, std::uint64_t perStream, const Progress &progress,
                                         const std::function<Bytes(std::size_t, std::size_t)> &encode)
{
    std::vector<Bytes> streams(std::size_t(streamCount(total, perStream)));
    std::atomic<std::size_t> done = 0;
    parallelFor(streams.size(), [&](std::size_t i) {
        if (progress.isCancelled())
            return;
        const std::uint64_t begin = i * perStream;
        streams[i] = encode(std::size_t(begin), std::size_t(std::min(perStream, total - begin)));
        progress.report(double(++done) / double(streams.size()));
    });
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    return streams;
}

std::vector<StreamView> readStreams(ByteReader &in, std::uint64_t count)
{
    std::vector<StreamView> streams;
    std::vector<std::uint64_t> lengths;
    // Each length takes at least one byte.
    if (!in.require(count <= in.left(), "stream count", count, "at most the bytes left"))
        return {};
    lengths.reserve(count);
    streams.reserve(count);
    for (std::uint64_t i = 0; i < count; ++i)
        lengths.push_back(in.varUint());
    for (const std::uint64_t length : lengths) {
        const std::uint64_t offset = in.offset();
        streams.push_back({in.bytes(length), offset});
    }
    if (!in.ok())
        return {};
    return streams;
}

Result<void> decodeStreams(std::span<const StreamView> streams, std::string_view stage, const Progress &progress,
                           const std::function<bool(std::size_t, std::span<const std::uint8_t>)> &decode)
{
    std::atomic<std::size_t> done = 0;
    std::atomic<std::size_t> firstBad = streams.size();
    parallelFor(streams.size(), [&](std::size_t i) {
        if (progress.isCancelled() || decode(i, streams[i].data)) {
            progress.report(double(++done) / double(streams.size()));
            return;
        }
        std::size_t known = firstBad;
        while (i < known && !firstBad.compare_exchange_weak(known, i)) {
        }
    });
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    if (firstBad < streams.size())
        return fail(Error{ErrorCode::CorruptStream, {std::string(stage)}, {}, Error::None, streams[firstBad].offset});
    return {};
}

} // namespace model::codec
