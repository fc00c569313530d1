// SPDX-License-Identifier: GPL-3.0-or-later
// Saving and opening terrains: random points, a thousand grid cells apart on average, heights of hills on the same
// grid; the fastest of some rounds, through files.
#include "model/io/terrain/terrainfile.h"
#include "model/terrain/simplify/simplifygrid.h"
#include "model/terrain/tin/tinedit.h"
#include "tests/bench/terrain/table.h"

#include <QFileInfo>
#include <QTemporaryDir>

#include <cmath>
#include <cstdio>
#include <random>

namespace bench {

namespace {

using namespace model;
using namespace model::terrain;

constexpr int Rounds = 3;

struct Took
{
    Fastest wall, processor;

    template <class Work>
    explicit Took(Work work)
    {
        for (int round = 0; round < Rounds; ++round) {
            const WallClock clock;
            const Stopwatch stopwatch;
            work();
            wall.add(clock.seconds());
            processor.add(stopwatch.seconds());
        }
    }
};

Terrain randomTerrain(std::size_t count)
{
    const double side = std::ceil(std::sqrt(double(count)));
    std::mt19937_64 random(1);
    const auto onGrid = [](double value) { return std::nearbyint(value * 1024) / 1024; };
    std::vector<Point3> points(count);
    for (Point3 &p : points) {
        p.x = onGrid(double(random() >> 11) * 0x1p-53 * side);
        p.y = onGrid(double(random() >> 11) * 0x1p-53 * side);
        p.z = onGrid(30 * std::sin(p.x * 0.01) * std::cos(p.y * 0.013) + 5 * std::sin(p.x * 0.1) +
                     0.5 * std::sin(p.y * 0.7 + p.x * 0.3));
    }
    return Terrain(buildTin(points, {{0, 0}, {side, side}})->tin);
}

void benchFile(const char *name, const QString &path, const Terrain &terrain)
{
    const Took save([&] { (void)io::saveTerrain(path, terrain, {}); });
    const Took load([&] { (void)io::openTerrain(path); });
    std::printf("%-24s %9u  save %.2f s (%.2f s of processors)  load %.2f s (%.2f s)  %.2f bytes a vertex\n", name,
                terrain.tin.vertexCount(), save.wall.seconds, save.processor.seconds, load.wall.seconds,
                load.processor.seconds, double(QFileInfo(path).size()) / terrain.tin.vertexCount());
    std::fflush(stdout);
}

void benchSimplify(std::uint32_t side)
{
    HeightGrid grid{side, side, 1, 1, {}};
    for (std::uint32_t j = 0; j < side; ++j)
        for (std::uint32_t i = 0; i < side; ++i)
            grid.heights.push_back(30 * std::sin(i * 0.01) * std::cos(j * 0.013) + 5 * std::sin(i * 0.1) +
                                   0.5 * std::sin(j * 0.7 + i * 0.3));
    std::uint32_t vertices = 0;
    const Took time([&] { vertices = simplifyGrid(grid, {0.25, 0x1p-10})->vertexCount(); });
    std::printf("%-24s %9u  to 0.25 m: %u vertices in %.2f s\n", "import of a grid", side * side, vertices,
                time.wall.seconds);
}

} // namespace

void printFiles(std::size_t largest)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath("a.terrain");
    for (const std::size_t size : {std::size_t(100'000), std::size_t(1'000'000), std::size_t(6'000'000)}) {
        if (size > largest)
            break;
        Terrain terrain = randomTerrain(size);
        benchFile("save and load", path, terrain);
        if (size != 1'000'000)
            continue;
        // What erosion leaves: heights with all their bits.
        TinEdit edit(terrain.tin);
        for (VertexId v = 0; v < terrain.tin.arrays().vertexSlots(); ++v)
            edit.setHeight(v, terrain.tin.arrays().heights[v] + 1e-3 / (v + 3));
        edit.commit();
        benchFile("the same, all eroded", path, terrain);
    }
    benchSimplify(2048);
}

} // namespace bench
