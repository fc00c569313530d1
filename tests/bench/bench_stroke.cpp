// SPDX-License-Identifier: GPL-3.0-or-later
// A stroke as the editor draws it, erosion on: from the pen's event until the document is changed, in processor time
// (what neighbours on the machine take does not count), and the same by the clock on the wall. Prints a line for each
// tool and size: build/release/bin/sandreel-bench-stroke [largest size].
#include "views/sculpt/strokecontroller.h"
#include "views/sculpt/toolvalues.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QThread>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>

namespace {

using namespace model::terrain;

Terrain dunes(std::size_t count)
{
    std::mt19937_64 random(1);
    const auto unit = [&] { return double(random() >> 11) * 0x1p-53; };
    std::vector<Point3> points(count);
    for (Point3 &p : points) {
        p = {unit(), unit(), 0};
        p.z = 0.02 * std::sin(20 * p.x) * std::cos(14 * p.y);
    }
    return Terrain(std::move(buildTin(points, {{0, 0}, {1, 1}})->tin));
}

double at(std::vector<double> times, double share)
{
    std::sort(times.begin(), times.end());
    return times.empty() ? 0 : times[std::min(times.size() - 1, std::size_t(share * double(times.size())))];
}

double processorMilliseconds()
{
    timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

/// Of one piece of work, by both clocks, in milliseconds.
class Part
{
public:
    Part() { mWall.start(); }
    double wall() const { return double(mWall.nsecsElapsed()) * 1e-6; }
    double processor() const { return processorMilliseconds() - mBegan; }

private:
    QElapsedTimer mWall;
    double mBegan = processorMilliseconds();
};

struct Spread
{
    std::vector<double> processor, wall;

    void add(const Part &part)
    {
        wall.push_back(part.wall());
        processor.push_back(part.processor());
    }
    void print(const char *what) const
    {
        std::printf("  %5zu %s  p50 %.2f ms  p99 %.2f ms  worst %.2f ms  (wall p99 %.2f ms)", wall.size(), what,
                    at(processor, 0.5), at(processor, 0.99), at(processor, 1), at(wall, 0.99));
    }
};

struct Times
{
    Spread events; ///< in the event's handler
    Spread frames; ///< of the erosion's steps, and of stamps that were put off
    double seconds = 0;
    std::size_t active = 0;

    void print(const char *tool, std::size_t size, std::size_t vertices) const
    {
        std::printf("%-10s %9zu", tool, size);
        events.print("events");
        frames.print("frames");
        std::printf("  %7zu active  %zu vertices after\n", active, vertices);
        std::fflush(stdout);
    }
};

/// Loops of a curve at 125 events a second, for `seconds`; between them the event loop runs, and with it the erosion.
Times drawn(commands::TerrainContext &context, views::ToolSettings &settings, double seconds)
{
    views::StrokeController controller(context, settings, nullptr);
    Times times;
    constexpr double EventsPerSecond = 125;
    QElapsedTimer clock;
    clock.start();
    for (int i = 0; i < int(seconds * EventsPerSecond); ++i) {
        const double t = i / EventsPerSecond;
        views::GroundEvent event;
        event.point = {0.5 + 0.3 * std::cos(1.7 * t), 0.5 + 0.3 * std::sin(2.3 * t), 0};
        event.time = std::uint64_t(1e3 * t);
        const Part handling;
        if (i == 0)
            controller.press(event);
        else
            controller.move(event);
        times.events.add(handling);
        while (double(clock.elapsed()) < 1e3 * (t + 1 / EventsPerSecond)) {
            const Part frame;
            QCoreApplication::processEvents();
            if (frame.wall() > 0.05)
                times.frames.add(frame);
            QThread::usleep(200);
        }
        times.active = std::max(times.active, controller.flow().figures().activeTriangles);
    }
    views::GroundEvent event;
    event.point = {0.5, 0.5, 0};
    controller.cancel();
    return times;
}

} // namespace

int main(int argc, char **argv)
{
    QCoreApplication app(argc, argv);
    const std::size_t largest = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1000000;
    for (std::size_t size = 100000; size <= largest; size *= 10) {
        const Terrain terrain = dunes(size);
        for (const char *name : {"imprint", "rake", "raise"}) {
            model::TerrainDocument document(terrain);
            commands::TerrainContext context(document);
            views::ToolSettings settings;
            for (std::size_t kind = 0; kind < settings.tools().size(); ++kind)
                if (std::string(nameOf(settings.tools()[kind])) == name)
                    settings.choose(kind);
            const Times times = drawn(context, settings, 8);
            times.print(name, size, document.tin().vertexCount());
        }
    }
    return 0;
}
