// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/analysis/vertexfans.h"

#include "model/base/parallel.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <numeric>

namespace model {

namespace {

/// The corners that a walk over linked sides meets, in both directions from one.
std::uint32_t fanSize(const FaceLinks &links, std::uint32_t start)
{
    std::uint32_t size = 1;
    FaceLinks::Step at{start, start};
    while (links.isLinked(at.side)) {
        at = links.aroundVertex(at);
        if (at.corner == start)
            return size;
        ++size;
    }
    at = {start, links.faces().previous(start)};
    while (links.isLinked(at.side)) {
        at = links.aroundVertex(at);
        ++size;
    }
    return size;
}

/// The fans of one vertex.
/// \param corners  all of it, ascending
std::vector<std::vector<std::uint32_t>> fansOf(const FaceLinks &links, const std::vector<std::uint32_t> &corners)
{
    const Faces &faces = links.faces();
    std::vector<std::size_t> root(corners.size());
    std::iota(root.begin(), root.end(), std::size_t(0));
    const auto rootOf = [&](std::size_t i) {
        while (root[i] != i)
            i = root[i] = root[root[i]];
        return i;
    };
    const auto join = [&](std::size_t a, std::size_t b) {
        root[std::max(rootOf(a), rootOf(b))] = std::min(rootOf(a), rootOf(b));
    };
    std::map<Edge, std::size_t> crowded;
    for (std::size_t i = 1; i < corners.size(); ++i)
        if (faces.faceOf(corners[i]) == faces.faceOf(corners[i - 1])) // a degenerate face
            join(i, i - 1);
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (const std::uint32_t side : {corners[i], faces.previous(corners[i])}) {
            if (links.isLinked(side)) {
                const std::uint32_t other = links.aroundVertex({corners[i], side}).corner;
                join(i, std::size_t(std::lower_bound(corners.begin(), corners.end(), other) - corners.begin()));
            } else if (links.across(side) == CrowdedSide) {
                join(i, crowded.emplace(links.edge(side), i).first->second);
            }
        }
    std::vector<std::vector<std::uint32_t>> fans(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
        fans[rootOf(i)].push_back(corners[i]);
    std::erase_if(fans, [](const auto &fan) { return fan.empty(); });
    return fans;
}

} // namespace

VertexFans findFans(const FaceLinks &links)
{
    const Faces &faces = links.faces();
    VertexFans result;
    result.cornerAt.assign(faces.vertexCount(), NoFaceCorner);
    std::vector<std::uint32_t> count(faces.vertexCount());
    for (std::uint32_t corner = 0; corner < faces.cornerCount(); ++corner) {
        result.cornerAt[faces.vertex(corner)] = corner;
        ++count[faces.vertex(corner)];
    }

    // One walk tells where it does not meet all corners; only there they are looked at one by one.
    std::vector<std::uint32_t> doubtful;
    std::mutex mutex;
    constexpr std::size_t Grain = 1 << 14; // vertices
    parallelRanges(faces.vertexCount(), Grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v)
            if (count[v] > 1 && fanSize(links, result.cornerAt[v]) != count[v]) {
                const std::lock_guard lock(mutex);
                doubtful.push_back(std::uint32_t(v));
            }
    });
    if (doubtful.empty())
        return result;
    std::sort(doubtful.begin(), doubtful.end());
    std::vector<std::vector<std::uint32_t>> corners(doubtful.size());
    std::vector<std::uint32_t> &place = count; // 1 + index into doubtful
    std::fill(place.begin(), place.end(), 0u);
    for (std::uint32_t i = 0; i < doubtful.size(); ++i)
        place[doubtful[i]] = i + 1;
    for (std::uint32_t corner = 0; corner < faces.cornerCount(); ++corner)
        if (const std::uint32_t at = place[faces.vertex(corner)])
            corners[at - 1].push_back(corner);
    for (std::uint32_t i = 0; i < doubtful.size(); ++i)
        if (auto fans = fansOf(links, corners[i]); fans.size() > 1)
            result.splits.push_back({doubtful[i], std::move(fans)});
    return result;
}

} // namespace model
