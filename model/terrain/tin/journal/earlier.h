// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/journal/slotmap.h"
#include "model/terrain/tin/tin.h"

namespace model::terrain {

/// A TIN's surface as it was before some edits that have been done since, without a copy of the TIN: it keeps what they
/// wrote over. A stroke presses its tool below the ground that lay there when it began.
class EarlierSurface
{
public:
    /// As it is now. Keep the TIN, and tell of each edit.
    explicit EarlierSurface(const Tin &tin)
        : mTin(&tin)
        , mSlots(sizesOf(tin))
    {}

    /// An edit was done, the next one after those told of before. Cost: that of the edit.
    void note(const Edit &edit);
    /// Nothing was noted, or nothing of it wrote anything.
    bool isNow() const { return mTriangles.isEmpty() && mHeights.isEmpty(); }

    /// What Tin::heightAt() said then, to the bit. Precondition: `p` lies in the domain.
    double heightAt(Point2 p) const;
    /// What Tin::gradientAt() said then, in degrees of slope.
    double slopeAt(Point2 p) const;

private:
    struct Sizes
    {
        std::uint32_t vertices = 0, triangles = 0;
    };
    struct Triangle
    {
        VertexId vertices[3];
        Corner opposites[3];
        std::uint8_t flags;
    };
    static Sizes sizesOf(const Tin &tin) { return {tin.arrays().vertexSlots(), tin.arrays().triangleSlots()}; }

    Triangle triangle(TriangleId t) const;
    Point2 point(VertexId v) const;
    double height(VertexId v) const;
    TriangleId find(Point2 p) const;
    Location sampleAt(Point2 p, TinArrays &sample) const;

    const Tin *mTin;
    Sizes mSlots;
    SlotMap<Point2> mPoints;
    SlotMap<double> mHeights;
    SlotMap<Triangle> mTriangles;
    mutable TriangleId mLast = None; ///< where the search before ended
};

} // namespace model::terrain
