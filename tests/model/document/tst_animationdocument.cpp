// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/animationdocument.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"
#include "tests/support/validateanimation.h"

#include <limits>
#include <set>

using namespace model;

class TestAnimationDocument final : public QObject
{
    Q_OBJECT

    static tests::SequencePtr source() { return tests::wave(tests::cube(), 6); }

    /// The kinds of the notices that a document sends, by their index in AnimationChange.
    static auto recordedNotices(AnimationDocument &document)
    {
        auto kinds = std::make_shared<std::vector<std::size_t>>();
        connect(&document, &AnimationDocument::changed, &document,
                [kinds](const AnimationChange &change) { kinds->push_back(change.index()); });
        return kinds;
    }
    template <class Change>
    static std::vector<std::size_t> one()
    {
        return {AnimationChange(Change{}).index()};
    }

private slots:
    void startsAsItsSource()
    {
        const auto sequence = source();
        const AnimationDocument document(sequence, {PcaSettings{7, 123}});
        QVERIFY(document.source() == sequence);
        QCOMPARE(document.frameCount(), 6u);
        QCOMPARE(document.vertexCount(), 8u);
        QVERIFY(document.connectivity() == sequence->connectivity());
        QVERIFY(document.timing() == Timing({TimeMap::identity(6), 25.0}));
        QVERIFY(document.placement().isIdentity());
        QVERIFY(document.name() == "wave");
        QVERIFY(document.compression() == (CompressionSettings{PcaSettings{7, 123}}));
        QVERIFY(document.frames()->keepsFrames());
        QVERIFY(tests::brokenRules(document).empty());
    }

    void settersReturnTheOldValueAndTellOnce()
    {
        AnimationDocument document(source());
        const auto notices = recordedNotices(document);
        const auto told = [&] { return std::exchange(*notices, {}); };

        const Timing timing{TimeMap({5, 0.5}), 12};
        QVERIFY(document.setTiming(timing) == Timing({TimeMap::identity(6), 25.0}));
        QVERIFY(told() == one<TimingChanged>());
        QVERIFY(document.timing() == timing);
        QVERIFY(document.setTiming(timing) == timing);
        QVERIFY(told().empty());

        const Similarity placement{2, {1, 2, 3}};
        QVERIFY(document.setPlacement(placement).isIdentity());
        QVERIFY(told() == one<PlacementChanged>());
        QVERIFY(document.setPlacement(placement) == placement);
        QVERIFY(told().empty());

        QVERIFY(document.setName("other") == "wave");
        QVERIFY(told() == one<NameChanged>());
        QVERIFY(document.setName("other") == "other");
        QVERIFY(told().empty());

        const CompressionSettings settings{PcaSettings{30, 500}};
        QVERIFY(document.setCompression(settings) == CompressionSettings());
        QVERIFY(told() == one<CompressionChanged>());
        QVERIFY(document.setCompression(settings) == settings);
        QVERIFY(told().empty());
        QVERIFY(tests::brokenRules(document).empty());
    }

    void framesShowEveryEdit()
    {
        const auto sequence = source();
        AnimationDocument document(sequence);
        const auto untouched = document.frames();
        document.setTiming({TimeMap({5, 0}), 12});
        document.setPlacement({2, {1, 0, 0}});
        document.setName("other");
        const auto edited = document.frames();
        QCOMPARE(edited->frameCount(), 2u);
        QCOMPARE(edited->frameRate(), 12.0);
        QVERIFY(edited->name() == "other");
        const Vec3f last = sequence->frame(5)[3];
        QVERIFY(edited->frame(0)[3] == Vec3f({2 * last.x + 1, 2 * last.y, 2 * last.z}));
        // A snapshot does not follow.
        QCOMPARE(untouched->frameCount(), 6u);
        QVERIFY(untouched->name() == "wave");
        QVERIFY(untouched->frame(5) == sequence->frame(5));
    }

    void stateIsWholeWhenTheNoticeArrives()
    {
        AnimationDocument document(source());
        int calls = 0;
        connect(&document, &AnimationDocument::changed, &document, [&] {
            ++calls;
            QVERIFY(tests::brokenRules(document).empty());
        });
        document.setTiming({TimeMap({1}), 12});
        document.setPlacement({2, {}});
        document.setName("");
        document.setCompression({PcaSettings{1, 1}});
        QCOMPARE(calls, 4);
    }

    void fingerprintTellsEverythingApartThatIsSaved()
    {
        const std::vector<void (*)(AnimationDocument &)> edits{
            [](AnimationDocument &) {},
            [](AnimationDocument &d) {
                d.setTiming({d.timing().map, 24});
            },
            [](AnimationDocument &d) {
                d.setTiming({d.timing().map.reversed(), 25});
            },
            [](AnimationDocument &d) {
                d.setTiming({d.timing().map.trimmed(0, 4), 25});
            },
            [](AnimationDocument &d) {
                d.setTiming({TimeMap({0, 1, 2, 3, 4, 4.75}), 25});
            },
            [](AnimationDocument &d) {
                d.setPlacement({2, {0, 0, 0}});
            },
            [](AnimationDocument &d) {
                d.setPlacement({1, {2, 0, 0}});
            },
            [](AnimationDocument &d) {
                d.setPlacement({1, {0, 2, 0}});
            },
            [](AnimationDocument &d) {
                d.setPlacement({1, {0, 0, 2}});
            },
            [](AnimationDocument &d) { d.setName("wavf"); },
            [](AnimationDocument &d) { d.setName(""); },
            [](AnimationDocument &d) {
                d.setCompression({PcaSettings{21, 10000}});
            },
            [](AnimationDocument &d) {
                d.setCompression({PcaSettings{20, 10001}});
            },
        };
        std::set<std::uint64_t> fingerprints;
        for (const auto edit : edits) {
            AnimationDocument document(source());
            edit(document);
            fingerprints.insert(document.fingerprint());
            AnimationDocument again(source());
            edit(again);
            QCOMPARE(again.fingerprint(), document.fingerprint());
        }
        fingerprints.insert(AnimationDocument(tests::noise(tests::cube(), 6)).fingerprint());
        QCOMPARE(fingerprints.size(), edits.size() + 1);
    }

    /// The validator is worth something only if it sees each rule broken.
    void validatorReportsEachRule_data()
    {
        QTest::addColumn<QString>("rule");
        QTest::addColumn<int>("index");
        for (int i = 0; i < int(breakings().size()); ++i)
            QTest::addRow("%d %s", i, breakings()[std::size_t(i)].first)
                << QString(breakings()[std::size_t(i)].first) << i;
    }
    void validatorReportsEachRule()
    {
        QFETCH(QString, rule);
        QFETCH(int, index);
        tests::AnimationState state = tests::stateOf(AnimationDocument(source()));
        QVERIFY(tests::brokenRules(state).empty());
        breakings()[std::size_t(index)].second(state);
        QVERIFY(tests::brokenRules(state) == std::vector<std::string>{rule.toStdString()});
    }

private:
    using State = tests::AnimationState;
    static const std::vector<std::pair<const char *, void (*)(State &)>> &breakings()
    {
        static const double nan = std::numeric_limits<double>::quiet_NaN();
        static const std::vector<std::pair<const char *, void (*)(State &)>> list{
            {"there is a frame",
             [](State &s) {
                 s.sourcePositions.clear();
                 s.shownSourcePositions.clear();
                 s.shownFrameCount = 0;
             }},
            {"every frame lies in the source",
             [](State &s) { s.sourcePositions[1] = s.shownSourcePositions[1] = 5.5; }},
            {"every frame lies in the source", [](State &s) { s.sourcePositions[1] = s.shownSourcePositions[1] = -1; }},
            {"the rate is above zero", [](State &s) { s.frameRate = s.shownFrameRate = 0; }},
            {"the placement is finite and its scale above zero",
             [](State &s) { s.placement.scale = s.shownPlacement.scale = 0; }},
            {"the placement is finite and its scale above zero",
             [](State &s) {
                 s.placement.offset[1] = s.shownPlacement.offset[1] = std::numeric_limits<double>::infinity();
             }},
            {"basis is in range",
             [](State &s) {
                 s.compression.method = PcaSettings{0, 1e4};
             }},
            {"basis is in range",
             [](State &s) {
                 s.compression.method = PcaSettings{1001, 1e4};
             }},
            {"resolution is in range",
             [](State &s) {
                 s.compression.method = PcaSettings{20, nan};
             }},
            {"resolution is in range",
             [](State &s) {
                 s.compression.method = PcaSettings{20, 2e7};
             }},
            {"step is in range",
             [](State &s) {
                 s.compression.method = ReelSettings{0, 20};
             }},
            {"predictor is in range",
             [](State &s) {
                 s.compression.method = DirectSettings{10, Predictor(5)};
             }},
            {"the frames follow the time map", [](State &s) { s.shownFrameCount = 5; }},
            {"the frames follow the time map", [](State &s) { s.shownSourcePositions[2] = 1; }},
            {"the frames have the rate", [](State &s) { s.shownFrameRate = 24; }},
            {"the frames have the placement", [](State &s) { s.shownPlacement.offset[2] = 1; }},
            {"the frames have the name", [](State &s) { s.shownName = "other"; }},
            {"the frames are those of the source", [](State &s) { s.showsSource = false; }},
            {"positions are finite", [](State &s) { s.positionsAreFinite = false; }},
        };
        return list;
    }
};

SANDREEL_TEST(TestAnimationDocument)
#include "tst_animationdocument.moc"
