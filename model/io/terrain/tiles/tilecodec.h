// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/bytes.h"
#include "model/base/progress.h"
#include "model/terrain/tin/build/restoretin.h"

namespace model::io {

/// The surface of a terrain as bytes: vertices, triangles, voids and layers. FORMAT.md, sections 4 and 5.
///
/// Lossless: every coordinate and every layer comes back to the bit, and the triangles are the same but for their
/// numbers. Vertices come back in the order of the file: along the Hilbert curve by tiles.
/// \param step     what x and y of most vertices are multiples of, or 0
/// \param fileIds  if wanted: the vertex of the file that each slot of `tin` became, None for free slots
/// \error Cancelled
/// Same logical terrain, same slots: same bytes, whatever the number of threads.
Result<Bytes> encodeSurface(const terrain::TinArrays &tin, const terrain::Rectangle &domain, terrain::Point2 step,
                            std::vector<terrain::VertexId> *fileIds = nullptr, const Progress &progress = Progress());

/// A surface as encodeSurface() was given it, for restoreTin().
struct DecodedSurface
{
    terrain::TinArrays arrays;
    terrain::Rectangle domain;
};

/// \param memoryLimit  bytes that the arrays may take
/// \error Truncated, BadValue, CorruptStream, TrailingBytes, each with its byte; LimitExceeded; Cancelled
/// Whether the triangles make a TIN is for restoreTin() to say: they are consistent, no more.
Result<DecodedSurface> decodeSurface(std::span<const std::uint8_t> bytes, std::uint64_t memoryLimit,
                                     const Progress &progress = Progress());

} // namespace model::io
