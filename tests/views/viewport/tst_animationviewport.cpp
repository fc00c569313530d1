// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"
#include "views/viewport/animationviewport.h"
#include "views/viewport/glsupport.h"

#include <QApplication>
#include <QMainWindow>
#include <QSignalSpy>
#include <QWheelEvent>

#include <cmath>

using namespace views;

namespace {

/// Pixels that differ clearly between two pictures.
int differenceOf(const QImage &a, const QImage &b)
{
    if (a.size() != b.size())
        return -1;
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
            if (std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) + std::abs(p.blue() - q.blue()) > 30)
                ++count;
        }
    return count;
}

/// Warm, as the surface is and the cool background is not.
bool isSurface(QColor color)
{
    return color.red() > color.blue() + 12;
}

void wheel(QWidget &widget, QPointF place, int notches)
{
    QWheelEvent event(place, widget.mapToGlobal(place), QPoint(), QPoint(0, 120 * notches), Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&widget, &event);
}

void drag(QWidget &widget, Qt::MouseButton button, QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {})
{
    QTest::mousePress(&widget, button, modifiers, from);
    for (const QPoint place : {(from + to) / 2, to}) {
        QMouseEvent move(QEvent::MouseMove, place, widget.mapToGlobal(place), Qt::NoButton, button, modifiers);
        QApplication::sendEvent(&widget, &move);
    }
    QTest::mouseRelease(&widget, button, modifiers, to);
}

} // namespace

class TestAnimationViewport final : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<Player> mPlayer;
    std::unique_ptr<AnimationViewport> mViewport;

    QImage picture() { return mViewport->grabFramebuffer(); }

    void show(const model::FrameSourcePtr &source)
    {
        mPlayer = std::make_unique<Player>();
        mViewport = std::make_unique<AnimationViewport>(*mPlayer);
        mViewport->resize(300, 240);
        mViewport->setStatisticsVisible(false);
        mViewport->setGridVisible(false);
        mViewport->show();
        QVERIFY(QTest::qWaitForWindowExposed(mViewport.get()));
        QSignalSpy fitted(mViewport.get(), &AnimationViewport::cameraChanged);
        mPlayer->setSource(source);
        QTRY_VERIFY(mPlayer->currentFrame());
        QTRY_VERIFY(!fitted.isEmpty());
        QTest::qWait(50); // the box over all frames
    }

private slots:
    void initTestCase() { QVERIFY2(glSupport().isSufficient, "these tests need a display with OpenGL 3.3"); }
    void init() { show(tests::constant(tests::cube(), 5)); }
    void cleanup()
    {
        mViewport.reset();
        mPlayer.reset();
    }

    void meshIsInTheMiddleBeforeTheBackground()
    {
        const QImage image = picture();
        QVERIFY(isSurface(image.pixelColor(150, 120)));
        for (const QPoint corner : {QPoint(5, 5), QPoint(294, 5), QPoint(294, 234)})
            QVERIFY(!isSurface(image.pixelColor(corner)));
        mPlayer->setSource(nullptr);
        QVERIFY(!isSurface(picture().pixelColor(150, 120)));
    }

    void surfaceIsLitFromAbove()
    {
        const QImage image = picture(); // a cube seen from above
        double top = 0, bottom = 0;
        int topCount = 0, bottomCount = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const QColor color = image.pixelColor(x, y);
                if (!isSurface(color))
                    continue;
                (y < 120 ? top : bottom) += color.lightness();
                ++(y < 120 ? topCount : bottomCount);
            }
        QVERIFY(topCount > 100 && bottomCount > 100);
        QVERIFY(top / topCount > bottom / bottomCount + 5);
    }

    void bothSidesAreLit()
    {
        show(tests::constant(tests::grid(), 2)); // faces +z
        model::OrbitCamera camera = mViewport->camera();
        camera.yaw = camera.pitch = 0;
        mViewport->setCamera(camera);
        const QColor front = picture().pixelColor(150, 120);
        camera.yaw = 3.14159f;
        mViewport->setCamera(camera);
        const QColor back = picture().pixelColor(150, 120);
        QVERIFY(isSurface(front));
        QVERIFY(back.blue() > back.red()); // its other side has another colour
        QVERIFY(back.lightness() > 60);
    }

    /// The left half of a sheet is where it was, the right half is off; from frame to frame by more.
    void errorsAreColoured()
    {
        const auto original = tests::constant(tests::grid(), 3);
        std::vector<model::Vec3f> positions(original->allPositions().begin(), original->allPositions().end());
        const std::size_t count = original->vertexCount();
        for (std::size_t i = 0; i < positions.size(); ++i)
            if (positions[i].x > 0.6f)
                positions[i].z += 0.01f * float(i / count + 1);
        show(std::make_shared<model::Sequence>(original->connectivity(), positions));
        model::OrbitCamera camera = mViewport->camera();
        camera.yaw = camera.pitch = 0;
        mViewport->setCamera(camera);
        const QPoint left(110, 120), right(240, 120);
        const auto isYellow = [](QColor color) { // greener than the surface's own sand
            return color.green() > color.blue() + 30 && color.green() > 0.9 * color.red();
        };
        const auto isViolet = [](QColor color) { return color.blue() > color.green() && color.red() > color.green(); };
        QVERIFY(isSurface(picture().pixelColor(left)) && isSurface(picture().pixelColor(right)));

        Comparison comparison(*mPlayer);
        mViewport->setComparison(&comparison);
        mViewport->setErrorColored(true);
        QCOMPARE(mViewport->errorRange(), 0.0f); // nothing to colour by
        comparison.start("grid", [original](const model::Progress &) -> model::Result<Original> {
            return Original{original, {}};
        });
        const auto shows = [this](std::uint32_t frame) {
            const FrameDataPtr shown = mPlayer->currentFrame();
            return shown && shown->frame == frame && shown->original;
        };
        QTRY_VERIFY(comparison.result() && shows(0));
        QVERIFY(isViolet(picture().pixelColor(left)));
        const QColor third = picture().pixelColor(right); // of the largest of all frames: blue-green
        QVERIFY2(third.blue() > third.red() + 20, qPrintable(third.name()));
        QVERIFY(qAbs(mViewport->errorRange() - 0.03f) < 1e-6f);
        mViewport->setErrorRangeOfFrame(true);
        QVERIFY2(isYellow(picture().pixelColor(right)), qPrintable(picture().pixelColor(right).name()));
        QVERIFY(qAbs(mViewport->errorRange() - 0.01f) < 1e-6f);
        mViewport->setErrorRangeOfFrame(false);
        mPlayer->seek(2);
        QTRY_VERIFY(shows(2));
        QVERIFY(isViolet(picture().pixelColor(left)) && isYellow(picture().pixelColor(right)));

        // Every way of drawing has the colours.
        for (const DrawMode mode : {DrawMode::ShadedWireframe, DrawMode::Wireframe, DrawMode::Points}) {
            mViewport->setDrawMode(mode);
            const QImage image = picture();
            int yellow = 0;
            for (int y = 0; y < image.height(); ++y)
                for (int x = image.width() / 2; x < image.width(); ++x)
                    yellow += isYellow(image.pixelColor(x, y));
            QVERIFY2(yellow > 20, qPrintable(QString::number(yellow)));
        }
        mViewport->setDrawMode(DrawMode::Shaded);
        const QImage exported = mViewport->renderPicture(*mPlayer->currentFrame(), {300, 240});
        QVERIFY2(isYellow(exported.pixelColor(right)), qPrintable(exported.pixelColor(right).name()));
        mViewport->setErrorColored(false);
        QVERIFY(isSurface(picture().pixelColor(left)));
        mViewport->setErrorColored(true);
        comparison.stop();
        QTRY_VERIFY(!mPlayer->currentFrame()->original);
        QVERIFY(isSurface(picture().pixelColor(left)));
        mViewport->setComparison(nullptr);
    }

    void modesDiffer()
    {
        std::vector<QImage> images;
        for (const DrawMode mode :
             {DrawMode::Shaded, DrawMode::ShadedWireframe, DrawMode::Wireframe, DrawMode::Points}) {
            mViewport->setDrawMode(mode);
            QCOMPARE(mViewport->drawMode(), mode);
            images.push_back(picture());
        }
        for (std::size_t i = 0; i < images.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY2(differenceOf(images[i], images[j]) > 100, qPrintable(QString("%1 %2").arg(i).arg(j)));
        QVERIFY(differenceOf(images[1], images[0]) < differenceOf(images[2], images[0])); // edges on the surface
        mViewport->setDrawMode(DrawMode::Shaded);
        QCOMPARE(differenceOf(picture(), images[0]), 0);
    }

    void densityThinsThePointsOut()
    {
        show(tests::constant(tests::grid(30, 30), 2));
        mViewport->setDrawMode(DrawMode::Points);
        int last = 0;
        for (const double density : {0.05, 0.3, 1.0}) {
            mViewport->setPointDensity(density);
            const QImage image = picture();
            int count = 0;
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    count += isSurface(image.pixelColor(x, y));
            QVERIFY(count > last * 2);
            last = count;
        }
        mViewport->setPointDensity(7);
        QCOMPARE(mViewport->pointDensity(), 1.0);
    }

    void leftDragOrbits()
    {
        const model::OrbitCamera before = mViewport->camera();
        QSignalSpy changed(mViewport.get(), &AnimationViewport::cameraChanged);
        const QImage image = picture();
        drag(*mViewport, Qt::LeftButton, {100, 100}, {160, 130});
        const model::OrbitCamera after = mViewport->camera();
        QVERIFY(std::abs(after.yaw - (before.yaw - 60.0f / 240 * 3.14159f)) < 1e-3f);
        QVERIFY(after.pitch > before.pitch);
        QCOMPARE(after.distance, before.distance);
        QVERIFY(after.target == before.target);
        QVERIFY(changed.size() >= 2);
        QVERIFY(differenceOf(picture(), image) > 100);
    }

    void middleAndShiftLeftDragPan()
    {
        for (const bool isMiddle : {true, false}) {
            const model::OrbitCamera before = mViewport->camera();
            drag(*mViewport, isMiddle ? Qt::MiddleButton : Qt::LeftButton, {100, 100}, {160, 130},
                 isMiddle ? Qt::NoModifier : Qt::ShiftModifier);
            QVERIFY(mViewport->camera().target != before.target);
            QCOMPARE(mViewport->camera().yaw, before.yaw);
        }
    }

    void rightDragZooms()
    {
        const float before = mViewport->camera().distance;
        drag(*mViewport, Qt::RightButton, {100, 150}, {100, 90});
        QVERIFY(mViewport->camera().distance < before);
    }

    void wheelZoomsToTheCursor()
    {
        const model::OrbitCamera before = mViewport->camera();
        wheel(*mViewport, {150, 120}, 1);
        QVERIFY(mViewport->camera().distance < before.distance);
        QVERIFY(model::length(mViewport->camera().target - before.target) < 1e-4f); // the middle stays the middle
        wheel(*mViewport, {250, 120}, 2);
        const model::Vec3f moved = mViewport->camera().target - before.target;
        QVERIFY(dot(moved, before.right()) > 0.01f); // towards the cursor
        mViewport->setCamera(before);
        wheel(*mViewport, {150, 120}, -1);
        QVERIFY(mViewport->camera().distance > before.distance);
    }

    void keysMoveTheCamera()
    {
        const model::OrbitCamera before = mViewport->camera();
        QTest::keyClick(mViewport.get(), Qt::Key_Left);
        QVERIFY(mViewport->camera().yaw != before.yaw);
        QTest::keyClick(mViewport.get(), Qt::Key_Right);
        QVERIFY(std::abs(mViewport->camera().yaw - before.yaw) < 1e-5f);
        QTest::keyClick(mViewport.get(), Qt::Key_Down);
        QVERIFY(mViewport->camera().pitch > before.pitch);
        QTest::keyClick(mViewport.get(), Qt::Key_Up);
        QTest::keyClick(mViewport.get(), Qt::Key_Plus);
        QVERIFY(mViewport->camera().distance < before.distance);
        QTest::keyClick(mViewport.get(), Qt::Key_Minus);
        QTest::keyClick(mViewport.get(), Qt::Key_Minus);
        QVERIFY(mViewport->camera().distance > before.distance);
        QTest::keyClick(mViewport.get(), Qt::Key_Left, Qt::ShiftModifier);
        QVERIFY(mViewport->camera().target != before.target);
        QTest::keyClick(mViewport.get(), Qt::Key_F);
        QVERIFY(model::length(mViewport->camera().target - before.target) < 1e-5f);
        QVERIFY(std::abs(mViewport->camera().distance - before.distance) < 1e-3f);
    }

    void cameraHoldsAllFramesAndStaysWhereTheUserPutIt()
    {
        // The mesh walks away: the camera must show where it will be.
        const model::TriangleMesh cube = tests::cube();
        std::vector<model::Vec3f> positions;
        for (int frame = 0; frame < 4; ++frame)
            for (const model::Vec3f &p : cube.positions)
                positions.push_back(p + model::Vec3f{10.0f * float(frame), 0, 0});
        const auto walk = std::make_shared<model::Sequence>(cube.connectivity, positions);
        mPlayer->setSource(walk);
        QTRY_COMPARE(mViewport->camera().target.x, 15.0f);
        drag(*mViewport, Qt::LeftButton, {100, 100}, {160, 130});
        const model::OrbitCamera ours = mViewport->camera();
        mPlayer->setSource(std::make_shared<model::Sequence>(cube.connectivity, positions)); // an edit
        QTest::qWait(100);
        QCOMPARE(mViewport->camera().yaw, ours.yaw);
        QVERIFY(mViewport->camera().target == ours.target);
        for (model::Vec3f &p : positions) // but one that makes it all a thousand times as large takes the camera along
            p = p * 1000;
        mPlayer->setSource(std::make_shared<model::Sequence>(cube.connectivity, positions));
        QTRY_VERIFY(std::abs(mViewport->camera().distance / ours.distance - 1000) < 1);
        QCOMPARE(mViewport->camera().yaw, ours.yaw);
    }

    void pictureSurvivesAMoveToAnotherWindow()
    {
        const QImage before = picture();
        {
            QMainWindow window; // the context is made anew
            mViewport->setParent(&window);
            window.setCentralWidget(mViewport.get());
            window.resize(300, 240);
            window.show();
            QVERIFY(QTest::qWaitForWindowExposed(&window));
            QTRY_VERIFY(isSurface(picture().pixelColor(picture().width() / 2, picture().height() / 2)));
            mViewport->setParent(nullptr);
        }
        mViewport->resize(300, 240);
        mViewport->show();
        QVERIFY(QTest::qWaitForWindowExposed(mViewport.get()));
        mViewport->fitView();
        QTRY_VERIFY(differenceOf(picture(), before) < 300);
    }

    void sizesDownToNothing()
    {
        for (const QSize size : {QSize(0, 0), QSize(1, 1), QSize(1, 300), QSize(300, 240)}) {
            mViewport->resize(size);
            QCoreApplication::processEvents();
            mViewport->repaint();
        }
        mViewport->fitView();
        QVERIFY(isSurface(picture().pixelColor(150, 120)));
    }

    void meshesOfEveryKindAreDrawn()
    {
        for (const auto &[name, sequence] : tests::namedAnimations()) {
            mPlayer->setSource(sequence);
            QTRY_VERIFY(mPlayer->currentFrame()->source == mPlayer->source());
            for (const DrawMode mode :
                 {DrawMode::Shaded, DrawMode::ShadedWireframe, DrawMode::Wireframe, DrawMode::Points}) {
                mViewport->setDrawMode(mode);
                QVERIFY(!picture().isNull());
            }
        }
    }

    void picturesOfOtherSizes()
    {
        const FrameDataPtr frame = mPlayer->currentFrame();
        const QImage large = mViewport->renderPicture(*frame, {900, 720});
        QCOMPARE(large.size(), QSize(900, 720));
        const QImage screen = picture();
        QVERIFY(isSurface(large.pixelColor(450, 360)));
        // The same view: scaled down it is the same picture, but for the axes in a corner and smooth edges.
        const QImage small = large.scaled(300, 240, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        QVERIFY(differenceOf(small, screen) < 300 * 240 / 20);
        QCOMPARE(differenceOf(picture(), screen), 0); // and the widget's own is as it was

        FrameData bare; // as somebody else may fill it
        bare.positions = frame->positions;
        bare.normals = frame->normals;
        QCOMPARE(differenceOf(mViewport->renderPicture(bare, {900, 720}), large), 0);
        bare.positions.pop_back();
        QVERIFY(mViewport->renderPicture(bare, {900, 720}).isNull());

        const QSize most = mViewport->maximumPictureSize();
        QVERIFY(most.width() >= 4096);
        QVERIFY(mViewport->renderPicture(*frame, {most.width() + 1, 10}).isNull());
        QVERIFY(mViewport->renderPicture(*frame, {0, 10}).isNull());
    }

    void framesOnTheScreenPaceThePlayer()
    {
        mPlayer->setPacing(model::Pacing::EveryFrame);
        mPlayer->setFramesPerSecond(120);
        mPlayer->play();
        QTRY_VERIFY(mPlayer->playback().frame() == 3);
        QTRY_VERIFY(mPlayer->playback().frame() == 1); // round and round
    }

    void overlayAndGridAreToggled()
    {
        const QImage bare = picture();
        mViewport->setStatisticsVisible(true);
        const QImage withText = picture();
        QVERIFY(differenceOf(withText.copy(0, 0, 150, 100), bare.copy(0, 0, 150, 100)) > 50);
        QCOMPARE(differenceOf(withText.copy(150, 110, 150, 130), bare.copy(150, 110, 150, 130)), 0);
        mViewport->setStatisticsVisible(false);
        mViewport->setGridVisible(true);
        QVERIFY(differenceOf(picture(), bare) > 20);
        mViewport->setGridVisible(false);
        QCOMPARE(differenceOf(picture(), bare), 0);
    }

    void backgroundFollowsThePalette()
    {
        QPalette palette;
        palette.setColor(QPalette::Window, Qt::white);
        mViewport->setPalette(palette);
        const int light = picture().pixelColor(5, 5).lightness();
        palette.setColor(QPalette::Window, Qt::black);
        mViewport->setPalette(palette);
        QVERIFY(picture().pixelColor(5, 5).lightness() < light - 100);
    }
};

SANDREEL_TEST(TestAnimationViewport)
#include "tst_animationviewport.moc"
