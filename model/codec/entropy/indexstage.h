// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/progress.h"
#include "model/codec/container/container.h"
#include "model/mesh/trianglemesh.h"

namespace model::codec {

/// The connectivity as index lists: any triangles, in their order, without loss. FORMAT.md 5.1.
/// \error Cancelled
Result<Bytes> encodeIndices(const Connectivity &connectivity, const Progress &progress);

/// The inverse. \param vertexCount, triangleCount  from the header
/// \error Truncated, TrailingBytes, BadValue, CorruptStream, Cancelled
Result<Connectivity> decodeIndices(const Chunk &chunk, std::uint32_t vertexCount, std::uint32_t triangleCount,
                                   const Progress &progress);

} // namespace model::codec
