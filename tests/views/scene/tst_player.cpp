// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"
#include "views/scene/player.h"

#include <QSemaphore>
#include <QSignalSpy>

#include <atomic>
#include <mutex>
#include <set>

using namespace views;

namespace {

/// Frames whose x is their number; counts what is asked for; waits at a gate or for a while with each.
class FakeSource final : public model::FrameSource
{
public:
    explicit FakeSource(std::uint32_t frameCount, int milliseconds = 0, double rate = 100)
        : mFrameCount(frameCount)
        , mMilliseconds(milliseconds)
        , mRate(rate)
    {
        mConnectivity.vertexCount = 3;
        mConnectivity.triangles = {{0, 1, 2}};
    }

    std::uint32_t frameCount() const override { return mFrameCount; }
    const model::Connectivity &connectivity() const override { return mConnectivity; }
    void positions(std::uint32_t frame, std::span<model::Vec3f> out) const override
    {
        {
            const std::lock_guard lock(mMutex);
            mAsked.push_back(frame);
        }
        started.release();
        if (isGated)
            gate.acquire();
        if (mMilliseconds > 0)
            QThread::msleep(unsigned(mMilliseconds));
        const auto x = float(frame);
        out[0] = {x, 0, 0};
        out[1] = {x, 1, 0};
        out[2] = {x, 0, 1};
    }
    double frameRate() const override { return mRate; }
    const std::string &name() const override { return mName; }
    std::uint64_t digest() const override { return 1; }
    std::size_t memoryBytes() const override { return 0; }

    std::vector<std::uint32_t> asked() const
    {
        const std::lock_guard lock(mMutex);
        return mAsked;
    }

    std::atomic<bool> isGated = false;
    mutable QSemaphore gate, started;

private:
    const std::uint32_t mFrameCount;
    const int mMilliseconds;
    const double mRate;
    std::string mName;
    model::Connectivity mConnectivity;
    mutable std::mutex mMutex;
    mutable std::vector<std::uint32_t> mAsked;
};

/// Notes the frames that are ready, and checks each.
struct Watcher
{
    explicit Watcher(Player &player)
    {
        QObject::connect(&player, &Player::frameReady, &player, [this](const FrameDataPtr &data) {
            frames.push_back(data->frame);
            QCOMPARE(data->positions[0].x, float(data->frame));
            QCOMPARE(data->normals[1], (model::Vec3f{1, 0, 0}));
        });
    }
    std::vector<std::uint32_t> frames;
};

bool isShown(const Player &player, std::uint32_t frame)
{
    return player.currentFrame() && player.currentFrame()->source == player.source() &&
           player.currentFrame()->frame == frame;
}

} // namespace

class TestPlayer final : public QObject
{
    Q_OBJECT

private slots:
    void withoutASourceNothingHappens()
    {
        Player player;
        player.play();
        player.seek(5);
        player.stop();
        QVERIFY(!player.playback().isPlaying());
        QVERIFY(!player.currentFrame());
        QCOMPARE(player.playback().frame(), 0u);
    }

    void sourceGivesItsFirstFrameAndItsRate()
    {
        Player player;
        QSignalSpy changed(&player, &Player::sourceChanged);
        player.setSource(std::make_shared<FakeSource>(10, 0, 30));
        QCOMPARE(changed.size(), 1);
        QCOMPARE(player.playback().framesPerSecond(), 30.0);
        QCOMPARE(player.playback().frameCount(), 10u);
        QTRY_VERIFY(isShown(player, 0));
    }

    void rateOfTheUserOutlivesAnEdit()
    {
        Player player;
        player.setSource(std::make_shared<FakeSource>(10, 0, 30));
        player.setFramesPerSecond(7);
        player.setSource(std::make_shared<FakeSource>(8, 0, 30));
        QCOMPARE(player.playback().framesPerSecond(), 7.0);
        player.setSource(std::make_shared<FakeSource>(8, 0, 60)); // resampled
        QCOMPARE(player.playback().framesPerSecond(), 60.0);
    }

    void newestRequestWins()
    {
        Player player;
        const auto source = std::make_shared<FakeSource>(1000);
        source->isGated = true;
        player.setSource(source);
        source->started.acquire(); // frame 0 is being made
        for (int frame = 1; frame <= 500; ++frame)
            player.seek(frame);
        source->isGated = false;
        source->gate.release(10);
        QTRY_VERIFY(isShown(player, 500));
        QCOMPARE(source->asked(), std::vector<std::uint32_t>({0, 500}));
    }

    void scrubbingShowsFramesOnTheWay()
    {
        Player player;
        const auto source = std::make_shared<FakeSource>(1000);
        source->isGated = true;
        player.setSource(source);
        Watcher watcher(player);
        source->started.acquire();
        source->gate.release();
        player.seek(10);
        source->started.acquire();
        player.seek(20); // while 10 is being made
        source->gate.release(2);
        QTRY_VERIFY(isShown(player, 20));
        QCOMPARE(watcher.frames, std::vector<std::uint32_t>({0, 10, 20}));
    }

    void everyFrameIsShownOnceAndInOrder()
    {
        Player player;
        const auto source = std::make_shared<FakeSource>(30, 3, 120);
        player.setPacing(model::Pacing::EveryFrame);
        player.setLoopMode(model::LoopMode::Once);
        player.setSource(source);
        QTRY_VERIFY(isShown(player, 0));
        Watcher watcher(player);
        connect(&player, &Player::frameReady, &player, [&player](const FrameDataPtr &data) {
            QTimer::singleShot(2, &player, [&player, frame = data->frame] { player.frameShown(frame); });
        });
        player.play();
        QTRY_VERIFY(!player.playback().isPlaying());
        QTRY_VERIFY(isShown(player, 29));
        std::vector<std::uint32_t> all;
        for (std::uint32_t frame = 1; frame < 30; ++frame)
            all.push_back(frame);
        QCOMPARE(watcher.frames, all);
        QCOMPARE(source->asked().size(), std::size_t(30)); // what is made ahead is not made again
    }

    void everyFrameWaitsUntilItIsShown()
    {
        Player player;
        player.setPacing(model::Pacing::EveryFrame);
        player.setSource(std::make_shared<FakeSource>(30, 0, 120));
        QTRY_VERIFY(isShown(player, 0));
        player.play();
        QTRY_VERIFY(isShown(player, 1));
        QTest::qWait(60); // many frames of 120 in a second
        QCOMPARE(player.playback().frame(), 1u);
        player.frameShown(0); // another frame says nothing
        QTest::qWait(30);
        QCOMPARE(player.playback().frame(), 1u);
        player.frameShown(1);
        QTRY_COMPARE(player.playback().frame(), 2u);
        player.setPacing(model::Pacing::RealTime); // and from now on nobody waits
        QTRY_VERIFY(player.playback().frame() > 4);
    }

    void realTimeDropsWhatItCannotMake()
    {
        Player player;
        const auto source = std::make_shared<FakeSource>(60, 40, 120); // three times too slow
        player.setLoopMode(model::LoopMode::Once);
        player.setSource(source);
        QTRY_VERIFY(isShown(player, 0));
        Watcher watcher(player);
        player.play();
        QTRY_VERIFY(!player.playback().isPlaying());
        QTRY_VERIFY(isShown(player, 59));
        QVERIFY(watcher.frames.size() < 40);
        QVERIFY(watcher.frames.size() > 2); // but it is a film, not only its end
        QVERIFY(std::ranges::is_sorted(watcher.frames));
    }

    void framesAheadAreReadyWhenDue()
    {
        Player player;
        const auto source = std::make_shared<FakeSource>(50, 0, 1); // a second for what takes no time
        player.setSource(source);
        QTRY_VERIFY(isShown(player, 0));
        player.play();
        QTRY_COMPARE(source->asked(), std::vector<std::uint32_t>({0, 1})); // before its time
        QCOMPARE(player.playback().frame(), 0u);
        QVERIFY(isShown(player, 0));
    }

    void jumpDropsWhatWasMadeAhead()
    {
        Player player;
        const auto source = std::make_shared<FakeSource>(500, 0, 1);
        player.setSource(source);
        QTRY_VERIFY(isShown(player, 0));
        source->isGated = true;
        source->started.acquire(int(source->started.available()));
        player.play();
        source->started.acquire(); // frame 1, ahead
        Watcher watcher(player);
        player.seek(300);
        source->isGated = false;
        source->gate.release(10);
        QTRY_VERIFY(isShown(player, 300));
        QCOMPARE(watcher.frames, std::vector<std::uint32_t>({300}));
    }

    void buffersAreUsedAgain()
    {
        Player player;
        player.setSource(std::make_shared<FakeSource>(200));
        std::set<const void *> buffers;
        connect(&player, &Player::frameReady, &player,
                [&](const FrameDataPtr &data) { buffers.insert(data->positions.data()); });
        for (int frame = 1; frame < 100; ++frame) {
            player.seek(frame);
            QTRY_VERIFY(isShown(player, std::uint32_t(frame)));
        }
        QVERIFY2(buffers.size() <= 4, qPrintable(QString::number(buffers.size())));
    }

    void destructionWaitsForTheFrameInWork()
    {
        const auto source = std::make_shared<FakeSource>(10);
        source->isGated = true;
        auto player = std::make_unique<Player>();
        player->setSource(source);
        source->started.acquire();
        player->seek(5);
        source->gate.release(10);
        player.reset();
        QCoreApplication::processEvents(); // a frame delivered to nobody
        QVERIFY(source.use_count() == 1);
    }

    void frameMayOutliveThePlayer()
    {
        FrameDataPtr kept;
        {
            Player player;
            player.setSource(std::make_shared<FakeSource>(10));
            QTRY_VERIFY(isShown(player, 0));
            kept = player.currentFrame();
        }
        QCOMPARE(kept->positions.size(), std::size_t(3));
    }

    void anotherSourceWhileOneIsAtWork()
    {
        Player player;
        const auto slow = std::make_shared<FakeSource>(10);
        slow->isGated = true;
        player.setSource(slow);
        slow->started.acquire();
        const auto next = std::make_shared<FakeSource>(20);
        player.setSource(next);
        Watcher watcher(player);
        connect(&player, &Player::frameReady, &player,
                [&](const FrameDataPtr &data) { QVERIFY(data->source == player.source()); });
        slow->gate.release();
        QTRY_VERIFY(isShown(player, 0));
        QCOMPARE(watcher.frames.size(), std::size_t(1));
        QVERIFY(player.currentFrame()->source == next);
        QTRY_COMPARE(slow.use_count(), 1); // nobody holds on to it
    }

    void shorterSourceClampsTheFrame()
    {
        Player player;
        player.setSource(std::make_shared<FakeSource>(100));
        player.seek(80);
        QTRY_VERIFY(isShown(player, 80));
        QSignalSpy moved(&player, &Player::frameChanged);
        player.setSource(std::make_shared<FakeSource>(50));
        QCOMPARE(player.playback().frame(), 49u);
        QCOMPARE(moved.size(), 1);
        QTRY_VERIFY(isShown(player, 49));
    }

    void noSourceAnyMore()
    {
        Player player;
        player.setSource(std::make_shared<FakeSource>(100));
        player.play();
        QTRY_VERIFY(player.currentFrame() && player.currentFrame()->frame > 0); // whichever is caught passing by
        player.setSource(nullptr);
        QVERIFY(!player.currentFrame());
        QVERIFY(!player.playback().isPlaying());
        QTest::qWait(30); // late frames change nothing
        QVERIFY(!player.currentFrame());
    }

    void scrubbingPausesAndResumes()
    {
        Player player;
        player.setSource(std::make_shared<FakeSource>(100));
        player.beginScrub();
        player.seek(3);
        player.endScrub();
        QVERIFY(!player.playback().isPlaying()); // was not playing
        player.play();
        player.beginScrub();
        QVERIFY(!player.playback().isPlaying());
        player.seek(50);
        player.endScrub();
        QVERIFY(player.playback().isPlaying());
        QVERIFY(player.playback().frame() >= 50);
        player.setLoopMode(model::LoopMode::Once);
        player.beginScrub();
        player.seek(99);
        player.endScrub();
        QVERIFY(!player.playback().isPlaying()); // it is over
        QCOMPARE(player.playback().frame(), 99u);
    }

    void eachChangeIsToldOnce()
    {
        Player player;
        player.setSource(std::make_shared<FakeSource>(100));
        QSignalSpy state(&player, &Player::stateChanged), moved(&player, &Player::frameChanged);
        player.setReversed(true);
        player.setReversed(true);
        QCOMPARE(state.size(), 1);
        player.setFramesPerSecond(12);
        player.setLoopMode(model::LoopMode::PingPong);
        player.setPacing(model::Pacing::EveryFrame);
        player.setRange(10, 20);
        QCOMPARE(state.size(), 5);
        player.seek(15);
        player.seek(15);
        player.step(2);
        player.goToFirst();
        player.goToLast();
        QCOMPARE(moved.size(), 4);
        QCOMPARE(player.playback().frame(), 20u);
        player.stop(); // reversed: its start is the end of the range
        QCOMPARE(moved.size(), 4);
        player.togglePlay();
        player.togglePlay();
        QCOMPARE(state.size(), 7);
    }
};

SANDREEL_TEST(TestPlayer)
#include "tst_player.moc"
