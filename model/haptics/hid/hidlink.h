// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/hid/hidsystem.h"
#include "model/haptics/time.h"

#include <atomic>
#include <functional>
#include <thread>

namespace model::haptics {

/// What speaks a device's language. Called by its HidLink, from one thread.
class HidHandler
{
public:
    virtual ~HidHandler() = default;
    /// The device was opened, for the first time or again. \returns an error if it is of no use
    virtual Result<void> connected(HidTransport &transport) = 0;
    virtual void received(std::span<const std::uint8_t> report, Time now) = 0;
    /// Time to send what is to be sent; called after each wait for a report.
    virtual Result<void> serve(HidTransport &transport, Time now) = 0;
    virtual void disconnected() = 0;
    /// The last chance to leave the device at rest.
    virtual void closing(HidTransport &transport) = 0;
};

/// Keeps a device open: reads its reports, and when it is gone looks for it twice a second until it comes back, by
/// vendor, product and serial number: its path may be another one then.
class HidLink
{
public:
    static constexpr Time RetryTime = std::chrono::milliseconds(500);
    static constexpr int ReadTimeout = 4; ///< ms: how often serve() is called in silence

    HidLink(HidSystem &system, HidDeviceInfo info, HidHandler &handler);
    HidLink(const HidLink &) = delete;
    HidLink &operator=(const HidLink &) = delete;
    ~HidLink(); ///< stops

    /// Opens the device now, so that the caller learns why not. \error those of HidSystem::open() and the handler
    Result<void> open();
    /// One round: a report, or trying to open the device again. Takes up to ReadTimeout.
    void pump(Time now);
    bool isConnected() const { return mTransport != nullptr; }

    /// Calls pump() from a thread of its own from now on.
    void start(std::function<Time()> clock);
    void stop();

private:
    Result<void> openAs(const HidDeviceInfo &info);
    void reopen(Time now);
    void lose();

    HidSystem &mSystem;
    HidDeviceInfo mInfo;
    HidHandler &mHandler;
    std::unique_ptr<HidTransport> mTransport;
    Time mRetry{0};
    std::thread mThread;
    std::atomic<bool> mHasToStop = false;
};

} // namespace model::haptics
