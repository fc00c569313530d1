// SPDX-License-Identifier: GPL-3.0-or-later
// The TIN against CGAL's Constrained_Delaunay_triangulation_2 on the same random points in the same run, taken in
// turns.
#include "tests/bench/terrain/table.h"

#include "model/terrain/tin/tinedit.h"

#include <cstdio>

namespace bench {

namespace {

using namespace model::terrain;

constexpr Rectangle Domain{{0, 0}, {1, 1}};
constexpr std::size_t Batch = 10000; ///< operations that are timed together
constexpr int Rounds = 7;

void print(const char *name, std::size_t size, const Fastest &ours, const Fastest &cgal, double scale, const char *unit)
{
    std::printf("%-24s %9zu  ours %8.3f %s  CGAL %8.3f %s  ratio %.2f\n", name, size, ours.seconds * scale, unit,
                cgal.seconds * scale, unit, ours.seconds / cgal.seconds);
    std::fflush(stdout);
}

void benchBuild(std::size_t size)
{
    const std::vector<Point3> points = randomPoints(size, 1);
    Fastest ours, cgal;
    double bytes = 0, layered = 0;
    for (int round = 0; round < (size > 2000000 ? 2 : 3); ++round) {
        {
            const Stopwatch stopwatch;
            auto built = buildTin(points, Domain);
            ours.add(stopwatch.seconds());
            Tin &tin = built->tin;
            bytes = double(tin.byteSize()) / tin.vertexCount();
            TinEdit edit(tin);
            for (std::uint32_t layer = 0; layer < 3; ++layer)
                edit.addLayer(layer, 0);
            edit.commit();
            layered = double(tin.byteSize()) / tin.vertexCount();
        }
        cgal.add(CgalTriangulation().build(points));
    }
    print("build", size, ours, cgal, 1, "s ");
    std::printf("%-24s %9zu  ours %8.1f bytes a vertex (arrays, hints and marks), with three layers %.1f\n", "memory",
                size, bytes, layered);
    std::fflush(stdout);
}

void benchOperations(std::size_t size)
{
    Tin tin = std::move(buildTin(randomPoints(size, 1), Domain)->tin);
    CgalTriangulation cgal;
    cgal.build(randomPoints(size, 1));
    const std::vector<Point3> points = randomPoints(Batch, 2);
    std::vector<VertexId> near, inserted(Batch);
    for (const Point3 &p : points)
        near.push_back(tin.arrays().vertex(tin.locate({p.x, p.y}).corner));
    cgal.findHints(points);
    Fastest insert, cgalInsert, insertGivingBack, remove, cgalRemove, nearBy, cgalNearBy, anywhere, undo;
    for (int round = 0; round < Rounds; ++round) {
        std::size_t odd = 0;
        {
            const Stopwatch stopwatch;
            for (std::size_t i = 0; i < Batch; ++i)
                odd += tin.locate({points[i].x, points[i].y}, near[i]).corner == NoCorner;
            nearBy.add(stopwatch.seconds());
        }
        cgalNearBy.add(cgal.locate(points));
        {
            const Stopwatch stopwatch;
            for (const Point3 &p : points)
                odd += tin.locate({p.x, p.y}).corner == NoCorner;
            anywhere.add(stopwatch.seconds());
        }
        // With the journal, the leak and all that a commit does; as tools do it, without spreading the leak over all.
        Stopwatch stopwatch;
        TinEdit putting(tin, VolumeRule::Keep);
        for (std::size_t i = 0; i < Batch; ++i)
            inserted[i] = putting.insert({points[i].x, points[i].y}, near[i]);
        Edit put = putting.commit();
        insert.add(stopwatch.seconds());
        cgalInsert.add(cgal.insert(points));
        stopwatch = Stopwatch();
        TinEdit taking(tin, VolumeRule::Keep);
        for (const VertexId v : inserted)
            taking.remove(v);
        Edit taken = taking.commit();
        remove.add(stopwatch.seconds());
        cgalRemove.add(cgal.remove());
        stopwatch = Stopwatch();
        tin.swap(taken);
        undo.add(stopwatch.seconds());
        tin.swap(put);
        stopwatch = Stopwatch();
        TinEdit giving(tin, VolumeRule::GiveBack);
        for (std::size_t i = 0; i < Batch; ++i)
            giving.insert({points[i].x, points[i].y}, near[i]);
        Edit given = giving.commit();
        insertGivingBack.add(stopwatch.seconds());
        tin.swap(given);
        if (odd)
            std::printf("lost\n");
    }
    const double each = 1e6 / double(Batch);
    print("insert from a hint", size, insert, cgalInsert, each, "us");
    std::printf("%-24s %9zu  ours %8.3f us\n", "and its volume spread", size, insertGivingBack.seconds * each);
    print("remove", size, remove, cgalRemove, each, "us");
    print("locate from a hint", size, nearBy, cgalNearBy, each, "us");
    std::printf("%-24s %9zu  ours %8.3f us\n", "locate anywhere", size, anywhere.seconds * each);
    std::printf("%-24s %9zu  ours %8.3f us a vertex\n", "undo of removals", size, undo.seconds * each);
}

} // namespace

void printTriangulation(std::size_t largest)
{
    const std::size_t middle = std::min<std::size_t>(largest, 1000000);
    benchBuild(middle);
    if (largest > middle)
        benchBuild(largest);
    benchOperations(middle);
}

} // namespace bench
