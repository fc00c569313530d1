// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/docks/logdock.h"

#include "tests/support/testmain.h"
#include "views/itemmodels/logmodel.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QMainWindow>
#include <QScrollBar>
#include <QToolBar>
#include <QToolButton>
#include <QTreeView>

#include <thread>

using namespace views;

class TestLogDock final : public QObject
{
    Q_OBJECT

    std::unique_ptr<LogModel> mLog;
    std::unique_ptr<QMainWindow> mWindow;
    QTreeView *mList = nullptr;

    /// The button of the dock's tool bar, by the place of its action.
    QToolButton *button(int index) const
    {
        auto *bar = mWindow->findChild<QToolBar *>();
        return qobject_cast<QToolButton *>(bar->widgetForAction(bar->actions().at(index)));
    }
    void press(int index) const { QTest::mouseClick(button(index), Qt::LeftButton); }
    static constexpr int Copy = 0, Clear = 1;

    QString shown(int row, LogModel::Column column) const
    {
        return mList->model()->index(row, column).data().toString();
    }
    static QString clipboard() { return QApplication::clipboard()->text(); }
    bool showsTheLast() const { return mList->verticalScrollBar()->value() == mList->verticalScrollBar()->maximum(); }

private slots:
    void init()
    {
        mLog = std::make_unique<LogModel>();
        mWindow = std::make_unique<QMainWindow>();
        mWindow->addDockWidget(Qt::BottomDockWidgetArea, new LogDock(*mLog));
        mList = mWindow->findChild<QTreeView *>("logList");
        mWindow->resize(700, 250);
        mWindow->show();
        mWindow->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(mWindow.get()));
        QApplication::clipboard()->setText("before");
    }
    void cleanup()
    {
        mWindow.reset();
        mLog.reset();
    }

    void messagesAreListedAsTheyCome()
    {
        mLog->add(LogLevel::Info, "Opened a.anim");
        mLog->add(LogLevel::Error, "b.anim cannot be opened.");
        QCOMPARE(mList->model()->rowCount(), 2);
        QCOMPARE(shown(0, LogModel::Text), QString("Opened a.anim"));
        QCOMPARE(shown(0, LogModel::Level), QString("Note"));
        QCOMPARE(shown(1, LogModel::Text), QString("b.anim cannot be opened."));
        QCOMPARE(shown(1, LogModel::Level), QString("Error"));
        QVERIFY(QTime::fromString(shown(1, LogModel::Time), "HH:mm:ss").isValid());
        QVERIFY(!mList->model()->index(1, LogModel::Level).data(Qt::DecorationRole).isNull());
    }

    void otherThreadsMaySayThings()
    {
        std::jthread([this] { mLog->addFromAnyThread(LogLevel::Warning, "from afar"); }).join();
        QCOMPARE(mLog->rowCount(), 0); // shown by this thread, when it gets to it
        QTRY_COMPARE(mLog->rowCount(), 1);
        QCOMPARE(shown(0, LogModel::Text), QString("from afar"));
    }

    void emptyLogHasNothingToCopyOrClear()
    {
        QVERIFY(!button(Copy)->isEnabled() && !button(Clear)->isEnabled());
        mLog->add(LogLevel::Info, "one");
        QVERIFY(button(Copy)->isEnabled() && button(Clear)->isEnabled());
        press(Clear);
        QCOMPARE(mList->model()->rowCount(), 0);
        QVERIFY(!button(Copy)->isEnabled() && !button(Clear)->isEnabled());
        QCOMPARE(clipboard(), QString("before"));
    }

    void copiesTheSelectedOrAll()
    {
        for (const char *const text : {"first", "second", "third"})
            mLog->add(LogLevel::Info, text);
        press(Copy);
        QCOMPARE(clipboard().count('\n'), 3);
        QVERIFY(clipboard().indexOf("first") < clipboard().indexOf("third"));
        // Each line stands for itself in a report: with its date.
        QVERIFY(clipboard().startsWith(QDate::currentDate().toString(Qt::ISODate)));

        // The third, then the first too; by keys.
        QTest::mouseClick(mList->viewport(), Qt::LeftButton, {},
                          mList->visualRect(mLog->index(2, LogModel::Text)).center());
        QTest::mouseClick(mList->viewport(), Qt::LeftButton, Qt::ControlModifier,
                          mList->visualRect(mLog->index(0, LogModel::Text)).center());
        QTest::keyClick(mList, Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(clipboard().count('\n'), 2);
        QVERIFY(!clipboard().contains("second"));
        QVERIFY(clipboard().indexOf("first") < clipboard().indexOf("third")); // in the order of the log
    }

    void newestIsInViewUnlessSomebodyReadsFurtherUp()
    {
        for (int i = 0; i < 100; ++i)
            mLog->add(LogLevel::Info, QString::number(i));
        QTRY_VERIFY(mList->verticalScrollBar()->maximum() > 0 && showsTheLast());
        mList->verticalScrollBar()->setValue(3);
        mLog->add(LogLevel::Info, "not now");
        QTest::qWait(20);
        QCOMPARE(mList->verticalScrollBar()->value(), 3);
        mList->scrollToBottom();
        mLog->add(LogLevel::Info, "now");
        QTRY_VERIFY(showsTheLast());
    }

    void oldestGoWhenThereAreTooMany()
    {
        for (int i = 0; i < LogModel::MaxRows + 10; ++i)
            mLog->add(LogLevel::Info, QString::number(i));
        QCOMPARE(mList->model()->rowCount(), int(LogModel::MaxRows));
        QCOMPARE(shown(0, LogModel::Text), QString("10"));
        QCOMPARE(shown(LogModel::MaxRows - 1, LogModel::Text), QString::number(LogModel::MaxRows + 9));
    }
};

SANDREEL_TEST(TestLogDock)
#include "tst_logdock.moc"
