// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/servo/servocore.h"

#include "model/haptics/servo/denormals.h"

#include <algorithm>
#include <cmath>

namespace model::haptics {

namespace {

/// The law's share of the damping that the device has; the rest pays for stiffness.
constexpr double DampingShare = 0.5;
constexpr double LargestGain = 2;
/// m, m/s: further or faster is no hand.
constexpr double LargestPosition = 10, LargestSpeed = 50;

bool isWithin(Vec3d v, double limit)
{
    return std::abs(v.x) <= limit && std::abs(v.y) <= limit && std::abs(v.z) <= limit; // false for NaN
}

} // namespace

void ServoCore::Periods::add(Time period)
{
    constexpr int Window = 1000;
    if (period > mLongest) {
        mSecond = mLongest;
        mLongest = period;
    } else {
        mSecond = std::max(mSecond, period);
    }
    if (++mCount < Window)
        return;
    mBefore = mSecond;
    mLongest = mSecond = Time(0);
    mCount = 0;
}

ServoCore::ServoCore()
    : mPatches(std::make_unique<TripleBuffer<TerrainPatch>>())
{
    for (std::size_t i = 0; i < mLaws.size(); ++i)
        mLaws[i] = makeLaw(EveryLaw[i]);
    mLaw = mLaws[0].get();
}

void ServoCore::publishSettings(const ServoSettings &settings)
{
    mNewSettings.writable() = settings;
    mNewSettings.publish();
}

void ServoCore::takeSettings()
{
    if (!mNewSettings.take())
        return;
    const ServoSettings &settings = mNewSettings.readable();
    if (settings.law != mSettings.law || !(settings.workspace == mSettings.workspace))
        mMemory = {}; // what the other law remembers says nothing here; the gate slews the change
    mSettings = settings;
    mGate.setLimits(mSettings.limits);
    for (std::size_t i = 0; i < mLaws.size(); ++i)
        if (EveryLaw[i] == mSettings.law)
            mLaw = mLaws[i].get();
}

/// A switch that goes on starts the gate, as soon as the force of a stop before has faded.
void ServoCore::heedSwitch(bool wantsForces)
{
    if (!wantsForces) {
        if (mWasWanted)
            mGate.stop();
        mHasToStart = false;
    } else if (!mWasWanted) {
        mHasToStart = true;
    }
    if (mHasToStart && mGate.state() == SafetyState::Stopped) {
        mGate.start();
        mHasToStart = false;
    }
    mWasWanted = wantsForces;
}

/// Colgate and Schenkel, Passivity of a Class of Sampled-Data Systems, 1994: b > K T / 2 + B. T is what the loop has
/// kept of late, so a late loop becomes soft by itself.
Contact ServoCore::contactHere(Vec3d position, Vec3d velocity, Time elapsed) const
{
    Contact contact = contactAt(mPatches->readable(), mSettings.workspace, position, velocity);
    contact.dt = seconds(elapsed);
    const double damping = std::max(0.0, mSettings.deviceDamping);
    const double gain = std::max(1.0, mSettings.gain);
    contact.dampingLimit = DampingShare * damping / gain;
    contact.stiffnessLimit = 2 * (1 - DampingShare) * damping / seconds(trustedPeriod()) / gain;
    return contact;
}

Vec3d ServoCore::ask(const Contact &contact, LawMemory &memory) const
{
    const Feel &feel = mSettings.overridesFeel ? mSettings.feel : mPatches->readable().feel;
    return mLaw->force(contact, feel, memory) * std::clamp(mSettings.gain, 0.0, LargestGain);
}

Vec3d ServoCore::lawForce(const Reading &reading, Vec3d velocity, Time elapsed, ServoSample &sample)
{
    Contact contact = contactHere(reading.position, velocity, elapsed);
    Vec3d force;
    if (mPatches->hasNews()) {
        // The old ground answers once more, here, with a memory of its own.
        LawMemory memory = mMemory;
        const Vec3d before = ask(contact, memory);
        const Time period = mPatches->readable().time;
        mPatches->take();
        contact = contactHere(reading.position, velocity, elapsed);
        force = ask(contact, mMemory);
        mBlend.change(before, force, mPatches->readable().time - period);
    } else {
        force = ask(contact, mMemory);
    }
    sample.depth = contact.isKnown ? contact.centreDepth : 0;
    return force;
}

ServoSample ServoCore::step(const Reading &reading, Time now)
{
    const FlushDenormals flush;
    const Time elapsed = mHasBegun ? now - mBefore : ServoPeriod;
    mHasBegun = true;
    mBefore = now;
    mPeriods.add(elapsed);
    takeSettings();

    ServoSample sample;
    sample.now = now;
    sample.reading = reading;
    sample.wantsForces = mWantsForces.load(std::memory_order_relaxed);
    heedSwitch(sample.wantsForces);

    SafetyInput input;
    input.position = reading.position;
    input.isConnected = reading.isConnected;
    input.elapsed = elapsed;
    input.readingAge = now - reading.time;
    input.rate = 1 / seconds(std::max(trustedPeriod(), ServoPeriod / 2));
    const double wrong = std::nan("");
    if (!isWithin(reading.position, LargestPosition)) {
        input.wanted = {wrong, wrong, wrong};
        mMemory = {};
        mBlend.reset();
        mVelocity.reset();
    } else {
        input.velocity = mVelocity.add(reading.position, reading.time);
        if (!isWithin(input.velocity, LargestSpeed))
            input.velocity = {};
        const Vec3d asked = lawForce(reading, input.velocity, elapsed, sample); // may change the blend: so it is first
        input.wanted = asked + mBlend.advance(elapsed);
    }
    const TerrainPatch &patch = mPatches->readable();
    input.snapshotAge = patch.id != 0 ? now - patch.time : Time::max();

    sample.lawForce = input.wanted;
    sample.force = mGate.filter(input);
    sample.patch = patch.id;
    sample.settings = mSettings.id;
    sample.state = mGate.state();
    sample.cause = mGate.cause();
    return sample;
}

} // namespace model::haptics
