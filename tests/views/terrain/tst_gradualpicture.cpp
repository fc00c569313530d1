// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testmain.h"
#include "tests/views/terrain/groundshapes.h"
#include "tests/views/terrain/settled.h"
#include "views/terrain/picture/dirtyslots.h"
#include "views/viewport/glsupport.h"

#include <QTimer>

#include <random>

using namespace model::terrain;
using namespace views;

/// Pictures that are drawn in steps, where the processor draws: the window answers between them.
class TestGradualPicture final : public QObject
{
    Q_OBJECT

private:
    static constexpr QSize Size{500, 400};

    std::unique_ptr<model::TerrainDocument> mDocument;

    std::unique_ptr<TerrainViewport> shown(const StepLimits &limits)
    {
        auto viewport = std::make_unique<TerrainViewport>(*mDocument);
        viewport->setStepLimits(limits);
        viewport->resize(Size);
        viewport->show();
        return QTest::qWaitForWindowExposed(viewport.get()) ? std::move(viewport) : nullptr;
    }
    /// Steps as small as a processor's, each in a turn of its own.
    static StepLimits smallSteps()
    {
        StepLimits limits = StepLimits::software();
        limits.tile = {128, 96};
        limits.chunks = 3;
        limits.milliseconds = 0;
        return limits;
    }
    static StepLimits atOnce()
    {
        StepLimits limits;
        limits.coarsePixels = StepLimits::software().coarsePixels;
        return limits;
    }
    static Edit dig(model::TerrainDocument &document, Point2 middle, double radius)
    {
        return document.edit([&](TinEdit &edit) {
            const TinArrays &tin = edit.tin().arrays();
            for (VertexId v = 0; v < tin.vertexSlots(); ++v)
                if (std::hypot(tin.points[v].x - middle.x, tin.points[v].y - middle.y) < radius)
                    edit.setHeight(v, tin.heights[v] - 0.05);
        });
    }

private slots:
    void initTestCase() { QVERIFY2(glSupport().isSufficient, "these tests need a display with OpenGL 3.3"); }
    void init() { mDocument = tests::groundDocument(tests::UnitSquare, 220, tests::dunes); }
    void cleanup() { mDocument.reset(); }

    void stepsAreSmallAndTheWindowAnswersBetweenThem()
    {
        const auto viewport = shown(smallSteps());
        QVERIFY(viewport);
        tests::settled(*viewport);
        int turns = 0;
        QTimer turn;
        turn.callOnTimeout([&] { ++turns; });
        const std::uint64_t before = viewport->workDone().steps;
        model::OrbitCamera camera = viewport->camera();
        camera.orbit(0.2f, 0.1f);
        viewport->setCamera(camera);
        turn.start(0);
        tests::settled(*viewport);
        const std::uint64_t steps = viewport->workDone().steps - before;
        QVERIFY2(steps >= 20, qPrintable(QString::number(steps))); // 4 x 5 tiles
        QVERIFY2(turns + 10 >= int(steps), qPrintable(QString("%1 turns, %2 steps").arg(turns).arg(steps)));
        QVERIFY(viewport->workDone().mostPixels <= 128 * 96 && viewport->workDone().mostPixels > 0);
        QVERIFY(viewport->workDone().mostChunks <= 3 && viewport->workDone().mostChunks > 0);
    }

    void cameraThatMovesIsFollowedAtOnce()
    {
        const auto viewport = shown(smallSteps());
        QVERIFY(viewport);
        const QImage before = tests::settled(*viewport);
        const std::uint64_t steps = viewport->workDone().steps;
        model::OrbitCamera camera = viewport->camera();
        camera.orbit(0.4f, 0);
        viewport->setCamera(camera);
        const QImage moving = viewport->grabFramebuffer();
        QCOMPARE(viewport->workDone().steps, steps); // a coarse picture: no step was needed
        QVERIFY(moving != before);
        QVERIFY(tests::settled(*viewport) != moving);
    }

    void stepsMakeTheSamePicture()
    {
        const auto steps = shown(smallSteps()), whole = shown(atOnce());
        QVERIFY(steps && whole);
        TerrainStyle style = whole->style();
        style.hasContours = true;
        style.edges = GroundEdges::Constrained;
        for (const auto &viewport : {steps.get(), whole.get()})
            viewport->setStyle(style);
        const QImage first = tests::settled(*whole);
        QCOMPARE(tests::settled(*steps), first);
        // After edits here and there, of which only parts are drawn anew.
        Edit near = dig(*mDocument, {0.4, 0.3}, 0.1);
        Edit far = dig(*mDocument, {0.8, 0.8}, 0.05);
        const QImage dug = tests::settled(*steps);
        QVERIFY(dug != first);
        TerrainViewport fresh(*mDocument);
        fresh.setStepLimits(atOnce());
        fresh.resize(Size);
        fresh.setStyle(style);
        fresh.show();
        QVERIFY(QTest::qWaitForWindowExposed(&fresh));
        fresh.setCamera(steps->camera());
        QVERIFY(differenceOf(tests::settled(fresh), dug) < dug.width() * dug.height() / 500);
        mDocument->swap(far);
        mDocument->swap(near);
        QVERIFY(differenceOf(tests::settled(*steps), first) < dug.width() * dug.height() / 500);
    }

    /// Pixels that a person could tell apart.
    static int differenceOf(const QImage &a, const QImage &b)
    {
        int count = 0;
        for (int y = 0; y < a.height(); ++y)
            for (int x = 0; x < a.width(); ++x)
                count += std::abs(qGreen(a.pixel(x, y)) - qGreen(b.pixel(x, y))) > 6;
        return count;
    }

    void graphicsCardDrawsAtOnce()
    {
        const auto card = shown(StepLimits()), steps = shown(smallSteps());
        QVERIFY(card && steps);
        QCOMPARE(card->style().quality, steps->style().quality);
        const QImage expected = tests::settled(*steps);
        // It smooths edges.
        QVERIFY(differenceOf(tests::settled(*card), expected) < expected.width() * expected.height() / 20);
        dig(*mDocument, {0.5, 0.5}, 0.1);
        const QImage dug = card->grabFramebuffer(); // no waiting
        QVERIFY(differenceOf(dug, expected) > 200);
        QVERIFY(!card->isLoading());
        QVERIFY(differenceOf(tests::settled(*steps), dug) < expected.width() * expected.height() / 20);
    }

    void smallEditIsDrawnInFewSteps()
    {
        const auto viewport = shown(smallSteps());
        QVERIFY(viewport);
        TerrainStyle style = viewport->style();
        style.quality = GroundQuality::Low; // no shadows
        viewport->setStyle(style);
        tests::settled(*viewport);
        const std::uint64_t first = viewport->workDone().steps;
        model::OrbitCamera camera = viewport->camera();
        camera.orbit(0.01f, 0);
        viewport->setCamera(camera);
        tests::settled(*viewport);
        const std::uint64_t before = viewport->workDone().steps, whole = before - first;
        dig(*mDocument, {0.5, 0.5}, 0.02);
        tests::settled(*viewport);
        const std::uint64_t steps = viewport->workDone().steps - before;
        QVERIFY2(steps > 0 && 3 * steps < whole, qPrintable(QString("%1 of %2").arg(steps).arg(whole)));
    }

    void staleTilesAreThePixelsThatWereAdded()
    {
        std::mt19937 random(3);
        const auto below = [&](int end) { return int(random() % unsigned(end)); };
        constexpr int Width = 97, Height = 61;
        for (int round = 0; round < 50; ++round) {
            StaleTiles tiles;
            tiles.reset({Width, Height}, {1 + below(40), 1 + below(40)});
            QVERIFY(tiles.isEmpty());
            QImage added(Width, Height, QImage::Format_Mono);
            added.fill(0);
            for (int k = below(4); k >= 0; --k) {
                const QRect part(below(Width + 20) - 10, below(Height + 20) - 10, 1 + below(50), 1 + below(30));
                tiles.add(part);
                for (int y = std::max(part.top(), 0); y <= std::min(part.bottom(), Height - 1); ++y)
                    for (int x = std::max(part.left(), 0); x <= std::min(part.right(), Width - 1); ++x)
                        added.setPixel(x, y, 1);
            }
            QImage taken(Width, Height, QImage::Format_Mono);
            taken.fill(0);
            while (!tiles.isEmpty()) {
                const QRect part = tiles.take();
                QVERIFY(!part.isEmpty() && QRect(0, 0, Width, Height).contains(part));
                QVERIFY(part.width() <= tiles.tile().width() && part.height() <= tiles.tile().height());
                for (int y = part.top(); y <= part.bottom(); ++y)
                    for (int x = part.left(); x <= part.right(); ++x) {
                        QCOMPARE(taken.pixelIndex(x, y), 0); // no pixel twice
                        taken.setPixel(x, y, 1);
                    }
            }
            for (int y = 0; y < Height; ++y)
                for (int x = 0; x < Width; ++x)
                    QVERIFY(taken.pixelIndex(x, y) >= added.pixelIndex(x, y));
        }
    }

    void noDirtySlotWaitsForEver()
    {
        DirtySlots dirty;
        for (std::uint32_t slot = 0; slot < 1000; slot += 3)
            dirty.add(slot);
        dirty.add(3); // once is enough
        QCOMPARE(dirty.count(), std::size_t(334));
        std::vector<int> times(1000);
        for (int turn = 0; turn < 40; ++turn) {
            for (const SlotRange &range : dirty.take(900, 0, 50)) {
                for (std::uint32_t i = 0; i < range.count; ++i)
                    ++times[range.first + i];
            }
            for (std::uint32_t slot = 0; slot < 60; slot += 3) // these come again and again
                dirty.add(slot);
        }
        for (std::uint32_t slot = 0; slot < 1000; ++slot)
            QVERIFY2((times[slot] > 0) == (slot % 3 == 0 && slot < 900), qPrintable(QString::number(slot)));
        dirty.add(10), dirty.add(12), dirty.add(20);
        dirty.clear();
        dirty.add(10), dirty.add(12), dirty.add(20);
        const std::vector<SlotRange> ranges = dirty.take(1000, 2);
        QCOMPARE(ranges.size(), std::size_t(2)); // 10 ... 12, and 20
        QCOMPARE(ranges[0].count, 3u);
        QCOMPARE(dirty.count(), std::size_t(0));
    }
};

SANDREEL_TEST(TestGradualPicture)
#include "tst_gradualpicture.moc"
