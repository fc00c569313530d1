// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tools/sculpt.h"

#include <algorithm>
#include <cmath>

namespace model::terrain {

namespace {

/// The first of these that failed.
Result<void> all(std::initializer_list<Result<void>> checks)
{
    for (const Result<void> &checked : checks)
        if (!checked)
            return checked;
    return {};
}

/// Sets each brushed vertex to what `heightOf(vertex, weight)` says.
template <class HeightOf>
void setHeights(TinEdit &edit, const ToolMemory &memory, HeightOf heightOf)
{
    for (const BrushVertex &brushed : memory.brushed)
        if (isOnGround(edit.tin().arrays(), brushed.vertex))
            edit.setHeight(brushed.vertex, heightOf(brushed.vertex, brushed.weight));
}

void raise(TinEdit &edit, const Brush &brush, double height, const StampPose &pose, ToolMemory &memory)
{
    const TinArrays &tin = edit.tin().arrays();
    gather(edit, brush, pose, memory);
    setHeights(edit, memory, [&](VertexId v, double weight) { return tin.heights[v] + weight * height; });
}

/// -1 ... 1 for each point of the integer lattice.
double latticeNoise(std::int64_t x, std::int64_t y, std::uint32_t seed)
{
    std::uint64_t bits = std::uint64_t(x) * 0x9e3779b97f4a7c15u ^ std::uint64_t(y) * 0xc2b2ae3d27d4eb4fu ^
                         (std::uint64_t(seed) << 32 | seed);
    bits = (bits ^ bits >> 30) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ bits >> 27) * 0x94d049bb133111ebu;
    return double((bits ^ bits >> 31) >> 11) * 0x1p-52 - 1;
}

double smoothed(double t)
{
    return t * t * t * (10 + t * (6 * t - 15));
}

double valueNoise(Point2 p, std::uint32_t seed)
{
    if (!(std::abs(p.x) < 0x1p52 && std::abs(p.y) < 0x1p52))
        return 0; // there is no lattice left to be smooth between
    const double fx = std::floor(p.x), fy = std::floor(p.y);
    const auto x = std::int64_t(fx), y = std::int64_t(fy);
    const double tx = smoothed(p.x - fx), ty = smoothed(p.y - fy);
    const double low = latticeNoise(x, y, seed) + tx * (latticeNoise(x + 1, y, seed) - latticeNoise(x, y, seed));
    const double high =
        latticeNoise(x, y + 1, seed) + tx * (latticeNoise(x + 1, y + 1, seed) - latticeNoise(x, y + 1, seed));
    return low + ty * (high - low);
}

double heightOf(const ReferenceSurface &surface, Point2 p)
{
    if (!surface.tin)
        return surface.height(p);
    const Rectangle &domain = surface.tin->domain();
    return surface.tin->heightAt(
        {std::clamp(p.x, domain.low.x, domain.high.x), std::clamp(p.y, domain.low.y, domain.high.y)});
}

std::uint32_t degreeOf(const TinArrays &tin, VertexId v)
{
    std::uint32_t degree = 0;
    forEachCornerAround(tin, v, [&](Corner) { ++degree; });
    return degree;
}

/// Each edge among the brushed vertices once, from the smaller to the larger place in `memory.brushed`.
template <class Visit>
void forEachBrushedEdge(const TinArrays &tin, const ToolMemory &memory, Visit visit)
{
    std::vector<std::pair<VertexId, std::uint32_t>> places;
    for (std::uint32_t i = 0; i < memory.brushed.size(); ++i)
        places.emplace_back(memory.brushed[i].vertex, i);
    std::sort(places.begin(), places.end());
    for (std::uint32_t i = 0; i < memory.brushed.size(); ++i) {
        const auto meet = [&](VertexId v) {
            const auto found = std::lower_bound(places.begin(), places.end(), std::pair(v, 0u));
            if (found != places.end() && found->first == v && found->second > i)
                visit(i, found->second);
        };
        forEachCornerAround(tin, memory.brushed[i].vertex, [&](Corner c) {
            if (!tin.isVoid(triangleOf(c)))
                meet(tin.vertex(next(c)));
            // The last edge of a fan at the border belongs to no next triangle.
            if (tin.opposite(next(c)) == NoCorner && !tin.isVoid(triangleOf(c)))
                meet(tin.vertex(previous(c)));
        });
    }
}

} // namespace

double noiseAt(Point2 p, std::uint32_t octaves, std::uint32_t seed)
{
    double sum = 0, weight = 1, weights = 0, frequency = 1;
    for (std::uint32_t i = 0; i < octaves; ++i) {
        sum += weight * valueNoise({p.x * frequency, p.y * frequency}, seed + i);
        weights += weight;
        weight *= 0.5;
        frequency *= 2;
    }
    return weights > 0 ? sum / weights : 0;
}

void stamp(TinEdit &edit, const Raise &tool, const StampPose &pose, ToolMemory &memory)
{
    raise(edit, tool.brush, tool.height, pose, memory);
}

void stamp(TinEdit &edit, const Lower &tool, const StampPose &pose, ToolMemory &memory)
{
    raise(edit, tool.brush, -tool.depth, pose, memory);
}

void stamp(TinEdit &edit, const Scoop &tool, const StampPose &pose, ToolMemory &memory)
{
    raise(edit, tool.brush, -tool.depth, pose, memory);
}

void stamp(TinEdit &edit, const Flatten &tool, const StampPose &pose, double level, ToolMemory &memory)
{
    const TinArrays &tin = edit.tin().arrays();
    gather(edit, tool.brush, pose, memory);
    setHeights(edit, memory, [&](VertexId v, double weight) {
        const double share = tool.strength * weight;
        return share >= 1 ? level : tin.heights[v] + share * (level - tin.heights[v]);
    });
}

void stamp(TinEdit &edit, const Smooth &tool, const StampPose &pose, ToolMemory &memory)
{
    const TinArrays &tin = edit.tin().arrays();
    gather(edit, tool.brush, pose, memory);
    // One explicit step of diffusion: what flows along an edge is at most a share of 1 / degree of the smaller area, so
    // that no vertex passes the mean of its neighbours. What one gives the other gets.
    std::vector<double> gained(memory.brushed.size());
    forEachBrushedEdge(tin, memory, [&](std::uint32_t i, std::uint32_t j) {
        const BrushVertex &a = memory.brushed[i], &b = memory.brushed[j];
        const double area = std::min(edit.areaOf(a.vertex), edit.areaOf(b.vertex));
        const double share =
            tool.strength * std::min(a.weight, b.weight) / std::max(degreeOf(tin, a.vertex), degreeOf(tin, b.vertex));
        const double flow = share * area * (tin.heights[a.vertex] - tin.heights[b.vertex]);
        gained[i] -= flow;
        gained[j] += flow;
    });
    double moved = 0;
    for (std::size_t i = 0; i < gained.size(); ++i) {
        const VertexId v = memory.brushed[i].vertex;
        if (gained[i] == 0 || !(edit.areaOf(v) > 0))
            continue;
        edit.displace(v, tin.heights[v] + gained[i] / edit.areaOf(v));
        moved += std::max(0.0, gained[i]);
    }
    edit.bookMoved(moved);
}

void stamp(TinEdit &edit, const Noise &tool, const StampPose &pose, ToolMemory &memory)
{
    const TinArrays &tin = edit.tin().arrays();
    gather(edit, tool.brush, pose, memory);
    setHeights(edit, memory, [&](VertexId v, double weight) {
        const Point2 p = tin.points[v];
        return tin.heights[v] + weight * tool.amplitude *
                                    noiseAt({p.x / tool.wavelength, p.y / tool.wavelength}, tool.octaves, tool.seed);
    });
}

void stamp(TinEdit &edit, const Restore &tool, const StampPose &pose, ToolMemory &memory)
{
    const TinArrays &tin = edit.tin().arrays();
    const double radius = tool.brush.radiusAt(pose);
    if (tool.reference.tin && radius > 0) {
        memory.disc.search(*tool.reference.tin, pose.at, radius);
        const TinArrays &reference = tool.reference.tin->arrays();
        memory.inserted.clear();
        VertexId near = None;
        for (const VertexId v : memory.disc.vertices()) {
            const Point2 p = reference.points[v];
            if (!edit.tin().domain().contains(p) || tin.isVoid(edit.tin().triangleAt(p, near)))
                continue;
            const std::uint32_t before = edit.tin().vertexCount();
            near = edit.insert(p, near);
            if (edit.tin().vertexCount() > before)
                memory.inserted.push_back(near);
        }
        if (!memory.inserted.empty())
            edit.giveBack(memory.inserted);
    }
    gather(edit, tool.brush, pose, memory);
    setHeights(edit, memory, [&](VertexId v, double weight) {
        const double height = heightOf(tool.reference, tin.points[v]), share = tool.strength * weight;
        if (!std::isfinite(height))
            return tin.heights[v];
        return share >= 1 ? height : tin.heights[v] + share * (height - tin.heights[v]);
    });
}

void stamp(TinEdit &edit, const Pour &tool, const StampPose &pose, ToolMemory &memory)
{
    const TinArrays &tin = edit.tin().arrays();
    gather(edit, tool.brush, pose, memory);
    double weighted = 0;
    for (const BrushVertex &brushed : memory.brushed)
        weighted += brushed.weight * edit.areaOf(brushed.vertex);
    if (!(weighted > 0))
        return;
    const double lift = tool.volume * tool.brush.strengthAt(pose) / weighted;
    setHeights(edit, memory, [&](VertexId v, double weight) { return tin.heights[v] + weight * lift; });
}

void stamp(TinEdit &edit, const Moisten &tool, const StampPose &pose, ToolMemory &memory)
{
    const TinArrays &tin = edit.tin().arrays();
    if (tin.layerCount() == 0)
        return;
    gather(edit, tool.brush, pose, memory);
    for (const BrushVertex &brushed : memory.brushed) {
        std::uint32_t layer = tin.layerCount();
        while (layer > 0 && !(tin.sample(brushed.vertex, layer - 1).thickness > 0))
            --layer;
        if (layer == 0)
            continue; // bare rock
        LayerSample sample = tin.sample(brushed.vertex, layer - 1);
        const double share = std::min(1.0, tool.strength * brushed.weight);
        const auto humidity = float(sample.humidity + share * (tool.humidity - double(sample.humidity)));
        if (humidity == sample.humidity)
            continue;
        sample.humidity = humidity;
        edit.setLayer(brushed.vertex, layer - 1, sample);
    }
}

Result<void> check(const Raise &tool)
{
    return all({tool.brush.check(), checkSetting("height", tool.height, -LargestSetting, LargestSetting)});
}
Result<void> check(const Lower &tool)
{
    return all({tool.brush.check(), checkSetting("depth", tool.depth, -LargestSetting, LargestSetting)});
}
Result<void> check(const Flatten &tool)
{
    return all({tool.brush.check(), checkSetting("strength", tool.strength, 0, 1),
                checkSetting("level", tool.level.value_or(0), -LargestSetting, LargestSetting)});
}
Result<void> check(const Smooth &tool)
{
    return all({tool.brush.check(), checkSetting("strength", tool.strength, 0, 1)});
}
Result<void> check(const Noise &tool)
{
    return all({tool.brush.check(), checkSetting("amplitude", tool.amplitude, -LargestSetting, LargestSetting),
                checkSetting("wavelength", tool.wavelength, 1e-6, LargestSetting),
                checkSetting("octaves", tool.octaves, 1, 16)});
}
Result<void> check(const Restore &tool)
{
    if (!tool.reference.tin && !tool.reference.height)
        return fail(ErrorCode::BadSetting, "reference", "none", "a surface");
    return all({tool.brush.check(), checkSetting("strength", tool.strength, 0, 1)});
}
Result<void> check(const Pour &tool)
{
    return all({tool.brush.check(), checkSetting("volume", tool.volume, 0, LargestSetting)});
}
Result<void> check(const Scoop &tool)
{
    return all({tool.brush.check(), checkSetting("depth", tool.depth, 0, LargestSetting)});
}
Result<void> check(const Moisten &tool)
{
    return all({tool.brush.check(), checkSetting("humidity", tool.humidity, 0, 1),
                checkSetting("strength", tool.strength, 0, 1)});
}

} // namespace model::terrain
