// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/terrain/erosion/heaps.h"
#include "tests/support/testmain.h"

#include <cmath>
#include <random>

using namespace model;
using namespace model::terrain;

namespace {

constexpr double Degree = M_PI / 180;
constexpr std::array<std::uint32_t, 3> OneTriangle[] = {{0, 1, 2}};

struct Random
{
    std::mt19937 generator{5};
    double operator()(double low, double high) { return low + (high - low) * double(generator()) / 4294967296.0; }
};

/// A triangle, counter-clockwise, not too thin, of random heights and dual areas.
std::vector<PatchVertex> randomTriangle(Random &random)
{
    for (;;) {
        std::vector<PatchVertex> v;
        for (int i = 0; i < 3; ++i)
            v.push_back({random(0, 1), random(0, 1), random(-1, 1), 1 / random(0.1, 1)});
        if ((v[1].x - v[0].x) * (v[2].y - v[0].y) - (v[1].y - v[0].y) * (v[2].x - v[0].x) > 0.05)
            return v;
    }
}

/// The gradient by Cramer's rule on the plane's equations.
std::pair<long double, long double> gradientOfPlane(std::span<const PatchVertex> v)
{
    const long double ax = v[1].x - v[0].x, ay = v[1].y - v[0].y, az = v[1].z - v[0].z;
    const long double bx = v[2].x - v[0].x, by = v[2].y - v[0].y, bz = v[2].z - v[0].z;
    const long double determinant = ax * by - ay * bx;
    return {(az * by - ay * bz) / determinant, (ax * bz - az * bx) / determinant};
}

double slopeOfPlane(std::span<const PatchVertex> v)
{
    const auto [x, y] = gradientOfPlane(v);
    return double(std::sqrt(x * x + y * y));
}

/// How steep `after` rises in the direction in which `before` is steepest.
double slopeAlong(std::span<const PatchVertex> before, std::span<const PatchVertex> after)
{
    const auto [x, y] = gradientOfPlane(before);
    const auto [ax, ay] = gradientOfPlane(after);
    return double((x * ax + y * ay) / std::sqrt(x * x + y * y));
}

/// One sweep over one triangle.
std::vector<PatchVertex> swept(const std::vector<PatchVertex> &v, double slope, const SweepRule &rule)
{
    Patch patch(v, OneTriangle, slope);
    patch.wake();
    Team::run([&](Team &team) { patch.sweep(team, rule, Progress()); });
    return {patch.vertices().begin(), patch.vertices().end()};
}

/// The rule as terrain.md writes it, word for word.
std::vector<PatchVertex> byTheBook(std::vector<PatchVertex> v, double slope, double omega)
{
    const auto [gx, gy] = gradientOfPlane(v);
    const long double steepness = std::sqrt(gx * gx + gy * gy);
    const long double area = 0.5L * ((v[1].x - v[0].x) * (v[2].y - v[0].y) - (v[1].y - v[0].y) * (v[2].x - v[0].x));
    long double d[3], sum = 0;
    for (int i = 0; i < 3; ++i) {
        std::vector<PatchVertex> hat = v; // phi_i: 1 at i, 0 at the others
        for (int k = 0; k < 3; ++k)
            hat[std::size_t(k)].z = k == i;
        const auto [px, py] = gradientOfPlane(hat);
        d[i] = px * gx + py * gy;
        sum += area * d[i] * d[i] * v[std::size_t(i)].inverseArea;
    }
    const long double lambda = (1 - slope / steepness) * steepness * steepness / sum;
    for (int i = 0; i < 3; ++i)
        v[std::size_t(i)].z -= double(omega * lambda * area * d[i] * v[std::size_t(i)].inverseArea);
    return v;
}

} // namespace

class TestFaceRule final : public QObject
{
    Q_OBJECT

private slots:
    void aStepIsThatOfTheFormula()
    {
        Random random;
        int moved = 0;
        for (int i = 0; i < 2000; ++i) {
            const std::vector<PatchVertex> v = randomTriangle(random);
            const double slope = random(0.1, 1.5), omega = random(0.5, 1.9), steepness = slopeOfPlane(v);
            if (omega * (1 - slope / steepness) > 1)
                continue; // see noStepGoesBeyondLevel
            const std::vector<PatchVertex> after = swept(v, slope, {ErosionRule::Face, omega, 0, 0});
            const std::vector<PatchVertex> expected = steepness > slope ? byTheBook(v, slope, omega) : v;
            for (std::size_t k = 0; k < 3; ++k)
                QVERIFY(std::abs(after[k].z - expected[k].z) < 1e-12);
            moved += steepness > slope;
        }
        QVERIFY(moved > 300);
    }

    /// Along the line of steepest descent; across it, unequal areas may leave a little.
    void aFullStepMakesTheSlopeCritical()
    {
        Random random;
        for (int i = 0; i < 500; ++i) {
            const std::vector<PatchVertex> v = randomTriangle(random);
            const double slope = slopeOfPlane(v) * random(0.1, 0.99);
            QVERIFY(std::abs(slopeAlong(v, swept(v, slope, {ErosionRule::Face, 1, 0, 0})) - slope) < 1e-12);
        }
    }

    void noStepGoesBeyondLevel()
    {
        Random random;
        for (int i = 0; i < 500; ++i) {
            std::vector<PatchVertex> v = randomTriangle(random);
            for (PatchVertex &vertex : v)
                vertex.z *= 1000; // a cliff
            const std::vector<PatchVertex> after = swept(v, 0.5, {ErosionRule::Face, 1.9, 0, 0});
            QVERIFY(std::abs(slopeAlong(v, after)) < slopeOfPlane(v) * 1e-12);
        }
    }

    void volumeStaysAndSoDoesEnergyNot()
    {
        Random random;
        for (int i = 0; i < 500; ++i) {
            const std::vector<PatchVertex> v = randomTriangle(random);
            const std::vector<PatchVertex> after = swept(v, 0.2, {ErosionRule::Face, 1.9, 0, 0});
            long double volume = 0, energy = 0, size = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                volume += (after[k].z - (long double)v[k].z) / v[k].inverseArea;
                energy += ((long double)after[k].z * after[k].z - (long double)v[k].z * v[k].z) / v[k].inverseArea;
                size += std::abs(v[k].z) / v[k].inverseArea;
            }
            QVERIFY(std::abs(volume) < 1e-15L * size);
            QVERIFY(energy <= 0 && (energy < 0 || slopeOfPlane(v) <= 0.2));
        }
    }

    void hysteresisStartsLateAndStopsEarly()
    {
        Random random;
        const double critical = std::tan(30 * Degree);
        const SweepRule rule{ErosionRule::Face, 1, 2, 0.5};
        for (int i = 0; i < 200; ++i) {
            std::vector<PatchVertex> v = randomTriangle(random);
            const double steepness = slopeOfPlane(v);
            const auto tilt = [&](double degrees) {
                std::vector<PatchVertex> tilted = v;
                for (PatchVertex &vertex : tilted)
                    vertex.z *= std::tan(degrees * Degree) / steepness;
                return tilted;
            };
            QCOMPARE(slopeOfPlane(swept(tilt(31.9), critical, rule)), slopeOfPlane(tilt(31.9)));
            QVERIFY(std::abs(slopeAlong(v, swept(tilt(32.1), critical, rule)) - critical) < 1e-12);
            // What is on its way goes on to the lower of the two.
            Patch patch(tilt(32.1), OneTriangle, critical);
            patch.wake();
            Team::run([&](Team &team) {
                patch.sweep(team, {ErosionRule::Face, 0.5, 2, 0.5}, Progress());
                const double halfway = slopeAlong(v, patch.vertices());
                QVERIFY(halfway > std::tan(31 * Degree) && halfway < std::tan(31.1 * Degree));
                patch.sweep(team, rule, Progress());
            });
            QVERIFY(slopeAlong(v, patch.vertices()) < critical + 1e-12);
            QVERIFY(!patch.isAtRest());
        }
    }

    /// Against a loop over all triangles in their order, as simple as can be, until nothing is too steep.
    void sweepsEndWhereAPlainLoopDoes()
    {
        Tin tin = tests::column(1500);
        std::vector<double> plain(tin.arrays().heights.values().begin(), tin.arrays().heights.values().end());
        const double critical = std::tan(30 * Degree);
        for (bool isAtRest = false; !isAtRest;) {
            isAtRest = true;
            for (TriangleId t = 0; t < tin.arrays().triangleSlots(); ++t) {
                std::vector<PatchVertex> v;
                for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c) {
                    const VertexId id = tin.arrays().vertex(c);
                    v.push_back({tin.arrays().points[id].x, tin.arrays().points[id].y, plain[id],
                                 1 / dualArea(tin.arrays(), id)});
                }
                if (slopeOfPlane(v) <= std::tan(30.05 * Degree))
                    continue;
                isAtRest = false;
                v = byTheBook(v, critical, 1);
                for (std::uint32_t i = 0; i < 3; ++i)
                    plain[tin.arrays().vertex(cornerOf(t, i))] = v[i].z;
            }
        }
        ErosionSettings settings;
        settings.relaxation = 1;
        Erosion erosion = *Erosion::create(settings, {});
        tests::settle(tin, erosion);
        double volume = 0, difference = 0;
        for (VertexId v = 0; v < tin.arrays().vertexSlots(); ++v) {
            volume += dualArea(tin.arrays(), v) * plain[v];
            difference += dualArea(tin.arrays(), v) * std::abs(plain[v] - tin.arrays().heights[v]);
        }
        QVERIFY2(difference < 0.03 * volume, qPrintable(QString::number(difference / volume)));
    }
};

SANDREEL_TEST(TestFaceRule)
#include "tst_facerule.moc"
