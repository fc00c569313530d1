// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/playback.h"
#include "tests/support/testmain.h"

#include <cmath>
#include <limits>
#include <random>

using namespace model;

namespace {

/// A player that a child would write: one frame at a time, with a direction.
struct Stepper
{
    int first, last;
    LoopMode mode;
    int frame;
    int direction;
    bool ended = false;

    void step()
    {
        if (ended)
            return;
        const int start = direction > 0 ? first : last, end = direction > 0 ? last : first;
        if (frame < first || frame > last) {
            frame = start;
            ended = mode == LoopMode::Once && frame == end;
            return;
        }
        if (mode == LoopMode::Loop) {
            frame = frame == end ? start : frame + direction;
        } else if (mode == LoopMode::Once) {
            frame = frame == end ? frame : frame + direction;
            ended = frame == end;
        } else if (first < last) {
            if (frame == end)
                direction = -direction;
            frame += direction;
        }
    }
};

} // namespace

Q_DECLARE_METATYPE(model::LoopMode)

class TestPlayback final : public QObject
{
    Q_OBJECT

private slots:
    void realTimeEqualsSteppingOneByOne_data()
    {
        QTest::addColumn<LoopMode>("mode");
        QTest::addColumn<bool>("reversed");
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("last");
        for (const auto &[name, mode] : {std::pair("once", LoopMode::Once), std::pair("loop", LoopMode::Loop),
                                         std::pair("ping-pong", LoopMode::PingPong)})
            for (const bool reversed : {false, true})
                for (const auto &[first, last] : {std::pair(0, 9), std::pair(2, 6), std::pair(3, 4), std::pair(5, 5)})
                    QTest::addRow("%s%s %d-%d", name, reversed ? " reversed" : "", first, last)
                        << mode << reversed << first << last;
    }
    void realTimeEqualsSteppingOneByOne()
    {
        QFETCH(LoopMode, mode);
        QFETCH(bool, reversed);
        QFETCH(int, first);
        QFETCH(int, last);
        // Times are whole 1/1024 s and rates powers of two, so that the reference is exact integer arithmetic.
        for (const int rate : {1, 8, 32, 64}) {
            Playback playback(10, rate);
            playback.setRange(first, last);
            playback.setLoopMode(mode);
            playback.setReversed(reversed);
            playback.seek(reversed ? last : first);
            Stepper expected{first, last, mode, reversed ? last : first, reversed ? -1 : 1};
            if (mode == LoopMode::Once && first == last)
                continue; // of one frame: see onceOfOneFrameEndsAfterIt
            playback.play();
            std::mt19937 random{std::uint32_t(rate)};
            std::int64_t ticks = 0, steps = 0;
            for (int i = 0; i < 500; ++i) {
                const int passed = int(random() % 400);
                ticks += passed;
                const int before = int(playback.frame());
                const bool told = playback.advance(passed / 1024.0);
                const bool wasEnded = expected.ended;
                for (; steps < ticks * rate / 1024; ++steps)
                    expected.step();
                QCOMPARE(int(playback.frame()), expected.frame);
                QCOMPARE(playback.isPlaying(), !expected.ended);
                QCOMPARE(told, expected.frame != before || expected.ended != wasEnded);
            }
        }
    }

    void oddRatesKeepTheClock()
    {
        // 29.97 frames in a second, whatever the ticks: after an hour the frame is that of the hour.
        Playback playback(1'000'000, 29.97);
        playback.play();
        std::mt19937 random(3);
        double time = 0;
        while (time < 3600) {
            const double passed = double(random() % 100) / 1000.0;
            time += passed;
            playback.advance(passed);
        }
        QVERIFY(std::abs(double(playback.frame()) - time * 29.97) <= 1.0);
    }

    void everyFrameShowsEachHoweverLongItTakes()
    {
        Playback playback(100, 25);
        playback.setPacing(Pacing::EveryFrame);
        playback.play();
        for (std::uint32_t frame = 1; frame < 100; ++frame) {
            QVERIFY(playback.advance(0.5)); // drawing takes ten times too long
            QCOMPARE(playback.frame(), frame);
        }
        // Of all that delay one frame is left to make up for.
        playback.setPacing(Pacing::RealTime);
        playback.seek(0);
        QVERIFY(!playback.advance(0.03));
    }

    void everyFrameMakesUpForOneFrameAtMost()
    {
        Playback playback(100, 10);
        playback.setPacing(Pacing::EveryFrame);
        playback.play();
        QVERIFY(playback.advance(5));
        QVERIFY(playback.advance(0)); // the one
        QVERIFY(!playback.advance(0));
        QCOMPARE(playback.frame(), 2u);
    }

    void secondsToNextFrameIsWhenSomethingHappens()
    {
        Playback playback(100, 25);
        QVERIFY(std::isinf(playback.secondsToNextFrame()));
        playback.play();
        QCOMPARE(playback.secondsToNextFrame(), 0.04);
        playback.advance(0.03);
        QVERIFY(!playback.advance(playback.secondsToNextFrame() - 1e-6));
        QVERIFY(playback.advance(2e-6));
    }

    void changingTheRateKeepsTheShareOfTheFrame()
    {
        Playback playback(100, 10);
        playback.play();
        playback.advance(0.05); // half of a frame
        playback.setFramesPerSecond(100);
        QVERIFY(std::abs(playback.secondsToNextFrame() - 0.005) < 1e-12);
    }

    void valuesOutOfRangeAreClamped()
    {
        Playback playback(10, 1000);
        QCOMPARE(playback.framesPerSecond(), 120.0);
        playback.setFramesPerSecond(0.2);
        QCOMPARE(playback.framesPerSecond(), 1.0);
        playback.setFramesPerSecond(std::numeric_limits<double>::quiet_NaN());
        QCOMPARE(playback.framesPerSecond(), 1.0);
        playback.seek(-5);
        QCOMPARE(playback.frame(), 0u);
        playback.seek(std::numeric_limits<std::int64_t>::max());
        QCOMPARE(playback.frame(), 9u);
        playback.step(std::numeric_limits<std::int64_t>::min());
        QCOMPARE(playback.frame(), 0u);
        playback.step(std::numeric_limits<std::int64_t>::max());
        QCOMPARE(playback.frame(), 9u);
        playback.step(-2);
        QCOMPARE(playback.frame(), 7u);
        playback.setRange(20, 4);
        QCOMPARE(playback.rangeFirst(), 4u);
        QCOMPARE(playback.rangeLast(), 9u);
        playback.play();
        QVERIFY(!playback.advance(-1));
        QVERIFY(!playback.advance(std::numeric_limits<double>::quiet_NaN()));
    }

    void sleepOfTheMachineDoesNoHarm()
    {
        for (const LoopMode mode : {LoopMode::Once, LoopMode::Loop, LoopMode::PingPong}) {
            Playback playback(10, 120);
            playback.setLoopMode(mode);
            playback.play();
            playback.advance(1e300);
            QVERIFY(playback.frame() < 10);
            QVERIFY(playback.secondsToNextFrame() >= 0);
        }
    }

    void onceOfOneFrameEndsAfterIt()
    {
        Playback playback(1, 10);
        playback.setLoopMode(LoopMode::Once);
        playback.play();
        QVERIFY(!playback.advance(0.05));
        QVERIFY(playback.isPlaying());
        QVERIFY(playback.advance(0.06));
        QVERIFY(!playback.isPlaying());
    }

    void playStartsOverFromTheEnd()
    {
        Playback playback(10, 10);
        playback.setLoopMode(LoopMode::Once);
        playback.setRange(2, 7);
        playback.seek(7);
        playback.play();
        QCOMPARE(playback.frame(), 2u);
        playback.setReversed(true);
        playback.pause();
        playback.play();
        QCOMPARE(playback.frame(), 7u);
    }

    void playFromOutsideTheRangeStartsIt()
    {
        Playback playback(10, 10);
        playback.setRange(4, 7);
        playback.seek(1);
        QCOMPARE(playback.frame(), 1u); // one may look there
        playback.play();
        QCOMPARE(playback.frame(), 4u);
        playback.setRange(6, 8); // the frame on show falls out while playing
        QVERIFY(playback.advance(0.1));
        QCOMPARE(playback.frame(), 6u);
    }

    void stopGoesToTheStartOfTheRange()
    {
        Playback playback(10, 10);
        playback.setRange(3, 8);
        playback.seek(5);
        playback.play();
        playback.stop();
        QVERIFY(!playback.isPlaying());
        QCOMPARE(playback.frame(), 3u);
        playback.setReversed(true);
        playback.stop();
        QCOMPARE(playback.frame(), 8u);
    }

    void pauseKeepsTheWayOfAPingPong()
    {
        Playback playback(5, 10);
        playback.setLoopMode(LoopMode::PingPong);
        playback.play();
        playback.advance(0.55); // 4 and back to 3
        QCOMPARE(playback.frame(), 3u);
        playback.pause();
        QVERIFY(!playback.advance(1));
        playback.play();
        playback.advance(0.1);
        QCOMPARE(playback.frame(), 2u);
    }

    void anotherLengthKeepsWhatStillFits()
    {
        Playback playback(10, 10);
        playback.seek(9);
        playback.setFrameCount(20);
        QCOMPARE(playback.rangeLast(), 19u); // all stays all
        QCOMPARE(playback.frame(), 9u);
        playback.setRange(5, 15);
        playback.setFrameCount(12);
        QCOMPARE(playback.rangeFirst(), 5u);
        QCOMPARE(playback.rangeLast(), 11u);
        playback.setFrameCount(3);
        QCOMPARE(playback.rangeFirst(), 2u);
        QCOMPARE(playback.rangeLast(), 2u);
        QCOMPARE(playback.frame(), 2u);
    }

    void frameAfterIsWhatPlayWillShow()
    {
        for (const LoopMode mode : {LoopMode::Once, LoopMode::Loop, LoopMode::PingPong})
            for (const std::uint32_t steps : {1u, 3u, 11u}) {
                Playback playback(7, 1);
                playback.setLoopMode(mode);
                playback.seek(2);
                playback.play();
                const std::uint32_t foreseen = playback.frameAfter(steps);
                playback.advance(steps);
                QCOMPARE(playback.frame(), foreseen);
            }
    }
};

SANDREEL_TEST(TestPlayback)
#include "tst_playback.moc"
