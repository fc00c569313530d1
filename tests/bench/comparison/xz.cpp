// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/error.h"
#include "model/codec/direct/grid.h"
#include "model/codec/framestack.h"
#include "tests/bench/comparison/contender.h"
#include "tests/bench/comparison/stopwatch.h"

#include <lzma.h>

#include <cstring>
#include <stdexcept>

namespace bench {

using namespace model;

namespace {

using Bytes = std::vector<std::uint8_t>;

// As `xz -9e`.
Bytes packed(const Bytes &plain)
{
    Bytes result(lzma_stream_buffer_bound(plain.size()));
    std::size_t size = 0;
    if (lzma_easy_buffer_encode(9 | LZMA_PRESET_EXTREME, LZMA_CHECK_CRC64, nullptr, plain.data(), plain.size(),
                                result.data(), &size, result.size()) != LZMA_OK)
        throw std::runtime_error("xz");
    result.resize(size);
    return result;
}

Bytes unpacked(const Bytes &file, std::size_t plainSize)
{
    Bytes result(plainSize);
    std::uint64_t memory = UINT64_MAX;
    std::size_t in = 0, out = 0;
    if (lzma_stream_buffer_decode(&memory, 0, nullptr, file.data(), &in, file.size(), result.data(), &out,
                                  result.size()) != LZMA_OK)
        throw std::runtime_error("xz");
    return result;
}

template <class T>
void append(Bytes &bytes, const T *values, std::size_t count)
{
    const auto *begin = reinterpret_cast<const std::uint8_t *>(values);
    bytes.insert(bytes.end(), begin, begin + count * sizeof(T));
}

/// Triangles as 32-bit indices, before everything else.
Bytes triangles(const Subject &subject)
{
    Bytes bytes;
    const auto &list = subject.animation->connectivity().triangles;
    append(bytes, list.data(), list.size());
    return bytes;
}

Measurement measured(const Bytes &plain)
{
    Measurement row;
    Bytes file, back;
    row.encodeSeconds = secondsOf([&] { file = packed(plain); });
    row.decodeSeconds = secondsOf([&] { back = unpacked(file, plain.size()); });
    if (back != plain)
        throw std::runtime_error("xz");
    row.bytes = file.size();
    return row;
}

class XzOfFloats final : public Contender
{
public:
    bool isLossless() const override { return true; }
    std::vector<Measurement> reach(const Subject &subject, double) override
    {
        Bytes plain = triangles(subject);
        append(plain, subject.animation->allPositions().data(), subject.animation->allPositions().size());
        Measurement row = measured(plain);
        row.codec = "xz of floats";
        row.setting = "-9e";
        return {row};
    }
};

/// The cells of `direct`, each less that of the frame before, axis by axis.
class XzOfCells final : public Contender
{
public:
    std::vector<Measurement> reach(const Subject &subject, double percent) override
    {
        const auto resolution = directResolution(subject, percent);
        if (!resolution)
            return {};
        const codec::FrameStack frames = *codec::FrameStack::gather(*subject.animation, Progress());
        const auto grid = codec::CellGrid::around(frames, *resolution);
        Bytes plain = triangles(subject);
        double squares = 0;
        if (2 * std::uint64_t(*resolution) < 1u << 16)
            squares = cells<std::int16_t>(frames, grid, plain);
        else
            squares = cells<std::int32_t>(frames, grid, plain);
        Measurement row = measured(plain);
        row.codec = "xz of cells";
        row.setting = "resolution=" + std::to_string(*resolution) + " -9e";
        row.kgErrorPercent = codec::kgErrorOf(squares, frames.centredEnergy());
        return {row};
    }

private:
    template <class T>
    static double cells(const codec::FrameStack &frames, const codec::CellGrid &grid, Bytes &plain)
    {
        double squares = 0;
        const std::size_t vertices = frames.vertexCount();
        std::vector<codec::Cell> last(vertices);
        std::vector<T> row(vertices);
        for (std::size_t f = 0; f < frames.frameCount(); ++f) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                for (std::size_t v = 0; v < vertices; ++v) {
                    const std::int32_t cell = grid.cellOf(frames.frame(f)[v])[axis];
                    row[v] = T(cell - last[v][axis]);
                    last[v][axis] = cell;
                }
                append(plain, row.data(), vertices);
            }
            for (std::size_t v = 0; v < vertices; ++v) {
                const Vec3f p = frames.frame(f)[v], q = grid.middleOf(last[v]);
                const double x = double(p.x) - double(q.x), y = double(p.y) - double(q.y),
                             z = double(p.z) - double(q.z);
                squares += x * x + y * y + z * z;
            }
        }
        return squares;
    }
};

} // namespace

std::unique_ptr<Contender> makeXzOfFloats()
{
    return std::make_unique<XzOfFloats>();
}

std::unique_ptr<Contender> makeXzOfCells()
{
    return std::make_unique<XzOfCells>();
}

} // namespace bench
