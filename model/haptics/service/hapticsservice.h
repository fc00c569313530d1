// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/device/simulateddevice.h"
#include "model/haptics/hid/catalog.h"
#include "model/haptics/hid/spacemouse.h"
#include "model/haptics/record/recording.h"
#include "model/haptics/servo/periodicthread.h"
#include "model/haptics/servo/samplering.h"
#include "model/haptics/snapshot/patchbuilder.h"

#include <optional>

namespace model::haptics {

/// Everything about haptics in one place, for an editor's dock or a command: finds devices, keeps one open, feels the
/// ground that it is shown, and tells what happens.
///
/// Called from one thread; the servo and the devices have threads of their own. No call waits longer than a device
/// takes to open or close. Whoever owns it calls publishGround() at least 30 times a second while a terrain is shown
/// (else forces fade), drain() several times a second, and devices() now and then to notice what was plugged in.
class HapticsService
{
public:
    explicit HapticsService(std::shared_ptr<HidSystem> system = hidapiSystem());
    HapticsService(const HapticsService &) = delete;
    HapticsService &operator=(const HapticsService &) = delete;
    ~HapticsService(); ///< closes

    std::vector<FoundDevice> devices() { return findDevices(*mSystem); }
    /// Opens a device instead of the one that is open, and starts the servo. Forces are off. \error as openDevice()
    Result<void> open(const FoundDevice &found);
    /// The same with the simulated device as the caller has prepared it.
    void openSimulated(std::unique_ptr<SimulatedDevice> device);
    /// Forces off, the servo stopped, the device at rest.
    void close();
    bool isOpen() const { return mDevice.device != nullptr; }

    // Of the open device; null if none is open, or it is another kind.
    const Capabilities *capabilities() const;
    SimulatedDevice *simulated() const { return dynamic_cast<SimulatedDevice *>(mDevice.device.get()); }
    SpaceMouse *spaceMouse() const { return dynamic_cast<SpaceMouse *>(mDevice.device.get()); }

    /// The device's own limits and damping are put in; the id too.
    void setSettings(ServoSettings settings);
    const ServoSettings &settings() const { return mSettings; }
    /// Off at the start, and after every open(). Safe to call at any time: this is what STOP and Esc do with false.
    void setForces(bool on);
    bool wantsForces() const { return mCore && mCore->wantsForces(); }

    /// Cuts the patch around the tool out of `terrain` and hands it to the servo. Cost: some 10 us to 1 ms.
    void publishGround(const terrain::Terrain &terrain);
    /// When it was last called: the time of the newest patch.
    Time shownAt() const { return mShownAt; }

    /// The steps since the last call, appended; they go into the recording too.
    void drain(std::vector<ServoSample> &samples);
    /// The last step. Of any thread; nothing before the first.
    ServoSample latest() const;
    Punctuality punctuality() const;
    /// Null while nothing is open.
    const Histogram *lateness() const { return mThread ? &mThread->lateness() : nullptr; }
    const Histogram *stepTimes() const { return mThread ? &mThread->stepTimes() : nullptr; }

    void startRecording();
    bool isRecording() const { return mRecorder.has_value(); }
    /// Precondition: isRecording().
    Recording stopRecording();

private:
    void begin(OpenDevice device);
    void publishSettings();

    std::shared_ptr<HidSystem> mSystem;
    OpenDevice mDevice;
    std::unique_ptr<ServoCore> mCore;
    std::unique_ptr<SampleRing> mRing;
    Latest<ServoSample> mLatest;
    std::unique_ptr<PeriodicThread> mThread; ///< after what it uses
    ServoSettings mSettings;
    PatchBuilder mBuilder;
    std::uint64_t mPatches = 0;
    Time mShownAt{0};
    std::optional<Recorder> mRecorder;
};

} // namespace model::haptics
