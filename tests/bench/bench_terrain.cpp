// SPDX-License-Identifier: GPL-3.0-or-later
// The TIN against CGAL's Constrained_Delaunay_triangulation_2 (the rows "cgal..."), on the same random points in the
// same run.
#include "model/terrain/tin/tinedit.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <map>
#include <random>

namespace {

using namespace model::terrain;

constexpr Rectangle Domain{{0, 0}, {1, 1}};
constexpr std::size_t Batch = 10000; ///< operations that are timed together

std::vector<Point3> randomPoints(std::size_t count, unsigned seed)
{
    std::mt19937_64 random(seed);
    const auto unit = [&] { return double(random() >> 11) * 0x1p-53; };
    std::vector<Point3> points(count);
    for (Point3 &p : points) {
        p = {unit(), unit(), 0};
        p.z = std::sin(9 * p.x) * std::cos(7 * p.y);
    }
    return points;
}

std::vector<Point3> gridPoints(std::size_t count)
{
    const auto side = std::size_t(std::sqrt(double(count)));
    std::vector<Point3> points;
    for (std::size_t y = 0; y < side; ++y)
        for (std::size_t x = 0; x < side; ++x)
            points.push_back({double(x) / double(side - 1), double(y) / double(side - 1), 0});
    return points;
}

/// Built once for each size and kept: the benchmarks put back what they change.
Tin &tinOf(std::size_t count)
{
    static std::map<std::size_t, Tin> tins;
    auto found = tins.find(count);
    if (found == tins.end())
        found = tins.emplace(count, std::move(buildTin(randomPoints(count, 1), Domain)->tin)).first;
    return found->second;
}

/// Processor time: what neighbours on the machine take does not count.
class Stopwatch
{
public:
    double seconds() const { return double(std::clock() - mBegin) / CLOCKS_PER_SEC; }

private:
    std::clock_t mBegin = std::clock();
};

/// Times a batch; the table's time is then that of one operation.
template <class Operation>
void timeBatch(benchmark::State &state, Operation operation)
{
    const Stopwatch stopwatch;
    operation();
    state.SetIterationTime(stopwatch.seconds() / Batch);
}

void terrainBuild(benchmark::State &state)
{
    const std::vector<Point3> points = randomPoints(std::size_t(state.range(0)), 1);
    double bytes = 0;
    for (auto _ : state) {
        const auto built = buildTin(points, Domain);
        bytes = double(built->tin.byteSize()) / built->tin.vertexCount();
    }
    state.counters["bytes/vertex"] = bytes;
}
void terrainBuildGrid(benchmark::State &state)
{
    const std::vector<Point3> points = gridPoints(std::size_t(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(buildTin(points, Domain)->tin.vertexCount());
}
void terrainInsert(benchmark::State &state)
{
    Tin &tin = tinOf(std::size_t(state.range(0)));
    const std::vector<Point3> points = randomPoints(Batch, 2);
    std::vector<VertexId> near;
    for (const Point3 &p : points)
        near.push_back(tin.arrays().vertex(tin.locate({p.x, p.y}).corner));
    for (auto _ : state) {
        TinEdit edit(tin);
        timeBatch(state, [&] {
            for (std::size_t i = 0; i < Batch; ++i)
                edit.insert({points[i].x, points[i].y}, near[i]);
        });
    }
}
void terrainRemove(benchmark::State &state)
{
    Tin &tin = tinOf(std::size_t(state.range(0)));
    std::mt19937 random(3);
    std::vector<VertexId> vertices;
    while (vertices.size() < Batch)
        vertices.push_back(4 + VertexId(random() % (tin.arrays().vertexSlots() - 4)));
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    std::shuffle(vertices.begin(), vertices.end(), random);
    for (auto _ : state) {
        TinEdit edit(tin);
        timeBatch(state, [&] {
            for (const VertexId v : vertices)
                edit.remove(v);
        });
    }
}
void terrainLocateNear(benchmark::State &state)
{
    const Tin &tin = tinOf(std::size_t(state.range(0)));
    const std::vector<Point3> points = randomPoints(Batch, 4);
    std::vector<VertexId> near;
    for (const Point3 &p : points)
        near.push_back(tin.arrays().vertex(tin.locate({p.x, p.y}).corner));
    for (auto _ : state)
        timeBatch(state, [&] {
            for (std::size_t i = 0; i < Batch; ++i)
                benchmark::DoNotOptimize(tin.locate({points[i].x, points[i].y}, near[i]));
        });
}
void terrainLocateAnywhere(benchmark::State &state)
{
    const Tin &tin = tinOf(std::size_t(state.range(0)));
    const std::vector<Point3> points = randomPoints(Batch, 5);
    for (auto _ : state)
        timeBatch(state, [&] {
            for (const Point3 &p : points)
                benchmark::DoNotOptimize(tin.locate({p.x, p.y}));
        });
}

/// A ring of 48 vertices and 48 constraints, put in and taken back: what a stamp and its undo cost the kernel.
constexpr std::size_t RingSize = 48;

Edit ring(Tin &tin, Point2 centre, double radius)
{
    TinEdit edit(tin);
    VertexId last = None;
    for (std::size_t i = 0; i <= RingSize; ++i) {
        const double angle = 2 * M_PI * double(i % RingSize) / double(RingSize);
        const VertexId v =
            edit.insert({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)}, last);
        if (last != None)
            benchmark::DoNotOptimize(edit.constrain(last, v, 1));
        last = v;
    }
    return edit.commit();
}

double ringRadius(std::int64_t vertices)
{
    return std::sqrt(100 / (M_PI * double(vertices))); // about 100 vertices inside
}

void terrainRing(benchmark::State &state)
{
    Tin &tin = tinOf(std::size_t(state.range(0)));
    std::mt19937 random(6);
    for (auto _ : state) {
        const Point2 centre{0.2 + 0.6 * double(random()) / 4294967296.0, 0.2 + 0.6 * double(random()) / 4294967296.0};
        const Stopwatch stopwatch;
        Edit edit = ring(tin, centre, ringRadius(state.range(0)));
        state.SetIterationTime(stopwatch.seconds());
        state.counters["bytes"] = double(edit.byteSize());
        tin.swap(edit);
    }
}
void terrainRingUndo(benchmark::State &state)
{
    Tin &tin = tinOf(std::size_t(state.range(0)));
    std::mt19937 random(6);
    for (auto _ : state) {
        const Point2 centre{0.2 + 0.6 * double(random()) / 4294967296.0, 0.2 + 0.6 * double(random()) / 4294967296.0};
        Edit edit = ring(tin, centre, ringRadius(state.range(0)));
        const Stopwatch stopwatch;
        tin.swap(edit);
        state.SetIterationTime(stopwatch.seconds());
    }
}

BENCHMARK(terrainBuild)->Arg(1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(terrainBuildGrid)->Arg(1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(terrainInsert)->Arg(1000000)->UseManualTime()->Iterations(5);
BENCHMARK(terrainRemove)->Arg(1000000)->UseManualTime()->Iterations(5);
BENCHMARK(terrainLocateNear)->Arg(1000000)->UseManualTime()->Iterations(20);
BENCHMARK(terrainLocateAnywhere)->Arg(1000000)->UseManualTime()->Iterations(20);
BENCHMARK(terrainRing)
    ->Arg(10000)
    ->Arg(100000)
    ->Arg(1000000)
    ->UseManualTime()
    ->Iterations(500)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(terrainRingUndo)->Arg(1000000)->UseManualTime()->Iterations(500)->Unit(benchmark::kMicrosecond);

} // namespace
