// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/analysis/facelinks.h"

#include "model/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <mutex>

namespace model {

namespace {

/// A side on its way to the other sides of its edge: those of one smaller vertex lie together.
struct Candidate
{
    std::uint32_t larger, side;

    friend bool operator<(Candidate a, Candidate b)
    {
        return a.larger != b.larger ? a.larger < b.larger : a.side < b.side;
    }
};

struct Candidates
{
    std::vector<std::uint32_t> begins; ///< #V + 1
    std::vector<Candidate> list;
};

Candidates bySmallerVertex(const Faces &faces, std::vector<std::uint32_t> &across)
{
    Candidates result;
    result.begins.resize(std::size_t(faces.vertexCount()) + 2);
    const auto forEachSide = [&](const auto &visit) {
        for (std::uint32_t f = 0; f < faces.faceCount(); ++f) {
            const std::uint32_t begin = faces.begin(f), end = faces.end(f);
            for (std::uint32_t side = begin; side < end; ++side)
                visit(side, faces.vertex(side), faces.vertex(side + 1 == end ? begin : side + 1));
        }
    };
    forEachSide([&](std::uint32_t side, std::uint32_t a, std::uint32_t b) {
        if (a == b)
            across[side] = PointSide;
        else
            ++result.begins[std::min(a, b) + 2];
    });
    for (std::size_t v = 2; v < result.begins.size(); ++v)
        result.begins[v] += result.begins[v - 1];
    result.list.resize(result.begins.back());
    forEachSide([&](std::uint32_t side, std::uint32_t a, std::uint32_t b) {
        if (a != b)
            result.list[result.begins[std::min(a, b) + 1]++] = {std::max(a, b), side};
    });
    return result;
}

} // namespace

FaceLinks::FaceLinks(const Faces &faces)
    : mFaces(faces)
    , mAcross(faces.cornerCount(), BorderSide)
{
    Candidates candidates = bySmallerVertex(faces, mAcross);
    std::mutex mutex;
    std::atomic<std::uint32_t> edgeCount = 0;
    constexpr std::size_t Grain = 1 << 14; // vertices
    parallelRanges(faces.vertexCount(), Grain, [&](std::size_t first, std::size_t last) {
        std::uint32_t edges = 0;
        for (std::size_t v = first; v < last; ++v) {
            const std::span bucket =
                std::span(candidates.list)
                    .subspan(candidates.begins[v], candidates.begins[v + 1] - candidates.begins[v]);
            std::sort(bucket.begin(), bucket.end());
            for (std::size_t begin = 0, end = 0; begin < bucket.size(); begin = end) {
                while (end < bucket.size() && bucket[end].larger == bucket[begin].larger)
                    ++end;
                ++edges;
                if (end - begin == 2) {
                    mAcross[bucket[begin].side] = bucket[begin + 1].side;
                    mAcross[bucket[begin + 1].side] = bucket[begin].side;
                } else if (end - begin > 2) {
                    CrowdedEdge crowded{{std::uint32_t(v), bucket[begin].larger}, {}};
                    for (const Candidate &candidate : bucket.subspan(begin, end - begin)) {
                        mAcross[candidate.side] = CrowdedSide;
                        crowded.sides.push_back(candidate.side);
                    }
                    const std::lock_guard lock(mutex);
                    mCrowded.push_back(std::move(crowded));
                }
            }
        }
        edgeCount += edges;
    });
    mEdgeCount = edgeCount;
    std::sort(mCrowded.begin(), mCrowded.end(),
              [](const CrowdedEdge &a, const CrowdedEdge &b) { return a.edge < b.edge; });
}

Edge FaceLinks::edge(std::uint32_t side) const
{
    const std::uint32_t a = mFaces.vertex(side), b = mFaces.sideEnd(side);
    return {std::min(a, b), std::max(a, b)};
}

} // namespace model
