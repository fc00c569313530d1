// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/service/hapticsservice.h"

namespace model::haptics {

namespace {

/// The patch reaches so many radii of the tool around it: further than a hand moves between two snapshots.
constexpr double PatchReach = 6;

} // namespace

HapticsService::HapticsService(std::shared_ptr<HidSystem> system)
    : mSystem(std::move(system))
{}

HapticsService::~HapticsService()
{
    close();
}

Result<void> HapticsService::open(const FoundDevice &found)
{
    close();
    auto device = openDevice(*mSystem, found);
    if (!device)
        return fail(std::move(device).error());
    begin(std::move(*device));
    return {};
}

void HapticsService::openSimulated(std::unique_ptr<SimulatedDevice> device)
{
    close();
    begin({std::move(device), nullptr});
}

void HapticsService::begin(OpenDevice device)
{
    mDevice = std::move(device);
    mCore = std::make_unique<ServoCore>();
    mRing = std::make_unique<SampleRing>();
    mPatches = 0;
    mLatest.set({});
    setSettings(mSettings);
    mThread = std::make_unique<PeriodicThread>([this](Time now) {
        const ServoSample sample = mCore->step(mDevice.device->read(now), now);
        mDevice.device->write(sample.force, now);
        mLatest.set(sample);
        mRing->push(sample);
    });
    mThread->start();
}

void HapticsService::close()
{
    if (!mThread)
        return;
    setForces(false);
    mThread->stop();
    if (mRecorder) {
        std::vector<ServoSample> rest;
        drain(rest);
    }
    mDevice.device->write({}, monotonicNow());
    mThread.reset();
    mDevice.link.reset();
    mDevice.device.reset();
}

const Capabilities *HapticsService::capabilities() const
{
    return mDevice.device ? &mDevice.device->capabilities() : nullptr;
}

void HapticsService::setSettings(ServoSettings settings)
{
    settings.id = mSettings.id + 1;
    if (const Capabilities *const device = capabilities()) {
        settings.limits.deviceForce = device->maxForce;
        settings.limits.low = device->low;
        settings.limits.high = device->high;
        settings.deviceDamping = device->damping;
    }
    mSettings = settings;
    if (!mCore)
        return;
    if (mRecorder)
        mRecorder->add(mSettings);
    mCore->publishSettings(mSettings);
}

void HapticsService::setForces(bool on)
{
    if (mCore)
        mCore->setForces(on);
}

void HapticsService::publishGround(const terrain::Terrain &terrain)
{
    if (!mThread)
        return;
    const Time now = monotonicNow();
    const Workspace &workspace = mSettings.workspace;
    const terrain::Point3 tool = workspace.toTerrain(latest().reading.position);
    TerrainPatch &patch = mCore->nextPatch();
    mBuilder.build(terrain, {tool.x, tool.y}, PatchReach * workspace.toolRadius, patch);
    patch.id = ++mPatches;
    patch.time = mShownAt = now;
    if (mRecorder)
        mRecorder->add(patch);
    mCore->publishPatch();
}

void HapticsService::drain(std::vector<ServoSample> &samples)
{
    if (!mRing)
        return;
    const std::size_t before = samples.size();
    mRing->drain(samples);
    if (mRecorder)
        mRecorder->add(std::span(samples).subspan(before));
}

ServoSample HapticsService::latest() const
{
    ServoSample sample;
    mLatest.read(sample);
    return sample;
}

Punctuality HapticsService::punctuality() const
{
    return mThread ? mThread->punctuality() : Punctuality();
}

/// A recording begins with a new servo: what the old one remembers could not be replayed.
void HapticsService::startRecording()
{
    if (!mThread)
        return;
    mThread->stop();
    mRecorder.emplace(mDevice.device->capabilities().name);
    mCore = std::make_unique<ServoCore>();
    mRing = std::make_unique<SampleRing>();
    mPatches = 0;
    setSettings(mSettings);
    mThread->start();
}

Recording HapticsService::stopRecording()
{
    std::vector<ServoSample> rest;
    drain(rest);
    if (mRing)
        mRecorder->setLost(mRing->lost());
    Recording recording = mRecorder->recording();
    mRecorder.reset();
    return recording;
}

} // namespace model::haptics
