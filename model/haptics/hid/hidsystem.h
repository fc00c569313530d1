// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/bytes.h"
#include "model/base/error.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace model::haptics {

/// A HID device as the system lists it. Texts are UTF-8.
struct HidDeviceInfo
{
    std::string path; ///< what open() takes: "/dev/hidraw3"
    std::uint16_t vendor = 0, product = 0;
    std::uint16_t usagePage = 0, usage = 0; ///< 0: not known
    std::string manufacturer, productName, serial;

    friend bool operator==(const HidDeviceInfo &, const HidDeviceInfo &) = default;
};

/// An open device. For one thread.
class HidTransport
{
public:
    virtual ~HidTransport() = default;
    /// Waits for an input report at most `milliseconds`. A report begins with its id, or is without one if the device
    /// numbers none. \returns its length; 0: none came
    /// \error CannotRead  the device is gone
    virtual Result<std::size_t> read(std::span<std::uint8_t> report, int milliseconds) = 0;
    /// Sends an output report, id first. \error CannotWrite
    virtual Result<void> write(std::span<const std::uint8_t> report) = 0;
    /// \error CannotWrite
    virtual Result<void> sendFeature(std::span<const std::uint8_t> report) = 0;
    /// Asks for the feature report whose id is the first byte. \returns its length, the id counted in
    /// \error CannotRead
    virtual Result<std::size_t> getFeature(std::span<std::uint8_t> report) = 0;
};

/// The system's HID devices. Thread-safe.
class HidSystem
{
public:
    virtual ~HidSystem() = default;
    /// \error CannotOpen  the HID library does not work here
    virtual Result<std::vector<HidDeviceInfo>> devices() = 0;
    /// \error CannotOpen  args: why; the device's path is the error's file
    virtual Result<std::unique_ptr<HidTransport>> open(const HidDeviceInfo &info) = 0;
    /// What the device says about its reports; needs no right to open it where the system publishes it.
    /// \error CannotRead
    virtual Result<Bytes> reportDescriptor(const HidDeviceInfo &info) = 0;
    /// Whether this user may open it. true if that cannot be told without trying.
    virtual bool hasPermission(const HidDeviceInfo &info) = 0;
};

/// The real one, through libhidapi.
std::unique_ptr<HidSystem> hidapiSystem();

} // namespace model::haptics
