// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/hid/spacemousereport.h"

#include <algorithm>

namespace model::haptics {

namespace {

constexpr std::uint16_t Logitech = 0x046d, Connexion = 0x256f;
constexpr std::uint16_t OldProducts[] = {0xc603, 0xc605, 0xc606, 0xc621, 0xc623, 0xc625,
                                         0xc626, 0xc627, 0xc628, 0xc629, 0xc62b, 0xc640};
/// Mice, keyboards and pads of the same vendor.
constexpr std::uint16_t OtherProducts[] = {0xc62c, 0xc641, 0xc650, 0xc651, 0xc654, 0xc655,
                                           0xc656, 0xc657, 0xc658, 0xc664, 0xc665, 0xc668};
constexpr std::uint16_t GenericDesktop = 1, MultiAxisController = 8;

enum ReportId : std::uint8_t { Translation = 1, Rotation = 2, Buttons = 3, Light = 4, Battery = 0x17 };

std::int16_t axisAt(std::span<const std::uint8_t> report, std::size_t axis)
{
    const std::int16_t value = std::int16_t(report[1 + 2 * axis] | report[2 + 2 * axis] << 8);
    return std::clamp<std::int16_t>(value, -SpaceMouseState::FullDeflection, SpaceMouseState::FullDeflection);
}

} // namespace

bool takeSpaceMouseReport(std::span<const std::uint8_t> report, SpaceMouseState &state)
{
    if (report.empty())
        return false;
    switch (report[0]) {
    case Translation:
        if (report.size() < 7)
            return false;
        for (std::size_t i = 0; i < (report.size() >= 13 ? 6u : 3u); ++i)
            state.axes[i] = axisAt(report, i);
        return true;
    case Rotation:
        if (report.size() < 7)
            return false;
        for (std::size_t i = 0; i < 3; ++i)
            state.axes[3 + i] = axisAt(report, i);
        return true;
    case Buttons:
        if (report.size() < 2)
            return false;
        state.buttons = 0;
        for (std::size_t i = 1; i < std::min<std::size_t>(report.size(), 5); ++i)
            state.buttons |= std::uint32_t(report[i]) << (8 * (i - 1));
        return true;
    case Battery:
        if (report.size() < 3 || report[1] > 100)
            return false;
        state.battery = report[1];
        state.isCharging = report[2] & 1;
        return true;
    }
    return false;
}

std::array<std::uint8_t, 2> spaceMouseLight(bool on)
{
    return {Light, std::uint8_t(on)};
}

bool isSpaceMouse(std::uint16_t vendor, std::uint16_t product, std::uint16_t usagePage, std::uint16_t usage)
{
    const auto isIn = [product](const auto &list) {
        return std::find(std::begin(list), std::end(list), product) != std::end(list);
    };
    const bool isKnown = (vendor == Logitech && isIn(OldProducts)) || (vendor == Connexion && !isIn(OtherProducts));
    const bool saysUsage = usagePage != 0 || usage != 0;
    return isKnown && (!saysUsage || (usagePage == GenericDesktop && usage == MultiAxisController));
}

} // namespace model::haptics
