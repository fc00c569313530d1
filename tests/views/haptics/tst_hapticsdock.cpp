// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testmain.h"
#include "tests/views/haptics/devicebench.h"
#include "views/haptics/hapticsdock.h"
#include "views/haptics/latenessplot.h"
#include "views/haptics/traceplot.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QPushButton>
#include <QScrollArea>

using namespace model::haptics;
using tests::DeviceBench;

namespace {

/// The dock in a window, as low as windows get.
struct DockBench : DeviceBench
{
    QMainWindow window;
    views::HapticsDock &dock = *new views::HapticsDock(session, &window);

    DockBench()
    {
        window.addDockWidget(Qt::RightDockWidgetArea, &dock);
        window.resize(500, 420);
        window.show();
        if (!QTest::qWaitForWindowExposed(&window))
            QTest::qFail("the window does not show", __FILE__, __LINE__);
    }
    ~DockBench() { delete &dock; }

    template <class T>
    T &named(const char *name)
    {
        return *dock.findChild<T *>(QLatin1String(name));
    }
    void pick(const char *box, int row)
    {
        QComboBox &combo = named<QComboBox>(box);
        combo.setCurrentIndex(row);
        emit combo.activated(row);
    }
};

} // namespace

class TestHapticsDock final : public QObject
{
    Q_OBJECT

private slots:
    void stopIsSeenHoweverTheRestIsScrolled()
    {
        DockBench bench;
        auto &stop = bench.named<QPushButton>("stop");
        for (const QScrollArea *area : bench.dock.findChildren<QScrollArea *>())
            QVERIFY(!area->isAncestorOf(&stop));
        QVERIFY(stop.isVisible() && stop.isEnabled());
        QVERIFY(bench.dock.rect().contains(QRect(stop.mapTo(&bench.dock, QPoint()), stop.size())));
    }

    void forcesAreOffAndCanOnlyBeHadFromADevice()
    {
        DockBench bench;
        auto &wanted = bench.named<QCheckBox>("forces");
        QVERIFY(!wanted.isEnabled() && !wanted.isChecked());
        bench.pick("device", bench.named<QComboBox>("device").findData(QStringLiteral("simulated")));
        QCOMPARE(bench.session.chosen(), QString("simulated"));
        QVERIFY(wanted.isEnabled() && !wanted.isChecked());
        QVERIFY(!bench.session.wantsForces());
        wanted.click();
        QVERIFY(bench.session.wantsForces());
        bench.named<QPushButton>("stop").click();
        QVERIFY(!bench.session.wantsForces() && !wanted.isChecked());
        wanted.click();
        bench.pick("device", 0);
        QVERIFY(!bench.session.wantsForces() && !wanted.isChecked() && !wanted.isEnabled());
    }

    void saysWhatTheForcesDo()
    {
        DockBench bench;
        auto &state = bench.named<QLabel>("state");
        QCOMPARE(state.text(), QString("No device."));
        bench.chooseSimulated();
        QTRY_COMPARE(state.text(), QString("Forces are off."));
        bench.session.setForces(true);
        QTRY_COMPARE_WITH_TIMEOUT(state.text(), QString("Forces are on."), 60'000);
        bench.session.service().simulated()->setConnected(false);
        QTRY_VERIFY(state.text().contains("unplugged"));
    }

    void devicesAreListedWhileTheyArePluggedIn()
    {
        DockBench bench;
        auto &devices = bench.named<QComboBox>("device");
        QCOMPARE(devices.count(), 2);
        bench.system->setDevices({tests::spaceNavigator()});
        QTRY_COMPARE(devices.count(), 3);
        QCOMPARE(devices.itemText(2), QString("SpaceNavigator"));
        bench.pick("device", 2); // which cannot be opened here
        QCOMPARE(devices.currentIndex(), 0);
        QVERIFY(bench.named<QLabel>("deviceHint").text().contains("Permission denied"));
        bench.system->setDevices({});
        QTRY_COMPARE(devices.count(), 2);
    }

    void permissionIsExplained()
    {
        DockBench bench;
        bench.system->forbid();
        bench.system->setDevices({tests::spaceNavigator()});
        QTRY_COMPARE(bench.named<QComboBox>("device").count(), 3);
        QCOMPARE(bench.named<QComboBox>("device").itemText(2), QString("SpaceNavigator (no permission)"));
        QVERIFY(bench.named<QLabel>("deviceHint").text().contains(UdevRuleName));
    }

    void feelIsChosenByNameAndNumber()
    {
        DockBench bench;
        bench.pick("law", 1);
        QCOMPARE(bench.session.feel().law, LawKind::Reference2009);
        bench.pick("material", 2);
        QCOMPARE(bench.session.feel().material, std::optional(model::terrain::MaterialPreset::MoistSand));
        bench.pick("material", 0);
        QVERIFY(!bench.session.feel().material);
        auto *force = bench.named<QWidget>("maxForce").findChild<QLineEdit *>();
        force->selectAll();
        QTest::keyClicks(force, "2.5");
        QCOMPARE(bench.session.feel().maxForce, 2.5);
        force->selectAll();
        QTest::keyClicks(force, "50"); // above what anybody may ask for
        QCOMPARE(bench.session.feel().maxForce, 5.0);
        auto *gain = bench.named<QWidget>("gain").findChild<QLineEdit *>();
        gain->selectAll();
        QTest::keyClicks(gain, "0.5");
        QCOMPARE(bench.session.feel().gain, 0.5);
    }

    void plotsShowWhatTheServoDid()
    {
        DockBench bench;
        bench.chooseSimulated();
        bench.moveTo({0.9, 0.5}, 0.1, false);
        bench.moveTo({0.1, 0.5}, 0.1, false);
        const auto [left, right] = bench.dock.positionPlot().rangeOf(0);
        const double reach = 400; // mm of the hand for the terrain
        QVERIFY(std::abs(left - (0.1 - 0.5) * reach) < 0.1);
        QVERIFY(std::abs(right - (0.9 - 0.5) * reach) < 0.1);
        QCOMPARE(bench.dock.forcePlot().rangeOf(2), std::pair(0.0, 0.0));
        std::uint64_t steps = 0;
        QTRY_VERIFY([&] {
            steps = 0;
            for (int bar = 0; bar < views::LatenessPlot::BarCount; ++bar)
                steps += bench.dock.latenessPlot().countIn(bar);
            return steps > 100;
        }());
        QVERIFY(steps <= bench.session.service().punctuality().steps);
    }

    void everythingHasANameForScreenReaders()
    {
        DockBench bench;
        for (const QComboBox *box : bench.dock.findChildren<QComboBox *>())
            QVERIFY(!box->accessibleName().isEmpty());
        for (const QWidget *plot : std::initializer_list<const QWidget *>{
                 &bench.dock.forcePlot(), &bench.dock.positionPlot(), &bench.dock.latenessPlot()})
            QVERIFY(!plot->accessibleName().isEmpty());
    }

    void tracesKeepTheExtremesOfTheLastSeconds()
    {
        views::TracePlot plot(QStringLiteral("x"), {{QStringLiteral("a"), Qt::red, Qt::red}}, 1);
        for (int i = 0; i < 20'000; ++i)
            plot.add(0.001 * i, {i == 15'000 ? 7.0 : i == 100 ? 99.0 : 1.0});
        QCOMPARE(plot.rangeOf(0), std::pair(1.0, 7.0)); // a single sample is not lost, one of long ago is
        QVERIFY(plot.columnCount() <= 400);
        plot.add(20, {std::nan("")}); // does not spoil the axis
        QCOMPARE(plot.rangeOf(0).first, 0.0);
    }

    void latenessIsCountedInItsDecade()
    {
        using namespace std::chrono_literals;
        QCOMPARE(views::LatenessPlot::barOf(0ns), 0);
        QCOMPARE(views::LatenessPlot::barOf(10'100ns), 10);
        QCOMPARE(views::LatenessPlot::barOf(1'001us), 30);
        QCOMPARE(views::LatenessPlot::barOf(5s), views::LatenessPlot::BarCount - 1);
    }
};

SANDREEL_TEST(TestHapticsDock)
#include "tst_hapticsdock.moc"
