// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/editedframes.h"
#include "tests/support/meshes.h"
#include "tests/support/rows.h"
#include "tests/support/testmain.h"

#include <cmath>
#include <set>

using namespace model;

class TestEditedFrames final : public QObject
{
    Q_OBJECT

    /// Vertex `vertex` at `position` of the sequence, moved by `placement`: plainly, in the highest precision.
    static std::array<long double, 3> expectedAt(const Sequence &sequence, double position, const Similarity &placement,
                                                 std::size_t vertex)
    {
        const auto before = std::uint32_t(std::floor(position)), after = std::uint32_t(std::ceil(position));
        const long double weight = (long double)(position)-before;
        const Vec3f a = sequence.frameView(before)[vertex], b = sequence.frameView(after)[vertex];
        const auto value = [&](float from, float to, int axis) {
            return placement.scale * ((1 - weight) * from + weight * to) + placement.offset[axis];
        };
        return {value(a.x, b.x, 0), value(a.y, b.y, 1), value(a.z, b.z, 2)};
    }

private slots:
    void everyFrameAsBruteForceSays_data() { tests::addRows(tests::namedAnimations()); }
    void everyFrameAsBruteForceSays()
    {
        QFETCH(int, row);
        const tests::SequencePtr sequence = tests::namedAnimations()[std::size_t(row)].sequence;
        const double last = sequence->frameCount() - 1;
        const TimeMap map({0, last, last / 2, last / 3, last * 0.999, last / 7, 0, last});
        for (const Similarity &placement : {Similarity{}, Similarity{0.25, {-1, 100, 0.125}}}) {
            const EditedFrames edited(sequence, map, placement, 30, "edited");
            QCOMPARE(edited.frameCount(), 8u);
            QCOMPARE(edited.frameRate(), 30.0);
            QVERIFY(edited.name() == "edited");
            QVERIFY(&edited.connectivity() == &sequence->connectivity());
            for (std::uint32_t frame = 0; frame < edited.frameCount(); ++frame) {
                const std::vector<Vec3f> positions = edited.frame(frame);
                for (std::size_t vertex = 0; vertex < positions.size(); ++vertex) {
                    const auto expected = expectedAt(*sequence, map.sourcePosition(frame), placement, vertex);
                    const float got[] = {positions[vertex].x, positions[vertex].y, positions[vertex].z};
                    for (int axis = 0; axis < 3; ++axis)
                        QVERIFY(std::abs(got[axis] - expected[axis]) <= 1.2e-7L * (1 + std::abs(expected[axis])));
                }
            }
        }
    }

    void wholePositionsAreExact()
    {
        const auto sequence = tests::noise(tests::torus(), 5);
        const EditedFrames edited(sequence, TimeMap({4, 0, 2, 2}), {}, 25, "");
        QVERIFY(edited.frame(0) == sequence->frame(4));
        QVERIFY(edited.frame(1) == sequence->frame(0));
        QVERIFY(edited.frame(3) == sequence->frame(2));
    }

    void knowsWhenFramesAreUntouched()
    {
        const auto sequence = tests::wave(tests::cube(), 3);
        const auto keeps = [&](TimeMap map, Similarity placement) {
            return EditedFrames(sequence, std::move(map), placement, 99, "other").keepsFrames();
        };
        QVERIFY(keeps(TimeMap::identity(3), {}));
        QVERIFY(!keeps(TimeMap::identity(2), {}));
        QVERIFY(!keeps(TimeMap({0, 1, 1}), {}));
        QVERIFY(!keeps(TimeMap::identity(3), {2, {}}));
        QVERIFY(!keeps(TimeMap::identity(3), {1, {0, 0, 1}}));
    }

    void digestTellsEditsApart()
    {
        const auto sequence = tests::wave(tests::cube(), 3);
        const auto digest = [&](TimeMap map, Similarity placement, double rate = 25, const char *name = "") {
            return EditedFrames(sequence, std::move(map), placement, rate, name).digest();
        };
        const std::uint64_t untouched = digest(TimeMap::identity(3), {});
        QCOMPARE(untouched, sequence->digest());
        QCOMPARE(digest(TimeMap::identity(3), {}, 30, "other"), untouched);
        QCOMPARE(digest(TimeMap({0, 1}), {}, 25), digest(TimeMap({0, 1}), {}, 30, "other"));
        const std::set<std::uint64_t> digests{untouched,
                                              digest(TimeMap({0, 1}), {}),
                                              digest(TimeMap({1, 0}), {}),
                                              digest(TimeMap({0, 1, 2, 2}), {}),
                                              digest(TimeMap::identity(3), {2, {}}),
                                              digest(TimeMap::identity(3), {1, {1, 0, 0}}),
                                              digest(TimeMap::identity(3), {1, {0, 1, 0}}),
                                              digest(TimeMap::identity(3), {1, {0, 0, 1}})};
        QCOMPARE(digests.size(), std::size_t(8));
    }

    void editsOfEditsAreSeenThrough()
    {
        const auto sequence = tests::noise(tests::cube(), 10);
        const auto reversed =
            std::make_shared<EditedFrames>(sequence, TimeMap::identity(10).reversed(), Similarity{}, 25, "");
        const EditedFrames twice(reversed, TimeMap::identity(10).reversed(), {}, 25, "");
        for (std::uint32_t frame = 0; frame < 10; ++frame)
            QVERIFY(twice.frame(frame) == sequence->frame(frame));
        QCOMPARE(twice.memoryBytes(), sequence->memoryBytes());
    }
};

SANDREEL_TEST(TestEditedFrames)
#include "tst_editedframes.moc"
