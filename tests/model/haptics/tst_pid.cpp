// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/hid/catalog.h"
#include "model/haptics/hid/piddevice.h"
#include "tests/model/haptics/grounds.h"
#include "tests/model/haptics/scriptedhid.h"
#include "tests/support/testmain.h"

#include <numbers>

using namespace model;
using namespace model::haptics;
using namespace std::chrono_literals;

namespace {

Bytes fromHex(const char *text)
{
    const QByteArray bytes = QByteArray::fromHex(text);
    return Bytes(bytes.begin(), bytes.end());
}

/// A stick with 16-bit axes X and Y, 8 buttons, and the reports of a constant force, as small as they can be.
Bytes stick()
{
    return fromHex("05 01 09 04 a1 01" // joystick
                   "85 01 05 01 09 30 09 31 16 0080 26 ff7f 75 10 95 02 81 02"
                   "05 09 19 01 29 08 15 00 25 01 75 01 95 08 81 02"
                   "05 0f 09 21 a1 02 85 02" // set effect
                   "09 22 15 01 25 28 75 08 95 01 91 02"
                   "09 25 a1 02 09 26 09 40 15 01 25 02 75 08 95 01 91 00 c0"
                   "09 50 15 00 27 ff7f0000 75 10 95 01 91 02" // duration
                   "09 52 15 00 26 ff00 75 08 95 01 91 02"     // gain
                   "09 53 15 00 26 ff00 75 08 95 01 91 02"     // trigger
                   "09 56 15 00 25 01 75 01 95 01 91 02 95 07 91 03"
                   "09 57 a1 02 05 0a 09 01 15 00 26 ff00 75 08 95 01 91 02 05 0f c0"
                   "c0"
                   "09 73 a1 02 85 03" // set constant force
                   "09 22 15 01 25 28 75 08 95 01 91 02"
                   "09 70 16 01d8 26 ff27 75 10 95 01 91 02 c0"
                   "09 77 a1 02 85 04" // operation
                   "09 22 15 01 25 28 75 08 95 01 91 02"
                   "09 78 a1 02 09 79 09 7a 09 7b 15 01 25 03 75 08 95 01 91 00 c0"
                   "09 7c 15 00 26 ff00 75 08 95 01 91 02 c0"
                   "09 96 a1 02 85 05 c0" // a control collection without fields, as some have
                   "09 95 a1 02 85 06 09 96 a1 02 09 97 09 98 09 99 09 9a 15 01 25 04 75 08 95 01 91 00 c0 c0"
                   "09 7d a1 02 85 07 09 7e 15 00 26 ff00 75 08 95 01 91 02 c0"
                   "09 ab a1 02 85 08 09 25 a1 02 09 26 09 40 15 01 25 02 75 08 95 01 b1 00 c0 c0"
                   "09 89 a1 02 85 09 09 22 15 01 25 28 75 08 95 01 b1 02"
                   "09 8b a1 02 09 8c 09 8d 09 8e 15 01 25 03 75 08 95 01 b1 00 c0 c0"
                   "c0");
}

HidDeviceInfo stickInfo()
{
    HidDeviceInfo info;
    info.path = "/dev/hidraw7";
    info.vendor = 0x1209;
    info.product = 0xffb0;
    info.usagePage = 1;
    info.usage = 4;
    info.productName = "Stick";
    return info;
}

struct Bench
{
    tests::ScriptedHid system;
    tests::ScriptedHid::Device &device = system.plug(stickInfo());
    PidDevice stickDevice{stickInfo(), *parseReportDescriptor(stick())};
    HidLink link{system, stickInfo(), stickDevice};
    Time now{1s};

    Bench()
    {
        device.answer = [](std::uint8_t id) { return Bytes{id, 5, 1}; }; // block 5, success
    }
    void run(int milliseconds, Vec3d force)
    {
        for (int i = 0; i < milliseconds; ++i) {
            stickDevice.write(force, now);
            link.pump(now);
            now += 1ms;
        }
    }
    std::vector<Bytes> sentOf(std::uint8_t id) const
    {
        std::vector<Bytes> found;
        for (const Bytes &report : device.sent)
            if (report[0] == id)
                found.push_back(report);
        return found;
    }
};

} // namespace

class TestPid final : public QObject
{
    Q_OBJECT

private slots:
    void descriptorIsRead()
    {
        const auto fields = parseReportDescriptor(stick());
        QVERIFY2(fields.has_value(), fields ? "" : fields.error().args[0].c_str());
        QVERIFY(hasConstantForce(*fields));
        const HidField &axes = (*fields)[0];
        QCOMPARE(axes.usages, (std::vector<HidUsage>{0x10030, 0x10031}));
        QCOMPARE(axes.least, -32768);
        QCOMPARE(axes.most, 32767);
        QCOMPARE((*fields)[1].usages.size(), 8u);
        QCOMPARE((*fields)[1].bitOffset, 32u);
        const HidField *const magnitude =
            fieldOf(*fields, HidField::Kind::Output, pid::SetConstantForce, pid::Magnitude);
        QVERIFY(magnitude);
        QCOMPARE(magnitude->reportId, 3);
        QCOMPARE(magnitude->bitOffset, 8u);
        QCOMPARE(magnitude->least, -10239);
        QCOMPARE(magnitude->most, 10239);
        QCOMPARE(reportSize(*fields, HidField::Kind::Output, 2), 9u);
        QCOMPARE(reportSize(*fields, HidField::Kind::Output, 99), 0u);
        const HidField *const gain = fieldOf(*fields, HidField::Kind::Output, pid::DeviceGainReport, pid::DeviceGain);
        QCOMPARE(gain->most, 255);
    }

    void everyPrefixIsReadOrRefused()
    {
        const Bytes whole = stick();
        for (std::size_t length = 0; length < whole.size(); ++length) {
            const Bytes part(whole.begin(), whole.begin() + std::ptrdiff_t(length));
            const auto fields = parseReportDescriptor(part);
            if (length > 6) // the outermost collection is open
                QVERIFY(!fields);
        }
    }

    void wrongDescriptorsAreRefused_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<int>("code");
        const auto row = [](const char *name, QByteArray bytes, ErrorCode code) {
            QTest::newRow(name) << bytes << int(code);
        };
        row("cut item", QByteArray::fromHex("0501a1"), ErrorCode::Truncated);
        row("cut long item", QByteArray::fromHex("fe10"), ErrorCode::Truncated);
        row("open", QByteArray::fromHex("a101"), ErrorCode::BadValue);
        row("closed twice", QByteArray::fromHex("a101c0c0"), ErrorCode::BadValue);
        row("pop", QByteArray::fromHex("b4"), ErrorCode::BadValue);
        row("no size", QByteArray::fromHex("95018102"), ErrorCode::BadValue);
        row("33 bits", QByteArray::fromHex("752195018102"), ErrorCode::BadValue);
        row("report 0", QByteArray::fromHex("8500"), ErrorCode::BadValue);
        row("endless report", QByteArray::fromHex("752097ffffffff8102"), ErrorCode::LimitExceeded);
        row("endless usages", QByteArray::fromHex("1b000000002bffffffff"), ErrorCode::LimitExceeded);
        row("deep", QByteArray::fromHex("a101").repeated(40), ErrorCode::LimitExceeded);
        row("pushes", QByteArray::fromHex("a4").repeated(40), ErrorCode::LimitExceeded);
        row("long", QByteArray(5000, '\0'), ErrorCode::LimitExceeded);
        row("fields", QByteArray::fromHex("75019501") + QByteArray::fromHex("8102").repeated(1100),
            ErrorCode::LimitExceeded);
    }
    void wrongDescriptorsAreRefused()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(int, code);
        const auto fields = parseReportDescriptor(Bytes(bytes.begin(), bytes.end()));
        QVERIFY(!fields);
        QCOMPARE(int(fields.error().code), code);
    }

    void anyBytesAreSafe()
    {
        std::mt19937 random(11);
        const Bytes whole = stick();
        for (int i = 0; i < 3000; ++i) {
            Bytes bytes = whole;
            for (int k = int(random() % 8); k >= 0; --k)
                bytes[random() % bytes.size()] = std::uint8_t(random());
            const auto fields = parseReportDescriptor(bytes);
            if (!fields || !hasConstantForce(*fields))
                continue;
            PidDevice device(stickInfo(), *fields);
            tests::ScriptedHid system;
            system.plug(stickInfo()).answer = [](std::uint8_t id) { return Bytes{id, 5, 1}; };
            const auto transport = system.open(stickInfo());
            (void)device.connected(**transport);
            device.write({1, 2, 0}, 1s);
            device.received(Bytes{1, 2, 3, 4, 5, 6}, 1s);
            (void)device.serve(**transport, 1s);
        }
    }

    void effectIsMadeAndLoaded()
    {
        Bench bench;
        int asked = 0;
        bench.device.answer = [&](std::uint8_t id) { return ++asked < 4 ? Bytes{id, 0, 3} : Bytes{id, 5, 1}; };
        QVERIFY(bench.link.open());
        QCOMPARE(asked, 4);
        QCOMPARE(bench.device.features, (std::vector<Bytes>{{8, 1}}));
        // Reset, enable, gain, and the effect: block 5, constant force, 60 ms, full gain, no trigger, direction.
        QCOMPARE(bench.device.sent, (std::vector<Bytes>{{6, 4}, {6, 1}, {7, 255}, {2, 5, 1, 60, 0, 255, 255, 1, 0}}));
    }

    void noRoomForTheEffect()
    {
        Bench bench;
        bench.device.answer = [](std::uint8_t id) { return Bytes{id, 0, 2}; };
        auto opened = bench.link.open();
        QVERIFY(!opened);
        QCOMPARE(opened.error().code, ErrorCode::UnsupportedFeature);
        bench.device.answer = [](std::uint8_t id) { return Bytes{id, 0, 3}; };
        opened = bench.link.open();
        QVERIFY(!opened);
        QCOMPARE(opened.error().code, ErrorCode::CannotRead);
        bench.device.answer = nullptr;
        QCOMPARE(bench.link.open().error().code, ErrorCode::CannotRead);
    }

    void forceIsSentByDirectionAndMagnitude_data()
    {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<int>("direction");
        QTest::newRow("towards the user") << 0.0 << -2.0 << 0;
        QTest::newRow("to the left") << -2.0 << 0.0 << 64;
        QTest::newRow("away") << 0.0 << 2.0 << 128;
        QTest::newRow("to the right") << 2.0 << 0.0 << 192;
    }
    void forceIsSentByDirectionAndMagnitude()
    {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(int, direction);
        Bench bench;
        QVERIFY(bench.link.open());
        bench.device.sent.clear();
        bench.run(1, {x, y, 3});
        // Half of 4 N is half of 10239.
        QCOMPARE(bench.device.sent,
                 (std::vector<Bytes>{
                     {2, 5, 1, 60, 0, 255, 255, 1, std::uint8_t(direction)}, {3, 5, 0x00, 0x14}, {4, 5, 1, 1}}));
    }

    /// Started anew before its 60 ms end, at most each 8 ms; stopped when there is no force, or the servo is silent.
    void effectIsKeptAliveAndLetGo()
    {
        Bench bench;
        QVERIFY(bench.link.open());
        bench.device.sent.clear();
        bench.run(240, {1, 0, 0});
        QCOMPARE(bench.sentOf(4).size(), 10u);
        QCOMPARE(bench.sentOf(3).size(), 30u);
        bench.run(20, {});
        QCOMPARE(bench.sentOf(4).back(), (Bytes{4, 5, 3, 1}));
        bench.run(20, {1, 0, 0});
        QCOMPARE(bench.sentOf(4).back(), (Bytes{4, 5, 1, 1}));
        for (int i = 0; i < 70; ++i, bench.now += 1ms)
            bench.link.pump(bench.now);
        QCOMPARE(bench.sentOf(4).back(), (Bytes{4, 5, 3, 1}));
        bench.run(20, {std::nan(""), 0, 0});
        QCOMPARE(bench.sentOf(4).back(), (Bytes{4, 5, 3, 1}));
        bench.link.stop();
        QCOMPARE(bench.sentOf(6).back(), (Bytes{6, 2})); // actuators off
    }

    void positionAndButtons()
    {
        Bench bench;
        QVERIFY(bench.link.open());
        bench.device.reports = {{1, 0xff, 0x7f, 0x00, 0x80, 0x81}, {1, 0, 0, 0}, {1}, {9, 9, 9, 9, 9, 9}};
        bench.run(1, {});
        const Reading reading = bench.stickDevice.read(bench.now);
        QVERIFY(std::abs(reading.position.x - 0.08) < 1e-9 && std::abs(reading.position.y - 0.08) < 1e-5);
        QCOMPARE(reading.buttons, 0x81u);
        bench.run(10, {}); // short reports and unknown ones
        QCOMPARE(bench.stickDevice.read(bench.now).position, reading.position);
        QVERIFY(bench.stickDevice.capabilities().isExperimental);
        QCOMPARE(bench.stickDevice.capabilities().buttonCount, 8u);
    }

    void unpluggedWithAForceOn()
    {
        Bench bench;
        QVERIFY(bench.link.open());
        bench.run(20, {1, 0, 0});
        bench.device.isPlugged = false;
        bench.run(20, {1, 0, 0});
        QVERIFY(!bench.stickDevice.read(bench.now).isConnected);
        bench.device.isPlugged = true;
        bench.device.sent.clear();
        bench.run(600, {});
        QVERIFY(bench.stickDevice.read(bench.now).isConnected);
        QCOMPARE(bench.device.sent[0], (Bytes{6, 4})); // from the reset on
    }

    void catalogFindsItByItsDescriptor()
    {
        tests::ScriptedHid system;
        tests::ScriptedHid::Device &device = system.plug(stickInfo());
        QCOMPARE(findDevices(system).size(), 1u);
        device.descriptor = fromHex("05010904a101c0");
        QCOMPARE(findDevices(system).size(), 1u);
        device.descriptor = stick();
        const auto found = findDevices(system);
        QCOMPARE(found.size(), 2u);
        QCOMPARE(found[1].id, std::string("force-feedback:/dev/hidraw7"));
        device.answer = [](std::uint8_t id) { return Bytes{id, 5, 1}; };
        QVERIFY(openDevice(system, found[1]).has_value());
        device.descriptor = fromHex("05010904a101c0");
        QCOMPARE(openDevice(system, found[1]).error().code, ErrorCode::UnsupportedFeature);
    }
};

SANDREEL_TEST(TestPid)
#include "tst_pid.moc"
