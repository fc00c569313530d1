// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: O. Devillers, S. Pion, M. Teillaud, Walking in a Triangulation, 2002: the stochastic walk, which ends in
// any triangulation.
#include "model/terrain/tin/journal/earlier.h"

#include "model/terrain/tin/predicates.h"

#include <algorithm>
#include <cmath>

namespace model::terrain {

void EarlierSurface::note(const Edit &edit)
{
    // What an earlier edit wrote over is older.
    for (const auto &saved : edit.mPoints)
        if (saved.slot < mSlots.vertices)
            mPoints.emplace(saved.slot, saved.value);
    for (const auto &saved : edit.mHeights)
        if (saved.slot < mSlots.vertices)
            mHeights.emplace(saved.slot, saved.value);
    for (const auto &saved : edit.mTriangles)
        if (saved.slot < mSlots.triangles) {
            const auto &[v, o, flags] = saved.value;
            mTriangles.emplace(saved.slot, Triangle{{v[0], v[1], v[2]}, {o[0], o[1], o[2]}, flags});
        }
}

EarlierSurface::Triangle EarlierSurface::triangle(TriangleId t) const
{
    if (const Triangle *const earlier = mTriangles.find(t))
        return *earlier;
    const TinArrays &tin = mTin->arrays();
    const VertexId *const v = tin.triangleVertices.data() + 3 * std::size_t(t);
    const Corner *const o = tin.opposites.data() + 3 * std::size_t(t);
    return {{v[0], v[1], v[2]}, {o[0], o[1], o[2]}, tin.triangleFlags[t]};
}

Point2 EarlierSurface::point(VertexId v) const
{
    const Point2 *const earlier = mPoints.find(v);
    return earlier ? *earlier : mTin->arrays().points[v];
}

double EarlierSurface::height(VertexId v) const
{
    const double *const earlier = mHeights.find(v);
    return earlier ? *earlier : mTin->arrays().heights[v];
}

/// A triangle that held `p`: any of them, if it lay on an edge or a vertex.
TriangleId EarlierSurface::find(Point2 p) const
{
    const auto was = [&](TriangleId t) { return t < mSlots.triangles && !(triangle(t).flags & FreeTriangle); };
    const TinArrays &tin = mTin->arrays();
    TriangleId t = mTin->triangleAt(p);
    for (Corner c = cornerOf(t, 0), last = cornerOf(t, 2); !was(t) && c <= last; ++c)
        if (const Corner o = tin.opposite(c); o != NoCorner && was(triangleOf(o)))
            t = triangleOf(o);
    if (!was(t))
        t = mLast != None ? mLast : 0;
    while (!was(t))
        ++t;
    std::uint32_t random = 1;
    for (bool isFound = false; !isFound;) {
        const Triangle here = triangle(t);
        const Point2 corners[] = {point(here.vertices[0]), point(here.vertices[1]), point(here.vertices[2])};
        random = random * 1664525 + 1013904223;
        isFound = true;
        for (std::uint32_t k = 0; k < 3 && isFound; ++k) {
            const std::uint32_t i = ((random >> 16) + k) % 3;
            if (orientation(corners[(i + 1) % 3], corners[(i + 2) % 3], p) < 0) {
                t = triangleOf(here.opposites[i] & ~ConstrainedBit);
                isFound = false;
            }
        }
    }
    return mLast = t;
}

/// The triangle at `p`, as locate() has chosen it then, alone in `sample`.
Location EarlierSurface::sampleAt(Point2 p, TinArrays &sample) const
{
    sample.resizeVertices(3);
    sample.resizeTriangles(1);
    sample.triangleFlags[0] = 0;
    TriangleId t = find(p);
    const auto take = [&] {
        const Triangle here = triangle(t);
        for (std::uint32_t i = 0; i < 3; ++i) {
            sample.points[i] = point(here.vertices[i]);
            sample.heights[i] = height(here.vertices[i]);
            sample.triangleVertices[i] = i;
            sample.corners[i] = i;
            sample.opposites[i] = BorderOpposite;
        }
        return here;
    };
    const Triangle here = take();
    Location location = locationIn(sample, p, 0);
    if (location.kind == Location::Kind::Edge) {
        const Corner o = here.opposites[location.corner] & ~ConstrainedBit;
        if (o < cornerOf(t, location.corner)) { // the side with the smaller number
            t = triangleOf(o);
            take();
            location.corner = o & 3;
        }
    } else if (location.kind == Location::Kind::Vertex) { // of the triangles around it that with the smallest number
        std::uint32_t i = 0;
        while (!(sample.points[i] == p))
            ++i;
        const TriangleId first = t;
        TriangleId smallest = t;
        for (const std::uint32_t side : {1u, 2u}) {
            Corner c = cornerOf(first, i);
            for (;;) {
                const Corner across = triangle(triangleOf(c)).opposites[((c & 3) + side) % 3] & ~ConstrainedBit;
                c = side == 1 ? next(across) : previous(across);
                if (across == NoCorner || triangleOf(c) == first)
                    break;
                smallest = std::min(smallest, triangleOf(c));
            }
        }
        t = smallest;
        take();
    }
    return location;
}

double EarlierSurface::heightAt(Point2 p) const
{
    if (isNow())
        return mTin->heightAt(p);
    TinArrays sample;
    const Location location = sampleAt(p, sample);
    if (location.kind == Location::Kind::Edge)
        return heightOn(sample, location.corner, p);
    if (location.kind == Location::Kind::Triangle)
        return heightIn(sample, 0, p);
    return sample.heights[sample.points[0] == p ? 0 : sample.points[1] == p ? 1 : 2];
}

double EarlierSurface::slopeAt(Point2 p) const
{
    TinArrays sample;
    sampleAt(p, sample);
    return slopeOf(sample, 0) * 180 / M_PI;
}

} // namespace model::terrain
