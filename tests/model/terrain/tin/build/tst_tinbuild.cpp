// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/validate.h"
#include "tests/model/terrain/tin/cgaljudge.h"
#include "tests/model/terrain/tin/randomedits.h"
#include "tests/support/testmain.h"

#include <cmath>

using namespace model;
using namespace model::terrain;

class TestTinBuild final : public QObject
{
    Q_OBJECT

private slots:
    void everyGroundIsCgalsTriangulation_data()
    {
        QTest::addColumn<int>("ground");
        QTest::addColumn<int>("count");
        for (const tests::Ground ground : tests::EveryGround)
            for (const int count : {0, 1, 2, 5, 60, 3000})
                QTest::addRow("%s, %d", tests::nameOf(ground), count) << int(ground) << count;
    }
    void everyGroundIsCgalsTriangulation()
    {
        QFETCH(int, ground);
        QFETCH(int, count);
        tests::PointSource source{tests::Ground(ground), unsigned(count)};
        const std::vector<Point3> points = source.points(std::size_t(count));
        const auto built = buildTin(points, source.domain());
        QVERIFY(built);
        QVERIFY(findDefects(built->tin).empty());
        QCOMPARE(tests::differenceFromCgal(built->tin), std::string());
    }

    void pointsKeepTheirPlacesAndTheFirstItsHeight()
    {
        const std::vector<Point3> points{{0.5, 0.5, 1}, {0.25, 0.5, 2}, {0.5, 0.5, 3}, {1, 1, 4}, {1, 1, 5}};
        const auto built = buildTin(points, {{0, 0}, {1, 1}});
        QVERIFY(built);
        const TinArrays &tin = built->tin.arrays();
        QCOMPARE(built->tin.vertexCount(), 6u);
        QCOMPARE(built->duplicates, 2u);
        QCOMPARE(built->vertexOf[2], built->vertexOf[0]);
        QCOMPARE(built->vertexOf[4], built->vertexOf[3]);
        QCOMPARE(built->vertexOf[3], 2u); // the corner north-east
        for (const std::size_t i : {0, 1, 3}) {
            const VertexId v = built->vertexOf[i];
            QCOMPARE(tin.points[v], (Point2{points[i].x, points[i].y}));
            QCOMPARE(tin.heights[v], points[i].z);
        }
        QCOMPARE(tin.heights[0], 2.0); // nearest
        QCOMPARE(tin.heights[1], 1.0);
    }

    /// Closer together than the curve can tell, and taken in turns: each place is one vertex all the same.
    void heapedPointsAreToldApart()
    {
        std::vector<Point3> points;
        for (int i = 0; i < 400; ++i)
            points.push_back({0.3 + (i % 5) * 0x1p-50, 0.3 + (i % 7) * 0x1p-50, double(i)});
        const auto built = buildTin(points, {{0, 0}, {1, 1}});
        QVERIFY(built);
        QCOMPARE(built->tin.vertexCount(), 4u + 35u);
        QCOMPARE(built->duplicates, 400u - 35u);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const VertexId v = built->vertexOf[i];
            QCOMPARE(built->tin.arrays().points[v], (Point2{points[i].x, points[i].y}));
            QCOMPARE(built->tin.arrays().heights[v], double(i % 35)); // of the first there
        }
        QVERIFY(findDefects(built->tin).empty());
        QCOMPARE(tests::differenceFromCgal(built->tin), std::string());
    }

    void theSamePointsMakeTheSameBytes()
    {
        tests::PointSource source(tests::Ground::Clusters, 5);
        const std::vector<Point3> points = source.points(2000);
        QCOMPARE(buildTin(points, source.domain())->tin.fingerprint(),
                 buildTin(points, source.domain())->tin.fingerprint());
    }

    void whatCannotBeBuiltIsRefused()
    {
        const Rectangle unit{{0, 0}, {1, 1}};
        const auto codeOf = [](const Point3 &point, const Rectangle &domain) {
            const std::vector<Point3> points{{0.5, 0.5, 0}, point};
            const auto built = buildTin(points, domain);
            return built ? ErrorCode::Cancelled : built.error().code;
        };
        QCOMPARE(codeOf({0.5, NAN, 0}, unit), ErrorCode::NonFinite);
        QCOMPARE(codeOf({0.5, 0.5, INFINITY}, unit), ErrorCode::NonFinite);
        QCOMPARE(codeOf({1.0000001, 0.5, 0}, unit), ErrorCode::BadValue);
        QCOMPARE(codeOf({0.5, 0.5, 0}, {{0, 0}, {1, 0}}), ErrorCode::BadValue);
        QCOMPARE(codeOf({0.5, 0.5, 0}, {{0, 0}, {NAN, 1}}), ErrorCode::BadValue);
        QCOMPARE(codeOf({0.5, 0.5, 0}, {{0, 0}, {1e13, 1}}), ErrorCode::BadValue);
        QCOMPARE(codeOf({0.5, 0.6, 0}, unit), ErrorCode::Cancelled); // built
        const std::vector<Point3> points{{0.5, 0.5, 0}, {7, 0.5, 0}};
        QCOMPARE(buildTin(points, unit).error().args[0], std::string("point 1"));
    }

    void boundsAreTight()
    {
        const std::vector<Point3> points{{1, 5, 0}, {-2, 7, 0}, {0, 4, 9}};
        QCOMPARE(boundsOf(points), (Rectangle{{-2, 4}, {1, 7}}));
    }
};

SANDREEL_TEST(TestTinBuild)
#include "tst_tinbuild.moc"
