// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tools/brush.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace model::terrain {

namespace {

/// A lattice point is left out if a vertex is nearer than this many spacings.
constexpr double NearEnough = 0.5;
/// Rows of the triangular lattice, in spacings.
constexpr double RowHeight = 0.8660254037844386;

/// Rises from 0 half a blend below 0 to 1 half a blend above.
double step(double x, double blend)
{
    if (blend <= 0)
        return x >= 0 ? 1 : 0;
    return std::clamp(x / blend + 0.5, 0.0, 1.0);
}

double squaredDistance(Point2 a, Point2 b)
{
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

std::string numberText(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
}

} // namespace

double weightOf(Falloff falloff, double t)
{
    if (!(t >= 0 && t <= 1))
        return 0;
    switch (falloff) {
    case Falloff::Constant:
        return 1;
    case Falloff::Linear:
        return 1 - t;
    case Falloff::Smooth:
        return 1 - t * t * (3 - 2 * t);
    case Falloff::Sphere:
        return std::sqrt(1 - t * t);
    case Falloff::Tip:
        return (1 - t) * (1 - t);
    }
    return 0;
}

double slopeAt(const TinArrays &tin, VertexId v)
{
    // The sum over the triangles of gradient times area needs no division by a needle's area.
    double x = 0, y = 0, area = 0;
    forEachCornerAround(tin, v, [&](Corner c) {
        if (tin.isVoid(triangleOf(c)))
            return;
        const VertexId b = tin.vertex(next(c)), d = tin.vertex(previous(c));
        const double bx = tin.points[b].x - tin.points[v].x, by = tin.points[b].y - tin.points[v].y,
                     bz = tin.heights[b] - tin.heights[v], dx = tin.points[d].x - tin.points[v].x,
                     dy = tin.points[d].y - tin.points[v].y, dz = tin.heights[d] - tin.heights[v];
        x += bz * dy - dz * by;
        y += dz * bx - bz * dx;
        area += bx * dy - by * dx;
    });
    return area > 0 ? std::atan(std::hypot(x, y) / area) * 180 / M_PI : 0;
}

bool Mask::isEverywhere() const
{
    return lowestSlope <= 0 && highestSlope >= 90 && lowestHeight == -NoLimit && highestHeight == NoLimit && !paint;
}

double Mask::weightOf(double slope, double height) const
{
    double weight = 1;
    if (lowestSlope > 0)
        weight *= step(slope - lowestSlope, slopeBlend);
    if (highestSlope < 90)
        weight *= step(highestSlope - slope, slopeBlend);
    if (lowestHeight > -NoLimit)
        weight *= step(height - lowestHeight, heightBlend);
    if (highestHeight < NoLimit)
        weight *= step(highestHeight - height, heightBlend);
    return weight;
}

double Mask::weightAt(const TinArrays &tin, VertexId v) const
{
    if (isEverywhere())
        return 1;
    const double open = openAt(tin.points[v]);
    if (open == 0)
        return 0;
    const bool isSlopeAsked = lowestSlope > 0 || highestSlope < 90;
    return open * weightOf(isSlopeAsked ? slopeAt(tin, v) : 0, tin.heights[v]);
}

Result<void> Mask::check() const
{
    for (const double limit : {lowestSlope, highestSlope, lowestHeight, highestHeight})
        if (std::isnan(limit))
            return fail(ErrorCode::BadSetting, "mask", "no number", "a number");
    if (const Result<void> checked = checkSetting("slope blend", slopeBlend, 0, 90); !checked)
        return checked;
    return checkSetting("height blend", heightBlend, 0, LargestSetting);
}

Result<void> checkSetting(const char *name, double value, double low, double high)
{
    if (value >= low && value <= high)
        return {};
    return fail(ErrorCode::BadSetting, name, numberText(value), numberText(low) + " ... " + numberText(high));
}

Result<void> Brush::check() const
{
    if (!(radius > 0))
        return fail(ErrorCode::BadSetting, "radius", numberText(radius), "above 0");
    for (const Result<void> &checked :
         {checkSetting("radius", radius, 0, LargestSetting), checkSetting("spacing", spacing, 0.01, 100), mask.check()})
        if (!checked)
            return checked;
    return detail == 0 ? Result<void>() : checkSetting("detail", detail, 0.01, 1);
}

void refineDisc(TinEdit &edit, Point2 centre, double radius, double spacing, ToolMemory &memory,
                const PaintMask *closed)
{
    const TinArrays &tin = edit.tin().arrays();
    const Rectangle &domain = edit.tin().domain();
    const double rowHeight = RowHeight * spacing;
    // Coordinates so large that the lattice is finer than their rounding are left as they are.
    if (!(std::abs(centre.x) + std::abs(centre.y) + radius < 0x1p50 * rowHeight))
        return;
    const double low = std::max(centre.y - radius, domain.low.y), high = std::min(centre.y + radius, domain.high.y);
    memory.inserted.clear();
    VertexId near = None;
    for (double row = std::ceil(low / rowHeight); row * rowHeight <= high; ++row) {
        const double y = row * rowHeight;
        const double half = std::sqrt(std::max(0.0, radius * radius - (y - centre.y) * (y - centre.y)));
        const double shift = std::fmod(row, 2) == 0 ? 0 : 0.5 * spacing;
        const double left = std::max(centre.x - half, domain.low.x), right = std::min(centre.x + half, domain.high.x);
        for (double column = std::ceil((left - shift) / spacing); column * spacing + shift <= right; ++column) {
            const Point2 p{column * spacing + shift, y};
            if (!domain.contains(p) || (closed && closed->at(p) == 1))
                continue;
            const TriangleId t = edit.tin().triangleAt(p, near);
            near = tin.vertex(cornerOf(t, 0));
            bool isWanted = !tin.isVoid(t);
            for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c)
                isWanted =
                    isWanted && squaredDistance(tin.pointAt(c), p) >= NearEnough * NearEnough * spacing * spacing;
            if (isWanted)
                memory.inserted.push_back(near = edit.insert(p, near));
        }
    }
    if (!memory.inserted.empty())
        edit.giveBack(memory.inserted);
}

void gather(TinEdit &edit, const Brush &brush, const StampPose &pose, ToolMemory &memory)
{
    memory.brushed.clear();
    const TinArrays &tin = edit.tin().arrays();
    const double radius = brush.radiusAt(pose);
    if (!(radius > 0))
        return;
    if (brush.detail > 0)
        // And one row beyond: the shape ends at the rim, and not at whatever vertex comes next.
        refineDisc(edit, pose.at, radius + brush.detail * brush.radius, brush.detail * brush.radius, memory,
                   brush.mask.paint.get());
    memory.disc.search(edit.tin(), pose.at, radius);
    for (const VertexId v : memory.disc.vertices()) {
        const double t = std::sqrt(squaredDistance(tin.points[v], pose.at)) / radius;
        const double weight = weightOf(brush.falloff, t) * brush.strengthAt(pose) * brush.mask.weightAt(tin, v);
        if (weight > 0)
            memory.brushed.push_back({v, weight});
    }
}

} // namespace model::terrain
