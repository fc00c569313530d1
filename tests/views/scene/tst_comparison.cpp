// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"
#include "views/scene/comparison.h"

#include <QSignalSpy>

#include <atomic>
#include <thread>

using namespace views;

namespace {

constexpr std::uint32_t Frames = 8;

std::function<model::Result<Original>(const model::Progress &)> giving(model::FrameSourcePtr frames,
                                                                       std::vector<std::uint32_t> permutation = {})
{
    return [=](const model::Progress &) -> model::Result<Original> { return Original{frames, permutation}; };
}

} // namespace

class TestComparison final : public QObject
{
    Q_OBJECT

private:
    const tests::SequencePtr mOriginal = tests::wave(tests::torus(), Frames);
    const tests::SequencePtr mDecoded = tests::noise(tests::torus(), Frames);
    std::unique_ptr<Player> mPlayer;
    std::unique_ptr<Comparison> mComparison;

    bool settle()
    {
        return QTest::qWaitFor([this] { return !mComparison->isReading() && !mComparison->isMeasuring(); }, 20000);
    }

private slots:
    void init()
    {
        mPlayer = std::make_unique<Player>();
        mComparison = std::make_unique<Comparison>(*mPlayer);
        mPlayer->setSource(mDecoded);
    }
    void cleanup()
    {
        mComparison.reset();
        mPlayer.reset();
    }

    void measuresInTheBackground()
    {
        QSignalSpy changed(mComparison.get(), &Comparison::changed);
        mComparison->start("wave", giving(mOriginal));
        QVERIFY(mComparison->isActive() && mComparison->isReading() && !mComparison->result());
        QCOMPARE(mComparison->originalName(), "wave");
        QVERIFY(settle());
        const model::ComparisonResult expected = *model::compareAnimations(*mOriginal, *mDecoded);
        QVERIFY(mComparison->result().has_value());
        QCOMPARE(mComparison->result()->kgErrorPercent, expected.kgErrorPercent);
        QCOMPARE(mComparison->result()->frames.size(), std::size_t(Frames));
        QVERIFY(!changed.isEmpty());
    }

    /// One float for each vertex comes with the frame, computed where the frame is.
    void framesCarryTheirErrors()
    {
        mComparison->start("wave", giving(mOriginal));
        QVERIFY(settle());
        for (const int frame : {5, 0}) {
            mPlayer->seek(frame);
            const auto isThere = [&] {
                const FrameDataPtr shown = mPlayer->currentFrame();
                return shown && shown->frame == std::uint32_t(frame) && shown->original;
            };
            QVERIFY(QTest::qWaitFor(isThere, 20000));
            const FrameDataPtr shown = mPlayer->currentFrame();
            QCOMPARE(shown->errors.size(), std::size_t(mDecoded->vertexCount()));
            float largest = 0;
            for (std::size_t i = 0; i < shown->errors.size(); ++i) {
                const float error = model::length(mDecoded->frameView(std::uint32_t(frame))[i] -
                                                  mOriginal->frameView(std::uint32_t(frame))[i]);
                QCOMPARE(shown->errors[i], error);
                largest = std::max(largest, error);
            }
            QCOMPARE(shown->largestError, largest);
        }
        mComparison->stop();
        QVERIFY(QTest::qWaitFor([&] { return mPlayer->currentFrame()->errors.empty(); }, 20000));
    }

    void verticesMayComeInAnotherOrder()
    {
        const std::uint32_t count = mOriginal->vertexCount();
        std::vector<std::uint32_t> order(count);
        std::vector<model::Vec3f> positions;
        for (std::uint32_t i = 0; i < count; ++i)
            order[i] = (5 * i + 3) % count;
        for (std::uint32_t i = 0; i < count * Frames; ++i)
            positions.push_back(mOriginal->frameView(i / count)[order[i % count]]);
        mPlayer->setSource(std::make_shared<model::Sequence>(mOriginal->connectivity(), positions));
        mComparison->start("wave", giving(mOriginal, order));
        QVERIFY(settle());
        QCOMPARE(mComparison->result()->maxVertexError, 0.0);
        QVERIFY(QTest::qWaitFor([&] { return mPlayer->currentFrame() && mPlayer->currentFrame()->original; }, 20000));
        QCOMPARE(mPlayer->currentFrame()->largestError, 0.0f);
    }

    /// As after trimming and its undo.
    void anEditIsMeasuredAnew()
    {
        mComparison->start("wave", giving(mOriginal));
        QVERIFY(settle());
        const double before = mComparison->result()->kgErrorPercent;

        mPlayer->setSource(tests::noise(tests::torus(), Frames - 3));
        QVERIFY(!mComparison->result()); // at once: nobody may show errors of other frames
        QVERIFY(settle());
        QVERIFY(!mComparison->result() && mComparison->isActive() && mComparison->mismatch());
        QVERIFY(mComparison->mismatch()->code == model::ErrorCode::MeshesDiffer);
        QVERIFY(!mPlayer->original());

        mPlayer->setSource(mDecoded);
        QVERIFY(settle());
        QVERIFY(mComparison->result() && !mComparison->mismatch());
        QCOMPARE(mComparison->result()->kgErrorPercent, before);
    }

    void whatNeverMatchedIsRefused_data()
    {
        QTest::addColumn<bool>("readable");
        QTest::newRow("cannot be read") << false;
        QTest::newRow("another size") << true;
    }
    void whatNeverMatchedIsRefused()
    {
        QFETCH(bool, readable);
        QSignalSpy failed(mComparison.get(), &Comparison::failed);
        mComparison->start("other", [readable](const model::Progress &) -> model::Result<Original> {
            if (!readable)
                return model::fail(model::ErrorCode::NotFound);
            return Original{tests::wave(tests::cube(), Frames), {}};
        });
        QVERIFY(QTest::qWaitFor([&] { return !failed.isEmpty(); }, 20000));
        QCOMPARE(failed.count(), 1);
        QCOMPARE(failed[0][0].toString(), "other");
        QVERIFY(failed[0][1].value<model::Error>().code ==
                (readable ? model::ErrorCode::MeshesDiffer : model::ErrorCode::NotFound));
        QVERIFY(!mComparison->isActive() && !mComparison->result() && !mPlayer->original());
    }

    void cancelLeavesNothing()
    {
        const auto begun = std::make_shared<std::atomic<bool>>(false);
        mComparison->start("slow", [begun](const model::Progress &progress) -> model::Result<Original> {
            *begun = true;
            while (!progress.isCancelled())
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            return Original{tests::wave(tests::torus(), Frames), {}}; // too late to be stopped
        });
        QVERIFY(QTest::qWaitFor([&] { return begun->load(); }, 20000));
        mComparison->cancel();
        QVERIFY(!mComparison->isActive() && !mComparison->isReading());
        QTest::qWait(50);
        QVERIFY(!mComparison->isActive() && !mComparison->result());
        // And another one can follow.
        mComparison->start("wave", giving(mOriginal));
        QVERIFY(settle());
        QVERIFY(mComparison->result().has_value());
        mComparison->cancel(); // nothing runs: nothing is lost
        QVERIFY(mComparison->result().has_value());
    }
};

SANDREEL_TEST(TestComparison)
#include "tst_comparison.moc"
