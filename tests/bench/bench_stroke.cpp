// SPDX-License-Identifier: GPL-3.0-or-later
// A stroke as the editor draws it, erosion on: from the pen's event until the document is changed. Prints one line for
// each size: build/release/bin/sandreel-bench-stroke [largest size].
#include "views/sculpt/strokecontroller.h"
#include "views/sculpt/toolvalues.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QThread>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
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

struct Times
{
    std::vector<double> events; ///< milliseconds in the event's handler
    std::vector<double> frames; ///< of the erosion's steps, and of stamps that were put off
    double seconds = 0;
    std::size_t active = 0;

    void print(const char *tool, std::size_t size, std::size_t vertices) const
    {
        std::printf("%-10s %9zu  %6zu events  p50 %.2f ms  p99 %.2f ms  worst %.2f ms   %6zu frames  p50 %.2f ms  p99 "
                    "%.2f ms  %7zu active  %zu vertices after\n",
                    tool, size, events.size(), at(events, 0.5), at(events, 0.99), at(events, 1), frames.size(),
                    at(frames, 0.5), at(frames, 0.99), active, vertices);
        std::fflush(stdout);
    }
};

/// Loops of a curve at 125 events a second, for `seconds`; between them the event loop runs, and with it the erosion.
Times drawn(commands::TerrainContext &context, views::ToolSettings &settings, double seconds)
{
    views::StrokeController controller(context, settings, nullptr);
    Times times;
    constexpr double EventsPerSecond = 125;
    QElapsedTimer clock, part;
    clock.start();
    for (int i = 0; i < int(seconds * EventsPerSecond); ++i) {
        const double t = i / EventsPerSecond;
        views::GroundEvent event;
        event.point = {0.5 + 0.3 * std::cos(1.7 * t), 0.5 + 0.3 * std::sin(2.3 * t), 0};
        event.time = std::uint64_t(1e3 * t);
        part.start();
        if (i == 0)
            controller.press(event);
        else
            controller.move(event);
        times.events.push_back(double(part.nsecsElapsed()) * 1e-6);
        while (double(clock.elapsed()) < 1e3 * (t + 1 / EventsPerSecond)) {
            part.start();
            QCoreApplication::processEvents();
            if (const double took = double(part.nsecsElapsed()) * 1e-6; took > 0.05)
                times.frames.push_back(took);
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
