// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/geometry/vec3d.h"
#include "model/haptics/time.h"

#include <cstdint>
#include <string>

namespace model::haptics {

/// What a device is and can do. Lengths are metres of the hand, axes x right, y away, z up.
struct Capabilities
{
    std::string name;
    bool hasForce = false;
    /// It says how far a cap is pushed, not where it is: the tool moves while it is pushed.
    bool movesByDeflection = false;
    bool hasLight = false;
    bool isExperimental = false;
    double maxForce = 0; ///< N
    /// N s/m, of its mechanics and the hand that holds it: what keeps a stiff loop stable.
    double damping = 1;
    Vec3d low{-0.1, -0.1, -0.1}, high{0.1, 0.1, 0.1}; ///< where it can go
    std::uint32_t buttonCount = 0;
};

/// What a device said last.
struct Reading
{
    Vec3d position;
    std::uint32_t buttons = 0; ///< a bit for each, the first in bit 0
    Time time{0};              ///< when it said so, on the servo's clock
    bool isConnected = true;

    friend bool operator==(const Reading &, const Reading &) = default;
};

/// A device as the servo sees it. read() and write() are called in turns, from the servo's thread, 1000 times a second:
/// they never block, lock or allocate. What talks to hardware does so in a thread of its own.
class HapticDevice
{
public:
    virtual ~HapticDevice() = default;
    virtual const Capabilities &capabilities() const = 0;
    virtual Reading read(Time now) noexcept = 0;
    /// The force to hold until the next one, N; it came out of the safety gate. Nothing without `hasForce`.
    virtual void write(Vec3d force, Time now) noexcept = 0;
};

/// Reference 003, formulas 5.3.1 and 5.3.2: devices count in millimetres with y up and z towards the user, applications
/// in units of 200 mm with z up. Differs: the printed x = (X + 150) / 200 does not map -100 ... 100 onto 0 ... 1, which
/// the text claims; centred it does, and the reserve of 50 lies on both sides of it.
Vec3d fromDevice2009(Vec3d device);
Vec3d toDevice2009(Vec3d application);
/// [X, Y, Z] = [X, Z, -Y]; a force keeps its newtons.
Vec3d forceToDevice2009(Vec3d application);

} // namespace model::haptics
