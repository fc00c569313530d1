// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/normalisation.h"
#include "model/base/parallel.h"
#include "tests/support/meshes.h"
#include "tests/support/rows.h"
#include "tests/support/testmain.h"

#include <limits>

using namespace model;

class TestNormalisation final : public QObject
{
    Q_OBJECT

    /// Two frames of two points: the box of the first is (1,2,3)..(5,4,3), that of both (1,-4,3)..(5,12,3).
    static FrameSourcePtr twoFrames()
    {
        return std::make_shared<Sequence>(Connectivity{2, {}},
                                          std::vector<Vec3f>{{1, 2, 3}, {5, 4, 3}, {2, -4, 3}, {3, 12, 3}});
    }
    static FrameSourcePtr onePoint(Vec3f point)
    {
        return std::make_shared<Sequence>(Connectivity{1, {}}, std::vector<Vec3f>{point});
    }

private slots:
    void boxes()
    {
        const FrameSourcePtr source = twoFrames();
        const Box3f first = boundingBoxOf(*source, 0);
        QVERIFY(first.min == Vec3f({1, 2, 3}) && first.max == Vec3f({5, 4, 3}));
        const Result<Box3f> all = boundingBoxOfAll(*source);
        QVERIFY(all && all->min == Vec3f({1, -4, 3}) && all->max == Vec3f({5, 12, 3}));
    }

    void closedForms()
    {
        const FrameSourcePtr source = twoFrames();
        QVERIFY(*normalisingSimilarity(*source, Normalisation::None) == Similarity{});
        // Centre (3,3,3), longest side 4.
        QVERIFY(*normalisingSimilarity(*source, Normalisation::FirstFrame) == Similarity({0.5, {-1.5, -1.5, -1.5}}));
        // Centre (3,4,3), longest side 16.
        QVERIFY(*normalisingSimilarity(*source, Normalisation::AllFrames) == Similarity({0.125, {-.375, -.5, -.375}}));
    }

    void aPointIsOnlyCentred()
    {
        for (const Normalisation mode : {Normalisation::FirstFrame, Normalisation::AllFrames})
            QVERIFY(*normalisingSimilarity(*onePoint({1, 2, 3}), mode) == Similarity({1, {-1, -2, -3}}));
    }

    void theLargestFloatsFit()
    {
        const float huge = std::numeric_limits<float>::max();
        const Sequence source({2, {}}, {{-huge, 0, 0}, {huge, 0, 0}});
        const Similarity similarity = *normalisingSimilarity(source, Normalisation::AllFrames);
        QVERIFY(similarity({huge, 0, 0}) == Vec3f({1, 0, 0}));
        QVERIFY(similarity({-huge, 0, 0}) == Vec3f({-1, 0, 0}));
    }

    void everyAnimationFillsTheCube_data() { tests::addRows(tests::namedAnimations()); }
    void everyAnimationFillsTheCube()
    {
        QFETCH(int, row);
        const tests::SequencePtr sequence = tests::namedAnimations()[std::size_t(row)].sequence;
        const auto edited = [&](const Similarity &placement) {
            return EditedFrames(sequence, TimeMap::identity(sequence->frameCount()), placement, 25, "");
        };
        const Box3f all = *boundingBoxOfAll(edited(*normalisingSimilarity(*sequence, Normalisation::AllFrames)));
        const Box3f first = boundingBoxOf(edited(*normalisingSimilarity(*sequence, Normalisation::FirstFrame)), 0);
        for (const Box3f &box : {all, first}) {
            constexpr float Rounding = 2e-7f;
            QVERIFY(box.min.x >= -1 - Rounding && box.min.y >= -1 - Rounding && box.min.z >= -1 - Rounding);
            QVERIFY(box.max.x <= 1 + Rounding && box.max.y <= 1 + Rounding && box.max.z <= 1 + Rounding);
            QVERIFY(length(box.center()) <= Rounding);
            QVERIFY(std::abs(box.longestSide() - (sequence->vertexCount() > 1 || box.longestSide() > 0 ? 2 : 0)) <=
                    2 * Rounding);
        }
    }

    void placementIsCountedFromTheSource()
    {
        const FrameSourcePtr source = twoFrames();
        // The second frame alone, placed somewhere: centre of (2,-4,3)..(3,12,3) is (2.5,4,3), longest side 16.
        const EditedFrames edited(source, TimeMap({1}), Similarity{7, {70, 700, 7000}}, 25, "");
        for (const Normalisation mode : {Normalisation::FirstFrame, Normalisation::AllFrames})
            QVERIFY(*normalisingPlacement(edited, mode) == Similarity({0.125, {-.3125, -.5, -.375}}));
        QVERIFY(normalisingPlacement(edited, Normalisation::None)->isIdentity());
        // What is shown now has another similarity: there the placement is seen.
        QVERIFY(*normalisingSimilarity(edited, Normalisation::FirstFrame) !=
                *normalisingPlacement(edited, Normalisation::FirstFrame));
    }

    void cancelStops()
    {
        const auto source = tests::wave(tests::cube(), 50);
        const Progress progress;
        progress.cancel();
        const auto box = boundingBoxOfAll(*source, progress);
        QVERIFY(!box && box.error().code == ErrorCode::Cancelled);
        const auto similarity = normalisingSimilarity(*source, Normalisation::AllFrames, progress);
        QVERIFY(!similarity && similarity.error().code == ErrorCode::Cancelled);
    }

    void progressReachesTheEnd()
    {
        double last = 0;
        QVERIFY(boundingBoxOfAll(*tests::wave(tests::cube(), 50), Progress([&](double f) { last = f; })));
        QVERIFY(last > 0.9);
    }
};

SANDREEL_TEST(TestNormalisation)
#include "tst_normalisation.moc"
