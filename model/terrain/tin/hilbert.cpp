// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: J. Skilling, Programming the Hilbert curve, 2004, for the curve; the state table is worked out from it.
// Differs: four states and a table look-up for each of the 32 levels.
#include "model/terrain/tin/hilbert.h"

#include <algorithm>
#include <array>

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

struct Key
{
    std::uint64_t index;
    std::uint32_t point;
};

/// Stable, by four digits of 11 bits from the top.
void radixSort(std::vector<Key> &keys)
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
                             [](const Key &a, const Key &b) { return a.index < b.index; });
    }
}

} // namespace

std::uint64_t hilbertIndex(std::uint32_t x, std::uint32_t y)
{
    std::uint64_t index = 0;
    unsigned state = 0;
    for (int bit = 31; bit >= 0; --bit) {
        const Step step = Steps[state * 4 + (x >> bit & 1) * 2 + (y >> bit & 1)];
        index = index << 2 | step.quadrant;
        state = step.state;
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
    radixSort(keys);
    std::vector<std::uint32_t> order(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i)
        order[i] = keys[i].point;
    return order;
}

} // namespace model::terrain
