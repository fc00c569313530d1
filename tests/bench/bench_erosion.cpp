// SPDX-License-Identifier: GPL-3.0-or-later
// Erosion of the column (a cylinder of radius 0.1 and height 0.5 on a unit square, at 30 degrees), and a trace along
// 80 % of the diagonal beside the same on a regular grid.
#include "model/base/parallel.h"
#include "model/terrain/erosion/erosion.h"
#include "model/terrain/erosion/refine.h"
#include "model/terrain/simplify/simplifytin.h"
#include "model/terrain/tin/disc.h"
#include "tests/bench/heightfield.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

using namespace model;
using namespace model::terrain;

constexpr double Degree = M_PI / 180;

Tin column(std::size_t vertices)
{
    std::mt19937_64 random(1);
    const auto unit = [&] { return double(random() >> 11) * 0x1p-53; };
    std::vector<Point3> points(vertices);
    for (Point3 &p : points) {
        p = {unit(), unit(), 0};
        p.z = std::hypot(p.x - 0.5, p.y - 0.5) < 0.1 ? 0.5 : 0;
    }
    return std::move(buildTin(points, {{0, 0}, {1, 1}})->tin);
}

double steepestFace(const Tin &tin)
{
    double steepest = 0;
    for (TriangleId t = 0; t < tin.arrays().triangleSlots(); ++t)
        if (tin.arrays().isTriangle(t))
            steepest = std::max(steepest, slopeOf(tin.arrays(), t) / Degree);
    return steepest;
}

/// Arguments: vertices, threads, layers, relaxation in hundredths, coarse pass.
void erosionColumn(benchmark::State &state)
{
    setThreadCount(unsigned(state.range(1)));
    const auto layers = std::uint8_t(state.range(2));
    Tin tin = column(std::size_t(state.range(0)));
    if (layers > 0) {
        TinEdit edit(tin);
        for (std::uint8_t l = 0; l < layers; ++l)
            edit.addLayer(l, 0);
        for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v)
            edit.setLayer(v, layers - 1u, {tin.arrays().heights[v], 0});
        edit.commit();
    }
    const Material sand = material(MaterialPreset::DrySand);
    ErosionSettings settings;
    settings.relaxation = double(state.range(3)) / 100;
    settings.hasCoarsePass = state.range(4) != 0;
    Erosion erosion = *Erosion::create(settings, std::span(&sand, 1));
    const double volume = tin.volume();
    double transfers = 0, visits = 0;
    for (auto _ : state) {
        TinEdit edit(tin);
        const auto settled = erosion.settle(edit);
        Edit done = edit.commit();
        state.PauseTiming();
        transfers += double(settled->transfers);
        visits += double(settled->visits);
        double top = 0, covered = 0;
        for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v) {
            top = std::max(top, tin.arrays().heights[v]);
            covered += tin.arrays().heights[v] > 1e-9 ? dualArea(tin.arrays(), v) : 0;
        }
        const double slope = std::tan(30 * Degree), radius = std::cbrt(3 * volume / (M_PI * slope));
        state.counters["slope"] = steepestFace(tin);
        state.counters["height%"] = 100 * (top / (radius * slope) - 1);
        state.counters["radius%"] = 100 * (std::sqrt(covered / M_PI) / radius - 1);
        state.counters["drift"] = tin.volume() / volume - 1;
        tin.swap(done);
        state.ResumeTiming();
    }
    state.counters["transfers/s"] = benchmark::Counter(transfers, benchmark::Counter::kIsRate);
    state.counters["visits/s"] = benchmark::Counter(visits, benchmark::Counter::kIsRate);
    setThreadCount(0);
}

/// The first sweeps over much steep ground: nearly every triangle moves, in cells enough for any number of threads.
/// Arguments: vertices, threads, layers.
void erosionSweep(benchmark::State &state)
{
    setThreadCount(unsigned(state.range(1)));
    std::mt19937_64 random(1);
    const auto unit = [&] { return double(random() >> 11) * 0x1p-53; };
    std::vector<Point3> points(std::size_t(state.range(0)));
    for (Point3 &p : points) {
        p = {unit(), unit(), 0};
        p.z = std::sin(40 * p.x) * std::cos(40 * p.y) * 0.1;
    }
    Tin tin = std::move(buildTin(points, {{0, 0}, {1, 1}})->tin);
    const auto layers = std::uint8_t(state.range(2));
    if (layers > 0) {
        TinEdit edit(tin);
        for (std::uint8_t l = 0; l < layers; ++l) {
            edit.addLayer(l, 0);
            for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v)
                edit.setLayer(v, l, {0.2, 0});
        }
        edit.commit();
    }
    const Material sand = material(MaterialPreset::DrySand);
    const SlopeTable slopes(tin.arrays().totals.layers, std::span(&sand, 1), sand);
    Patch::Ids ids;
    double transfers = 0, visits = 0;
    for (auto _ : state) {
        state.PauseTiming();
        {
            Patch patch(tin, slopes, sand, ids);
            for (TriangleId t = 0; t < tin.arrays().triangleSlots(); ++t)
                patch.add(t);
            Team::run([&](Team &team) {
                const SweepRule rule{ErosionRule::Face, 1.85, Erosion::RestTolerance, Erosion::RestTolerance / 2};
                patch.sweep(team, rule, Progress());
                state.ResumeTiming();
                for (int i = 0; i < 20; ++i) {
                    const SweepCount count = patch.sweep(team, rule, Progress());
                    transfers += double(count.transfers);
                    visits += double(count.visits);
                }
                state.PauseTiming();
            });
        }
        state.ResumeTiming();
    }
    state.counters["transfers/s"] = benchmark::Counter(transfers, benchmark::Counter::kIsRate);
    state.counters["visits/s"] = benchmark::Counter(visits, benchmark::Counter::kIsRate);
    setThreadCount(0);
}

/// What a sixtieth of a second of a brush costs in a large terrain: a dab of 0.01, and the run after it.
void erosionBrush(benchmark::State &state)
{
    setThreadCount(unsigned(state.range(1)));
    std::mt19937_64 random(1);
    const auto unit = [&] { return double(random() >> 11) * 0x1p-53; };
    std::vector<Point3> points(std::size_t(state.range(0)));
    for (Point3 &p : points)
        p = {unit(), unit(), 0};
    Tin tin = std::move(buildTin(points, {{0, 0}, {1, 1}})->tin);
    Erosion erosion = *Erosion::create({}, {});
    const double radius = std::sqrt(100 / (M_PI * double(state.range(0))));
    for (auto _ : state) {
        state.PauseTiming();
        const Point2 centre{0.2 + 0.6 * unit(), 0.2 + 0.6 * unit()};
        TinEdit dab(tin);
        const VertexId v = dab.insert(centre);
        dab.setHeight(v, tin.arrays().heights[v] + 20 * radius);
        const Edit done = dab.commit();
        state.ResumeTiming();
        erosion.activate(tin, done);
        TinEdit edit(tin);
        benchmark::DoNotOptimize(erosion.run(edit, 1.0 / 60));
        edit.commit();
    }
    setThreadCount(0);
}

// The trace: balls of radius 0.04, 40 of them pressed 0.1 deep along 80 % of the diagonal, after
// each of which the ground settles.

constexpr double TraceRadius = 0.04, TraceDepth = 0.1;
constexpr int Stamps = 40;
constexpr double AnyAngle = 60;        ///< the vertical error alone says what goes
constexpr double SmallestError = 4e-3; ///< of what goes while the trace is drawn
constexpr double TraceError = 3e-3;    ///< to which the finished trace is simplified

Point2 stampAt(int i)
{
    const double at = 0.1 + 0.8 * i / (Stamps - 1);
    return {at, at};
}

/// Of two surfaces, the mean vertical difference at 90,000 points of the trace's neighbourhood.
template <class A, class B>
double meanDifference(const A &a, const B &b)
{
    double sum = 0;
    int count = 0;
    for (int i = 0; i < 300; ++i)
        for (int k = 0; k < 300; ++k) {
            // Along and across.
            const double along = 0.1 + 0.8 * (i + 0.5) / 300, across = 0.2 * ((k + 0.5) / 300 - 0.5);
            const Point2 p{along + across, along - across};
            sum += std::abs(a(p) - b(p));
            ++count;
        }
    return sum / count;
}

bench::HeightField traceOnGrid(std::size_t side)
{
    bench::HeightField field(side, 30);
    for (int i = 0; i < Stamps; ++i) {
        field.press(stampAt(i).x, stampAt(i).y, TraceRadius, TraceDepth);
        field.settle();
    }
    return field;
}

/// The same on a TIN that is two triangles to begin with: ground under the ball as fine as `spacing`, what slides and
/// what it slides over too; what is flat afterwards, to `error`, goes.
Tin traceOnTin(double spacing, double error)
{
    Tin tin(Rectangle{{0, 0}, {1, 1}});
    ErosionSettings settings;
    settings.longestEdge = spacing;
    Erosion erosion = *Erosion::create(settings, {});
    DiscSearch search;
    for (int i = 0; i < Stamps; ++i) {
        const Point2 centre = stampAt(i);
        TinEdit edit(tin);
        const double outer = 1.5 * TraceRadius;
        search.search(tin, centre, outer);
        std::uint32_t added = 0;
        splitLongEdges(edit, search.triangles(), spacing, 1000000, added);
        search.search(tin, centre, outer);
        double dug = 0, rim = 0;
        for (const VertexId v : search.vertices()) {
            const Point2 p = tin.arrays().points[v];
            const double distance = std::hypot(p.x - centre.x, p.y - centre.y) / TraceRadius;
            if (distance >= 1) {
                rim += edit.areaOf(v);
                continue;
            }
            const double floor = -TraceDepth * std::sqrt(1 - distance * distance), before = tin.arrays().heights[v];
            if (floor < before) {
                dug += (before - floor) * edit.areaOf(v);
                edit.setHeight(v, floor);
            }
        }
        for (const VertexId v : search.vertices()) {
            const Point2 p = tin.arrays().points[v];
            if (std::hypot(p.x - centre.x, p.y - centre.y) >= TraceRadius)
                edit.setHeight(v, tin.arrays().heights[v] + dug / rim);
        }
        benchmark::DoNotOptimize(erosion.settle(edit));
        if (i % 8 == 7 || i + 1 == Stamps) {
            std::vector<VertexId> all(tin.arrays().vertexSlots());
            for (VertexId v = 0; v < all.size(); ++v)
                all[v] = v;
            for (int pass = 0; pass < 3; ++pass)
                removeRedundant(edit, all, error, AnyAngle);
        }
        edit.commit();
    }
    return tin;
}

void traceGrid(benchmark::State &state)
{
    static const bench::HeightField Fine = traceOnGrid(401);
    double error = 0, bytes = 0;
    for (auto _ : state) {
        const bench::HeightField field = traceOnGrid(std::size_t(state.range(0)));
        state.PauseTiming();
        bytes = double(field.byteSize());
        error = meanDifference([&](Point2 p) { return field.heightAt(p.x, p.y); },
                               [&](Point2 p) { return Fine.heightAt(p.x, p.y); });
        state.ResumeTiming();
    }
    state.counters["bytes"] = bytes;
    state.counters["error"] = error;
}

void traceTin(benchmark::State &state)
{
    static const Tin Fine = traceOnTin(0.003, 1e-5);
    double error = 0, bytes = 0, vertices = 0;
    for (auto _ : state) {
        const auto simple = simplifyTin(traceOnTin(double(state.range(0)) * 1e-4, SmallestError), TraceError);
        const Tin &tin = *simple;
        state.PauseTiming();
        bytes = double(tin.byteSize());
        vertices = tin.vertexCount();
        error = meanDifference([&](Point2 p) { return tin.heightAt(p); }, [&](Point2 p) { return Fine.heightAt(p); });
        state.ResumeTiming();
    }
    state.counters["bytes"] = bytes;
    state.counters["vertices"] = vertices;
    state.counters["error"] = error;
}

void columnArguments(benchmark::internal::Benchmark *table)
{
    table->Args({40000, 1, 0, 185, 0})->Args({40000, 2, 0, 185, 0})->Args({40000, 1, 0, 100, 0});
    table->Args({40000, 1, 0, 185, 1})->Args({40000, 1, 1, 185, 0})->Args({40000, 1, 3, 185, 0});
    table->Unit(benchmark::kMillisecond)->UseRealTime()->Repetitions(3)->ReportAggregatesOnly(false);
}

BENCHMARK(erosionSweep)
    ->Args({1000000, 1, 0})
    ->Args({1000000, 2, 0})
    ->Args({1000000, 1, 3})
    ->Args({1000000, 2, 3})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(erosionColumn)->Apply(columnArguments);
BENCHMARK(erosionBrush)->Args({1000000, 1})->Args({1000000, 2})->UseRealTime()->Unit(benchmark::kMicrosecond);
BENCHMARK(traceGrid)->Arg(76)->Arg(151)->Arg(226)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(traceTin)->Arg(75)->Arg(100)->Unit(benchmark::kMillisecond)->Iterations(1);

} // namespace
