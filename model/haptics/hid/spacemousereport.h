// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace model::haptics {

/// What a 3Dconnexion SpaceMouse has said.
struct SpaceMouseState
{
    static constexpr int FullDeflection = 350;

    /// -FullDeflection ... FullDeflection as the device counts: x right, y towards the user, z down, and turns about
    /// them.
    std::array<std::int16_t, 6> axes{};
    std::uint32_t buttons = 0;
    std::int16_t battery = -1; ///< percent; -1: it has none, or has not said
    bool isCharging = false;

    friend bool operator==(const SpaceMouseState &, const SpaceMouseState &) = default;
};

/// Takes an input report, id first, into `state`. Old devices send translation and rotation apart, new ones together.
/// \returns false for reports that it does not know or that are too short; `state` is untouched then
/// Source: github.com/AndunHH/spacemouse (captures), spacenavd src/dev.c. Lengths are minimums: newer devices append.
bool takeSpaceMouseReport(std::span<const std::uint8_t> report, SpaceMouseState &state);

/// The output report that switches the light.
std::array<std::uint8_t, 2> spaceMouseLight(bool on);

/// By vendor and product; `usagePage` and `usage` 0 if the system does not say. Receivers show several devices with
/// the same numbers, of which one has axes.
bool isSpaceMouse(std::uint16_t vendor, std::uint16_t product, std::uint16_t usagePage, std::uint16_t usage);

} // namespace model::haptics
