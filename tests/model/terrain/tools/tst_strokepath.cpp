// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tools/strokepath.h"
#include "tests/model/terrain/tools/strokes.h"
#include "tests/support/testmain.h"

#include <QTest>

#include <algorithm>

#include <cmath>
#include <random>

using namespace model;
using namespace model::terrain;

namespace {

const std::vector<PathPoint> Bent{{{0.1, 0.1}, 0.25, 0}, {{0.7, 0.3}, 1, 2}, {{0.4, 0.9}, 0.5, 1}};

} // namespace

class TestStrokePath final : public QObject
{
    Q_OBJECT

private slots:
    void stampsLieAtEqualDistances()
    {
        const auto poses = resample(Bent, 0.05);
        QVERIFY(poses);
        const double length = std::hypot(0.6, 0.2) + std::hypot(0.3, 0.6);
        QCOMPARE(poses->size(), std::size_t(length / 0.05) + 1);
        const double first = std::hypot(0.6, 0.2);
        for (std::size_t k = 0; k < poses->size(); ++k) {
            const double s = 0.05 * double(k), t = s < first ? s / first : (s - first) / std::hypot(0.3, 0.6);
            const Point2 wanted =
                s < first ? Point2{0.1 + t * 0.6, 0.1 + t * 0.2} : Point2{0.7 - t * 0.3, 0.3 + t * 0.6};
            QVERIFY(std::hypot((*poses)[k].at.x - wanted.x, (*poses)[k].at.y - wanted.y) < 1e-9);
            QVERIFY(std::abs((*poses)[k].pressure - (s < first ? 0.25 + 0.75 * t : 1 - 0.5 * t)) < 1e-8);
            QVERIFY(std::abs(std::hypot((*poses)[k].direction.x, (*poses)[k].direction.y) - 1) < 1e-12);
        }
    }
    void morePointsOnThePathChangeNothing()
    {
        const auto few = resample(Bent, 0.0123);
        for (const int count : {1, 7, 500}) {
            const auto many = resample(tests::oversampled(Bent, count, unsigned(count)), 0.0123);
            QVERIFY(few && many);
            QCOMPARE(many->size(), few->size());
            for (std::size_t k = 0; k < few->size(); ++k) {
                QVERIFY((*many)[k].at == (*few)[k].at);
                QVERIFY((*many)[k].direction == (*few)[k].direction);
                QCOMPARE((*many)[k].pressure, (*few)[k].pressure);
                QCOMPARE((*many)[k].speed, (*few)[k].speed);
            }
        }
    }
    void aPointIsOneStampWithoutDirection()
    {
        for (const std::vector<PathPoint> &path :
             {std::vector<PathPoint>{{{0.5, 0.5}, 0.7, 0}},
              std::vector<PathPoint>{{{0.5, 0.5}, 0.7, 0}, {{0.5, 0.5}, 0.7, 0}, {{0.5, 0.5}, 0.7, 0}}}) {
            const auto poses = resample(path, 0.1);
            QVERIFY(poses);
            QCOMPARE(poses->size(), std::size_t(1));
            QVERIFY((poses->front().direction == Point2{0, 0}));
            QVERIFY(std::abs(poses->front().pressure - 0.7) < 1e-9); // rounded, as all are
        }
    }
    void badPathsAreNamed()
    {
        QCOMPARE(resample({}, 1).error().code, ErrorCode::BadSetting);
        QCOMPARE(resample(Bent, 0).error().code, ErrorCode::BadSetting);
        QCOMPARE(resample(Bent, std::nan("")).error().code, ErrorCode::BadSetting);
        QCOMPARE(resample(Bent, 1e-9).error().code, ErrorCode::LimitExceeded);
        const auto with = [](PathPoint p) { return resample(std::vector<PathPoint>{Bent[0], p}, 0.1).error(); };
        QCOMPARE(with({{std::nan(""), 0}, 1, 0}).code, ErrorCode::NonFinite);
        QCOMPARE(with({{std::nan(""), 0}, 1, 0}).args[0], std::string("path point 1"));
        QCOMPARE(with({{0, 1e300}, 1, 0}).code, ErrorCode::BadSetting);
        QCOMPARE(with({{0, 0}, 1.5, 0}).code, ErrorCode::BadSetting);
        QCOMPARE(with({{0, 0}, 1, -1}).code, ErrorCode::BadSetting);
    }
    void copiesLieWhereTheirSymmetrySays()
    {
        const StampPose pose{{0.25, 0.5}, {1, 0}, 1, 0, false};
        const Symmetry mirror{Symmetry::Kind::MirrorBoth, {1, 1}, 2};
        QCOMPARE(mirror.count(), 4u);
        QVERIFY((mirror.copyOf(pose, 1).at == Point2{1.75, 0.5}));
        QVERIFY((mirror.copyOf(pose, 1).direction == Point2{-1, 0}));
        QVERIFY(mirror.copyOf(pose, 1).isMirrored);
        QVERIFY((mirror.copyOf(pose, 2).at == Point2{0.25, 1.5}));
        QVERIFY((mirror.copyOf(pose, 3).at == Point2{1.75, 1.5}));
        QVERIFY(!mirror.copyOf(pose, 3).isMirrored);
        const Symmetry star{Symmetry::Kind::Radial, {0.5, 0.5}, 4};
        const StampPose turned = star.copyOf(pose, 1);
        QVERIFY(std::hypot(turned.at.x - 0.5, turned.at.y - 0.25) < 1e-15);
        QVERIFY(std::hypot(turned.direction.x, turned.direction.y - 1) < 1e-15);
        QCOMPARE((Symmetry{Symmetry::Kind::Radial, {0, 0}, 0}.check().error().code), ErrorCode::BadSetting);
        QCOMPARE((Symmetry{Symmetry::Kind::MirrorX, {std::nan(""), 0}, 2}.check().error().code), ErrorCode::NonFinite);
    }
};

SANDREEL_TEST(TestStrokePath)
#include "tst_strokepath.moc"
