// SPDX-License-Identifier: GPL-3.0-or-later
// How long the window of a terrain is deaf: the longest single event of the editor's thread while the camera turns,
// while it rests afterwards, and while somebody digs. On a busy machine the processor time tells more than the clock.
// xvfb-run -a build/release/bin/sandreel-bench-terrainview [vertices].
#include "model/document/terraindocument.h"
#include "views/terrain/terrainviewport.h"
#include "views/viewport/glsupport.h"

#include <QApplication>
#include <QElapsedTimer>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>

namespace {

using namespace model::terrain;

class TimedApplication final : public QApplication
{
public:
    using QApplication::QApplication;

    bool notify(QObject *receiver, QEvent *event) override
    {
        if (mDepth++ > 0) {
            const bool isTaken = QApplication::notify(receiver, event);
            --mDepth;
            return isTaken;
        }
        QElapsedTimer clock;
        clock.start();
        const std::clock_t before = std::clock();
        const bool isTaken = QApplication::notify(receiver, event);
        --mDepth;
        longest = std::max(longest, double(clock.nsecsElapsed()) * 1e-6);
        mostWork = std::max(mostWork, 1e3 * double(std::clock() - before) / CLOCKS_PER_SEC);
        return isTaken;
    }
    void print(const char *what)
    {
        std::printf("%-16s longest event %7.1f ms, of all threads %7.1f ms of processor", what, longest, mostWork);
        longest = mostWork = 0;
    }
    double longest = 0, mostWork = 0; ///< milliseconds

private:
    int mDepth = 0;
};

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

void wait(TimedApplication &application, const views::TerrainViewport &viewport, const char *what)
{
    QElapsedTimer clock;
    clock.start();
    do
        QApplication::processEvents(QEventLoop::WaitForMoreEvents, 20);
    while (viewport.isLoading());
    application.print(what);
    std::printf("   until exact %7.0f ms\n", double(clock.nsecsElapsed()) * 1e-6);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char **argv)
{
    views::setDefaultGlFormat();
    TimedApplication application(argc, argv);
    const auto size = std::size_t(argc > 1 ? std::atol(argv[1]) : 1'000'000);
    model::TerrainDocument document(dunes(size));
    views::TerrainViewport viewport(document);
    viewport.resize(1280, 720);
    viewport.show();
    wait(application, viewport, "opened");
    for (const auto &[quality, name] :
         {std::pair(views::GroundQuality::Low, "low"), std::pair(views::GroundQuality::Medium, "medium"),
          std::pair(views::GroundQuality::High, "high")}) {
        views::TerrainStyle style = viewport.style();
        style.quality = quality;
        viewport.setStyle(style);
        wait(application, viewport, name);
        for (int i = 0; i < 30; ++i) {
            model::OrbitCamera camera = viewport.camera();
            camera.orbit(0.01f, i < 15 ? 0.004f : -0.004f);
            viewport.setCamera(camera);
            QApplication::processEvents();
        }
        application.print("  camera turned");
        std::printf("\n");
        wait(application, viewport, "  camera rests");
        for (int i = 0; i < 40; ++i) {
            const double x = 0.3 + 0.01 * i;
            const TinArrays &tin = document.tin().arrays();
            document.edit([&](TinEdit &edit) {
                for (VertexId v = 0; v < tin.vertexSlots(); ++v)
                    if (std::abs(tin.points[v].x - x) < 0.02 && std::abs(tin.points[v].y - 0.5) < 0.02)
                        edit.setHeight(v, tin.heights[v] - 0.002);
            });
            QApplication::processEvents();
        }
        wait(application, viewport, "  40 stamps");
        document.edit([&](TinEdit &edit) { // as an erosion that has seized a third of the terrain
            const TinArrays &tin = edit.tin().arrays();
            for (VertexId v = 0; v < tin.vertexSlots(); v += 3)
                edit.setHeight(v, tin.heights[v] - 1e-4);
        });
        wait(application, viewport, "  a third moved");
    }
    return 0;
}
