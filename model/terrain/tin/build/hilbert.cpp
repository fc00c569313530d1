// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: J. Skilling, Programming the Hilbert curve, 2004, for the curve; the state table is worked out from it.
// Differs: four states, and a table look-up for every four of the 32 levels.
#include "model/terrain/tin/build/hilbert.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace model::terrain {

namespace {

struct Step
{
    std::uint8_t quadrant; ///< along the curve
    std::uint8_t state;    ///< of the curve inside it
};

// State 0 runs (0,0) (0,1) (1,1) (1,0), 1 is its mirror at the diagonal, 2 and 3 are these turned by half a turn.
// Index: state * 4 + x bit * 2 + y bit.
constexpr std::array<Step, 16> Steps{{
    {0, 1},
    {1, 0},
    {3, 3},
    {2, 0}, // (0,0) (0,1) (1,0) (1,1)
    {0, 0},
    {3, 2},
    {1, 1},
    {2, 1}, //
    {2, 2},
    {3, 1},
    {1, 2},
    {0, 3}, //
    {2, 3},
    {1, 3},
    {3, 0},
    {0, 2}, //
}};

/// Four levels at once. Index: state * 256 + 4 bits of x * 16 + 4 bits of y; the low 8 bits are the place along the
/// curve, above them is the state.
constexpr std::array<std::uint16_t, 1024> FourSteps = [] {
    std::array<std::uint16_t, 1024> table{};
    for (unsigned i = 0; i < table.size(); ++i) {
        unsigned state = i >> 8, place = 0;
        for (int bit = 3; bit >= 0; --bit) {
            const Step step = Steps[state * 4 + (i >> (4 + bit) & 1) * 2 + (i >> bit & 1)];
            place = place << 2 | step.quadrant;
            state = step.state;
        }
        table[i] = std::uint16_t(state << 8 | place);
    }
    return table;
}();

struct Key
{
    std::uint64_t index;
    std::uint32_t point;
};

/// By four digits of 11 bits from the top. Stable, but that points at one place become neighbours.
void radixSort(std::vector<Key> &keys, std::span<const Point3> points)
{
    constexpr int Bits = 11;
    std::vector<Key> sorted(keys.size());
    for (int shift = 64 - 4 * Bits; shift < 64; shift += Bits) {
        std::vector<std::uint32_t> starts((1 << Bits) + 1);
        for (const Key &key : keys)
            ++starts[(key.index >> shift & ((1 << Bits) - 1)) + 1];
        for (std::size_t d = 1; d < starts.size(); ++d)
            starts[d] += starts[d - 1];
        for (const Key &key : keys)
            sorted[starts[key.index >> shift & ((1 << Bits) - 1)]++] = key;
        keys.swap(sorted);
    }
    // What agrees in those 44 bits is rare, unless the points are heaped.
    for (std::size_t first = 0, last; first < keys.size(); first = last) {
        for (last = first + 1; last < keys.size() && keys[last].index >> 20 == keys[first].index >> 20;)
            ++last;
        if (last - first > 1)
            std::stable_sort(keys.begin() + std::ptrdiff_t(first), keys.begin() + std::ptrdiff_t(last),
                             [&](const Key &a, const Key &b) {
                                 const Point3 &p = points[a.point], &q = points[b.point];
                                 return std::tie(a.index, p.x, p.y) < std::tie(b.index, q.x, q.y);
                             });
    }
}

} // namespace

std::uint64_t hilbertIndex(std::uint32_t x, std::uint32_t y)
{
    std::uint64_t index = 0;
    unsigned state = 0;
    for (int shift = 28; shift >= 0; shift -= 4) {
        const unsigned step = FourSteps[state | (x >> shift & 15) << 4 | (y >> shift & 15)];
        index = index << 8 | (step & 255);
        state = step & ~255u;
    }
    return index;
}

std::vector<std::uint32_t> hilbertOrder(std::span<const Point3> points, const Rectangle &domain)
{
    const double size = std::max(domain.high.x - domain.low.x, domain.high.y - domain.low.y);
    const double scale = 4294967295.0 / size;
    std::vector<Key> keys(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        keys[i] = {hilbertIndex(std::uint32_t((points[i].x - domain.low.x) * scale),
                                std::uint32_t((points[i].y - domain.low.y) * scale)),
                   std::uint32_t(i)};
    radixSort(keys, points);
    std::vector<std::uint32_t> order(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i)
        order[i] = keys[i].point;
    return order;
}

} // namespace model::terrain
