// SPDX-License-Identifier: GPL-3.0-or-later
// The stages CLRS and ORDR: streams that are anything, and any mesh and any order there and back.
// Input: a byte that says which, then what Kind says.
#include "model/codec/connectivity/connectivitystage.h"
#include "model/codec/connectivity/vertexorder.h"
#include "tests/fuzz/bytesource.h"
#include "tests/fuzz/require.h"
#include "tests/support/scarcity.h"

#include <algorithm>
#include <numeric>

using namespace model;
using namespace model::codec;

namespace {

enum Kind : std::uint8_t {
    Stream,      ///< u16 vertices, u16 triangles, the stream
    Mesh,        ///< byte of vertices, corners a byte each
    OrderStream, ///< byte of columns of a grid of 64 vertices, the stream
    Order,       ///< byte of columns, a byte or two for each place
    Kinds
};

constexpr std::uint64_t MemoryLimit = std::uint64_t(8) << 20;

Triangle canonical(Triangle t)
{
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
}

std::vector<Triangle> canonical(const Connectivity &connectivity, const std::vector<std::uint32_t> &names)
{
    std::vector<Triangle> result;
    for (const Triangle &t : connectivity.triangles)
        result.push_back(canonical({names[t[0]], names[t[1]], names[t[2]]}));
    std::sort(result.begin(), result.end());
    return result;
}

std::vector<std::uint32_t> identity(std::uint32_t count)
{
    std::vector<std::uint32_t> names(count);
    std::iota(names.begin(), names.end(), 0u);
    return names;
}

void requireSound(const CodedConnectivity &coded)
{
    const std::uint32_t count = coded.connectivity.vertexCount;
    for (const Triangle &triangle : coded.connectivity.triangles)
        for (const std::uint32_t vertex : triangle)
            SANDREEL_REQUIRE(vertex < count);
    SANDREEL_REQUIRE(coded.neighbours.size() == count);
    for (std::uint32_t v = 0; v < count; ++v) {
        const VertexNeighbours &n = coded.neighbours[v];
        SANDREEL_REQUIRE(n.isNone() || (n.left < v && n.right < v && n.opposite < v));
    }
}

void requireRoundTrip(const Connectivity &mesh)
{
    const auto encoded = encodeConnectivity(mesh, Progress());
    SANDREEL_REQUIRE(encoded.has_value());
    requireSound(encoded->coded);
    Chunk chunk;
    chunk.payload = encoded->bytes;
    const auto decoded = decodeConnectivity(chunk, mesh.vertexCount, std::uint32_t(mesh.triangles.size()),
                                            ~std::uint64_t(0), Progress());
    SANDREEL_REQUIRE(decoded.has_value());
    SANDREEL_REQUIRE(decoded->connectivity == encoded->coded.connectivity);
    SANDREEL_REQUIRE(decoded->neighbours == encoded->coded.neighbours);
    SANDREEL_REQUIRE(canonical(decoded->connectivity, encoded->permutation) ==
                     canonical(mesh, identity(mesh.vertexCount)));
}

void decodeStream(tests::ByteSource &in)
{
    const std::uint32_t vertices = in.u16() % 4096 + 1, triangles = in.u16() % 8192;
    const Bytes stream = in.rest();
    Chunk chunk;
    chunk.payload = stream;
    tests::AllocationMeter meter;
    const auto decoded = decodeConnectivity(chunk, vertices, triangles, MemoryLimit, Progress());
    SANDREEL_REQUIRE(meter.peak() <= MemoryLimit);
    if (!decoded)
        return;
    requireSound(*decoded);
    requireRoundTrip(decoded->connectivity);
}

void encodeMesh(tests::ByteSource &in)
{
    Connectivity mesh;
    mesh.vertexCount = in.u8() % 64 + 1u;
    while (!in.isEmpty() && mesh.triangles.size() < 500) {
        Triangle &t = mesh.triangles.emplace_back();
        for (std::uint32_t &v : t)
            v = in.below(mesh.vertexCount);
    }
    requireRoundTrip(mesh);
}

std::vector<VertexNeighbours> gridNeighbours(std::uint32_t columns)
{
    constexpr std::uint32_t Vertices = 64;
    Connectivity mesh{Vertices, {}};
    for (std::uint32_t v = 0; v + columns + 1 < Vertices; ++v) {
        mesh.triangles.push_back({v, v + 1, v + columns});
        mesh.triangles.push_back({v + 1, v + columns + 1, v + columns});
    }
    return encodeConnectivity(mesh, Progress())->coded.neighbours;
}

bool isPermutation(std::vector<std::uint32_t> places)
{
    std::sort(places.begin(), places.end());
    return places == identity(std::uint32_t(places.size()));
}

void decodeOrder(tests::ByteSource &in)
{
    const auto neighbours = gridNeighbours(in.u8() % 31 + 2u);
    const Bytes stream = in.rest();
    Chunk chunk;
    chunk.payload = stream;
    if (const auto places = decodeVertexOrder(chunk, neighbours))
        SANDREEL_REQUIRE(places->size() == neighbours.size() && isPermutation(*places));
}

void encodeOrder(tests::ByteSource &in)
{
    const auto neighbours = gridNeighbours(in.u8() % 31 + 2u);
    std::vector<std::uint32_t> free = identity(std::uint32_t(neighbours.size())), places;
    while (!free.empty()) {
        const auto at = free.begin() + std::ptrdiff_t(in.below(std::uint32_t(free.size())));
        places.push_back(*at);
        free.erase(at);
    }
    const Bytes stream = encodeVertexOrder(places, neighbours);
    Chunk chunk;
    chunk.payload = stream;
    const auto decoded = decodeVertexOrder(chunk, neighbours);
    SANDREEL_REQUIRE(decoded.has_value() && *decoded == places);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    tests::ByteSource in({data, size});
    switch (Kind(in.u8() % Kinds)) {
    case Stream:
        decodeStream(in);
        break;
    case Mesh:
        encodeMesh(in);
        break;
    case OrderStream:
        decodeOrder(in);
        break;
    default:
        encodeOrder(in);
        break;
    }
    return 0;
}
