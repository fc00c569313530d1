// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/bytes.h"
#include "model/base/progress.h"

#include <functional>
#include <span>
#include <vector>

namespace model::codec {

/// Several streams in one payload, so that they can be decoded on several threads: all lengths, then all bytes.
/// FORMAT.md 3.4.
void writeStreams(ByteWriter &out, std::span<const Bytes> streams);

struct StreamView
{
    std::span<const std::uint8_t> data;
    std::uint64_t offset = 0; ///< in the file
};
/// Mirrors writeStreams; empty after an error, which the reader keeps.
std::vector<StreamView> readStreams(ByteReader &in, std::uint64_t count);

/// Decodes streams on several threads.
/// \param decode  decodes stream i; returns false if it is corrupt, or anything once the work is cancelled
/// \error CorruptStream{stage} at the first corrupt stream, Cancelled
Result<void> decodeStreams(std::span<const StreamView> streams, std::string_view stage, const Progress &progress,
                           const std::function<bool(std::size_t, std::span<const std::uint8_t>)> &decode);

/// Ranges of `perStream` out of `total`, the last one shorter.
inline std::uint64_t streamCount(std::uint64_t total, std::uint64_t perStream)
{
    return (total + perStream - 1) / perStream;
}

/// Encodes ranges of `perStream` out of `total` items on several threads.
/// \param encode  encodes the items [begin, begin + count); returns anything once the work is cancelled
/// \error Cancelled
Result<std::vector<Bytes>> encodeStreams(std::uint64_t total, std::uint64_t perStream, const Progress &progress,
                                         const std::function<Bytes(std::size_t begin, std::size_t count)> &encode);

} // namespace model::codec
