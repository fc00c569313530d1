// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/validate.h"
#include "model/terrain/tools/stroke.h"

#include <QTest>
#include <algorithm>

#include <cmath>
#include <random>

namespace tests {

using namespace model::terrain;

/// A flat square at height 1, or a wavy one, of random vertices.
inline Tin ground(std::size_t count, double waves = 0.2, unsigned seed = 5)
{
    std::mt19937_64 random(seed);
    const auto unit = [&] { return double(random() >> 11) * 0x1p-53; };
    std::vector<Point3> points(count);
    for (Point3 &p : points) {
        p = {unit(), unit(), 0};
        p.z = 1 + waves * std::sin(9 * p.x) * std::cos(7 * p.y);
    }
    return std::move(model::terrain::buildTin(points, {{0, 0}, {1, 1}})->tin);
}

inline std::vector<PathPoint> line(Point2 a, Point2 b)
{
    return {{a, 1, 0}, {b, 1, 0}};
}

/// Every promise that all strokes keep: valid, the ledger explains the volume, undo and redo are exact to the byte.
inline StrokeReport drawAndCheck(Tin &tin, const Stroke &stroke, OwnerId owner = None)
{
    const std::uint64_t before = tin.fingerprint();
    const double volume = tin.volume();
    auto done = draw(tin, stroke, owner);
    if (!done) {
        qWarning("stroke refused: %s %s", done.error().args[0].c_str(), done.error().args[1].c_str());
        return {};
    }
    const std::vector<TinDefect> defects = findDefects(tin);
    if (!defects.empty())
        qWarning("%s %u %u %u", nameOf(defects[0].rule), defects[0].ids[0], defects[0].ids[1], defects[0].ids[2]);
    [&] { QVERIFY(defects.empty()); }();
    const std::uint64_t after = tin.fingerprint();
    const double explained = volume + done->report.added - done->report.removed - done->report.compressed;
    [&] {
        QVERIFY2(std::abs(tin.volume() - explained) <= 1e-12 * std::max(1.0, std::abs(volume)),
                 qPrintable(QString::number(tin.volume() - explained)));
        QVERIFY(std::abs(tin.volume() - tin.ledger().expected()) <= 1e-12 * std::max(1.0, std::abs(volume)));
    }();
    tin.swap(done->edit);
    [&] { QCOMPARE(tin.fingerprint(), before); }();
    tin.swap(done->edit);
    [&] { QCOMPARE(tin.fingerprint(), after); }();
    return done->report;
}

/// One of each tool that leaves a mark, `radius` large.
inline std::vector<Tool> everyTool(double radius)
{
    Brush brush;
    brush.radius = radius;
    Imprint imprint;
    imprint.radius = radius;
    imprint.depth = 0.1;
    const auto flat = [](Point2) { return 1.0; };
    return {imprint,
            Rake{2 * radius, 3, 0.02, 0.5, {}},
            Raise{brush, 0.05},
            Lower{brush, 0.05},
            Flatten{brush, 0.5, {}},
            Smooth{brush, 0.5},
            Noise{brush, 0.05, radius, 2, 1},
            Ramp{brush, {}, {}},
            Restore{brush, 0.5, {flat, {}}},
            Pour{brush, 0.001},
            Scoop{brush, 0.05},
            Breakline{radius, {}, Crossing::Split}};
}

/// `path` with `count` points between each two, at random places on the line.
inline std::vector<PathPoint> oversampled(const std::vector<PathPoint> &path, int count, unsigned seed)
{
    std::mt19937 random(seed);
    std::vector<PathPoint> more{path[0]};
    for (std::size_t i = 1; i < path.size(); ++i) {
        std::vector<double> places{1};
        for (int k = 0; k < count; ++k)
            places.push_back(double(random()) / 4294967296.0);
        std::sort(places.begin(), places.end());
        const PathPoint &a = path[i - 1], &b = path[i];
        for (const double t : places)
            more.push_back({{a.at.x + t * (b.at.x - a.at.x), a.at.y + t * (b.at.y - a.at.y)},
                            a.pressure + t * (b.pressure - a.pressure),
                            a.speed + t * (b.speed - a.speed)});
        more.back() = b;
    }
    return more;
}

} // namespace tests
