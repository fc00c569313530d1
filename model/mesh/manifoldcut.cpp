// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/manifoldcut.h"

#include "model/mesh/edgesides.h"
#include "model/mesh/manifoldlinks.h"

#include <atomic>

namespace model {

namespace {

enum class Side : std::uint8_t { Unknown, Kept, Flipped };

/// Links the sides of each edge in pairs. \returns whether a pair has the same direction: something must be flipped
bool linkSides(const Connectivity &connectivity, std::span<const std::uint32_t> vertices, std::vector<Corner> &links)
{
    std::atomic<bool> twisted = false;
    const auto link = [&](Corner a, Corner b) {
        links[a] = b;
        links[b] = a;
    };
    forEachEdge(connectivity, [&](std::span<const Corner> sides) {
        const auto isRising = [&](Corner c) {
            return vertices[CornerTable::next(c)] < vertices[CornerTable::previous(c)];
        };
        if (sides.size() == 2) {
            if (isRising(sides[0]) == isRising(sides[1]))
                twisted = true;
            link(sides[0], sides[1]);
        } else if (sides.size() > 2) {
            std::vector<Corner> rising, falling;
            for (const Corner c : sides)
                (isRising(c) ? rising : falling).push_back(c);
            for (std::size_t i = 0; i < std::min(rising.size(), falling.size()); ++i)
                link(rising[i], falling[i]);
        }
    });
    return twisted;
}

/// Chooses which triangles to flip so that all links join opposite directions; takes apart the links that cannot.
std::vector<Side> orient(std::span<const std::uint32_t> vertices, std::vector<Corner> &links)
{
    std::vector<Side> sides(vertices.size() / 3, Side::Unknown);
    std::vector<std::uint32_t> part;
    for (std::uint32_t start = 0; start < sides.size(); ++start) {
        if (sides[start] != Side::Unknown)
            continue;
        sides[start] = Side::Kept;
        part.assign(1, start);
        std::size_t flippedCount = 0;
        for (std::size_t i = 0; i < part.size(); ++i)
            for (Corner c = 3 * part[i]; c < 3 * part[i] + 3; ++c) {
                const Corner o = links[c];
                if (o == NoCorner)
                    continue;
                const bool twisted = vertices[CornerTable::next(c)] == vertices[CornerTable::next(o)];
                const Side wanted = (sides[part[i]] == Side::Flipped) != twisted ? Side::Flipped : Side::Kept;
                if (sides[o / 3] == Side::Unknown) {
                    sides[o / 3] = wanted;
                    flippedCount += wanted == Side::Flipped;
                    part.push_back(o / 3);
                } else if (sides[o / 3] != wanted) {
                    links[c] = links[o] = NoCorner;
                }
            }
        if (2 * flippedCount > part.size())
            for (const std::uint32_t t : part)
                sides[t] = sides[t] == Side::Flipped ? Side::Kept : Side::Flipped;
    }
    return sides;
}

/// Exchanges the second and third corner of the flipped triangles, in both tables.
std::vector<bool> flip(const std::vector<Side> &sides, std::vector<std::uint32_t> &vertices, std::vector<Corner> &links)
{
    std::vector<bool> flipped(sides.size());
    const auto moved = [&](Corner c) {
        return c == NoCorner || c % 3 == 0 || sides[c / 3] != Side::Flipped ? c : c % 3 == 1 ? c + 1 : c - 1;
    };
    for (std::uint32_t t = 0; t < sides.size(); ++t) {
        if (sides[t] != Side::Flipped)
            continue;
        flipped[t] = true;
        std::swap(vertices[3 * t + 1], vertices[3 * t + 2]);
        std::swap(links[3 * t + 1], links[3 * t + 2]);
    }
    for (Corner &link : links)
        link = moved(link);
    return flipped;
}

/// The corners of one fan, from any of them on. \returns their number
template <class Take>
std::uint32_t walkFan(const std::vector<Corner> &links, Corner first, Take &&take)
{
    std::uint32_t count = 1;
    take(first);
    Corner c = first;
    for (;;) { // counter-clockwise, round or to a border
        const Corner across = links[CornerTable::next(c)];
        if (across == NoCorner)
            break;
        c = CornerTable::next(across);
        if (c == first)
            return count;
        ++count;
        take(c);
    }
    for (c = first;;) { // and from the first one clockwise
        const Corner across = links[CornerTable::previous(c)];
        if (across == NoCorner)
            return count;
        c = CornerTable::previous(across);
        ++count;
        take(c);
    }
}

/// The vertices with more than one fan.
std::vector<bool> verticesOfManyFans(std::uint32_t vertexCount, const std::vector<std::uint32_t> &vertices,
                                     const std::vector<Corner> &links)
{
    std::vector<Corner> anyCorner(vertexCount, NoCorner);
    std::vector<std::uint32_t> cornerCount(vertexCount);
    for (Corner c = 0; c < vertices.size(); ++c) {
        anyCorner[vertices[c]] = c;
        ++cornerCount[vertices[c]];
    }
    constexpr std::size_t Grain = 1 << 14; // vertices
    std::vector<bool> result(vertexCount);
    parallelRanges(vertexCount, Grain, [&](std::size_t first, std::size_t last) {
        for (std::size_t v = first; v < last; ++v)
            if (anyCorner[v] != NoCorner)
                cornerCount[v] -= walkFan(links, anyCorner[v], [](Corner) {});
    });
    for (std::size_t v = 0; v < vertexCount; ++v)
        result[v] = cornerCount[v] > 0;
    return result;
}

/// Gives each fan of a vertex but the first a copy of it. \returns what each copy is a copy of
std::vector<std::uint32_t> copyVertices(std::uint32_t vertexCount, std::vector<std::uint32_t> &vertices,
                                        const std::vector<Corner> &links)
{
    std::vector<bool> hasMany = verticesOfManyFans(vertexCount, vertices, links);
    std::vector<std::uint32_t> copied;
    if (std::find(hasMany.begin(), hasMany.end(), true) == hasMany.end())
        return copied;
    std::vector<bool> isFirst = hasMany;
    std::vector<bool> seen(vertices.size());
    for (Corner c = 0; c < vertices.size(); ++c) {
        const std::uint32_t vertex = vertices[c];
        if (seen[c] || !hasMany[vertex])
            continue;
        std::uint32_t name = vertex;
        if (!isFirst[vertex]) {
            name = vertexCount + std::uint32_t(copied.size());
            copied.push_back(vertex);
        }
        isFirst[vertex] = false;
        walkFan(links, c, [&](Corner other) {
            seen[other] = true;
            vertices[other] = name;
        });
    }
    return copied;
}

} // namespace

ManifoldCut cutIntoManifold(const Connectivity &connectivity)
{
    ManifoldCut cut;
    cut.inputVertexCount = connectivity.vertexCount;
    std::vector<std::uint32_t> vertices(3 * connectivity.triangles.size());
    for (std::size_t t = 0; t < connectivity.triangles.size(); ++t)
        std::copy_n(connectivity.triangles[t].begin(), 3, vertices.begin() + std::ptrdiff_t(3 * t));
    std::vector<Corner> links;
    bool mayHaveManyFans = true;
    if (std::optional<ManifoldLinks> clean = manifoldLinks(connectivity)) {
        links = std::move(clean->opposites);
        mayHaveManyFans = clean->hasManyFans;
    } else {
        links.assign(vertices.size(), NoCorner);
        if (linkSides(connectivity, vertices, links)) {
            const std::vector<Side> sides = orient(vertices, links);
            if (std::find(sides.begin(), sides.end(), Side::Flipped) != sides.end())
                cut.flipped = flip(sides, vertices, links);
        }
    }
    if (mayHaveManyFans)
        cut.copied = copyVertices(connectivity.vertexCount, vertices, links);
    cut.corners =
        CornerTable(connectivity.vertexCount + std::uint32_t(cut.copied.size()), std::move(vertices), std::move(links));
    return cut;
}

} // namespace model
