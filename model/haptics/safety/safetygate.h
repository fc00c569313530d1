// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/geometry/vec3d.h"
#include "model/haptics/time.h"

#include <cstdint>

namespace model::haptics {

/// N, whatever a device or a user asks for: a jump to it in a millisecond knocks a stylus out of the hand.
inline constexpr double HardForceLimit = 10;

/// What the gate keeps to. check() of the values is inside: what makes no sense counts as the strictest.
struct SafetyLimits
{
    double deviceForce = HardForceLimit; ///< N, the most that the device may be asked for
    double userForce = 4;                ///< N, the most that the user wants
    double power = 3;                    ///< W, force times speed
    Vec3d low{-0.2, -0.2, -0.2};         ///< the device's workspace, m; soft walls push back outside ...
    Vec3d high{0.2, 0.2, 0.2};
    double wallStiffness = 150; ///< N/m ... so hard
    double wallForce = 2;       ///< N ... and no harder

    friend bool operator==(const SafetyLimits &, const SafetyLimits &) = default;
};

/// Why there is no force. Numbers are part of the recording format.
enum class SafetyCause : std::uint8_t {
    None = 0,
    Stopped = 1,       ///< the user's doing, and so at every start
    StaleSnapshot = 2, ///< the terrain's thread has stalled
    LateLoop = 3,      ///< the servo itself has
    DeviceSilent = 4,  ///< no reading for too long
    DeviceLost = 5,    ///< unplugged
    BadNumber = 6,     ///< NaN or infinite; latched until the next stop
};

enum class SafetyState : std::uint8_t {
    Stopped = 0, ///< no force
    Waiting = 1, ///< no force yet: what is wanted has to be small first
    Rising = 2,  ///< the force grows from nothing to all
    On = 3,
    Fading = 4, ///< to nothing, then Waiting or Stopped
};

/// What one step knows.
struct SafetyInput
{
    Vec3d wanted;             ///< N
    Vec3d position, velocity; ///< m, m/s, of the hand
    Time elapsed{0};          ///< since the step before, as it really was
    Time snapshotAge{0};      ///< since the ground was as it is felt
    Time readingAge{0};       ///< since the device last said where it is
    bool isConnected = true;
    double rate = 1000; ///< Hz that the loop really keeps
};

/// The one function that every force passes on its way to a device. Pure logic: no clock, no device, no thread.
///
/// Whatever comes in, what goes out is finite, at most min(HardForceLimit, device, user) long, changes by at most
/// RiseRate (FallRate towards nothing) times the time since the step before, and is zero 100 ms after the last good
/// snapshot or reading: at once if the loop itself slept longer. Within the limit of power as far as the rates allow.
/// A stop is not one of the causes that heal: forces begin with start() alone.
/// Source: CHAI3D 3.2, CGenericTool (waiting for a small force, rise over 2 s, damping meanwhile).
class SafetyGate
{
public:
    static constexpr double RiseRate = 500;  ///< N/s
    static constexpr double FallRate = 2000; ///< N/s
    /// No more than this counts as the time between two steps when the force rises: after a pause it does not jump.
    static constexpr Time LongestStep = std::chrono::milliseconds(2);
    static constexpr Time LargestSnapshotAge = std::chrono::milliseconds(50);
    static constexpr Time LargestReadingAge = std::chrono::milliseconds(50);
    static constexpr Time LatestStep = std::chrono::milliseconds(20);
    /// In which a force fades when something is wrong; with the ages above well within 100 ms.
    static constexpr Time FadeTime = std::chrono::milliseconds(30);
    static constexpr double SmallForce = 0.2; ///< N
    static constexpr int SmallSteps = 4;      ///< so many in a row, more than 3
    static constexpr Time SoftStart = std::chrono::seconds(2);
    static constexpr double StartDamping = 1;       ///< N s/m at the beginning of the soft start, less and less ...
    static constexpr double StartDampingRate = 400; ///< ... if the loop keeps so many Hz

    void setLimits(const SafetyLimits &limits);
    const SafetyLimits &limits() const { return mLimits; }

    /// Allows forces. A latched cause is forgotten. Does nothing if they are allowed already.
    void start();
    /// Forces fade out now, and stay out.
    void stop();

    /// The force for the device. To be called once in each step.
    Vec3d filter(const SafetyInput &input);

    SafetyState state() const { return mState; }
    /// Why there is no force, or why it fades; None while there is one.
    SafetyCause cause() const { return mCause; }

private:
    SafetyCause causeOf(const SafetyInput &input) const;
    Vec3d wall(Vec3d position) const;
    Vec3d target(const SafetyInput &input);
    Vec3d slewed(Vec3d target, Time elapsed) const;
    Vec3d faded(Time elapsed);
    double forceLimit() const;

    SafetyLimits mLimits;
    SafetyState mState = SafetyState::Stopped;
    SafetyCause mCause = SafetyCause::Stopped;
    Vec3d mForce;         ///< that of the step before
    double mFadeRate = 0; ///< N/s
    double mRise = 0;     ///< share of the force, 0 ... 1
    int mSmallSteps = 0;
};

} // namespace model::haptics
