// SPDX-License-Identifier: GPL-3.0-or-later
// What is left of the volume: the ledger against the sum over all triangles.
#include "model/terrain/erosion/erosion.h"
#include "model/terrain/tools/stroke.h"
#include "tests/bench/terrain/table.h"

#include <cmath>
#include <cstdio>
#include <random>

namespace bench {

namespace {

using namespace model::terrain;

double driftOf(const Tin &tin)
{
    const double expected = tin.ledger().expected();
    return std::abs(tin.volume() - expected) / std::abs(expected);
}

Tin raised(std::size_t size)
{
    std::vector<Point3> points = randomPoints(size, 1);
    for (Point3 &p : points)
        p.z = 1 + p.z / 64;
    return std::move(buildTin(points, {{0, 0}, {1, 1}})->tin);
}

/// The worst of some strokes of 40 stamps.
double strokeDrift()
{
    Tin tin = raised(100000);
    std::mt19937 random(2);
    const auto place = [&] { return 0.2 + 0.6 * double(random()) / 4294967296.0; };
    double worst = 0;
    ToolMemory memory;
    OwnerId owner = 1;
    for (int i = 0; i < 10; ++i) {
        Imprint tool;
        tool.radius = 0.02;
        tool.depth = 0.01;
        const auto done =
            draw(tin, {tool, {{{place(), place()}, 1, 0}, {{place(), place()}, 1, 0}}, {}}, owner, memory);
        owner = done->report.nextOwner;
        worst = std::max(worst, driftOf(tin));
    }
    return worst;
}

/// Vertices, constraints, heights and removals, each edit followed by erosion.
double mixedDrift(int edits)
{
    Tin tin = raised(5000);
    ErosionSettings settings;
    settings.flatError = 1e-3;
    Erosion erosion = *Erosion::create(settings, {});
    std::mt19937 random(3);
    const auto unit = [&] { return double(random()) / 4294967296.0; };
    double worst = 0;
    for (int i = 0; i < edits; ++i) {
        TinEdit edit(tin, i % 3 ? VolumeRule::GiveBack : VolumeRule::Keep);
        const VertexId v = edit.insert({unit(), unit()});
        const auto other = VertexId(random() % tin.arrays().vertexSlots());
        if (i % 5 == 0)
            (void)edit.constrain(v, v == 3 ? 2 : 3, OwnerId(i), Crossing::Split);
        else if (i % 5 == 1)
            edit.releaseOwner(OwnerId(i - 1));
        else if (i % 5 == 2 && tin.arrays().isVertex(other) && edit.canRemove(other))
            edit.remove(other);
        else
            edit.setHeight(v, tin.arrays().heights[v] + unit() * 0.1 - 0.05);
        const Edit done = edit.commit();
        erosion.activate(tin, done);
        TinEdit slide(tin);
        (void)erosion.run(slide, 0.02);
        slide.commit();
        if (i % 100 == 99)
            worst = std::max(worst, driftOf(tin));
    }
    return worst;
}

} // namespace

void printBooks()
{
    std::printf("%-24s %9d  %.1e of the whole\n", "volume after a stroke", 100000, strokeDrift());
    std::printf("%-24s %9d  %.1e of the whole\n", "after mixed edits", 10000, mixedDrift(10000));
    std::fflush(stdout);
}

} // namespace bench
