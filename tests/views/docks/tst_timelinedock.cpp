// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"
#include "views/docks/timelinedock.h"
#include "views/widgets/timelineslider.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMainWindow>
#include <QSet>
#include <QSpinBox>
#include <QToolButton>
#include <QWheelEvent>

using namespace views;

class TestTimelineDock final : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<Player> mPlayer;
    std::unique_ptr<QMainWindow> mWindow;
    TimelineDock *mDock = nullptr;
    TimelineSlider *mSlider = nullptr;

    std::uint32_t frame() const { return mPlayer->playback().frame(); }
    void key(Qt::Key which, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(mWindow.get(), which, modifiers); }
    QPoint onRuler(int number) const { return {mSlider->positionOf(number), mSlider->ruler().center().y()}; }
    void moveMouse(QPoint place)
    {
        QMouseEvent move(QEvent::MouseMove, place, mSlider->mapToGlobal(place), Qt::NoButton, Qt::LeftButton,
                         Qt::NoModifier);
        QApplication::sendEvent(mSlider, &move);
    }

private slots:
    void init()
    {
        mPlayer = std::make_unique<Player>();
        mPlayer->setSource(tests::wave(tests::oneTriangle(), 201));
        mPlayer->setFramesPerSecond(1); // slow enough to stand still during a test
        mWindow = std::make_unique<QMainWindow>();
        mDock = new TimelineDock;
        mWindow->addDockWidget(Qt::BottomDockWidgetArea, mDock);
        mDock->setPlayer(mPlayer.get());
        mSlider = mDock->findChild<TimelineSlider *>();
        mWindow->resize(900, 300);
        mWindow->show();
        mWindow->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(mWindow.get()));
        mWindow->setFocus();
    }
    void cleanup()
    {
        mWindow.reset();
        mPlayer.reset();
    }

    void withoutAPlayerAllIsDisabled()
    {
        mDock->setPlayer(nullptr);
        for (const QAction *action : mDock->actions())
            QVERIFY2(!action->isEnabled(), qPrintable(action->objectName()));
        QVERIFY(!mSlider->isEnabled());
        mDock->setPlayer(mPlayer.get());
        QVERIFY(mSlider->isEnabled());
        mPlayer->setSource(nullptr);
        QVERIFY(!mSlider->isEnabled());
        mPlayer.reset(); // goes away first
        QVERIFY(!mDock->player());
        key(Qt::Key_Space);
    }

    void actionsAreNamedAndEveryKeyIsTheirsAlone()
    {
        QSet<QKeySequence> keys;
        QSet<QString> names;
        for (const QAction *action : mDock->actions()) {
            QVERIFY(!action->objectName().isEmpty() && !action->text().isEmpty());
            QVERIFY2(!action->icon().isNull(), qPrintable(action->objectName()));
            QVERIFY(!names.contains(action->objectName()));
            names.insert(action->objectName());
            for (const QKeySequence &shortcut : action->shortcuts()) {
                QVERIFY2(!keys.contains(shortcut), qPrintable(shortcut.toString()));
                keys.insert(shortcut);
            }
        }
        QVERIFY(mDock->action("playPause") && !mDock->action("nonsense"));
    }

    void keysDriveThePlayer()
    {
        key(Qt::Key_Space);
        QVERIFY(mPlayer->playback().isPlaying());
        QCOMPARE(mDock->action("playPause")->text(), "&Pause");
        key(Qt::Key_Space);
        QVERIFY(!mPlayer->playback().isPlaying());
        key(Qt::Key_End);
        QCOMPARE(frame(), 200u);
        key(Qt::Key_Left);
        QCOMPARE(frame(), 199u);
        key(Qt::Key_Comma);
        QCOMPARE(frame(), 198u);
        key(Qt::Key_Right);
        QCOMPARE(frame(), 199u);
        key(Qt::Key_Left, Qt::ControlModifier);
        QCOMPARE(frame(), 189u);
        key(Qt::Key_Home);
        QCOMPARE(frame(), 0u);
        key(Qt::Key_B);
        QVERIFY(mPlayer->playback().isReversed());
        key(Qt::Key_E);
        QVERIFY(mPlayer->playback().pacing() == model::Pacing::EveryFrame);
        QCOMPARE(mDock->findChild<QComboBox *>("pacing")->currentIndex(), 1);
    }

    void rangeIsSetWhereOneStands()
    {
        mPlayer->seek(50);
        key(Qt::Key_I);
        mPlayer->seek(150);
        key(Qt::Key_O);
        QCOMPARE(mPlayer->playback().rangeFirst(), 50u);
        QCOMPARE(mPlayer->playback().rangeLast(), 150u);
        mPlayer->seek(20); // an end before the start takes the start along
        key(Qt::Key_O);
        QCOMPARE(mPlayer->playback().rangeFirst(), 20u);
        QCOMPARE(mPlayer->playback().rangeLast(), 20u);
        key(Qt::Key_I, Qt::ShiftModifier);
        QCOMPARE(mPlayer->playback().rangeFirst(), 0u);
        QCOMPARE(mPlayer->playback().rangeLast(), 200u);
    }

    void pressAndDragOnTheRulerScrubs()
    {
        mPlayer->play();
        QTest::mousePress(mSlider, Qt::LeftButton, {}, onRuler(101));
        QVERIFY(!mPlayer->playback().isPlaying());
        QCOMPARE(frame(), 100u);
        moveMouse(onRuler(151));
        QCOMPARE(frame(), 150u);
        moveMouse(onRuler(151) + QPoint(5000, 40)); // far outside: the end
        QCOMPARE(frame(), 200u);
        moveMouse(onRuler(31));
        QTest::mouseRelease(mSlider, Qt::LeftButton, {}, onRuler(31));
        QCOMPARE(frame(), 30u);
        QVERIFY(mPlayer->playback().isPlaying());
    }

    void handlesOfTheRangeAreDragged()
    {
        const int y = mSlider->rangeStrip().center().y();
        QTest::mousePress(mSlider, Qt::LeftButton, {}, {mSlider->positionOf(1), y});
        moveMouse({mSlider->positionOf(41), y});
        QTest::mouseRelease(mSlider, Qt::LeftButton, {}, {mSlider->positionOf(41), y});
        QTest::mousePress(mSlider, Qt::LeftButton, {}, {mSlider->positionOf(201), y});
        moveMouse({mSlider->positionOf(11), y}); // not beyond the other end
        moveMouse({mSlider->positionOf(121), y});
        QTest::mouseRelease(mSlider, Qt::LeftButton, {}, {mSlider->positionOf(121), y});
        QCOMPARE(mPlayer->playback().rangeFirst(), 40u);
        QCOMPARE(mPlayer->playback().rangeLast(), 120u);
        QCOMPARE(frame(), 0u); // the playhead stays
    }

    void wheelSteps()
    {
        mPlayer->seek(100);
        const auto wheel = [&](int notches, Qt::KeyboardModifiers modifiers) {
            const QPointF place = onRuler(50);
            QWheelEvent event(place, mSlider->mapToGlobal(place), {}, {0, 120 * notches}, Qt::NoButton, modifiers,
                              Qt::NoScrollPhase, false);
            QApplication::sendEvent(mSlider, &event);
        };
        wheel(-1, {});
        QCOMPARE(frame(), 101u);
        wheel(2, Qt::ShiftModifier);
        QCOMPARE(frame(), 81u);
    }

    void sliderHasKeysOfItsOwn()
    {
        mSlider->setFocus();
        QTest::keyClick(mSlider, Qt::Key_PageUp);
        QCOMPARE(frame(), 10u);
        QTest::keyClick(mSlider, Qt::Key_PageDown);
        QCOMPARE(frame(), 0u);
    }

    void numbersAreTyped()
    {
        auto *number = mDock->findChild<QSpinBox *>("frame");
        QCOMPARE(number->text(), "1 / 201");
        number->setFocus();
        number->selectAll();
        QTest::keyClicks(number, "120");
        QTest::keyClick(number, Qt::Key_Return);
        QCOMPARE(frame(), 119u);
        auto *rate = mDock->findChild<QDoubleSpinBox *>("framesPerSecond");
        rate->setFocus();
        rate->selectAll();
        QTest::keyClicks(rate, "60");
        QTest::keyClick(rate, Qt::Key_Return);
        QCOMPARE(mPlayer->playback().framesPerSecond(), 60.0);
        rate->selectAll();
        QTest::keyClicks(rate, "500"); // refused while it is typed
        QTest::keyClick(rate, Qt::Key_Return);
        QVERIFY(mPlayer->playback().framesPerSecond() <= 120);
    }

    void displayDoesNotDisturbPlay()
    {
        mPlayer->setFramesPerSecond(100);
        mPlayer->play();
        QTRY_VERIFY(frame() > 5);
        QTRY_COMPARE(mSlider->value(), int(frame()) + 1);
        QVERIFY(mPlayer->playback().isPlaying());
    }

    void loopModesExcludeEachOther()
    {
        mDock->action("loopPingPong")->trigger();
        QVERIFY(mPlayer->playback().loopMode() == model::LoopMode::PingPong);
        QVERIFY(!mDock->action("loopRepeat")->isChecked());
        mPlayer->setLoopMode(model::LoopMode::Once);
        QVERIFY(mDock->action("loopOnce")->isChecked());
    }

    void spacePressesTheFocusedButton()
    {
        auto *button = mDock->findChild<QToolButton *>("stepForwardButton");
        QVERIFY(button);
        button->setFocus();
        QTest::keyClick(button, Qt::Key_Space);
        QCOMPARE(frame(), 1u);
        QVERIFY(!mPlayer->playback().isPlaying());
    }

    void everyControlHasANameAndARoomOfItsOwn()
    {
        for (const int width : {900, 420, 260}) {
            mDock->setFloating(true);
            mDock->resize(width, 200);
            QTest::qWait(50);
            QList<QRect> places;
            for (const QWidget *control : mDock->widget()->findChildren<QWidget *>()) {
                const bool isControl = qobject_cast<const QAbstractButton *>(control) ||
                                       qobject_cast<const QAbstractSpinBox *>(control) ||
                                       qobject_cast<const QComboBox *>(control);
                if (!isControl || !control->isVisible())
                    continue;
                const auto *button = qobject_cast<const QToolButton *>(control);
                QVERIFY(!control->accessibleName().isEmpty() || (button && !button->text().isEmpty()));
                const QRect place(control->mapTo(mDock->widget(), QPoint(0, 0)), control->size());
                QVERIFY2(mDock->widget()->rect().contains(place),
                         qPrintable(QString("%1 at %2").arg(control->objectName()).arg(width)));
                for (const QRect &other : places)
                    QVERIFY(!other.intersects(place));
                places << place;
            }
            QVERIFY(places.size() > 12);
        }
    }
};

SANDREEL_TEST(TestTimelineDock)
#include "tst_timelinedock.moc"
