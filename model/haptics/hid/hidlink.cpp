// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/hid/hidlink.h"

namespace model::haptics {

HidLink::HidLink(HidSystem &system, HidDeviceInfo info, HidHandler &handler)
    : mSystem(system)
    , mInfo(std::move(info))
    , mHandler(handler)
{}

HidLink::~HidLink()
{
    stop();
}

Result<void> HidLink::open()
{
    return openAs(mInfo);
}

Result<void> HidLink::openAs(const HidDeviceInfo &info)
{
    auto transport = mSystem.open(info);
    if (!transport)
        return fail(std::move(transport).error());
    if (auto ready = mHandler.connected(**transport); !ready)
        return fail(std::move(ready).error().in(info.path));
    mInfo.path = info.path;
    mTransport = std::move(*transport);
    return {};
}

void HidLink::pump(Time now)
{
    if (!mTransport) {
        reopen(now);
        return;
    }
    std::uint8_t report[256];
    const auto count = mTransport->read(report, ReadTimeout);
    if (!count) {
        lose();
        mRetry = now + RetryTime;
        return;
    }
    if (*count > 0)
        mHandler.received({report, std::min(*count, sizeof report)}, now);
    if (!mHandler.serve(*mTransport, now)) {
        lose();
        mRetry = now + RetryTime;
    }
}

void HidLink::reopen(Time now)
{
    if (now < mRetry)
        return;
    mRetry = now + RetryTime;
    const auto devices = mSystem.devices();
    if (!devices)
        return;
    for (const HidDeviceInfo &info : *devices)
        if (info.vendor == mInfo.vendor && info.product == mInfo.product && info.serial == mInfo.serial &&
            info.usagePage == mInfo.usagePage && info.usage == mInfo.usage && openAs(info))
            return;
}

void HidLink::lose()
{
    mTransport.reset();
    mHandler.disconnected();
}

void HidLink::start(std::function<Time()> clock)
{
    if (mThread.joinable())
        return;
    mHasToStop = false;
    mThread = std::thread([this, clock = std::move(clock)] {
        while (!mHasToStop) {
            pump(clock());
            if (!mTransport)
                std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
    });
}

void HidLink::stop()
{
    mHasToStop = true;
    if (mThread.joinable())
        mThread.join();
    if (mTransport) {
        mHandler.closing(*mTransport);
        lose();
    }
}

} // namespace model::haptics
