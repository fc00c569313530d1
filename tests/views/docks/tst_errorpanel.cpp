// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"
#include "views/docks/errorpanel.h"
#include "views/docks/timelinedock.h"
#include "views/widgets/errorplot.h"
#include "views/widgets/timelineslider.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QMainWindow>
#include <QProgressBar>
#include <QToolButton>

#include <algorithm>
#include <atomic>
#include <thread>

using namespace views;

/// The plot of errors in the timeline, driven with the mouse and the keys.
class TestErrorPanel final : public QObject
{
    Q_OBJECT

private:
    static constexpr int Frames = 60;
    static constexpr int Worst = 42; // from 1

    std::unique_ptr<Player> mPlayer;
    std::unique_ptr<Comparison> mComparison;
    std::unique_ptr<QMainWindow> mWindow;
    TimelineDock *mDock = nullptr;
    ErrorPanel *mPanel = nullptr;
    ErrorPlot *mPlot = nullptr;
    tests::SequencePtr mOriginal;

    int frame() const { return int(mPlayer->playback().frame()) + 1; }
    bool compare()
    {
        mComparison->start("cube.obj", [original = mOriginal](const model::Progress &) -> model::Result<Original> {
            return Original{original, {}};
        });
        return QTest::qWaitFor([this] { return mComparison->result().has_value(); }, 20000);
    }
    QPoint onPlot(int number) const { return {int(mPlot->placeOf(number).x()), mPlot->height() / 2}; }

private slots:
    /// The error of frame n is n / 1000, except for the worst of all; one vertex of frame 7 is far off.
    void init()
    {
        mOriginal = tests::constant(tests::cube(), Frames);
        std::vector<model::Vec3f> positions(mOriginal->allPositions().begin(), mOriginal->allPositions().end());
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const int number = int(i / 8) + 1;
            positions[i].x += number == Worst ? 0.5f : float(number) / 1000;
        }
        positions[6 * 8 + 3].y += 1;
        mPlayer = std::make_unique<Player>();
        mPlayer->setSource(std::make_shared<model::Sequence>(mOriginal->connectivity(), positions));
        mComparison = std::make_unique<Comparison>(*mPlayer);
        mWindow = std::make_unique<QMainWindow>();
        mDock = new TimelineDock;
        mWindow->addDockWidget(Qt::BottomDockWidgetArea, mDock);
        mDock->setPlayer(mPlayer.get());
        mDock->setComparison(mComparison.get());
        mPanel = mDock->findChild<ErrorPanel *>();
        mPlot = mDock->findChild<ErrorPlot *>();
        mWindow->resize(900, 400);
        mWindow->show();
        mWindow->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(mWindow.get()));
        mWindow->setFocus();
    }
    void cleanup()
    {
        mWindow.reset();
        mComparison.reset();
        mPlayer.reset();
    }

    void hiddenWhileNothingIsCompared()
    {
        QVERIFY(!mPanel->isVisible());
        QVERIFY(!mDock->action("worstFrame")->isEnabled());
        QVERIFY(compare());
        QVERIFY(mPanel->isVisible() && mPlot->isVisible());
        QVERIFY(mDock->action("worstFrame")->isEnabled());
        mComparison->stop();
        QVERIFY(!mPanel->isVisible());
        QVERIFY(!mDock->action("worstFrame")->isEnabled());
    }

    void plotsTheErrorOfEachFrame()
    {
        QVERIFY(compare());
        const model::ComparisonResult &errors = *mComparison->result();
        QCOMPARE(mPlot->values().size(), std::size_t(Frames));
        for (int i = 0; i < Frames; ++i)
            QCOMPARE(mPlot->values()[std::size_t(i)], errors.frames[std::size_t(i)].kgErrorPercent);
        // Above the frame's place on the ruler, higher the larger.
        const auto *slider = mDock->findChild<TimelineSlider *>();
        for (const int number : {1, 30, Frames})
            QCOMPARE(mPlot->mapToGlobal(QPoint(int(mPlot->placeOf(number).x()), 0)).x(),
                     slider->mapToGlobal(QPoint(slider->positionOf(number), 0)).x());
        QVERIFY(mPlot->placeOf(50).y() < mPlot->placeOf(10).y());
        QVERIFY(mPlot->placeOf(Worst).y() < mPlot->placeOf(50).y());
        QVERIFY(mPlot->placeOf(Worst).y() >= 0);

        auto *curve = mDock->findChild<QComboBox *>("errorCurve");
        curve->setCurrentIndex(ErrorPanel::LargestVertexError);
        for (int i = 0; i < Frames; ++i)
            QCOMPARE(mPlot->values()[std::size_t(i)],
                     100 * errors.frames[std::size_t(i)].maxVertexError / errors.diagonal);
    }

    void pressAndDragGoToAFrame()
    {
        QVERIFY(compare());
        mPlayer->play();
        QTest::mousePress(mPlot, Qt::LeftButton, {}, onPlot(20));
        QCOMPARE(frame(), 20);
        QVERIFY(!mPlayer->playback().isPlaying());
        QMouseEvent move(QEvent::MouseMove, onPlot(33), mPlot->mapToGlobal(onPlot(33)), Qt::NoButton, Qt::LeftButton,
                         Qt::NoModifier);
        QApplication::sendEvent(mPlot, &move);
        QCOMPARE(frame(), 33);
        QTest::mouseRelease(mPlot, Qt::LeftButton, {}, onPlot(33));
        QTest::mouseClick(mPlot, Qt::LeftButton, {}, QPoint(mPlot->width() - 1, 5));
        QCOMPARE(frame(), Frames);
        QTest::mouseClick(mPlot, Qt::RightButton, {}, onPlot(10));
        QCOMPARE(frame(), Frames);
    }

    /// Each curve has its own worst frame.
    void goesToTheWorstFrame()
    {
        QTest::keyClick(mWindow.get(), Qt::Key_W); // nothing to go to yet
        QCOMPARE(frame(), 1);
        QVERIFY(compare());
        QTest::keyClick(mWindow.get(), Qt::Key_W);
        QCOMPARE(frame(), Worst);
        auto *curve = mDock->findChild<QComboBox *>("errorCurve");
        curve->setFocus();
        QTest::keyClick(curve, Qt::Key_Down);
        QCOMPARE(curve->currentIndex(), int(ErrorPanel::LargestVertexError));
        QTest::mouseClick(mDock->findChild<QToolButton *>("worstFrameButton"), Qt::LeftButton);
        QCOMPARE(frame(), 7);
        QVERIFY(mDock->findChild<QLabel *>("errorValues")->text().contains("frame 7"));
        QVERIFY(mPlot->accessibleDescription().contains("frame 7"));
    }

    void showsProgressAndCancels()
    {
        const auto begun = std::make_shared<std::atomic<bool>>(false);
        mComparison->start("large.obj", [begun](const model::Progress &progress) -> model::Result<Original> {
            progress.report(0.5);
            *begun = true;
            while (!progress.isCancelled())
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            return model::fail(model::ErrorCode::Cancelled);
        });
        auto *bar = mDock->findChild<QProgressBar *>("comparingProgress");
        QVERIFY(QTest::qWaitFor([&] { return bar->value() == bar->maximum() / 2; }, 20000));
        QVERIFY(mPanel->isVisible() && bar->isVisible() && !mPlot->isVisible());
        QTest::mouseClick(mDock->findChild<QToolButton *>("cancelComparing"), Qt::LeftButton);
        QVERIFY(!mPanel->isVisible() && !mComparison->isActive());
    }

    void saysWhenAnEditDoesNotMatch()
    {
        QVERIFY(compare());
        mPlayer->setSource(tests::constant(tests::cube(), Frames - 10));
        QVERIFY(QTest::qWaitFor([this] { return mComparison->mismatch().has_value(); }, 20000));
        auto *message = mDock->findChild<QLabel *>("errorMessage");
        QVERIFY(mPanel->isVisible() && message->isVisible() && !mPlot->isVisible());
        QVERIFY2(message->text().contains("cube.obj") && message->text().contains("50"), qPrintable(message->text()));
        QVERIFY(!mDock->action("worstFrame")->isEnabled());
    }

    void aComparisonThatGoesAwayIsLetGoOf()
    {
        QVERIFY(compare());
        mComparison.reset();
        QVERIFY(!mPanel->isVisible());
        QTest::keyClick(mWindow.get(), Qt::Key_W);
    }

    void everyControlHasARoomOfItsOwn()
    {
        QVERIFY(compare());
        mDock->setFloating(true);
        for (const int width : {900, 420, 260}) {
            mDock->resize(width, 260);
            QTest::qWait(50);
            QList<QRect> places;
            for (const QWidget *control : mDock->widget()->findChildren<QWidget *>()) {
                const bool isControl = qobject_cast<const QToolButton *>(control) ||
                                       qobject_cast<const QComboBox *>(control) ||
                                       qobject_cast<const ErrorPlot *>(control);
                if (!isControl || !control->isVisible())
                    continue;
                const QRect place(control->mapTo(mDock->widget(), QPoint(0, 0)), control->size());
                QVERIFY2(mDock->widget()->rect().contains(place),
                         qPrintable(QString("%1 at %2").arg(control->objectName()).arg(width)));
                for (const QRect &other : places)
                    QVERIFY(!other.intersects(place));
                places << place;
            }
            QVERIFY(places.size() > 10);
        }
    }

    void everythingIsNamed()
    {
        QVERIFY(compare());
        for (const QWidget *widget : mPanel->findChildren<QWidget *>())
            if (widget->focusPolicy() != Qt::NoFocus) {
                const auto *button = qobject_cast<const QToolButton *>(widget);
                const QString name = button ? button->text() : widget->accessibleName();
                QVERIFY2(!name.isEmpty(), qPrintable(widget->objectName()));
            }
        QVERIFY(!mPlot->accessibleName().isEmpty());
    }
};

SANDREEL_TEST(TestErrorPanel)
#include "tst_errorpanel.moc"
