// SPDX-License-Identifier: GPL-3.0-or-later
// Erosion: how fast material moves, and the column of dry sand until it rests.
#include "model/base/parallel.h"
#include "model/terrain/erosion/erosion.h"
#include "tests/bench/terrain/table.h"

#include <atomic>
#include <cmath>
#include <cstdio>
#include <random>
#include <thread>

namespace bench {

namespace {

using namespace model;
using namespace model::terrain;

constexpr double Degree = M_PI / 180;

void addLayers(Tin &tin, std::uint32_t count, double thickness)
{
    TinEdit edit(tin);
    for (std::uint32_t layer = 0; layer < count; ++layer) {
        edit.addLayer(layer, 0);
        for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v)
            edit.setLayer(v, layer, {thickness, 0});
    }
    edit.commit();
}

/// Transfers in a second, of processors and on the wall.
struct Rate
{
    double processor = 0, wall = 0;
};

/// The first sweeps over much steep ground: nearly every triangle moves, in cells enough for any number of threads.
Rate sweepRate(const Tin &tin, unsigned threads)
{
    const Material sand = material(MaterialPreset::DrySand);
    const SlopeTable slopes(tin.arrays().totals.layers, std::span(&sand, 1), sand);
    Patch::Ids ids;
    Rate best;
    for (int round = 0; round < 3; ++round) {
        Patch patch(tin, slopes, sand, ids);
        for (TriangleId t = 0; t < tin.arrays().triangleSlots(); ++t)
            patch.add(t);
        const SweepRule rule{ErosionRule::Face, 1.85, Erosion::RestTolerance, Erosion::RestTolerance / 2};
        Team::run(
            [&](Team &team) {
                patch.sweep(team, rule, Progress());
                const WallClock clock;
                const Stopwatch stopwatch;
                double transfers = 0;
                for (int i = 0; i < 10; ++i)
                    transfers += double(patch.sweep(team, rule, Progress()).transfers);
                best.wall = std::max(best.wall, transfers / clock.seconds());
                best.processor = std::max(best.processor, transfers / stopwatch.seconds());
            },
            threads);
    }
    return best;
}

void benchTransfers(std::size_t size)
{
    for (const std::uint32_t layers : {0u, 3u}) {
        std::vector<Point3> points = randomPoints(size, 1);
        for (Point3 &p : points)
            p.z = std::sin(40 * p.x) * std::cos(40 * p.y) * 0.1;
        Tin tin = std::move(buildTin(points, {{0, 0}, {1, 1}})->tin);
        if (layers > 0)
            addLayers(tin, layers, 0.2);
        const Rate one = sweepRate(tin, 1), two = sweepRate(tin, 2);
        std::printf(
            "%-24s %9zu  one thread %.1f M/s (%.1f on the wall)  two %.1f M/s on the wall, %.2f x  layers: %u\n",
            "transfers", size, 1e-6 * one.processor, 1e-6 * one.wall, 1e-6 * two.wall, two.wall / one.wall, layers);
        std::fflush(stdout);
    }
}

void benchColumn(const char *name, const ErosionSettings &settings, int rounds)
{
    constexpr std::size_t Vertices = 40000;
    Erosion erosion = *Erosion::create(settings, {});
    Tin tin = column(Vertices);
    const double volume = tin.volume();
    Fastest processor, wall;
    std::uint64_t transfers = 0;
    double slope = 0, height = 0, width = 0, drift = 0;
    for (int round = 0; round < rounds; ++round) {
        TinEdit edit(tin);
        const WallClock clock;
        const Stopwatch stopwatch;
        transfers = erosion.settle(edit)->transfers;
        Edit done = edit.commit();
        wall.add(clock.seconds());
        processor.add(stopwatch.seconds());
        double top = 0, covered = 0;
        for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v) {
            top = std::max(top, tin.arrays().heights[v]);
            covered += tin.arrays().heights[v] > 1e-9 ? dualArea(tin.arrays(), v) : 0;
        }
        const double critical = std::tan(30 * Degree), radius = std::cbrt(3 * volume / (M_PI * critical));
        slope = steepestFace(tin);
        height = 100 * (top / (radius * critical) - 1);
        width = 100 * (std::sqrt(covered / M_PI) / radius - 1);
        drift = tin.volume() / volume - 1;
        tin.swap(done);
    }
    std::printf(
        "%-24s %9zu  %.3f s (%.3f s of processors)  %.1f M transfers  steepest %.2f deg  cone %+.1f %% high, %+.1f %% "
        "wide  volume %+.0e\n",
        name, Vertices, wall.seconds, processor.seconds, 1e-6 * double(transfers), slope, height, width, drift);
    std::fflush(stdout);
}

/// Cancelled at many moments, on a terrain of hills that take seconds: from the word until settle() has returned.
void benchCancel(std::size_t size)
{
    std::vector<Point3> points = randomPoints(size, 1);
    for (Point3 &p : points)
        p.z = std::sin(12 * p.x) * std::cos(12 * p.y) * 0.3;
    Tin tin = std::move(buildTin(points, {{0, 0}, {1, 1}})->tin);
    ErosionSettings settings;
    settings.longestEdge = 1.5 / std::sqrt(double(size));
    settings.flatError = 1e-4;
    double longest = 0, processor = 0;
    constexpr int Cancels = 12;
    std::mt19937 random(5);
    for (int i = 0; i < Cancels; ++i) {
        settings.hasCoarsePass = i % 2 == 1;
        Erosion erosion = *Erosion::create(settings, {});
        const Progress progress;
        std::atomic<bool> isOver = false;
        TinEdit edit(tin);
        std::thread settling([&] {
            (void)erosion.settle(edit, progress);
            isOver = true;
        });
        std::this_thread::sleep_for(std::chrono::milliseconds(random() % 2500));
        const bool wasOver = isOver;
        const WallClock clock;
        const Stopwatch stopwatch;
        progress.cancel();
        settling.join();
        if (!wasOver) {
            longest = std::max(longest, clock.seconds());
            processor = std::max(processor, stopwatch.seconds());
        }
        edit.rollBack();
    }
    std::printf("%-24s %9zu  %d cancels, the longest %.0f ms (%.0f ms of processors)\n", "settling is cancelled", size,
                Cancels, 1e3 * longest, 1e3 * processor);
    std::fflush(stdout);
}

} // namespace

Tin column(std::size_t vertices)
{
    std::vector<Point3> points = randomPoints(vertices, 1);
    for (Point3 &p : points)
        p.z = std::hypot(p.x - 0.5, p.y - 0.5) < 0.1 ? 0.5 : 0;
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

void printSliding(std::size_t largest)
{
    const std::size_t size = std::min<std::size_t>(largest, 1000000);
    benchTransfers(size);
    setThreadCount(1);
    benchColumn("column, one thread", {}, 3);
    setThreadCount(0);
    benchColumn("column", {}, 3);
    ErosionSettings settings;
    settings.hasCoarsePass = true;
    benchColumn("and coarsely first", settings, 3);
    settings = {};
    settings.relaxation = 1;
    benchColumn("by plain relaxation", settings, 1);
    benchCancel(size);
}

} // namespace bench
