// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/erosion/patch.h"

namespace model::terrain {

/// Moves material over the triangles of one list of a patch: the innermost loop of erosion.
///
/// Of a triangle of gradient g, with phi_i the hat function of its vertex i, A_i the dual areas and theta the critical
/// angle, d_i = grad(phi_i) . g and lambda = (1 - tan(theta) / |g|) |g|^2 / sum(A d_i^2 / A_i):
/// z_i -= omega lambda A d_i / A_i. The d_i add up to 0, so that volume is untouched; omega = 1 makes the slope exactly
/// theta. Differs: no step goes beyond level, however large omega is, so that cliffs do not turn over; every step then
/// lowers sum(A_i z_i^2), by as much as the slope is too steep, and sweeping comes to an end. A vertex that should give
/// and has nothing, or only what stands as steep as this, stays; the two others then do what they can.
class Slider
{
public:
    Slider(Patch &patch, const SweepRule &rule);

    void sweep(Patch::List &list) const;
    /// Steeper than the rule allows, with material that can move.
    bool isSliding(const PatchTriangle &triangle) const;

private:
    /// Twice the area, the gradient times that, and for each vertex its share in it.
    struct Shape
    {
        double doubleArea, squaredGradient;
        double q[3];
    };
    static Shape shapeOf(const PatchVertex &a, const PatchVertex &b, const PatchVertex &c);
    double limitOf(double slope, double margin) const;
    /// What a triangle would do: how much each vertex goes up or down. False if it rests, or has nothing to give.
    struct Plan
    {
        double dz[3];
        double slope; ///< of the triangle, a tangent
    };
    bool plan(const PatchTriangle &triangle, Plan &plan) const;
    bool planPair(const PatchTriangle &triangle, const Shape &shape, int fixed, Plan &plan) const;
    double roomAt(std::uint32_t v, double slope) const;
    void apply(Patch::List &list, PatchTriangle &triangle) const;

    template <bool HasFloor>
    void sweepAlike(Patch::List &list) const;
    void sweepEdges(Patch::List &list) const;
    bool moveLayers(const std::uint32_t (&v)[3], const double (&dz)[3], double slope) const;
    bool moveOneLayer(const std::uint32_t (&v)[3], const double (&dz)[3], double share) const;
    double movable(std::uint32_t v, double slope) const;
    void noteMoved(Patch::List &list, const std::uint32_t (&v)[3]) const;

    Patch &mPatch;
    const SweepRule mRule;
    const double mStart, mStop; ///< tangents of the margins
};

} // namespace model::terrain
