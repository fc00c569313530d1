// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/tin.h"

#include "model/base/digest.h"
#include "model/base/parallel.h"
#include "model/terrain/tin/constraints/constraintlists.h"
#include "model/terrain/tin/tinwriter.h"

#include <algorithm>
#include <cassert>
#include <vector>

namespace model::terrain {

namespace {

/// The volume between the plane at 0 and what is `height(v)` above it at each vertex.
template <class Height>
double volumeUnder(const TinArrays &tin, Height height)
{
    // Blocks that do not depend on the number of threads: nor does the sum.
    constexpr std::size_t Block = 1 << 18;
    const std::size_t slots = tin.triangleSlots();
    std::vector<CompensatedSum> sums((slots + Block - 1) / Block);
    parallelFor(sums.size(), [&](std::size_t i) {
        CompensatedSum sum;
        for (std::size_t t = i * Block, end = std::min(t + Block, slots); t < end; ++t) {
            if (tin.triangleFlags[t] & (FreeTriangle | VoidTriangle))
                continue;
            const VertexId *const v = tin.triangleVertices.data() + 3 * t;
            sum.add(areaOf(tin, TriangleId(t)) * (height(v[0]) + height(v[1]) + height(v[2])));
        }
        sums[i] = sum;
    });
    CompensatedSum total;
    for (const CompensatedSum &sum : sums) {
        total.add(sum.sum);
        total.add(sum.lost);
    }
    return total.value() / 3;
}

} // namespace

Tin::Tin(const Rectangle &domain)
    : mDomain(domain)
{
    assert(domain.low.x < domain.high.x && domain.low.y < domain.high.y);
    TinWriter writer(mArrays, mJournal);
    for (const Point2 corner :
         {domain.low, Point2{domain.high.x, domain.low.y}, domain.high, Point2{domain.low.x, domain.high.y}})
        writer.addVertex(corner, 0);
    const TriangleId t = writer.addTriangle(0), u = writer.addTriangle(0);
    writer.setTriangle(t, 0, 1, 2);
    writer.setTriangle(u, 0, 2, 3);
    for (VertexId v = 0; v < 4; ++v)
        writer.setCornerOf(v, v == 3 ? cornerOf(u, 2) : cornerOf(t, v));
    writer.link(cornerOf(t, 0), BorderOpposite);
    writer.link(cornerOf(t, 2), BorderOpposite);
    writer.link(cornerOf(u, 0), BorderOpposite);
    writer.link(cornerOf(u, 1), BorderOpposite);
    writer.link(cornerOf(t, 1), cornerOf(u, 2));
    writer.edges = {cornerOf(t, 1)};
    writer.restoreDelaunay();
    mHints.build(mArrays, mDomain);
}

Location Tin::locate(Point2 p, VertexId near) const
{
    assert(mDomain.contains(p));
    return terrain::locate(mArrays, p, near == None ? mHints.near(mArrays, p) : near);
}

TriangleId Tin::triangleAt(Point2 p, VertexId near) const
{
    return triangleOf(locate(p, near).corner);
}

double Tin::heightAt(Point2 p, VertexId near) const
{
    const Location location = locate(p, near);
    if (location.kind == Location::Kind::Vertex)
        return mArrays.heights[mArrays.vertex(location.corner)];
    if (location.kind == Location::Kind::Edge)
        return heightOn(mArrays, location.corner, p);
    return heightIn(mArrays, triangleOf(location.corner), p);
}

Gradient Tin::gradientAt(Point2 p, VertexId near) const
{
    return gradientOf(mArrays, triangleAt(p, near));
}

bool Tin::isConstrained(VertexId a, VertexId b) const
{
    const Corner c = cornerOfEdge(mArrays, a, b);
    return c != NoCorner && mArrays.isConstrained(c);
}

std::vector<OwnerId> Tin::ownersOf(VertexId a, VertexId b) const
{
    return terrain::ownersOf(mArrays, a, b);
}

double Tin::volume() const
{
    return volumeUnder(mArrays, [this](VertexId v) { return mArrays.heights[v]; });
}

double Tin::layerVolume(std::uint32_t layer) const
{
    return volumeUnder(mArrays, [=, this](VertexId v) { return mArrays.thicknesses[mArrays.layerSlot(v, layer)]; });
}

void Tin::swap(Edit &edit)
{
    assert(!mJournal.isRecording());
    Journal::swap(mArrays, edit);
    Journal::forEachLinkedVertex(edit, [&](VertexId v) {
        if (mArrays.isVertex(v))
            mHints.note(v, mArrays.points[v]);
    });
}

std::uint64_t Tin::fingerprint() const
{
    std::uint64_t digest = digestOfArray(std::span(&mDomain, 1));
    digest = digestOfArray(mArrays.points.values(), digest);
    digest = digestOfArray(mArrays.heights.values(), digest);
    digest = digestOfArray(mArrays.corners.values(), digest);
    digest = digestOfArray(mArrays.constraints.values(), digest);
    digest = digestOfArray(mArrays.thicknesses.values(), digest);
    digest = digestOfArray(mArrays.humidities.values(), digest);
    digest = digestOfArray(mArrays.triangleVertices.values(), digest);
    digest = digestOfArray(mArrays.opposites.values(), digest);
    digest = digestOfArray(mArrays.triangleFlags.values(), digest);
    digest = digestOfArray(mArrays.records.values(), digest);
    return digestOfArray(std::span(&mArrays.totals, 1), digest);
}

std::size_t Tin::byteSize() const
{
    return sizeof(Tin) + mArrays.byteSize() + mHints.byteSize() + mJournal.byteSize();
}

} // namespace model::terrain
