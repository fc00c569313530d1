// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/terrain/table.h"

#include "model/terrain/tools/stroke.h"

#include <cmath>
#include <cstdio>
#include <random>

namespace bench {

namespace {

using namespace model::terrain;

/// A stamp somewhere in the middle of the domain, whole.
Stroke stampAt(std::mt19937 &random, double radius)
{
    const auto place = [&] { return 0.2 + 0.6 * double(random()) / 4294967296.0; };
    Imprint tool;
    tool.radius = radius;
    tool.depth = radius / 2;
    const Point2 p{place(), place()};
    return {tool, {{p, 1, 0}}, {}};
}

struct Times
{
    std::vector<double> draw, undo;

    static double at(std::vector<double> times, double share)
    {
        std::sort(times.begin(), times.end());
        return times[std::min(times.size() - 1, std::size_t(share * double(times.size())))];
    }
};

/// Waves that rise by a seventh at most: few vertices under a tool lie deeper than its sole.
Tin gentleGround(std::size_t size)
{
    std::vector<Point3> points = randomPoints(size, 1);
    for (Point3 &p : points)
        p.z *= 1.0 / 64;
    return std::move(buildTin(points, {{0, 0}, {1, 1}})->tin);
}

/// Stamps that are undone one by one: each finds the TIN as it was built.
Times stampTimes(Tin &tin, double radius, int count)
{
    Times times;
    ToolMemory memory;
    std::mt19937 random(6);
    for (int i = 0; i < count; ++i) {
        const Stroke stroke = stampAt(random, radius);
        Stopwatch stopwatch;
        auto done = draw(tin, stroke, 1, memory);
        if (i > 0) // the first one makes the marks
            times.draw.push_back(stopwatch.seconds());
        stopwatch = Stopwatch();
        tin.swap(done->edit);
        times.undo.push_back(stopwatch.seconds());
    }
    return times;
}

} // namespace

void printStamps(std::size_t largest)
{
    largest = std::min<std::size_t>(largest, 1000000);
    for (std::size_t size = largest / 100; size <= largest; size *= 10) {
        Tin tin = gentleGround(size);
        const double hundred = std::sqrt(100 / (M_PI * double(size)));
        const Times times = stampTimes(tin, hundred, 1000);
        std::printf("%-24s %9zu  p50 %.3f ms  p99 %.3f ms  undo p50 %.3f ms  p99 %.3f ms\n", "stamp on 100 vertices",
                    size, Times::at(times.draw, 0.5) * 1e3, Times::at(times.draw, 0.99) * 1e3,
                    Times::at(times.undo, 0.5) * 1e3, Times::at(times.undo, 0.99) * 1e3);
        std::fflush(stdout);
        if (size < largest)
            continue;
        const Times large = stampTimes(tin, 0.04, 50);
        std::printf("%-24s %9zu  p50 %.3f ms  fastest %.3f ms\n", "stamp of radius 0.04", size,
                    Times::at(large.draw, 0.5) * 1e3, Times::at(large.draw, 0) * 1e3);
        ToolMemory memory;
        std::mt19937 random(7);
        std::vector<Edit> edits;
        OwnerId owner = 1;
        for (int i = 0; i < 200; ++i) {
            auto done = draw(tin, stampAt(random, hundred), owner, memory);
            owner = done->report.nextOwner;
            edits.push_back(std::move(done->edit));
        }
        const Stopwatch stopwatch;
        for (std::size_t i = edits.size(); i-- > 0;)
            tin.swap(edits[i]);
        std::printf("%-24s %9zu  %.3f ms\n", "undo of 200 stamps", size, stopwatch.seconds() * 1e3);
    }
}

} // namespace bench
