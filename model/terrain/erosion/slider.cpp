// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/erosion/slider.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace model::terrain {

namespace {

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// A film of material thinner than this, in metres, does not say how steep a slope stands. It slides with the rest.
constexpr double Film = 1e-9;
/// A step that moves no vertex by as much, in metres, is none. The heights of a sliver, whose vertices are in a line
/// but for their rounding, are rounded too: it would be too steep for ever.
constexpr double LeastMove = Film;

double tangent(double degrees)
{
    return std::tan(degrees * M_PI / 180);
}

} // namespace

Slider::Slider(Patch &patch, const SweepRule &rule)
    : mPatch(patch)
    , mRule(rule)
    , mStart(tangent(rule.start))
    , mStop(tangent(rule.stop))
{}

/// tan(a + b) of tan(a) and tan(b).
double Slider::limitOf(double slope, double margin) const
{
    return slope * margin < 1 ? (slope + margin) / (1 - slope * margin) : Infinity;
}

inline Slider::Shape Slider::shapeOf(const PatchVertex &a, const PatchVertex &b, const PatchVertex &c)
{
    // The edges opposite to the vertices, turned by 90 degrees: doubleArea * grad(phi).
    const double pbx = c.y - a.y, pby = a.x - c.x, pcx = a.y - b.y, pcy = b.x - a.x;
    const double zb = b.z - a.z, zc = c.z - a.z;
    const double gx = zb * pbx + zc * pcx, gy = zb * pby + zc * pcy;
    const double qb = pbx * gx + pby * gy, qc = pcx * gx + pcy * gy;
    return {pcy * pbx - pcx * pby, gx * gx + gy * gy, {-(qb + qc), qb, qc}};
}

inline void Slider::noteMoved(Patch::List &list, const std::uint32_t (&v)[3]) const
{
    ++list.count.transfers;
    std::uint8_t *const isWhole = mPatch.mIsWhole.data();
    for (const std::uint32_t i : v)
        if (!isWhole[i]) {
            isWhole[i] = 1;
            list.pending.push_back(i);
        }
}

template <bool HasFloor>
void Slider::sweepAlike(Patch::List &list) const
{
    PatchVertex *const vertices = mPatch.mVertices.data();
    const double *const floors = mPatch.mFloors.data();
    const double slope = mPatch.mSlope, omega = mRule.relaxation;
    const double limits[] = {limitOf(slope, mStart), limitOf(slope, mStop)};
    const double squaredLimits[] = {limits[0] * limits[0], limits[1] * limits[1]};
    for (PatchTriangle &triangle : list.triangles) {
        PatchVertex &a = vertices[triangle.vertices[0]], &b = vertices[triangle.vertices[1]],
                    &c = vertices[triangle.vertices[2]];
        const Shape shape = shapeOf(a, b, c);
        const double squaredArea = shape.doubleArea * shape.doubleArea;
        if (!(shape.squaredGradient > squaredLimits[triangle.tag & 1] * squaredArea)) {
            triangle.tag &= ~1u;
            continue;
        }
        const double da = shape.q[0] * a.inverseArea, db = shape.q[1] * b.inverseArea, dc = shape.q[2] * c.inverseArea;
        const double excess = omega * (1 - slope * shape.doubleArea / std::sqrt(shape.squaredGradient));
        double step =
            std::min(excess, 1.0) * shape.squaredGradient / (shape.q[0] * da + shape.q[1] * db + shape.q[2] * dc);
        if (!(step * std::max({std::abs(da), std::abs(db), std::abs(dc)}) > LeastMove)) {
            triangle.tag &= ~1u;
            continue;
        }
        if constexpr (HasFloor) {
            if (step * da > a.z - floors[triangle.vertices[0]] || step * db > b.z - floors[triangle.vertices[1]] ||
                step * dc > c.z - floors[triangle.vertices[2]]) {
                apply(list, triangle);
                continue;
            }
        }
        a.z -= step * da;
        b.z -= step * db;
        c.z -= step * dc;
        triangle.tag |= 1;
        noteMoved(list, triangle.vertices);
    }
}

/// How much of the layer at the surface of `v` there is to move, if it stands less steep than `slope`. What lies below
/// comes when it is the surface: it may be stronger.
double Slider::movable(std::uint32_t v, double slope) const
{
    if (mPatch.mSurfaceSlopes[v] >= slope)
        return 0;
    const std::size_t at = std::size_t(v) * mPatch.mLayers;
    double sum = 0;
    for (std::uint32_t l = mPatch.mLayers; l-- > 0 && sum <= Film;)
        sum += mPatch.mThicknesses[at + l];
    return sum;
}

/// The same where all three vertices have the same layer of the same humidity at the surface, enough of it, and nothing
/// above: no mixing, and no angle changes.
bool Slider::moveOneLayer(const std::uint32_t (&v)[3], const double (&dz)[3], double share) const
{
    const std::uint32_t layers = mPatch.mLayers;
    const std::size_t at[3] = {std::size_t(v[0]) * layers, std::size_t(v[1]) * layers, std::size_t(v[2]) * layers};
    double *const thicknesses = mPatch.mThicknesses.data();
    std::uint32_t top = layers - 1;
    while (top > 0 && thicknesses[at[0] + top] == 0 && thicknesses[at[1] + top] == 0 && thicknesses[at[2] + top] == 0)
        --top;
    const float humidity = mPatch.mHumidities[at[0] + top];
    double after[3];
    for (int i = 0; i < 3; ++i) {
        after[i] = thicknesses[at[i] + top] + share * dz[i];
        if (!(after[i] > Film) || !(thicknesses[at[i] + top] > Film) || mPatch.mHumidities[at[i] + top] != humidity)
            return false;
    }
    for (int i = 0; i < 3; ++i) {
        thicknesses[at[i] + top] = after[i];
        double height = mPatch.mFloors[v[i]];
        for (std::uint32_t l = 0; l <= top; ++l)
            height += thicknesses[at[i] + l];
        mPatch.mVertices[v[i]].z = height;
    }
    return true;
}

bool Slider::moveLayers(const std::uint32_t (&v)[3], const double (&dz)[3], double slope) const
{
    double share = 1;
    for (int i = 0; i < 3; ++i)
        if (dz[i] < 0) {
            // Most often the top layer will do, and it is known to move.
            if (-dz[i] * share <= mPatch.mThicknesses[std::size_t(v[i] + 1) * mPatch.mLayers - 1])
                continue;
            const double there = movable(v[i], slope);
            if (-dz[i] * share > there)
                share = there / -dz[i];
        }
    if (!(share > 0))
        return false;
    if (moveOneLayer(v, dz, share))
        return true;
    double pool[MaxLayers] = {}, water[MaxLayers] = {}, given = 0;
    for (int i = 0; i < 3; ++i) {
        if (!(dz[i] < 0))
            continue;
        const std::size_t at = std::size_t(v[i]) * mPatch.mLayers;
        const double area = 1 / mPatch.mVertices[v[i]].inverseArea;
        double left = -dz[i] * share;
        for (std::uint32_t l = mPatch.mLayers; l-- > 0 && left > 0;) {
            const double taken = std::min(left, mPatch.mThicknesses[at + l]);
            mPatch.mThicknesses[at + l] -= taken;
            left -= taken;
            pool[l] += taken * area;
            water[l] += taken * area * double(mPatch.mHumidities[at + l]);
            given += taken * area;
        }
    }
    double wanted = 0;
    for (int i = 0; i < 3; ++i)
        if (dz[i] > 0)
            wanted += dz[i] / mPatch.mVertices[v[i]].inverseArea;
    for (int i = 0; i < 3; ++i) {
        const std::size_t at = std::size_t(v[i]) * mPatch.mLayers;
        if (dz[i] > 0)
            for (std::uint32_t l = 0; l < mPatch.mLayers; ++l) {
                // Of each layer the same share, with its water.
                const double more = pool[l] * dz[i] / wanted, thickness = mPatch.mThicknesses[at + l];
                if (!(more > 0))
                    continue;
                const double humidity =
                    (thickness * double(mPatch.mHumidities[at + l]) + water[l] * dz[i] / wanted) / (thickness + more);
                mPatch.mThicknesses[at + l] = thickness + more;
                mPatch.mHumidities[at + l] = float(std::clamp(humidity, 0.0, 1.0));
            }
        double height = mPatch.mFloors[v[i]];
        for (std::uint32_t l = 0; l < mPatch.mLayers; ++l)
            height += mPatch.mThicknesses[at + l];
        mPatch.mVertices[v[i]].z = height;
        mPatch.refreshSlope(v[i]);
    }
    return given > 0;
}

double Slider::roomAt(std::uint32_t v, double slope) const
{
    return mPatch.mMode == Patch::Mode::Layered ? movable(v, slope) : mPatch.mVertices[v].z - mPatch.mFloors[v];
}

bool Slider::plan(const PatchTriangle &triangle, Plan &plan) const
{
    const PatchVertex *const v[3] = {&mPatch.mVertices[triangle.vertices[0]], &mPatch.mVertices[triangle.vertices[1]],
                                     &mPatch.mVertices[triangle.vertices[2]]};
    const bool isLayered = mPatch.mMode == Patch::Mode::Layered;
    const Shape shape = shapeOf(*v[0], *v[1], *v[2]);
    if (isLayered) {
        // Most rest: less steep than the weakest of the three stands.
        const double *const slopes = mPatch.mSurfaceSlopes.data();
        const double least =
            std::min({slopes[triangle.vertices[0]], slopes[triangle.vertices[1]], slopes[triangle.vertices[2]]}) *
            shape.doubleArea;
        if (!(shape.squaredGradient > least * least))
            return false;
    }
    const double gradient = std::sqrt(shape.squaredGradient);
    plan.slope = gradient / shape.doubleArea;
    // Who has to give, who can, and how steep the strongest of it stands.
    double room[3] = {}, critical = 0, weakest = Infinity;
    int fixed = -1, strong = -1, stuck = 0, giving = 0;
    for (int i = 0; i < 3; ++i) {
        if (!(shape.q[i] > 0))
            continue;
        room[i] = roomAt(triangle.vertices[i], plan.slope);
        if (room[i] > Film) {
            const double stands = isLayered ? mPatch.mSurfaceSlopes[triangle.vertices[i]] : mPatch.mSlope;
            if (stands > critical)
                strong = i;
            critical = std::max(critical, stands);
            weakest = std::min(weakest, stands);
            ++giving;
        } else {
            fixed = i;
            ++stuck;
        }
    }
    if (stuck > 1)
        return false;
    if (stuck == 1)
        return planPair(triangle, shape, fixed, plan);
    // The weaker goes first, and the stronger where that does not help.
    if (giving == 2 && weakest < critical && planPair(triangle, shape, strong, plan))
        return true;
    if (giving == 0 || !(plan.slope > limitOf(critical, triangle.isMoving() ? mStop : mStart)))
        return false;
    double sum = 0;
    for (int i = 0; i < 3; ++i)
        sum += shape.q[i] * shape.q[i] * v[i]->inverseArea;
    const double excess = mRule.relaxation * (1 - critical * shape.doubleArea / gradient);
    double step = std::min(excess, 1.0) * shape.squaredGradient / sum;
    for (int i = 0; i < 3; ++i)
        if (shape.q[i] > 0 && step * shape.q[i] * v[i]->inverseArea > room[i])
            step = room[i] / (shape.q[i] * v[i]->inverseArea);
    double most = 0;
    for (int i = 0; i < 3; ++i) {
        plan.dz[i] = -step * shape.q[i] * v[i]->inverseArea;
        most = std::max(most, std::abs(plan.dz[i]));
    }
    return most > LeastMove;
}

/// One vertex stays; a volume s goes from one of the others to the last. That changes the gradient (times the double
/// area) G to G + s u. The least s that makes its length what it may be, or else that of the least length.
bool Slider::planPair(const PatchTriangle &triangle, const Shape &shape, int fixed, Plan &plan) const
{
    int from = (fixed + 1) % 3, to = (fixed + 2) % 3;
    const PatchVertex *const v[3] = {&mPatch.mVertices[triangle.vertices[0]], &mPatch.mVertices[triangle.vertices[1]],
                                     &mPatch.mVertices[triangle.vertices[2]]};
    double px[3], py[3], gx = 0, gy = 0;
    for (int i = 0; i < 3; ++i) {
        const PatchVertex &b = *v[(i + 1) % 3], &c = *v[(i + 2) % 3];
        px[i] = b.y - c.y;
        py[i] = c.x - b.x;
        gx += v[i]->z * px[i];
        gy += v[i]->z * py[i];
    }
    // Never uphill, and not beyond level: this lowers sum(A_i z_i^2) too.
    if (v[from]->z < v[to]->z)
        std::swap(from, to);
    const double ux = px[to] * v[to]->inverseArea - px[from] * v[from]->inverseArea,
                 uy = py[to] * v[to]->inverseArea - py[from] * v[from]->inverseArea;
    const double descent = gx * ux + gy * uy, square = ux * ux + uy * uy;
    const double level = (v[from]->z - v[to]->z) / (v[from]->inverseArea + v[to]->inverseArea);
    const double room = roomAt(triangle.vertices[from], plan.slope);
    if (!(room > Film) || !(descent < 0))
        return false;
    const double critical =
        mPatch.mMode == Patch::Mode::Layered ? mPatch.mSurfaceSlopes[triangle.vertices[from]] : mPatch.mSlope;
    if (!(plan.slope > limitOf(critical, triangle.isMoving() ? mStop : mStart)))
        return false;
    const double limit = critical * shape.doubleArea;
    const double discriminant = descent * descent - square * (shape.squaredGradient - limit * limit);
    const double least = -descent / square;
    double volume = discriminant > 0 ? mRule.relaxation * (-descent - std::sqrt(discriminant)) / square : least;
    volume = std::min({volume, least, level, room / v[from]->inverseArea});
    if (!(volume * v[from]->inverseArea > LeastMove))
        return false;
    plan.dz[fixed] = 0;
    plan.dz[from] = -volume * v[from]->inverseArea;
    plan.dz[to] = volume * v[to]->inverseArea;
    return true;
}

/// Does what plan() says, whatever the material.
void Slider::apply(Patch::List &list, PatchTriangle &triangle) const
{
    Plan plan;
    bool hasMoved = this->plan(triangle, plan);
    if (hasMoved && mPatch.mMode == Patch::Mode::Layered)
        hasMoved = moveLayers(triangle.vertices, plan.dz, plan.slope);
    else if (hasMoved)
        for (int i = 0; i < 3; ++i)
            mPatch.mVertices[triangle.vertices[i]].z += plan.dz[i];
    triangle.setMoving(hasMoved);
    if (hasMoved)
        noteMoved(list, triangle.vertices);
}

void Slider::sweepEdges(Patch::List &list) const
{
    const bool isLayered = mPatch.mMode == Patch::Mode::Layered;
    for (PatchTriangle &triangle : list.triangles) {
        bool hasMoved = false;
        for (int i = 0; i < 3; ++i) {
            std::uint32_t from = triangle.vertices[i], to = triangle.vertices[(i + 1) % 3];
            if (mPatch.mVertices[from].z < mPatch.mVertices[to].z)
                std::swap(from, to);
            PatchVertex &high = mPatch.mVertices[from], &low = mPatch.mVertices[to];
            const double length = std::hypot(high.x - low.x, high.y - low.y), drop = high.z - low.z;
            const double slope = isLayered ? mPatch.mSurfaceSlopes[from] : mPatch.mSlope;
            if (!(drop > limitOf(slope, triangle.isMoving() ? mStop : mStart) * length))
                continue;
            const double volume =
                std::min(mRule.relaxation * (drop - slope * length), drop) / (high.inverseArea + low.inverseArea);
            double down = volume * high.inverseArea;
            if (isLayered) {
                const std::uint32_t third = triangle.vertices[(i + 2) % 3];
                const std::uint32_t v[3] = {from, to, third};
                const double dz[3] = {-down, volume * low.inverseArea, 0};
                hasMoved |= moveLayers(v, dz, drop / length);
                continue;
            }
            down = std::min(down, high.z - mPatch.mFloors[from]);
            if (!(down > 0))
                continue;
            high.z -= down;
            low.z += down / high.inverseArea * low.inverseArea;
            hasMoved = true;
        }
        triangle.setMoving(hasMoved);
        if (hasMoved)
            noteMoved(list, triangle.vertices);
    }
}

void Slider::sweep(Patch::List &list) const
{
    list.count.visits += list.triangles.size();
    if (mRule.rule == ErosionRule::Edge)
        sweepEdges(list);
    else if (mPatch.mMode == Patch::Mode::Layered)
        for (PatchTriangle &triangle : list.triangles)
            apply(list, triangle);
    else if (mPatch.mLayers > 0)
        sweepAlike<true>(list);
    else
        sweepAlike<false>(list);
}

bool Slider::isSliding(const PatchTriangle &triangle) const
{
    Plan ignored;
    return plan(triangle, ignored);
}

} // namespace model::terrain
