// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/hid/catalog.h"
#include "model/haptics/hid/spacemouse.h"
#include "tests/support/testmain.h"

#include <algorithm>
#include <cstring>

#include <fcntl.h>
#include <linux/uhid.h>
#include <unistd.h>

using namespace model;
using namespace model::haptics;

namespace {

/// Axes in reports 1 and 2, two buttons in 3, a light in 4: as a SpaceNavigator has them.
const char *const Descriptor = "0501 0908 a101"
                               "a100 8501 16a2fe 265e01 36a2fe 465e01 0930 0931 0932 7510 9503 8102 c0"
                               "a100 8502 0933 0934 0935 7510 9503 8102 c0"
                               "a102 8503 0509 1901 2902 1500 2501 7501 9502 8102 950e 8103 c0"
                               "a102 8504 0508 094b 1500 2501 7501 9501 9102 9507 9103 c0"
                               "c0";

/// A device that the kernel believes in, while it lives.
class VirtualDevice
{
public:
    VirtualDevice()
        : mFile(::open("/dev/uhid", O_RDWR | O_CLOEXEC))
    {
        if (mFile < 0)
            return;
        uhid_event event{};
        event.type = UHID_CREATE2;
        std::strcpy(reinterpret_cast<char *>(event.u.create2.name), "Sandreel test SpaceNavigator");
        const QByteArray descriptor = QByteArray::fromHex(Descriptor);
        std::copy(descriptor.begin(), descriptor.end(), event.u.create2.rd_data);
        event.u.create2.rd_size = std::uint16_t(descriptor.size());
        event.u.create2.bus = 3; // USB
        event.u.create2.vendor = 0x046d;
        event.u.create2.product = 0xc626;
        mIsThere = ::write(mFile, &event, sizeof event) == sizeof event;
    }
    VirtualDevice(const VirtualDevice &) = delete;
    VirtualDevice &operator=(const VirtualDevice &) = delete;
    ~VirtualDevice()
    {
        if (mFile >= 0)
            ::close(mFile);
    }
    bool isThere() const { return mIsThere; }
    bool say(std::initializer_list<std::uint8_t> report)
    {
        uhid_event event{};
        event.type = UHID_INPUT2;
        event.u.input2.size = std::uint16_t(report.size());
        std::copy(report.begin(), report.end(), event.u.input2.data);
        return ::write(mFile, &event, sizeof event) == sizeof event;
    }

private:
    int mFile;
    bool mIsThere = false;
};

} // namespace

/// The shipped adapter with the system's libhidapi and a device of the kernel's.
class TestUhid final : public QObject
{
    Q_OBJECT

private slots:
    void aDeviceOfTheKernelIsFoundAndRead()
    {
        VirtualDevice device;
        if (!device.isThere())
            QSKIP("/dev/uhid is not there, or not for this user: the adapter runs under the fake library alone");
        const auto system = hidapiSystem();
        FoundDevice found;
        QTRY_VERIFY(std::ranges::any_of(findDevices(*system), [&](const FoundDevice &candidate) {
            found = candidate;
            return candidate.name == "Sandreel test SpaceNavigator";
        }));
        if (!found.isAllowed)
            QSKIP("this user may not open hidraw devices");
        auto open = openDevice(*system, found);
        QVERIFY(open.has_value());
        const auto *mouse = dynamic_cast<SpaceMouse *>(open->device.get());
        QVERIFY(device.say({3, 2, 0}));
        QVERIFY(device.say({1, 100, 0, 0, 0, 0, 0}));
        QTRY_COMPARE(mouse->state().buttons, 2u);
        QTRY_COMPARE(int(mouse->state().axes[0]), 100);
    }
};

SANDREEL_TEST(TestUhid)
#include "tst_uhid.moc"
