// SPDX-License-Identifier: GPL-3.0-or-later
// Based on:
// - C. Loop: Smooth Subdivision Surfaces Based on Triangles, 1987
// - H. Hoppe, T. DeRose, T. Duchamp, M. Halstead, H. Jin, J. McDonald, J. Schweitzer, W. Stuetzle: Piecewise Smooth
//   Surface Reconstruction, 1994 (creases and borders)
// - G. Taubin: A Signal Processing Approach to Fair Surface Design, 1995
#include "model/mesh/editing/subdivide.h"

#include "model/base/parallel.h"
#include "model/geometry/vec3d.h"
#include "model/mesh/analysis/facelinks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace model {

namespace {

using Share = VertexSources::Share;

/// Triangles, their edges, and which of these are smooth: those between two triangles.
struct EdgeGraph
{
    explicit EdgeGraph(const Faces &triangles)
        : links(triangles)
        , edges(fans(triangles))
        , isSmooth(edges.edges().size())
    {
        for (std::uint32_t side = 0; side < triangles.cornerCount(); ++side)
            if (links.isLinked(side))
                isSmooth[edgeOf(links.edge(side))] = true;
    }
    /// Precondition: it is one.
    std::uint32_t edgeOf(Edge edge) const
    {
        const auto all = edges.edges();
        return std::uint32_t(std::lower_bound(all.begin(), all.end(), edge) - all.begin());
    }

    const FaceLinks links;
    const VertexEdges edges;
    std::vector<bool> isSmooth;
};

/// Where an old vertex goes to.
std::vector<Share> evenShares(const EdgeGraph &graph, std::uint32_t vertex)
{
    std::vector<std::uint32_t> sharp, all;
    for (const std::uint32_t edge : graph.edges.at(vertex)) {
        all.push_back(graph.edges.otherEnd(edge, vertex));
        if (!graph.isSmooth[edge])
            sharp.push_back(all.back());
    }
    if (all.empty() || (!sharp.empty() && sharp.size() != 2)) // a corner
        return {{vertex, 1}};
    if (sharp.size() == 2)
        return {{vertex, 0.75f}, {sharp[0], 0.125f}, {sharp[1], 0.125f}};
    const double n = double(all.size());
    const double c = 0.375 + std::cos(2 * std::numbers::pi / n) / 4;
    const double beta = (0.625 - c * c) / n;
    std::vector<Share> shares{{vertex, float(1 - n * beta)}};
    for (const std::uint32_t other : all)
        shares.push_back({other, float(beta)});
    return shares;
}

/// The vertex opposite to a side in its triangle.
std::uint32_t tip(const Faces &triangles, std::uint32_t side)
{
    return triangles.vertex(triangles.previous(side));
}

} // namespace

EditedMesh subdivide(const Faces &faces)
{
    std::vector<std::uint32_t> faceFrom;
    const Faces triangles(fans(faces, &faceFrom));
    const EdgeGraph graph(triangles);
    EditedMesh result;
    for (std::uint32_t v = 0; v < triangles.vertexCount(); ++v)
        result.vertices.addMean(evenShares(graph, v));

    std::vector<std::uint32_t> sideOf(graph.edges.edges().size(), BorderSide); // one of each edge
    for (std::uint32_t side = triangles.cornerCount(); side-- > 0;)
        if (graph.links.across(side) != PointSide)
            sideOf[graph.edgeOf(graph.links.edge(side))] = side;
    for (std::uint32_t edge = 0; edge < sideOf.size(); ++edge) {
        const auto [a, b] = graph.edges.edges()[edge];
        if (graph.isSmooth[edge])
            result.vertices.addMean(std::array<Share, 4>{
                Share{a, 0.375f},
                {b, 0.375f},
                {tip(triangles, sideOf[edge]), 0.125f},
                {tip(triangles, graph.links.across(sideOf[edge])), 0.125f},
            });
        else
            result.vertices.addMean(std::array{Share{a, 0.5f}, Share{b, 0.5f}});
    }
    result.faces = Faces(result.vertices.count());
    for (std::uint32_t t = 0; t < triangles.faceCount(); ++t) {
        std::array<std::uint32_t, 3> middle{};
        const auto corners = triangles.face(t);
        for (std::uint32_t i = 0; i < 3; ++i) {
            const std::uint32_t side = 3 * t + i; // a side from a vertex to itself has that vertex in its middle
            middle[i] = graph.links.across(side) == PointSide
                            ? corners[i]
                            : triangles.vertexCount() + graph.edgeOf(graph.links.edge(side));
        }
        result.faces.add(middle);
        for (std::uint32_t i = 0; i < 3; ++i)
            result.faces.add(std::array{corners[i], middle[i], middle[(i + 2) % 3]});
        result.faceFrom.insert(result.faceFrom.end(), 4, faceFrom[t]);
    }
    return result;
}

std::vector<Vec3f> smooth(const Faces &faces, std::span<const Vec3f> positions, const Smoothing &smoothing)
{
    // One step inwards, one a little further outwards: Taubin's pass band of 0.1.
    constexpr double Inwards = 0.5, Outwards = -0.526;
    const VertexEdges edges(fans(faces));
    std::vector<bool> stays(faces.vertexCount());
    if (smoothing.keepBorders) {
        const FaceLinks links(faces);
        for (std::uint32_t side = 0; side < faces.cornerCount(); ++side)
            if (links.isBorder(side))
                stays[faces.vertex(side)] = stays[faces.sideEnd(side)] = true;
    }
    std::vector<Vec3d> now(positions.begin(), positions.end()), next = now;
    const auto step = [&](double factor) {
        constexpr std::size_t Grain = 1 << 12; // vertices
        parallelRanges(now.size(), Grain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v) {
                const auto around = edges.at(std::uint32_t(v));
                if (stays[v] || around.empty())
                    continue;
                Vec3d sum;
                for (const std::uint32_t edge : around)
                    sum = sum + now[edges.otherEnd(edge, std::uint32_t(v))];
                next[v] = now[v] + (sum * (1.0 / double(around.size())) - now[v]) * factor;
            }
        });
        now.swap(next);
    };
    for (unsigned round = 0; round < smoothing.rounds; ++round) {
        step(Inwards);
        step(Outwards);
    }
    std::vector<Vec3f> result;
    result.reserve(now.size());
    for (const Vec3d &p : now)
        result.push_back({float(p.x), float(p.y), float(p.z)});
    return result;
}

} // namespace model
