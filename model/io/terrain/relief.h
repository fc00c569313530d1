// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/ids.h"

#include <array>
#include <cstdint>

namespace model::io {

enum class ReliefShape : std::uint8_t { Flat, Dunes, Noise };
inline constexpr ReliefShape EveryReliefShape[] = {ReliefShape::Flat, ReliefShape::Dunes, ReliefShape::Noise};

/// What a new terrain looks like: a description, of which the same heights come on every machine.
struct ReliefSettings
{
    ReliefShape shape = ReliefShape::Flat;
    double height = 5;      ///< metres, about, from the lowest place to the highest
    double wavelength = 40; ///< metres: from one dune to the next, or of the largest hills
    std::uint32_t seed = 1;

    friend bool operator==(const ReliefSettings &, const ReliefSettings &) = default;
};

/// Heights above the lowest place, for any point.
class Relief
{
public:
    /// Precondition: height and wavelength are above 0 unless it is flat.
    explicit Relief(const ReliefSettings &settings);

    double heightAt(terrain::Point2 p) const;

private:
    double noise(double x, double y) const;
    double hills(double x, double y) const;
    double dunes(double x, double y) const;

    ReliefSettings mSettings;
    std::array<std::uint8_t, 256> mOrder; ///< a permutation, by the seed
};

} // namespace model::io
