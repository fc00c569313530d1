// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/connectivity/connectivitystage.h"

namespace model::codec {

/// The order that the vertices had: for each vertex, in the coded order, its place in the input. Coded against the
/// places of its neighbours and of the vertex before, as makers of meshes number vertices along rows and strips.
/// FORMAT.md 15.
/// \param places      #V, a permutation of 0 ... V - 1
/// \param neighbours  #V
/// O(V log V), 9 bytes for a vertex.
Bytes encodeVertexOrder(std::span<const std::uint32_t> places, std::span<const VertexNeighbours> neighbours);

/// The inverse. Takes untrusted bytes.
/// \error CorruptStream
Result<std::vector<std::uint32_t>> decodeVertexOrder(const Chunk &chunk, std::span<const VertexNeighbours> neighbours);

} // namespace model::codec
