// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/analysis/closedsurface.h"

#include <numeric>

namespace model {

namespace {
constexpr std::uint32_t None = ~std::uint32_t(0);
}

SurfaceCutter::SurfaceCutter(const FaceLinks &links, const MeshParts &parts)
    : mLinks(links)
    , mParts(parts)
    , mFacesByComponent(links.faces().faceCount())
    , mBegins(parts.componentCount() + 2)
    , mHalfEdge(links.faces().cornerCount())
    , mVertex(links.faces().vertexCount(), None)
{
    for (const std::uint32_t component : parts.componentOf)
        ++mBegins[component + 2];
    std::partial_sum(mBegins.begin(), mBegins.end(), mBegins.begin());
    for (std::uint32_t f = 0; f < parts.componentOf.size(); ++f)
        mFacesByComponent[mBegins[parts.componentOf[f] + 1]++] = f;
}

ClosedSurface SurfaceCutter::cut(std::uint32_t component, std::span<const Vec3f> positions)
{
    const Faces &faces = mLinks.faces();
    const auto members =
        std::span(mFacesByComponent).subspan(mBegins[component], mBegins[component + 1] - mBegins[component]);
    ClosedSurface surface;
    std::uint32_t count = 0;
    for (const std::uint32_t face : members)
        for (std::uint32_t corner = faces.begin(face); corner < faces.end(face); ++corner) {
            mHalfEdge[corner] = count++;
            std::uint32_t &vertex = mVertex[faces.vertex(corner)];
            if (vertex == None) {
                vertex = surface.vertexCount();
                surface.inputVertex.push_back(faces.vertex(corner));
            }
        }
    for (auto *list : {&surface.start, &surface.next, &surface.opposite, &surface.face})
        list->resize(count);
    std::vector<std::uint32_t> borders;
    for (const std::uint32_t face : members) {
        for (std::uint32_t corner = faces.begin(face); corner < faces.end(face); ++corner) {
            const std::uint32_t h = mHalfEdge[corner];
            const bool isTurned = mParts.isTurned[face];
            surface.start[h] = mVertex[isTurned ? faces.sideEnd(corner) : faces.vertex(corner)];
            surface.next[h] = mHalfEdge[isTurned ? faces.previous(corner) : faces.next(corner)];
            surface.face[h] = surface.faceCount;
            surface.opposite[h] = mLinks.isLinked(corner) ? mHalfEdge[mLinks.across(corner)] : None;
            if (surface.opposite[h] == None)
                borders.push_back(h);
        }
        ++surface.faceCount;
    }

    // Lids: a manifold has one border edge that ends at a vertex of its border.
    std::vector<std::uint32_t> lidFrom(borders.empty() ? 0 : surface.vertexCount(), None);
    for (const std::uint32_t border : borders) {
        const std::uint32_t lid = surface.halfEdgeCount();
        surface.start.push_back(surface.start[surface.next[border]]);
        surface.opposite.push_back(border);
        surface.opposite[border] = lid;
        surface.next.push_back(None);
        surface.face.push_back(None);
        lidFrom[surface.start[lid]] = lid;
    }
    for (std::uint32_t lid = count; lid < surface.halfEdgeCount(); ++lid)
        surface.next[lid] = lidFrom[surface.start[surface.opposite[lid]]];
    for (std::uint32_t lid = count; lid < surface.halfEdgeCount(); ++lid) {
        if (surface.face[lid] != None)
            continue;
        for (std::uint32_t at = lid; surface.face[at] == None; at = surface.next[at])
            surface.face[at] = surface.faceCount;
        ++surface.faceCount;
    }

    surface.length.resize(surface.halfEdgeCount());
    for (std::uint32_t h = 0; h < surface.halfEdgeCount(); ++h)
        surface.length[h] =
            length(positions[surface.inputVertex[surface.end(h)]] - positions[surface.inputVertex[surface.start[h]]]);
    for (const std::uint32_t vertex : surface.inputVertex)
        mVertex[vertex] = None;
    return surface;
}

} // namespace model
