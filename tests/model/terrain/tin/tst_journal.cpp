// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tin/journal/editjoiner.h"
#include "model/terrain/tin/tinedit.h"
#include "model/terrain/tin/validate.h"
#include "tests/model/terrain/tin/randomedits.h"
#include "tests/support/testmain.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <set>

using namespace model::terrain;

namespace {

/// All bytes of a TIN's state, as they lie there.
std::string bytesOf(const Tin &tin)
{
    std::string bytes;
    const auto add = [&](const auto &array) {
        bytes.append(reinterpret_cast<const char *>(array.data()), array.byteSize());
        bytes += '|';
    };
    const TinArrays &arrays = tin.arrays();
    add(arrays.points);
    add(arrays.heights);
    add(arrays.corners);
    add(arrays.constraints);
    add(arrays.thicknesses);
    add(arrays.humidities);
    add(arrays.triangleVertices);
    add(arrays.opposites);
    add(arrays.triangleFlags);
    add(arrays.records);
    bytes.append(reinterpret_cast<const char *>(&arrays.totals), sizeof(arrays.totals));
    return bytes;
}

/// Which slots of `part` differ between two states, the new ones included.
std::vector<std::uint32_t> changedSlots(const TinArrays &before, const TinArrays &after, TinPart part)
{
    std::vector<std::uint32_t> changed;
    const bool isTriangles = part == TinPart::Triangles;
    const std::uint32_t count = isTriangles ? after.triangleSlots() : after.vertexSlots();
    for (std::uint32_t i = 0; i < count; ++i) {
        bool isSame = i < (isTriangles ? before.triangleSlots() : before.vertexSlots());
        if (isSame && isTriangles)
            isSame = std::memcmp(&before.triangleVertices[3 * i], &after.triangleVertices[3 * i], 12) == 0 &&
                     std::memcmp(&before.opposites[3 * i], &after.opposites[3 * i], 12) == 0;
        else if (isSame)
            isSame =
                part == TinPart::Points ? before.points[i] == after.points[i] : before.heights[i] == after.heights[i];
        if (!isSame)
            changed.push_back(i);
    }
    return changed;
}

} // namespace

class TestJournal final : public QObject
{
    Q_OBJECT

private slots:
    void undoAndRedoAreExactToTheByte_data()
    {
        QTest::addColumn<int>("ground");
        QTest::addColumn<bool>("hasLayers");
        for (const tests::Ground ground : tests::EveryGround)
            QTest::newRow(tests::nameOf(ground)) << int(ground) << false;
        QTest::newRow("layers") << int(tests::Ground::Random) << true;
        QTest::newRow("layers on a grid") << int(tests::Ground::Grid) << true;
    }
    /// Some thousand random edits in all, walked back and forth at random.
    void undoAndRedoAreExactToTheByte()
    {
        QFETCH(int, ground);
        QFETCH(bool, hasLayers);
        tests::PointSource source(tests::Ground(ground), 21);
        auto built = buildTin(source.points(150), source.domain());
        QVERIFY(built);
        Tin &tin = built->tin;
        std::vector<Edit> edits;
        std::vector<std::string> states{bytesOf(tin)};
        for (int i = 0; i < 500; ++i) {
            {
                TinEdit edit(tin, source.below(2) ? VolumeRule::GiveBack : VolumeRule::Keep);
                for (std::uint32_t steps = source.below(8); steps > 0; --steps)
                    if (hasLayers && source.below(2))
                        tests::randomLayerStep(edit, source, i % 5 == 0);
                    else
                        tests::randomStep(edit, source);
                edits.push_back(edit.commit());
            }
            states.push_back(bytesOf(tin));
            const std::size_t back = source.below(3) == 0 ? source.below(std::uint32_t(edits.size())) % 30 : 0;
            for (std::size_t k = 0; k < back; ++k) {
                tin.swap(edits[edits.size() - 1 - k]);
                QVERIFY(bytesOf(tin) == states[states.size() - 2 - k]);
            }
            if (back > 0)
                QVERIFY(findDefects(tin).empty());
            if (source.below(2)) { // another future
                edits.resize(edits.size() - back);
                states.resize(states.size() - back);
                continue;
            }
            for (std::size_t k = back; k-- > 0;) {
                tin.swap(edits[edits.size() - 1 - k]);
                QVERIFY(bytesOf(tin) == states[states.size() - 1 - k]);
            }
        }
        while (!edits.empty()) {
            tin.swap(edits.back());
            edits.pop_back();
            states.pop_back();
            QVERIFY(bytesOf(tin) == states.back());
        }
        QVERIFY(findDefects(tin).empty());
    }

    void joinedEditsAreUndoneAsOne_data() { undoAndRedoAreExactToTheByte_data(); }
    /// Runs of random edits joined to one each, walked back and forth.
    void joinedEditsAreUndoneAsOne()
    {
        QFETCH(int, ground);
        QFETCH(bool, hasLayers);
        tests::PointSource source(tests::Ground(ground), 33);
        auto built = buildTin(source.points(150), source.domain());
        QVERIFY(built);
        Tin &tin = built->tin;
        std::vector<Edit> edits;
        std::vector<std::string> states{bytesOf(tin)};
        int joined = 0, refused = 0;
        for (int run = 0; run < 40; ++run) {
            std::optional<EditJoiner> joiner;
            for (std::uint32_t i = 0, count = 1 + source.below(20); i < count; ++i) {
                TinEdit edit(tin, source.below(2) ? VolumeRule::GiveBack : VolumeRule::Keep);
                for (std::uint32_t steps = source.below(8); steps > 0; --steps)
                    if (hasLayers && source.below(2))
                        tests::randomLayerStep(edit, source, i % 5 == 0);
                    else
                        tests::randomStep(edit, source);
                Edit done = edit.commit();
                if (joiner && joiner->join(edits.back(), done)) {
                    states.back() = bytesOf(tin);
                    ++joined;
                    continue;
                }
                refused += joiner.has_value();
                edits.push_back(std::move(done));
                states.push_back(bytesOf(tin));
                joiner.emplace(edits.back());
            }
            for (const int direction : {0, 1}) {
                for (std::size_t k = 0; k < edits.size(); ++k) {
                    tin.swap(edits[direction ? k : edits.size() - 1 - k]);
                    QVERIFY(bytesOf(tin) == states[direction ? k + 1 : edits.size() - 1 - k]);
                }
                if (direction == 0)
                    QVERIFY(findDefects(tin).empty());
            }
        }
        QVERIFY(joined > 100);
        QCOMPARE(refused > 0, hasLayers);
    }

    void aLongSlideKeepsWhatItWroteOnce()
    {
        tests::PointSource source(tests::Ground::Random, 5);
        Tin tin = std::move(buildTin(source.points(500), source.domain())->tin);
        const std::string before = bytesOf(tin);
        const auto slide = [&](int frame) {
            TinEdit edit(tin);
            for (VertexId v = 10; v < 200; ++v)
                edit.transfer(v, v + 1, 1e-4 * ((frame + int(v)) % 3 - 1));
            return edit.commit();
        };
        Edit all = slide(0);
        const std::size_t once = all.byteSize();
        EditJoiner joiner(all);
        for (int frame = 1; frame < 1000; ++frame)
            QVERIFY(joiner.join(all, slide(frame)));
        QVERIFY(all.isValuesOnly());
        QVERIFY(all.byteSize() <= 2 * once);
        QCOMPARE(all.dirtyRanges(TinPart::Heights), (std::vector<SlotRange>{{10, 191}}));
        const std::string after = bytesOf(tin);
        tin.swap(all);
        QVERIFY(bytesOf(tin) == before);
        tin.swap(all);
        QVERIFY(bytesOf(tin) == after);
    }

    /// Few slots are sorted, many are marked.
    void dirtyRangesOfManySlots()
    {
        tests::PointSource source(tests::Ground::Random, 6);
        Tin tin = std::move(buildTin(source.points(9000), source.domain())->tin);
        for (const std::uint32_t count : {100u, 5000u, 60000u}) {
            TinEdit edit(tin);
            std::set<std::uint32_t> written;
            for (std::uint32_t i = 0; i < count; ++i) {
                const VertexId v = source.below(tin.arrays().vertexSlots());
                edit.setHeight(v, tin.arrays().heights[v] + 1);
                written.insert(v);
            }
            std::vector<SlotRange> expected;
            for (const std::uint32_t v : written) {
                if (expected.empty() || expected.back().first + expected.back().count != v)
                    expected.push_back({v, 0});
                ++expected.back().count;
            }
            QCOMPARE(edit.commit().dirtyRanges(TinPart::Heights), expected);
        }
    }

    void whatIsNotCommittedIsUndone()
    {
        tests::PointSource source(tests::Ground::Random, 4);
        auto built = buildTin(source.points(100), source.domain());
        const std::string before = bytesOf(built->tin);
        {
            TinEdit edit(built->tin);
            for (int i = 0; i < 50; ++i)
                tests::randomStep(edit, source);
        }
        QVERIFY(bytesOf(built->tin) == before);
        // And what follows does not depend on it having been there.
        auto fresh = buildTin(tests::PointSource(tests::Ground::Random, 4).points(100), source.domain());
        for (Tin *tin : {&built->tin, &fresh->tin}) {
            tests::PointSource steps(tests::Ground::Random, 99);
            TinEdit edit(*tin);
            for (int i = 0; i < 50; ++i)
                tests::randomStep(edit, steps);
            edit.commit();
        }
        QVERIFY(bytesOf(built->tin) == bytesOf(fresh->tin));
    }

    void dirtyRangesHoldEveryChange()
    {
        tests::PointSource source(tests::Ground::Grid, 8);
        auto built = buildTin(source.points(60), source.domain());
        Tin &tin = built->tin;
        for (int i = 0; i < 200; ++i) {
            const Tin before = tin;
            Edit edit = [&] {
                TinEdit open(tin);
                tests::randomStep(open, source);
                return open.commit();
            }();
            for (const TinPart part : {TinPart::Points, TinPart::Heights, TinPart::Triangles}) {
                const std::vector<std::uint32_t> changed = changedSlots(before.arrays(), tin.arrays(), part);
                std::vector<std::uint32_t> dirty;
                std::uint32_t end = 0;
                for (const SlotRange &range : edit.dirtyRanges(part)) {
                    QVERIFY(range.count > 0 && (dirty.empty() || range.first > end)); // ascending, joined
                    for (end = range.first; end < range.first + range.count; ++end)
                        dirty.push_back(end);
                }
                QVERIFY(std::includes(dirty.begin(), dirty.end(), changed.begin(), changed.end()));
                QVERIFY(dirty.size() <= changed.size() + 60); // written, but with what was there
            }
            QCOMPARE(edit.isEmpty(), bytesOf(before) == bytesOf(tin));
            QVERIFY(edit.byteSize() >= sizeof(Edit));
        }
    }

    void aHeightCostsAFewBytes()
    {
        Tin tin(Rectangle{{0, 0}, {1, 1}});
        TinEdit edit(tin);
        edit.setHeight(2, 5);
        const Edit done = edit.commit();
        QVERIFY(done.byteSize() < sizeof(Edit) + 100);
        QCOMPARE(done.dirtyRanges(TinPart::Heights), (std::vector<SlotRange>{{2, 1}}));
        QVERIFY(done.dirtyRanges(TinPart::Triangles).empty());
    }

    void aCopyIsASnapshot()
    {
        tests::PointSource source(tests::Ground::Random, 4);
        auto built = buildTin(source.points(100), source.domain());
        const Tin snapshot = built->tin;
        const std::string before = bytesOf(built->tin);
        TinEdit edit(built->tin);
        for (int i = 0; i < 50; ++i)
            tests::randomStep(edit, source);
        edit.commit();
        QVERIFY(bytesOf(snapshot) == before);
        QVERIFY(findDefects(snapshot).empty());
        QVERIFY(bytesOf(built->tin) != before);
    }
};

SANDREEL_TEST(TestJournal)
#include "tst_journal.moc"
