// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/hid/catalog.h"
#include "model/haptics/hid/spacemouse.h"
#include "tests/model/haptics/grounds.h"
#include "tests/model/haptics/scriptedhid.h"
#include "tests/support/testmain.h"

using namespace model;
using namespace model::haptics;
using namespace std::chrono_literals;

namespace {

HidDeviceInfo navigator()
{
    HidDeviceInfo info;
    info.path = "/dev/hidraw3";
    info.vendor = 0x046d;
    info.product = 0xc626;
    info.usagePage = 1;
    info.usage = 8;
    info.productName = "SpaceNavigator";
    return info;
}

/// A SpaceMouse on a scripted system, driven by hand.
struct Bench
{
    tests::ScriptedHid system;
    tests::ScriptedHid::Device &device = system.plug(navigator());
    SpaceMouse mouse{navigator()};
    HidLink link{system, navigator(), mouse};
    Time now{1s};

    /// A report (or silence), and then so many steps of the servo.
    Reading say(Bytes report, int steps = 8)
    {
        if (!report.empty())
            device.reports.push_back(std::move(report));
        Reading reading;
        for (int i = 0; i < steps; ++i) {
            if (i % 4 == 0)
                link.pump(now);
            now += 1ms;
            reading = mouse.read(now);
        }
        return reading;
    }
};

} // namespace

class TestSpaceMouse final : public QObject
{
    Q_OBJECT

private slots:
    void reportsAreTaken_data()
    {
        QTest::addColumn<QByteArray>("report");
        QTest::addColumn<bool>("isTaken");
        QTest::addColumn<QList<int>>("axes");
        QTest::addColumn<uint>("buttons");
        QTest::addColumn<int>("battery");
        const auto row = [](const char *name, const char *hex, QList<int> axes = {}, uint buttons = 0,
                            int battery = -1) {
            const bool isTaken = !axes.isEmpty();
            QTest::newRow(name) << QByteArray::fromHex(hex) << isTaken << (isTaken ? axes : QList<int>(6, 0)) << buttons
                                << battery;
        };
        row("translation", "01 0a00 f6ff 5e01", {10, -10, 350, 0, 0, 0});
        row("rotation", "02 0000 e2ff 0000", {0, 0, 0, 0, -30, 0}); // spelled out in captures
        row("both at once", "01 0100 0200 0300 0400 0500 faff", {1, 2, 3, 4, 5, -6});
        row("both, with more behind", "01 0100 0200 0300 0400 0500 faff 9999", {1, 2, 3, 4, 5, -6});
        row("longer than before", "01 0a00 f6ff 5e01 77", {10, -10, 350, 0, 0, 0});
        row("beyond the range", "01 ff7f 0080 f401", {350, -350, 350, 0, 0, 0});
        row("left button", "03 0100", QList<int>(6, 0), 1);
        row("right button", "03 0200", QList<int>(6, 0), 2);
        row("many buttons", "03 01000080", QList<int>(6, 0), 0x80000001u);
        row("six bytes of buttons", "03 010203040506", QList<int>(6, 0), 0x04030201u);
        row("battery", "17 5a01", QList<int>(6, 0), 0, 90);
        row("nothing", "");
        row("short translation", "01 0a00 f6ff 5e");
        row("short rotation", "02 01");
        row("short buttons", "03");
        row("short battery", "17 10");
        row("more than full", "17 6500");
        row("unknown", "55 0102030405060708");
    }
    void reportsAreTaken()
    {
        QFETCH(QByteArray, report);
        QFETCH(bool, isTaken);
        QFETCH(QList<int>, axes);
        QFETCH(uint, buttons);
        QFETCH(int, battery);
        SpaceMouseState state;
        const Bytes bytes(report.begin(), report.end()); // of its own size, for AddressSanitizer
        QCOMPARE(takeSpaceMouseReport(bytes, state), isTaken);
        for (int i = 0; i < 6; ++i)
            QCOMPARE(int(state.axes[std::size_t(i)]), axes[i]);
        QCOMPARE(state.buttons, buttons);
        QCOMPARE(int(state.battery), battery);
        QCOMPARE(state.isCharging, battery >= 0);
    }

    void garbageMovesNothing()
    {
        Bench bench;
        QVERIFY(bench.link.open());
        std::mt19937 random(5);
        for (int i = 0; i < 3000; ++i) {
            Bytes report(random() % 40);
            for (std::uint8_t &byte : report)
                byte = std::uint8_t(random());
            if (!report.empty() && report[0] < 4)
                report[0] = 0x20;
            const Reading reading = bench.say(report, 1);
            QCOMPARE(reading.position, Vec3d());
            QVERIFY(reading.isConnected);
        }
    }

    void itMovesWhileItIsPushed()
    {
        Bench bench;
        QVERIFY(bench.link.open());
        bench.say({}, 4);
        // Full to the right for 80 ms, as a Navigator says it: both reports in turns, each 8 ms.
        Reading reading;
        for (int i = 0; i < 10; ++i)
            reading = bench.say(i % 2 ? Bytes{2, 0, 0, 0, 0, 0, 0} : Bytes{1, 0x5e, 1, 0, 0, 0, 0});
        QVERIFY2(std::abs(reading.position.x - 0.15 * 0.08) < 0.002, qPrintable(QString::number(reading.position.x)));
        QVERIFY(reading.position.y == 0 && reading.position.z == 0);
        for (int i = 0; i < 3; ++i)
            reading = bench.say({1, 0, 0, 0, 0, 0, 0});
        const Vec3d at = reading.position;
        QCOMPARE(bench.say({}, 500).position, at);
        // Pressed down, the tool sinks; it stays in its workspace.
        for (int i = 0; i < 300; ++i)
            reading = bench.say({1, 0, 0, 0, 0, 0x5e, 1});
        QCOMPARE(reading.position.z, -0.1);
    }

    void aDeadZoneHoldsItStill()
    {
        Bench bench;
        QVERIFY(bench.link.open());
        bench.say({1, 20, 0, 0xec, 0xff, 0, 0}, 50);
        QCOMPARE(bench.mouse.read(bench.now).position, Vec3d());
        QVERIFY(bench.mouse.state().axes[0] == 20);
    }

    /// Deflected, and then nothing more: a report of the release was lost.
    void silenceStopsIt()
    {
        Bench bench;
        QVERIFY(bench.link.open());
        bench.say({1, 0x5e, 1, 0, 0, 0, 0}, 8);
        const Vec3d after = bench.say({}, 200).position;
        QVERIFY(after.x > 0.02 && after.x < 0.15 * 0.17);
        QCOMPARE(bench.say({}, 500).position, after);
    }

    void comesBackAfterItWasUnplugged()
    {
        Bench bench;
        QVERIFY(bench.link.open());
        bench.mouse.setLight(true);
        bench.say({1, 0x5e, 1, 0, 0, 0, 0}, 40);
        const Vec3d before = bench.mouse.read(bench.now).position;
        QCOMPARE(bench.device.sent, (std::vector<Bytes>{{4, 1}}));
        bench.device.isPlugged = false;
        QVERIFY(!bench.say({}, 8).isConnected);
        QCOMPARE(bench.say({}, 2000).position, before);
        // Another one with the same numbers but its own serial is not it; the same at another path is.
        HidDeviceInfo other = navigator();
        other.path = "/dev/hidraw8";
        other.serial = "other";
        bench.system.plug(other);
        QVERIFY(!bench.say({}, 1000).isConnected);
        HidDeviceInfo moved = navigator();
        moved.path = "/dev/hidraw9";
        tests::ScriptedHid::Device &again = bench.system.plug(moved);
        QVERIFY(bench.say({}, 1000).isConnected);
        QCOMPARE(again.opened, 1);
        QCOMPARE(again.sent, (std::vector<Bytes>{{4, 1}})); // its light too
        again.reports.push_back({3, 1, 0});
        QCOMPARE(bench.say({}).buttons, 1u);
        bench.link.stop();
        QCOMPARE(again.sent.back(), (Bytes{4, 0}));
    }

    void onlyWhatIsOneIsListed()
    {
        QVERIFY(isSpaceMouse(0x046d, 0xc626, 1, 8));
        QVERIFY(isSpaceMouse(0x256f, 0xc635, 1, 8));
        QVERIFY(isSpaceMouse(0x256f, 0xc635, 0, 0));  // usage not known
        QVERIFY(!isSpaceMouse(0x256f, 0xc652, 1, 6)); // a receiver's keyboard
        QVERIFY(isSpaceMouse(0x256f, 0xc652, 1, 8));
        QVERIFY(!isSpaceMouse(0x256f, 0xc650, 1, 8)); // CadMouse
        QVERIFY(!isSpaceMouse(0x046d, 0xc077, 1, 2));
        QVERIFY(!isSpaceMouse(0x1234, 0xc626, 1, 8));

        tests::ScriptedHid system;
        QCOMPARE(findDevices(system).size(), 1u);
        system.plug(navigator());
        system.plug(navigator()); // listed once for each collection
        HidDeviceInfo mouse = navigator();
        mouse.path = "/dev/hidraw1";
        mouse.product = 0xc077;
        system.plug(mouse);
        HidDeviceInfo second = navigator();
        second.path = "/dev/hidraw5";
        second.productName.clear();
        system.plug(second).isAllowed = false;
        const auto found = findDevices(system);
        QCOMPARE(found.size(), 3u);
        QCOMPARE(found[0].id, std::string("simulated"));
        QCOMPARE(found[1].id, std::string("spacemouse:/dev/hidraw3"));
        QVERIFY(found[1].isAllowed && found[1].name == "SpaceNavigator");
        QVERIFY(!found[2].isAllowed && found[2].name == "spacemouse");
        system.isBroken = true;
        QCOMPARE(findDevices(system).size(), 1u);
    }

    void whatIsForbiddenSaysSo()
    {
        tests::ScriptedHid system;
        system.plug(navigator()).isAllowed = false;
        const auto open = openDevice(system, findDevices(system)[1]);
        QVERIFY(!open);
        QCOMPARE(open.error().code, ErrorCode::CannotOpen);
        QCOMPARE(open.error().args[0], std::string("Permission denied"));
        QCOMPARE(open.error().file, std::string("/dev/hidraw3"));
    }

    void theThreadKeepsItOpen()
    {
        tests::ScriptedHid system;
        system.plug(navigator());
        auto open = openDevice(system, findDevices(system)[1]);
        QVERIFY(open.has_value());
        QTRY_VERIFY(open->device->read(Time(0)).isConnected);
        open->link.reset();
        QVERIFY(!open->device->read(Time(0)).isConnected);
    }
};

SANDREEL_TEST(TestSpaceMouse)
#include "tst_spacemouse.moc"
