// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tools/lines.h"

#include <algorithm>
#include <cmath>

namespace model::terrain {

namespace {

/// Lattice of a rake in distances of two tines: a groove and a ridge have two vertices each across.
constexpr double RakeDetail = 0.25;
/// How far from the line between its neighbours a point of a path may lie and count as on it, in lengths of the line.
constexpr double OnLine = 1e-9;

double dot(Point2 a, Point2 b)
{
    return a.x * b.x + a.y * b.y;
}

/// A plane z = height + slope . (p - centre) through points with weights, or a level one if they lie on a line.
struct Plane
{
    Point2 centre;
    double height = 0;
    Point2 slope;

    double at(Point2 p) const { return height + slope.x * (p.x - centre.x) + slope.y * (p.y - centre.y); }
};

/// Least squares over vertices weighted by their areas.
Plane planeThrough(TinEdit &edit, std::span<const BrushVertex> vertices)
{
    const TinArrays &tin = edit.tin().arrays();
    Plane plane;
    double area = 0;
    for (const BrushVertex &b : vertices) {
        const double a = edit.areaOf(b.vertex);
        area += a;
        plane.centre.x += a * tin.points[b.vertex].x;
        plane.centre.y += a * tin.points[b.vertex].y;
        plane.height += a * tin.heights[b.vertex];
    }
    if (!(area > 0))
        return plane;
    plane.centre = {plane.centre.x / area, plane.centre.y / area};
    plane.height /= area;
    double xx = 0, xy = 0, yy = 0, xz = 0, yz = 0;
    for (const BrushVertex &b : vertices) {
        const double a = edit.areaOf(b.vertex), x = tin.points[b.vertex].x - plane.centre.x,
                     y = tin.points[b.vertex].y - plane.centre.y, z = tin.heights[b.vertex] - plane.height;
        xx += a * x * x;
        xy += a * x * y;
        yy += a * y * y;
        xz += a * x * z;
        yz += a * y * z;
    }
    const double determinant = xx * yy - xy * xy;
    if (determinant > 1e-9 * (xx + yy) * (xx + yy))
        plane.slope = {(xz * yy - yz * xy) / determinant, (yz * xx - xz * xy) / determinant};
    return plane;
}

/// The part of a-b inside the domain; false if there is none. Source: Y.-D. Liang, B. Barsky, 1984.
bool clip(const Rectangle &domain, Point2 &a, Point2 &b)
{
    double enter = 0, leave = 1;
    const Point2 d{b.x - a.x, b.y - a.y};
    const auto cut = [&](double p, double q) {
        if (p == 0)
            return q >= 0;
        const double t = q / p;
        if (p < 0)
            enter = std::max(enter, t);
        else
            leave = std::min(leave, t);
        return true;
    };
    if (!cut(-d.x, a.x - domain.low.x) || !cut(d.x, domain.high.x - a.x) || !cut(-d.y, a.y - domain.low.y) ||
        !cut(d.y, domain.high.y - a.y) || enter >= leave)
        return false;
    const auto at = [&](double t) {
        return Point2{std::clamp(a.x + t * d.x, domain.low.x, domain.high.x),
                      std::clamp(a.y + t * d.y, domain.low.y, domain.high.y)};
    };
    const Point2 from = enter > 0 ? at(enter) : a, to = leave < 1 ? at(leave) : b;
    a = from;
    b = to;
    return true;
}

} // namespace

void stamp(TinEdit &edit, const Rake &tool, const StampPose &pose, ToolMemory &memory)
{
    if (dot(pose.direction, pose.direction) == 0 || !(pose.pressure > 0))
        return; // a rake that is not drawn leaves no groove
    const TinArrays &tin = edit.tin().arrays();
    const double pitch = tool.width / tool.tines;
    const double reach = std::hypot(tool.width, pitch) / 2;
    refineDisc(edit, pose.at, reach, RakeDetail * pitch, memory, tool.mask.paint.get());
    memory.disc.search(edit.tin(), pose.at, reach);
    memory.brushed.clear();
    const Point2 across{-pose.direction.y, pose.direction.x};
    for (const VertexId v : memory.disc.vertices()) {
        const Point2 p{tin.points[v].x - pose.at.x, tin.points[v].y - pose.at.y};
        const double u = dot(p, across);
        if (std::abs(dot(p, pose.direction)) > pitch / 2 || std::abs(u) > tool.width / 2 || !isOnGround(tin, v))
            continue;
        // -1 at the tines, which stand in the middle of their share of the width, and 1 half-way between two.
        const double wave = std::cos(2 * M_PI * (u + tool.width / 2) / pitch);
        memory.brushed.push_back({v, wave * tool.mask.weightAt(tin, v)});
    }
    const Plane ground = planeThrough(edit, memory.brushed);
    const double before = edit.leak();
    std::vector<VertexId> ridges;
    std::vector<double> weights;
    for (const BrushVertex &b : memory.brushed)
        if (b.weight > 0) {
            ridges.push_back(b.vertex);
            weights.push_back(b.weight);
        }
    if (ridges.empty())
        return;
    for (const BrushVertex &b : memory.brushed)
        if (const double groove = ground.at(tin.points[b.vertex]) + b.weight * tool.depth * pose.pressure;
            b.weight < 0 && tin.heights[b.vertex] > groove)
            edit.displace(b.vertex, groove);
    edit.bookMoved(before - edit.leak());
    edit.giveBack(ridges, weights);
}

void makeRamp(TinEdit &edit, const Ramp &tool, Point2 from, Point2 to, double pressure, ToolMemory &memory)
{
    const TinArrays &tin = edit.tin().arrays();
    const Rectangle &domain = edit.tin().domain();
    const auto groundAt = [&](Point2 p) {
        return edit.tin().heightAt(
            {std::clamp(p.x, domain.low.x, domain.high.x), std::clamp(p.y, domain.low.y, domain.high.y)});
    };
    const double fromHeight = tool.from.value_or(groundAt(from)), toHeight = tool.to.value_or(groundAt(to));
    const StampPose ends[] = {{from, {}, pressure, 0, false}, {to, {}, pressure, 0, false}};
    const double radius = tool.brush.radiusAt(ends[0]);
    if (!(radius > 0))
        return;
    const Point2 d{to.x - from.x, to.y - from.y};
    const double length = std::hypot(d.x, d.y);
    const auto steps = std::uint32_t(std::ceil(length / (radius / 2)));
    std::vector<VertexId> vertices;
    for (const bool isRefining : {true, false})
        for (std::uint32_t i = 0; i <= steps; ++i) {
            const double t = steps > 0 ? double(i) / steps : 0;
            const Point2 centre{from.x + t * d.x, from.y + t * d.y};
            if (isRefining && tool.brush.detail > 0)
                refineDisc(edit, centre, radius, tool.brush.detail * tool.brush.radius, memory,
                           tool.brush.mask.paint.get());
            if (isRefining)
                continue;
            memory.disc.search(edit.tin(), centre, radius * 1.05); // discs half a radius apart leave no gap
            vertices.insert(vertices.end(), memory.disc.vertices().begin(), memory.disc.vertices().end());
        }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    struct Target
    {
        VertexId vertex;
        double height;
    };
    std::vector<Target> targets; // the mask sees the ground as it was
    for (const VertexId v : vertices) {
        const Point2 p{tin.points[v].x - from.x, tin.points[v].y - from.y};
        const double along = length > 0 ? std::clamp(dot(p, d) / (length * length), 0.0, 1.0) : 0;
        const double distance = std::hypot(p.x - along * d.x, p.y - along * d.y);
        const double weight = weightOf(tool.brush.falloff, distance / radius) * tool.brush.strengthAt(ends[0]) *
                              tool.brush.mask.weightAt(tin, v);
        const double height = fromHeight + along * (toHeight - fromHeight);
        if (weight > 0 && isOnGround(tin, v))
            targets.push_back({v, weight >= 1 ? height : tin.heights[v] + weight * (height - tin.heights[v])});
    }
    for (const Target &target : targets)
        edit.setHeight(target.vertex, target.height);
}

std::vector<Point2> cornersOf(std::span<const PathPoint> path)
{
    std::vector<Point2> corners;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const Point2 p = path[i].at;
        if (!corners.empty() && corners.back() == p)
            continue;
        if (!corners.empty() && i + 1 < path.size()) {
            const Point2 a = corners.back(), b = path[i + 1].at;
            const Point2 d{b.x - a.x, b.y - a.y}, e{p.x - a.x, p.y - a.y};
            const double squared = dot(d, d), along = dot(d, e);
            if (along > 0 && along < squared && std::abs(d.x * e.y - d.y * e.x) <= OnLine * squared)
                continue;
        }
        corners.push_back(p);
    }
    return corners;
}

Result<void> insertBreakline(TinEdit &edit, const Breakline &tool, std::span<const Point2> path, OwnerId owner)
{
    std::vector<VertexId> inserted;
    std::vector<std::pair<VertexId, VertexId>> edges;
    for (std::size_t i = 1; i < path.size(); ++i) {
        Point2 a = path[i - 1], b = path[i];
        if (!clip(edit.tin().domain(), a, b))
            continue;
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        const double parts = tool.spacing > 0 ? std::max(1.0, std::ceil(length / tool.spacing)) : 1;
        if (!(parts + double(edges.size()) < double(LargestStampCount)))
            return fail(ErrorCode::LimitExceeded, "number of breakline edges", std::to_string(parts),
                        std::to_string(LargestStampCount));
        VertexId last = None;
        for (double part = 0; part <= parts; ++part) {
            const double t = part / parts;
            const Point2 p = part == parts ? b : Point2{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
            const VertexId v = edit.insert(p, last != None ? last : inserted.empty() ? None : inserted.back());
            inserted.push_back(v);
            if (last != None && last != v)
                edges.emplace_back(last, v);
            last = v;
        }
    }
    for (const auto &[a, b] : edges)
        if (const Result<void> done = edit.constrain(a, b, owner, tool.crossing); !done)
            return done;
    std::sort(inserted.begin(), inserted.end());
    inserted.erase(std::unique(inserted.begin(), inserted.end()), inserted.end());
    // What the surface gained by being divided anew goes back to all that it was divided around, before heights are set
    // on purpose.
    std::vector<VertexId> around = inserted;
    for (const VertexId v : inserted)
        forEachCornerAround(edit.tin().arrays(), v,
                            [&](Corner c) { around.push_back(edit.tin().arrays().vertex(next(c))); });
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    edit.giveBack(around);
    if (tool.height)
        for (const VertexId v : inserted)
            edit.setHeight(v, *tool.height);
    return {};
}

Result<void> check(const Rake &tool)
{
    for (const Result<void> &checked :
         {checkSetting("width", tool.width, 1e-6, LargestSetting), checkSetting("tines", tool.tines, 1, 100),
          checkSetting("depth", tool.depth, 0, LargestSetting), checkSetting("spacing", tool.spacing, 0.01, 10),
          tool.mask.check()})
        if (!checked)
            return checked;
    return {};
}

Result<void> check(const Ramp &tool)
{
    for (const Result<void> &checked :
         {tool.brush.check(), checkSetting("height", tool.from.value_or(0), -LargestSetting, LargestSetting),
          checkSetting("height", tool.to.value_or(0), -LargestSetting, LargestSetting)})
        if (!checked)
            return checked;
    return {};
}

Result<void> check(const Breakline &tool)
{
    for (const Result<void> &checked :
         {checkSetting("spacing", tool.spacing, 0, LargestSetting),
          checkSetting("height", tool.height.value_or(0), -LargestSetting, LargestSetting)})
        if (!checked)
            return checked;
    return {};
}

} // namespace model::terrain
