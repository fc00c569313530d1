// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/material/material.h"

#include <cstdint>

namespace model::haptics {

/// How a material answers a tool, at the hand: newtons, and metres that the hand moves. Plain data, for the servo.
struct Feel
{
    double resistance = 120;   ///< N/m: how the force at which it yields grows with depth
    double crust = 0.15;       ///< N: at which it yields at the surface
    double plough = 90;        ///< N/m: the same sideways, with what is heaped ahead
    double elasticity = 500;   ///< N/m: below the yield
    double damping = 0.25;     ///< N s/m, in full contact
    double hold = 0.05;        ///< the share of the yield force that it can pull back with, 0 ... 1
    double graininess = 0.05;  ///< the share of the force by which grains roughen it, 0 ... 1
    double grainSize = 0.0006; ///< metres of travel from grain to grain

    friend bool operator==(const Feel &, const Feel &) = default;
};

/// From what the terrain knows of a material, at a humidity of 0 ... 1: heavier and steeper material resists more,
/// compressible less; what stands steeper than the same material dry is held together by water, and holds the tool.
Feel feelOf(const terrain::Material &material, double humidity);

/// Bedrock: it does not yield within what a device can push.
Feel rockFeel();

} // namespace model::haptics
