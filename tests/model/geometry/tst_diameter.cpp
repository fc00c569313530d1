// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/geometry/diameter.h"
#include "tests/support/testmain.h"

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace model;

namespace {

using Points = std::vector<Vec3f>;

double bruteForce(const Points &points)
{
    long double best = 0;
    for (const Vec3f &a : points)
        for (const Vec3f &b : points) {
            const long double x = (long double)a.x - b.x, y = (long double)a.y - b.y, z = (long double)a.z - b.z;
            best = std::max(best, x * x + y * y + z * z);
        }
    return double(std::sqrt(best));
}

/// As hard as it gets: every point has another one almost a diameter away.
Points sphere(int count)
{
    Points points;
    for (int i = 0; i < count; ++i) {
        const double z = 1 - (2 * i + 1.0) / count, angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
        const double r = std::sqrt(1 - z * z);
        points.push_back({float(r * std::cos(angle)), float(r * std::sin(angle)), float(z)});
    }
    return points;
}

Points cloud(unsigned seed, int count, Vec3f scale)
{
    std::mt19937 random(seed);
    Points points;
    for (int i = 0; i < count; ++i)
        points.push_back(
            {float(random() % 10007) * scale.x, float(random() % 10007) * scale.y, float(random() % 10007) * scale.z});
    return points;
}

} // namespace

class TestDiameter final : public QObject
{
    Q_OBJECT

private slots:
    void asBruteForceSays_data()
    {
        QTest::addColumn<int>("kind");
        const char *names[] = {"sphere", "cube", "plane", "line", "equal points", "two points", "far from the origin"};
        for (int i = 0; i < int(std::size(names)); ++i)
            QTest::newRow(names[i]) << i;
    }
    void asBruteForceSays()
    {
        QFETCH(int, kind);
        Points points;
        switch (kind) {
        case 0:
            points = sphere(1500);
            break;
        case 1:
            points = cloud(1, 1500, {1, 1, 1});
            break;
        case 2:
            points = cloud(2, 1500, {1, 0.3f, 0});
            break;
        case 3:
            points = cloud(3, 1500, {0, 0, 2});
            break;
        case 4:
            points = Points(500, Vec3f{1, 2, 3});
            break;
        case 5:
            points = {{0, 0, 0}, {3, 4, 12}};
            break;
        case 6:
            points = cloud(4, 700, {1e-3f, 1e-3f, 1e-3f});
            for (Vec3f &p : points)
                p = p + Vec3f{1e4f, 0, 0};
            break;
        }
        const double expected = bruteForce(points);
        QVERIFY(std::abs(diameter(points) - expected) <= 1e-14 * expected);
    }

    void byHand()
    {
        QCOMPARE(diameter(Points{}), 0.0);
        QCOMPARE(diameter(Points{{5, 5, 5}}), 0.0);
        QCOMPARE(diameter(Points{{0, 0, 0}, {3, 4, 12}, {1, 1, 1}}), 13.0);
    }
};

SANDREEL_TEST(TestDiameter)
#include "tst_diameter.moc"
