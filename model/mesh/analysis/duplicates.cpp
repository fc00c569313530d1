// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/analysis/duplicates.h"

#include <algorithm>
#include <map>

namespace model {

namespace {

/// A twin has all edges of the face: none is a border, and those of two sides all lead to it.
bool mayHaveTwin(const FaceLinks &links, std::uint32_t face)
{
    const Faces &faces = links.faces();
    std::uint32_t twin = NoId;
    for (std::uint32_t side = faces.begin(face); side < faces.end(face); ++side) {
        if (links.isBorder(side))
            return false;
        if (!links.isLinked(side))
            continue;
        const std::uint32_t neighbour = faces.faceOf(links.across(side));
        if (neighbour == face) // a face of two corners, or folded onto itself
            continue;
        if (twin != NoId && twin != neighbour)
            return false;
        twin = neighbour;
    }
    return true;
}

/// The same for all ways to write a face: from its smallest corner on, in the direction that comes first.
std::vector<std::uint32_t> canonical(std::span<const std::uint32_t> face)
{
    std::vector<std::uint32_t> best, turned;
    for (std::size_t start = 0; start < face.size(); ++start)
        for (const std::size_t step : {std::size_t(1), face.size() - 1}) {
            turned.clear();
            for (std::size_t i = 0; i < face.size(); ++i)
                turned.push_back(face[(start + i * step) % face.size()]);
            if (best.empty() || turned < best)
                best = turned;
        }
    return best;
}

} // namespace

std::vector<ProblemIds> findDuplicateFaces(const FaceLinks &links)
{
    std::vector<ProblemIds> duplicates;
    std::map<std::vector<std::uint32_t>, std::uint32_t> first;
    for (std::uint32_t f = 0; f < links.faces().faceCount(); ++f) {
        if (!mayHaveTwin(links, f))
            continue;
        const auto [at, isNew] = first.emplace(canonical(links.faces().face(f)), f);
        if (!isNew)
            duplicates.push_back({f, at->second});
    }
    return duplicates;
}

} // namespace model
