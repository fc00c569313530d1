// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/hid/hidsystem.h"

#include <deque>
#include <functional>
#include <map>

namespace tests {

/// HID devices that do as a test says.
class ScriptedHid final : public model::haptics::HidSystem
{
public:
    using Bytes = model::Bytes;

    /// What one device says and is told. Shared by all that open it.
    struct Device
    {
        model::haptics::HidDeviceInfo info;
        Bytes descriptor;
        bool isAllowed = true, isPlugged = true;
        /// In turn; an empty one is silence.
        std::deque<Bytes> reports;
        std::vector<Bytes> sent, features;
        /// Answers feature requests; nothing: an error.
        std::function<model::Result<Bytes>(std::uint8_t id)> answer;
        int opened = 0;
    };

    Device &plug(const model::haptics::HidDeviceInfo &info)
    {
        mDevices.push_back(std::make_unique<Device>());
        mDevices.back()->info = info;
        return *mDevices.back();
    }

    model::Result<std::vector<model::haptics::HidDeviceInfo>> devices() override
    {
        if (isBroken)
            return model::fail(model::ErrorCode::CannotOpen, "no library");
        std::vector<model::haptics::HidDeviceInfo> found;
        for (const auto &device : mDevices)
            if (device->isPlugged)
                found.push_back(device->info);
        return found;
    }
    model::Result<std::unique_ptr<model::haptics::HidTransport>>
    open(const model::haptics::HidDeviceInfo &info) override
    {
        for (const auto &device : mDevices)
            if (device->info.path == info.path && device->isPlugged && device->isAllowed) {
                ++device->opened;
                return std::unique_ptr<model::haptics::HidTransport>(std::make_unique<Transport>(*device));
            }
        return model::fail(model::Error{
            model::ErrorCode::CannotOpen, {"Permission denied"}, info.path, model::Error::None, model::Error::None});
    }
    model::Result<Bytes> reportDescriptor(const model::haptics::HidDeviceInfo &info) override
    {
        for (const auto &device : mDevices)
            if (device->info.path == info.path && !device->descriptor.empty())
                return device->descriptor;
        return model::fail(model::ErrorCode::CannotRead, "report descriptor");
    }
    bool hasPermission(const model::haptics::HidDeviceInfo &info) override
    {
        for (const auto &device : mDevices)
            if (device->info.path == info.path)
                return device->isAllowed;
        return false;
    }

    bool isBroken = false;

private:
    class Transport final : public model::haptics::HidTransport
    {
    public:
        explicit Transport(Device &device)
            : mDevice(device)
        {}
        model::Result<std::size_t> read(std::span<std::uint8_t> report, int) override
        {
            if (!mDevice.isPlugged)
                return model::fail(model::ErrorCode::CannotRead, "gone");
            if (mDevice.reports.empty())
                return 0;
            const Bytes bytes = mDevice.reports.front();
            mDevice.reports.pop_front();
            const std::size_t count = std::min(bytes.size(), report.size());
            std::copy_n(bytes.begin(), count, report.begin());
            return count;
        }
        model::Result<void> write(std::span<const std::uint8_t> report) override
        {
            if (!mDevice.isPlugged)
                return model::fail(model::ErrorCode::CannotWrite, "gone");
            mDevice.sent.emplace_back(report.begin(), report.end());
            return {};
        }
        model::Result<void> sendFeature(std::span<const std::uint8_t> report) override
        {
            mDevice.features.emplace_back(report.begin(), report.end());
            return {};
        }
        model::Result<std::size_t> getFeature(std::span<std::uint8_t> report) override
        {
            if (!mDevice.answer)
                return model::fail(model::ErrorCode::CannotRead, "no answer");
            const auto bytes = mDevice.answer(report[0]);
            if (!bytes)
                return model::fail(bytes.error());
            const std::size_t count = std::min(bytes->size(), report.size());
            std::copy_n(bytes->begin(), count, report.begin());
            return count;
        }

    private:
        Device &mDevice;
    };

    std::vector<std::unique_ptr<Device>> mDevices;
};

} // namespace tests
