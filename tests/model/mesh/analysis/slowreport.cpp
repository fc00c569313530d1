// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/mesh/analysis/slowreport.h"

#include <algorithm>
#include <functional>

namespace tests {

namespace {

using Edge = std::array<std::uint32_t, 2>;

/// The classes of 0..count-1 under what `joined` joins, by repeated search.
std::vector<std::set<std::uint32_t>> classes(std::uint32_t count,
                                             const std::function<bool(std::uint32_t, std::uint32_t)> &joined)
{
    std::vector<std::set<std::uint32_t>> result;
    std::vector<bool> seen(count);
    for (std::uint32_t start = 0; start < count; ++start) {
        if (seen[start])
            continue;
        std::set<std::uint32_t> &members = result.emplace_back();
        std::vector<std::uint32_t> left{start};
        seen[start] = true;
        while (!left.empty()) {
            const std::uint32_t at = left.back();
            left.pop_back();
            members.insert(at);
            for (std::uint32_t other = 0; other < count; ++other)
                if (!seen[other] && joined(at, other)) {
                    seen[other] = true;
                    left.push_back(other);
                }
        }
    }
    return result;
}

std::vector<Edge> sidesOf(std::span<const std::uint32_t> face)
{
    std::vector<Edge> sides;
    for (std::size_t i = 0; i < face.size(); ++i)
        if (face[i] != face[(i + 1) % face.size()])
            sides.push_back({face[i], face[(i + 1) % face.size()]});
    return sides;
}

Edge sorted(Edge e)
{
    return {std::min(e[0], e[1]), std::max(e[0], e[1])};
}

bool shareEdge(const std::vector<Edge> &a, const std::vector<Edge> &b, std::uint32_t at = ~0u)
{
    for (const Edge &s : a)
        for (const Edge &t : b)
            if (s == t && (at == ~0u || s[0] == at || s[1] == at))
                return true;
    return false;
}

/// Whether signs can be given to the faces so that all edges of two sides are run along both ways: tried by spreading
/// from one face.
bool isOrientable(const model::Faces &faces, const std::set<std::uint32_t> &members,
                  const std::map<Edge, std::vector<std::pair<std::uint32_t, bool>>> &runs)
{
    std::map<std::uint32_t, bool> turned;
    for (const std::uint32_t start : members) {
        if (!turned.emplace(start, false).second)
            continue;
        for (bool changed = true; changed;) {
            changed = false;
            for (const auto &[edge, sides] : runs) {
                if (sides.size() != 2 || !members.contains(sides[0].first))
                    continue;
                for (int i = 0; i < 2; ++i) {
                    const auto &[from, fromWay] = sides[std::size_t(i)];
                    const auto &[to, toWay] = sides[std::size_t(1 - i)];
                    const auto known = turned.find(from);
                    if (known == turned.end())
                        continue;
                    const bool wanted = known->second ^ (fromWay == toWay);
                    const auto [at, isNew] = turned.emplace(to, wanted);
                    changed |= isNew;
                    if (at->second != wanted)
                        return false;
                }
            }
        }
    }
    return faces.faceCount() > 0;
}

} // namespace

SlowReport slowReport(const model::Faces &faces)
{
    SlowReport report;
    std::map<Edge, std::vector<std::pair<std::uint32_t, bool>>> runs;
    std::map<std::multiset<Edge>, int> shapes;
    std::set<std::uint32_t> used;
    std::vector<std::vector<Edge>> edgesOf(faces.faceCount());
    for (std::uint32_t f = 0; f < faces.faceCount(); ++f) {
        const auto face = faces.face(f);
        std::multiset<Edge> shape;
        for (const Edge &side : sidesOf(face)) {
            runs[sorted(side)].push_back({f, side[0] < side[1]});
            report.sidesOf[sorted(side)].push_back(f);
            shape.insert(sorted(side));
            edgesOf[f].push_back(sorted(side));
        }
        if (face.size() == 3 && !shape.empty() && shapes[shape]++ > 0)
            ++report.duplicates;
        used.insert(face.begin(), face.end());
        if (face.size() < 3 || std::set(face.begin(), face.end()).size() < face.size())
            report.degenerate.insert(f);
    }
    for (const auto &[edge, sides] : runs) {
        if (sides.size() > 2)
            report.crowded.insert(edge);
        if (sides.size() == 2 && sides[0].second == sides[1].second)
            report.inconsistent.insert(edge);
    }
    for (const auto &members : classes(
             faces.faceCount(), [&](std::uint32_t a, std::uint32_t b) { return shareEdge(edgesOf[a], edgesOf[b]); })) {
        SlowReport::Component &component = report.components.emplace_back();
        component.faces = members;
        for (const std::uint32_t f : members) {
            component.vertices.insert(faces.face(f).begin(), faces.face(f).end());
            for (const Edge &side : sidesOf(faces.face(f))) {
                component.edges.insert(sorted(side));
                if (runs[sorted(side)].size() == 1)
                    component.borderEdges.insert(sorted(side));
                component.isManifold &= runs[sorted(side)].size() <= 2;
            }
            component.isManifold &= !report.degenerate.contains(f);
        }
        component.isOrientable = isOrientable(faces, members, runs);
    }
    for (std::uint32_t v = 0; v < faces.vertexCount(); ++v) {
        if (!used.contains(v)) {
            report.isolated.insert(v);
            continue;
        }
        std::vector<std::uint32_t> around;
        for (std::uint32_t f = 0; f < faces.faceCount(); ++f)
            if (std::ranges::find(faces.face(f), v) != faces.face(f).end())
                around.push_back(f);
        const auto fans = classes(std::uint32_t(around.size()), [&](std::uint32_t a, std::uint32_t b) {
            return shareEdge(edgesOf[around[a]], edgesOf[around[b]], v);
        });
        if (fans.size() > 1)
            report.manyFans.insert(v);
        for (SlowReport::Component &component : report.components) {
            const auto here = std::count_if(fans.begin(), fans.end(), [&](const std::set<std::uint32_t> &fan) {
                return component.faces.contains(around[*fan.begin()]);
            });
            component.isManifold &= here <= 1;
        }
    }
    return report;
}

} // namespace tests
