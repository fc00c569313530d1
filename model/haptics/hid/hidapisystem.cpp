// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that knows libhidapi. It takes version 0.13.1 (Debian 12); newer calls only where they were found when
// the program was configured.
#include "model/haptics/hid/hidsystem.h"

#include <hidapi/hidapi.h>

#include <cerrno>
#include <cstring>
#include <cwchar>
#include <fstream>
#include <iterator>
#include <mutex>

#include <unistd.h>

namespace model::haptics {

namespace {

/// What no descriptor exceeds (HID 1.11 has 16-bit lengths; Linux ends at 4 KiB).
constexpr std::size_t LargestDescriptor = 4096;

std::string utf8(const wchar_t *text)
{
    std::string result;
    for (; text && *text; ++text) {
        const std::uint32_t c = std::uint32_t(*text);
        if (c < 0x80) {
            result += char(c);
        } else if (c < 0x800) {
            result += {char(0xc0 | (c >> 6)), char(0x80 | (c & 0x3f))};
        } else if (c < 0x10000) {
            result += {char(0xe0 | (c >> 12)), char(0x80 | ((c >> 6) & 0x3f)), char(0x80 | (c & 0x3f))};
        } else if (c < 0x110000) {
            result += {char(0xf0 | (c >> 18)), char(0x80 | ((c >> 12) & 0x3f)), char(0x80 | ((c >> 6) & 0x3f)),
                       char(0x80 | (c & 0x3f))};
        }
    }
    return result;
}

std::string lastError(hid_device *device)
{
    const std::string text = utf8(hid_error(device));
    return text.empty() ? "unknown reason" : text;
}

class HidapiTransport final : public HidTransport
{
public:
    HidapiTransport(hid_device *device, std::string path, std::mutex &systemMutex)
        : mDevice(device)
        , mPath(std::move(path))
        , mSystemMutex(systemMutex)
    {}
    ~HidapiTransport() override
    {
        const std::lock_guard lock(mSystemMutex);
        hid_close(mDevice);
    }

    Result<std::size_t> read(std::span<std::uint8_t> report, int milliseconds) override
    {
        const int count = hid_read_timeout(mDevice, report.data(), report.size(), milliseconds);
        if (count < 0)
            return fail(Error{ErrorCode::CannotRead, {lastError(mDevice)}, mPath, Error::None, Error::None});
        return std::size_t(count);
    }
    Result<void> write(std::span<const std::uint8_t> report) override
    {
        return sent(hid_write(mDevice, report.data(), report.size()));
    }
    Result<void> sendFeature(std::span<const std::uint8_t> report) override
    {
        return sent(hid_send_feature_report(mDevice, report.data(), report.size()));
    }
    Result<std::size_t> getFeature(std::span<std::uint8_t> report) override
    {
        const int count = hid_get_feature_report(mDevice, report.data(), report.size());
        if (count < 0)
            return fail(Error{ErrorCode::CannotRead, {lastError(mDevice)}, mPath, Error::None, Error::None});
        return std::size_t(count);
    }

private:
    Result<void> sent(int count)
    {
        if (count < 0)
            return fail(Error{ErrorCode::CannotWrite, {lastError(mDevice)}, mPath, Error::None, Error::None});
        return {};
    }

    hid_device *mDevice;
    std::string mPath;
    std::mutex &mSystemMutex;
};

/// libhidapi lists, opens and closes with state of its own: one at a time.
class HidapiSystem final : public HidSystem
{
public:
    ~HidapiSystem() override { hid_exit(); }

    Result<std::vector<HidDeviceInfo>> devices() override
    {
        const std::lock_guard lock(mMutex);
        if (hid_init() != 0)
            return fail(ErrorCode::CannotOpen, lastError(nullptr));
        std::vector<HidDeviceInfo> found;
        hid_device_info *const list = hid_enumerate(0, 0);
        for (const hid_device_info *d = list; d; d = d->next)
            found.push_back({d->path ? d->path : "", d->vendor_id, d->product_id, d->usage_page, d->usage,
                             utf8(d->manufacturer_string), utf8(d->product_string), utf8(d->serial_number)});
        hid_free_enumeration(list);
        return found;
    }

    Result<std::unique_ptr<HidTransport>> open(const HidDeviceInfo &info) override
    {
        const std::lock_guard lock(mMutex);
        hid_device *const device = hid_open_path(info.path.c_str());
        if (!device) {
            const std::string reason = isForbidden(info) ? std::strerror(EACCES) : lastError(nullptr);
            return fail(Error{ErrorCode::CannotOpen, {reason}, info.path, Error::None, Error::None});
        }
        return std::unique_ptr<HidTransport>(std::make_unique<HidapiTransport>(device, info.path, mMutex));
    }

    Result<Bytes> reportDescriptor(const HidDeviceInfo &info) override
    {
        Bytes bytes;
#ifdef SANDREEL_HIDAPI_HAS_REPORT_DESCRIPTOR // hidapi 0.14
        if (hid_device *const device = hid_open_path(info.path.c_str())) {
            bytes.resize(LargestDescriptor);
            const int count = hid_get_report_descriptor(device, bytes.data(), bytes.size());
            hid_close(device);
            bytes.resize(count > 0 ? std::size_t(count) : 0);
        }
        if (!bytes.empty())
            return bytes;
#endif
        // Linux publishes it beside the device, to be read by all.
        const std::string name = info.path.substr(info.path.rfind('/') + 1);
        std::ifstream file("/sys/class/hidraw/" + name + "/device/report_descriptor", std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
        if (bytes.empty() || bytes.size() > LargestDescriptor)
            return fail(Error{ErrorCode::CannotRead, {"report descriptor"}, info.path, Error::None, Error::None});
        return bytes;
    }

    bool hasPermission(const HidDeviceInfo &info) override
    {
        return !isForbidden(info);
    }

private:
    static bool isForbidden(const HidDeviceInfo &info)
    {
        return access(info.path.c_str(), R_OK | W_OK) != 0 && errno == EACCES;
    }

    std::mutex mMutex;
};

} // namespace

std::unique_ptr<HidSystem> hidapiSystem()
{
    return std::make_unique<HidapiSystem>();
}

} // namespace model::haptics
