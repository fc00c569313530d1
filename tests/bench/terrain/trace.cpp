// SPDX-License-Identifier: GPL-3.0-or-later
// The trace: balls of radius 0.04, 40 of them pressed 0.1 deep along 80 % of the diagonal of a unit square, after each
// of which the ground settles. On a TIN, and on a regular grid of the same vertical error.
#include "model/terrain/erosion/erosion.h"
#include "model/terrain/erosion/refine.h"
#include "model/terrain/simplify/simplifytin.h"
#include "model/terrain/tin/query/disc.h"
#include "tests/bench/terrain/heightfield.h"
#include "tests/bench/terrain/table.h"

#include <cmath>
#include <cstdio>

namespace bench {

namespace {

using namespace model::terrain;

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

HeightField traceOnGrid(std::size_t side)
{
    HeightField field(side, 30);
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
        (void)erosion.settle(edit);
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

} // namespace

void printTrace()
{
    const HeightField fineField = traceOnGrid(401);
    const Tin fineTin = traceOnTin(0.003, 1e-5);
    const Stopwatch onTin;
    const auto tin = simplifyTin(traceOnTin(0.0075, SmallestError), TraceError);
    const double tinSeconds = onTin.seconds();
    const double tinError =
        meanDifference([&](Point2 p) { return tin->heightAt(p); }, [&](Point2 p) { return fineTin.heightAt(p); });
    const Stopwatch onGrid;
    const HeightField field = traceOnGrid(151);
    const double gridSeconds = onGrid.seconds();
    const double gridError = meanDifference([&](Point2 p) { return field.heightAt(p.x, p.y); },
                                            [&](Point2 p) { return fineField.heightAt(p.x, p.y); });
    std::printf(
        "%-24s %9u  TIN %zu bytes, %.2f mm off, %.2f s  grid of 151 x 151 %zu bytes, %.2f mm off, %.2f s  ratio of "
        "memory %.2f\n",
        "trace", tin->vertexCount(), tin->byteSize(), 1e3 * tinError, tinSeconds, field.byteSize(), 1e3 * gridError,
        gridSeconds, double(tin->byteSize()) / double(field.byteSize()));
    std::fflush(stdout);
}

} // namespace bench
