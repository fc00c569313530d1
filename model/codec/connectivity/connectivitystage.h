// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/progress.h"
#include "model/codec/container/container.h"
#include "model/mesh/cornertable.h"

namespace model::codec {

inline constexpr std::uint32_t NoVertex = ~std::uint32_t(0);

/// The vertices next to a vertex that come before it in the coded order, for prediction by left + right - opposite. A
/// vertex inside has the parallelogram over the edge left-right; on the border of a hole left = right is the vertex
/// before it and opposite the one before that; with one neighbour all three are the same. NoVertex three times for the
/// first vertex of a part, and for vertices without a triangle.
struct VertexNeighbours
{
    std::uint32_t left = NoVertex, right = NoVertex, opposite = NoVertex;

    bool isNone() const { return left == NoVertex; }
    friend bool operator==(const VertexNeighbours &, const VertexNeighbours &) = default;
};

/// What encoder and decoder both have once the connectivity is coded.
struct CodedConnectivity
{
    /// In the coded order of vertices (as EdgeBreaker meets them, those without a triangle last) and triangles. The
    /// triangles are those of the input, each as it was oriented; which of its corners comes first may differ.
    Connectivity connectivity;
    std::vector<VertexNeighbours> neighbours; ///< #V
    /// The mesh as it was walked, cut where it was no oriented manifold. Triangle t is triangle t of `connectivity`,
    /// perhaps turned over.
    CornerTable corners;
    /// For each vertex of `corners` the vertex of `connectivity`; empty where nothing was cut: they are the same.
    std::vector<std::uint32_t> welded;

    std::uint32_t weldedVertex(std::uint32_t cut) const { return welded.empty() ? cut : welded[cut]; }
};

struct EncodedConnectivity
{
    Bytes bytes;
    CodedConnectivity coded;
    std::vector<std::uint32_t> permutation; ///< for each vertex of coded.connectivity the input's vertex
};

/// Any triangles, without loss but for the order of vertices and triangles. FORMAT.md 12.
/// Linear time but for vertices of very many triangles; about 100 bytes for a triangle.
/// \error LimitExceeded  more than MaxCodedTriangles
/// \error Cancelled
Result<EncodedConnectivity> encodeConnectivity(const Connectivity &connectivity, const Progress &progress);

/// The inverse. Takes untrusted bytes.
/// \param vertexCount, triangleCount  from the header
/// \param memoryLimit  most bytes that this may allocate
/// \error CorruptStream, LimitExceeded, Cancelled
Result<CodedConnectivity> decodeConnectivity(const Chunk &chunk, std::uint32_t vertexCount, std::uint32_t triangleCount,
                                             std::uint64_t memoryLimit, const Progress &progress);

/// Corners are numbered by 32 bits.
inline constexpr std::uint32_t MaxCodedTriangles = 0xfffffffeu / 3;

} // namespace model::codec
