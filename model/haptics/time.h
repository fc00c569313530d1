// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace model::haptics {

/// A moment on the clock that drives the servo, or a span of it. The thread takes CLOCK_MONOTONIC; tests and replays a
/// virtual clock.
using Time = std::chrono::nanoseconds;

/// The servo's period: 1000 Hz.
inline constexpr Time ServoPeriod = std::chrono::milliseconds(1);

constexpr double seconds(Time t)
{
    return double(t.count()) * 1e-9;
}

} // namespace model::haptics
