// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/tinwriter.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace model::terrain {

Corner cornerOfEdge(const TinArrays &tin, VertexId a, VertexId b)
{
    Corner found = NoCorner;
    forEachCornerAround(tin, a, [&](Corner c) {
        if (tin.vertex(next(c)) == b)
            found = previous(c);
        else if (found == NoCorner && tin.vertex(previous(c)) == b && tin.opposite(next(c)) == NoCorner)
            found = next(c);
    });
    return found;
}

VertexId TinWriter::addVertex(Point2 point, double height)
{
    VertexId v = tin.totals.freeVertex;
    if (v != NoFreeVertex) {
        if (mIsRecording) {
            mJournal.touchPoint(tin, v);
            mJournal.touchHeight(tin, v);
            mJournal.touchLinks(tin, v);
            if (tin.layerCount() > 0)
                mJournal.touchColumn(tin, v);
        }
        tin.totals.freeVertex = tin.corners[v] & ~FreeVertexBit;
    } else {
        v = tin.vertexSlots();
        tin.resizeVertices(std::size_t(v) + 1);
    }
    tin.points[v] = point;
    tin.heights[v] = height;
    tin.corners[v] = NoCorner;
    tin.constraints[v] = None;
    for (std::size_t i = tin.layerSlot(v, 0); i < tin.layerSlot(v + 1, 0); ++i) {
        tin.thicknesses[i] = 0;
        tin.humidities[i] = 0;
    }
    ++tin.totals.vertices;
    return v;
}

void TinWriter::freeVertex(VertexId v)
{
    assert(tin.constraints[v] == None);
    touchLinks(v);
    tin.corners[v] = tin.totals.freeVertex | FreeVertexBit;
    tin.totals.freeVertex = v;
    --tin.totals.vertices;
}

TriangleId TinWriter::addTriangle(std::uint8_t flags)
{
    TriangleId t = tin.totals.freeTriangle;
    if (t != None) {
        touchTriangle(t);
        tin.totals.freeTriangle = tin.opposites[3 * std::size_t(t)];
    } else {
        t = tin.triangleSlots();
        tin.resizeTriangles(std::size_t(t) + 1);
    }
    tin.triangleFlags[t] = flags;
    ++tin.totals.triangles;
    return t;
}

void TinWriter::freeTriangle(TriangleId t)
{
    touchTriangle(t);
    for (std::size_t i = 3 * std::size_t(t); i < 3 * std::size_t(t) + 3; ++i) {
        tin.triangleVertices[i] = 0;
        tin.opposites[i] = BorderOpposite;
    }
    tin.opposites[3 * std::size_t(t)] = tin.totals.freeTriangle;
    tin.triangleFlags[t] = FreeTriangle;
    tin.totals.freeTriangle = t;
    --tin.totals.triangles;
}

void TinWriter::setTriangle(TriangleId t, VertexId a, VertexId b, VertexId c)
{
    touchTriangle(t);
    VertexId *const v = tin.triangleVertices.data() + 3 * std::size_t(t);
    v[0] = a;
    v[1] = b;
    v[2] = c;
}

void TinWriter::setConstrained(Corner c, bool isConstrained)
{
    const Corner o = tin.opposite(c);
    assert(o != NoCorner && "the border stays constrained");
    link(c, o | (isConstrained ? ConstrainedBit : 0));
}

void TinWriter::flip(Corner c)
{
    const Corner o = tin.opposite(c);
    assert(o != NoCorner && !tin.isConstrained(c));
    const VertexId a = tin.vertex(c), b = tin.vertex(next(c)), d = tin.vertex(previous(c)), e = tin.vertex(o);
    touchTriangle(triangleOf(c));
    touchTriangle(triangleOf(o));
    if (mIsRecording) {
        if (!tin.isVoid(triangleOf(c))) {
            const Point2 pa = tin.points[a], pb = tin.points[b], pd = tin.points[d], pe = tin.points[e];
            const double bx = pb.x - pa.x, by = pb.y - pa.y, bz = tin.heights[b] - tin.heights[a];
            const double dx = pd.x - pa.x, dy = pd.y - pa.y, dz = tin.heights[d] - tin.heights[a];
            const double ex = pe.x - pa.x, ey = pe.y - pa.y, ez = tin.heights[e] - tin.heights[a];
            // The two diagonals and the four sides bound a tetrahedron: it is what the surface gains.
            leak.add((bx * (ez * dy - ey * dz) + by * (ex * dz - ez * dx) + bz * (ey * dx - ex * dy)) / 6);
        }
        noteVertex(a);
        noteVertex(b);
        noteVertex(d);
        noteVertex(e);
    }
    // From a-b-d and e-d-b to a-b-e and e-d-a: c and o keep their vertices.
    const Corner outerBe = tin.opposites[slotOf(next(o))], outerDa = tin.opposites[slotOf(next(c))];
    tin.triangleVertices[slotOf(previous(c))] = e;
    tin.triangleVertices[slotOf(previous(o))] = a;
    link(c, outerBe);
    link(o, outerDa);
    tin.opposites[slotOf(next(c))] = next(o);
    tin.opposites[slotOf(next(o))] = next(c);
    if (tin.corners[b] == previous(o))
        setCornerOf(b, next(c));
    if (tin.corners[d] == previous(c))
        setCornerOf(d, next(o));
}

void TinWriter::splitTriangle(TriangleId t, VertexId v)
{
    const VertexId a = tin.vertex(cornerOf(t, 0)), b = tin.vertex(cornerOf(t, 1)), c = tin.vertex(cornerOf(t, 2));
    const Corner outerA = tin.opposites[slotOf(cornerOf(t, 0))], outerB = tin.opposites[slotOf(cornerOf(t, 1))],
                 outerC = tin.opposites[slotOf(cornerOf(t, 2))];
    const TriangleId u = addTriangle(tin.triangleFlags[t]), w = addTriangle(tin.triangleFlags[t]);
    loseVolume({t}, v);
    setTriangle(t, v, b, c);
    setTriangle(u, v, c, a);
    setTriangle(w, v, a, b);
    setCornerOf(v, cornerOf(t, 0));
    moveCorner(a, cornerOf(t, 0), cornerOf(u, 2));
    gainVolume({t, u, w}, v);
    link(cornerOf(t, 0), outerA);
    link(cornerOf(u, 0), outerB);
    link(cornerOf(w, 0), outerC);
    link(cornerOf(t, 1), cornerOf(u, 2));
    link(cornerOf(u, 1), cornerOf(w, 2));
    link(cornerOf(w, 1), cornerOf(t, 2));
    for (const VertexId corner : {v, a, b, c})
        noteVertex(corner);
    edges.assign({cornerOf(t, 0), cornerOf(u, 0), cornerOf(w, 0)});
}

void TinWriter::splitEdge(Corner c, VertexId v)
{
    const Corner o = tin.opposite(c);
    const Corner bit = tin.opposites[slotOf(c)] & ConstrainedBit;
    // a-b-d becomes v-d-a and v-a-b; beyond, e-d-b becomes v-b-e and v-e-d.
    const TriangleId t = triangleOf(c);
    const VertexId a = tin.vertex(c), b = tin.vertex(next(c)), d = tin.vertex(previous(c));
    const Corner outerDa = tin.opposites[slotOf(next(c))], outerAb = tin.opposites[slotOf(previous(c))];
    const TriangleId t2 = addTriangle(tin.triangleFlags[t]);
    if (o == NoCorner) {
        loseVolume({t}, v);
        const Corner cornerA = c, cornerB = next(c), cornerD = previous(c);
        setTriangle(t, v, d, a);
        setTriangle(t2, v, a, b);
        setCornerOf(v, cornerOf(t, 0));
        moveCorner(a, cornerA, cornerOf(t, 2));
        moveCorner(b, cornerB, cornerOf(t2, 2));
        moveCorner(d, cornerD, cornerOf(t, 1));
        gainVolume({t, t2}, v);
        link(cornerOf(t, 0), outerDa);
        link(cornerOf(t2, 0), outerAb);
        link(cornerOf(t, 1), cornerOf(t2, 2));
        link(cornerOf(t, 2), BorderOpposite);
        link(cornerOf(t2, 1), BorderOpposite);
        for (const VertexId corner : {v, a, b, d})
            noteVertex(corner);
        edges.assign({cornerOf(t, 0), cornerOf(t2, 0)});
        return;
    }
    const TriangleId u = triangleOf(o);
    const VertexId e = tin.vertex(o);
    const Corner outerBe = tin.opposites[slotOf(next(o))], outerEd = tin.opposites[slotOf(previous(o))];
    const TriangleId u2 = addTriangle(tin.triangleFlags[u]);
    loseVolume({t, u}, v);
    setTriangle(t, v, d, a);
    setTriangle(t2, v, a, b);
    setTriangle(u, v, b, e);
    setTriangle(u2, v, e, d);
    setCornerOf(v, cornerOf(t, 0));
    moveCorner(a, c, cornerOf(t, 2));
    moveCorner(b, next(c), cornerOf(t2, 2));
    moveCorner(d, previous(c), cornerOf(t, 1));
    moveCorner(e, o, cornerOf(u, 2));
    moveCorner(d, next(o), cornerOf(u2, 2));
    moveCorner(b, previous(o), cornerOf(u, 1));
    gainVolume({t, t2, u, u2}, v);
    link(cornerOf(t, 0), outerDa);
    link(cornerOf(t2, 0), outerAb);
    link(cornerOf(u, 0), outerBe);
    link(cornerOf(u2, 0), outerEd);
    link(cornerOf(t, 1), cornerOf(t2, 2));
    link(cornerOf(t2, 1), cornerOf(u, 2) | bit);
    link(cornerOf(u, 1), cornerOf(u2, 2));
    link(cornerOf(u2, 1), cornerOf(t, 2) | bit);
    for (const VertexId corner : {v, a, b, d, e})
        noteVertex(corner);
    edges.assign({cornerOf(t, 0), cornerOf(t2, 0), cornerOf(u, 0), cornerOf(u2, 0)});
}

void TinWriter::restoreDelaunayAround(VertexId v)
{
    const Point2 p = tin.points[v];
    while (!edges.empty()) {
        const Corner c = edges.back();
        const Corner o = tin.opposites[slotOf(c)];
        if (!(o & ConstrainedBit) &&
            isInsideCircle(tin.pointAt(o), tin.pointAt(next(o)), tin.pointAt(previous(o)), p)) {
            flip(c);
            edges.push_back(previous(o)); // where v is in the other triangle
        } else {
            edges.pop_back();
        }
    }
}

void TinWriter::restoreDelaunay()
{
    while (!edges.empty()) {
        const Corner c = edges.back();
        const Corner o = tin.opposites[slotOf(c)];
        if (!(o & ConstrainedBit) &&
            isInsideCircle(tin.pointAt(o), tin.pointAt(next(o)), tin.pointAt(previous(o)), tin.pointAt(c))) {
            flip(c);
            edges.insert(edges.end(), {previous(c), o, previous(o)});
        } else {
            edges.pop_back();
        }
    }
}

std::vector<VertexId> TinWriter::takeReconnected()
{
    for (const VertexId v : mReconnected)
        mJournal.forgetReconnected(v);
    std::vector<VertexId> taken = std::exchange(mReconnected, {});
    taken.erase(std::remove_if(taken.begin(), taken.end(), [this](VertexId v) { return !tin.isVertex(v); }),
                taken.end());
    std::sort(taken.begin(), taken.end());
    return taken;
}

void TinWriter::loseVolume(std::initializer_list<TriangleId> triangles, VertexId level)
{
    for (const TriangleId t : triangles)
        if (mIsRecording)
            leak.add(-volumeOf(t, tin.heights[level]));
}

void TinWriter::gainVolume(std::initializer_list<TriangleId> triangles, VertexId level)
{
    for (const TriangleId t : triangles)
        if (mIsRecording)
            leak.add(volumeOf(t, tin.heights[level]));
}

double TinWriter::volumeOf(TriangleId t, double level) const
{
    if (tin.isVoid(t))
        return 0;
    const VertexId *const v = tin.triangleVertices.data() + 3 * std::size_t(t);
    return areaOf(tin, t) * ((tin.heights[v[0]] - level) + (tin.heights[v[1]] - level) + (tin.heights[v[2]] - level)) /
           3;
}

} // namespace model::terrain
