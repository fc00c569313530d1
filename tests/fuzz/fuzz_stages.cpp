// SPDX-License-Identifier: GPL-3.0-or-later
// The other stages, each without the file around it: streams that are anything, and any integers there and back.
// Input: a byte that says which stage, one that says whether a stream follows or integers, a byte of columns, those.
#include "model/codec/coddyac/lanestage.h"
#include "model/codec/coddyac/parallelogramstage.h"
#include "model/codec/direct/framecoder.h"
#include "model/codec/entropy/bandstage.h"
#include "model/codec/entropy/indexstage.h"
#include "model/codec/reel/reelstream.h"
#include "tests/fuzz/bytesource.h"
#include "tests/fuzz/require.h"

#include <algorithm>
#include <optional>

using namespace model;
using namespace model::codec;

namespace {

enum Stage : std::uint8_t { Indices, Rows, Means, Lanes, Parallelograms, FramesByRange, FramesByDeflate, Reel, Stages };

Chunk chunkOf(const Bytes &payload)
{
    Chunk chunk;
    chunk.payload = payload;
    return chunk;
}

Connectivity strip(std::uint32_t vertices)
{
    Connectivity mesh{vertices, {}};
    for (std::uint32_t v = 0; v + 2 < vertices; ++v)
        mesh.triangles.push_back(v % 2 ? Triangle{v + 1, v, v + 2} : Triangle{v, v + 1, v + 2});
    return mesh;
}

/// #rows x `columns` integers of at most `bits` bits.
template <class Integer>
std::vector<Integer> integers(tests::ByteSource &in, std::size_t columns, unsigned bits)
{
    std::vector<Integer> values;
    do
        for (std::size_t i = 0; i < columns; ++i)
            values.push_back(Integer(in.integer(bits)));
    while (!in.isEmpty());
    return values;
}

void indices(tests::ByteSource &in, bool isStream, std::uint32_t columns)
{
    if (isStream) {
        const Bytes bytes = in.rest();
        if (const auto decoded = decodeIndices(chunkOf(bytes), columns, 3 * columns, Progress()))
            for (const Triangle &t : decoded->triangles)
                SANDREEL_REQUIRE(t[0] < columns && t[1] < columns && t[2] < columns);
        return;
    }
    Connectivity mesh{columns, {}};
    while (!in.isEmpty())
        mesh.triangles.push_back({in.below(columns), in.below(columns), in.below(columns)});
    const auto bytes = encodeIndices(mesh, Progress());
    SANDREEL_REQUIRE(bytes.has_value());
    const auto decoded = decodeIndices(chunkOf(*bytes), columns, std::uint32_t(mesh.triangles.size()), Progress());
    SANDREEL_REQUIRE(decoded.has_value() && *decoded == mesh);
}

void rows(tests::ByteSource &in, bool isStream, std::uint32_t columns)
{
    const std::uint32_t stride = columns % 3 == 0 ? 3 : 1;
    std::vector<std::int32_t> found;
    const auto take = [&](std::uint32_t k, std::span<const std::int32_t> row) {
        SANDREEL_REQUIRE(row.size() == columns && k * columns == found.size());
        found.insert(found.end(), row.begin(), row.end());
    };
    if (isStream) {
        const Bytes bytes = in.rest();
        (void)decodeBands(chunkOf(bytes), {7, columns, stride}, "rows", Progress(), take);
        for (const std::int32_t value : found)
            SANDREEL_REQUIRE(std::abs(std::int64_t(value)) <= MaxBandValue);
        return;
    }
    const auto values = integers<std::int32_t>(in, columns, 30);
    const Bands shape{std::uint32_t(values.size() / columns), columns, stride};
    const auto bytes = encodeBands(shape, values, Progress());
    SANDREEL_REQUIRE(bytes.has_value());
    SANDREEL_REQUIRE(decodeBands(chunkOf(*bytes), shape, "rows", Progress(), take).has_value());
    SANDREEL_REQUIRE(found == values);
}

void means(tests::ByteSource &in, bool isStream, std::uint32_t columns)
{
    if (isStream) {
        const Bytes bytes = in.rest();
        if (const auto decoded = decodeMeans(chunkOf(bytes), 3 * columns))
            for (const std::int64_t value : *decoded)
                SANDREEL_REQUIRE(value <= MaxMeanValue && value >= -MaxMeanValue);
        return;
    }
    const auto values = integers<std::int64_t>(in, 3, 53);
    const auto decoded = decodeMeans(chunkOf(encodeMeans(values)), values.size());
    SANDREEL_REQUIRE(decoded.has_value() && *decoded == values);
}

void lanes(tests::ByteSource &in, bool isStream, std::uint32_t columns)
{
    const std::size_t wide = 3 * std::size_t(columns);
    std::vector<std::int64_t> found;
    const auto take = [&](std::size_t, std::span<const std::int64_t> row) {
        found.insert(found.end(), row.begin(), row.end());
    };
    if (isStream) {
        const Bytes bytes = in.rest();
        (void)decodeLanes(chunkOf(bytes), 5, wide, "lanes", Progress(), take);
        for (const std::int64_t value : found)
            SANDREEL_REQUIRE(value <= MaxLaneValue && value >= -MaxLaneValue);
        return;
    }
    const auto values = integers<std::int64_t>(in, wide, 53);
    const Bytes bytes = encodeLanes(wide, values);
    SANDREEL_REQUIRE(decodeLanes(chunkOf(bytes), values.size() / wide, wide, "lanes", Progress(), take).has_value());
    SANDREEL_REQUIRE(found == values);
}

void parallelograms(tests::ByteSource &in, bool isStream, std::uint32_t columns)
{
    const auto neighbours = encodeConnectivity(strip(columns), Progress())->coded.neighbours;
    std::vector<std::int32_t> found;
    const auto take = [&](std::uint32_t, std::span<const std::int32_t> row) {
        found.insert(found.end(), row.begin(), row.end());
    };
    if (isStream) {
        const Bytes bytes = in.rest();
        (void)decodeByParallelograms(chunkOf(bytes), 4, neighbours, Progress(), take);
        for (const std::int32_t value : found)
            SANDREEL_REQUIRE(std::abs(std::int64_t(value)) <= MaxBandValue);
        return;
    }
    const auto values = integers<std::int32_t>(in, columns, 30);
    const auto bytes = encodeByParallelograms(values.size() / columns, values, neighbours, Progress());
    SANDREEL_REQUIRE(bytes.has_value());
    SANDREEL_REQUIRE(
        decodeByParallelograms(chunkOf(*bytes), values.size() / columns, neighbours, Progress(), take).has_value());
    SANDREEL_REQUIRE(found == values);
}

void frames(tests::ByteSource &in, bool isStream, std::uint32_t columns, Entropy entropy)
{
    const std::uint8_t choice = in.u8();
    const FrameShape shape{std::uint32_t(1) << (choice / 5 % 25), Predictor(choice % 5), entropy};
    const MeshWalk walk(strip(columns),
                        shape.predictor == Predictor::Neighbours ? MeshWalk::Order::Growing : MeshWalk::Order::File);
    std::vector<std::vector<Cell>> wanted;
    Bytes bytes;
    if (isStream) {
        bytes = in.rest();
    } else {
        while (wanted.size() < 8 && !in.isEmpty()) {
            std::vector<Cell> &cells = wanted.emplace_back(columns);
            for (Cell &cell : cells)
                for (std::int32_t &c : cell)
                    c = std::int32_t(std::uint64_t(in.integer(24)) % shape.resolution);
        }
        bytes =
            encodeFrames(shape, walk, {}, std::vector<std::span<const Cell>>(wanted.begin(), wanted.end()), Progress());
    }
    FrameDecoder decoder(shape, walk, {}, bytes);
    std::vector<std::vector<Cell>> done;
    const auto before = [&](std::size_t back) {
        return done.size() > back ? std::span<const Cell>(done[done.size() - 1 - back]) : std::span<const Cell>();
    };
    for (std::size_t f = 0; f < (isStream ? 8 : wanted.size()); ++f) {
        std::vector<Cell> now(columns);
        const bool isWhole = decoder.next(before(0), before(1), before(2), now);
        for (const Cell &cell : now)
            for (const std::int32_t c : cell)
                SANDREEL_REQUIRE(c >= 0 && c < std::int32_t(shape.resolution));
        if (!isWhole) {
            SANDREEL_REQUIRE(isStream);
            return;
        }
        done.push_back(std::move(now));
    }
    SANDREEL_REQUIRE(isStream || (decoder.isAtEnd() && done == wanted));
}

/// Residuals of BandCoder and ShapeCoder: read, or the next ones of a list.
template <class Coder>
struct Residuals
{
    Coder &coder;
    const std::int32_t *next = nullptr;
    std::vector<std::int32_t> done{};

    template <class Model, class... Rest>
    std::int32_t operator()(Model &model, const typename Model::Contexts &contexts, std::size_t set, const Rest &...)
    {
        done.push_back(model.code(coder, contexts, set, next ? *next++ : 0));
        return done.back();
    }
};

constexpr std::size_t ReelBands = 6;

template <class Coder>
std::vector<std::int32_t> codeReel(Coder &coder, const CoarseToFine &nodes, const std::int32_t *values)
{
    Residuals<Coder> residuals{coder, values};
    ShapeCoder shape(nodes, 0.8);
    shape.codeAll(residuals, [] { return true; });
    BandModel learned;
    BandCoder bands(nodes, krigingWeights(nodes, shape.places()), {ReelBands, 0.9, MeshRidge}, learned);
    for (std::size_t band = 0; band < ReelBands; ++band)
        bands.nextBand(residuals);
    return residuals.done;
}

void reel(tests::ByteSource &in, bool isStream, std::uint32_t columns)
{
    const auto nodes = coarseToFine(strip(columns), Progress());
    if (isStream) {
        const Bytes bytes = in.rest();
        RangeDecoder coder(bytes);
        codeReel(coder, *nodes, nullptr);
        return;
    }
    std::vector<std::int32_t> values((3 + ReelBands) * columns);
    for (std::int32_t &value : values)
        value = std::int32_t(in.integer(30));
    RangeEncoder encoder;
    codeReel(encoder, *nodes, values.data());
    const Bytes bytes = encoder.finish();
    RangeDecoder decoder(bytes);
    SANDREEL_REQUIRE(codeReel(decoder, *nodes, nullptr) == values);
    SANDREEL_REQUIRE(decoder.isAtEnd());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    tests::ByteSource in({data, size});
    const Stage stage = Stage(in.u8() % Stages);
    const bool isStream = in.u8() % 2 == 0;
    const std::uint32_t columns = in.u8() % 60 + 1u;
    switch (stage) {
    case Indices:
        indices(in, isStream, columns);
        break;
    case Rows:
        rows(in, isStream, columns);
        break;
    case Means:
        means(in, isStream, columns);
        break;
    case Lanes:
        lanes(in, isStream, columns);
        break;
    case Parallelograms:
        parallelograms(in, isStream, columns);
        break;
    case FramesByRange:
        frames(in, isStream, columns, Entropy::Range);
        break;
    case FramesByDeflate:
        frames(in, isStream, columns, Entropy::Deflate);
        break;
    default:
        reel(in, isStream, columns);
        break;
    }
    return 0;
}
