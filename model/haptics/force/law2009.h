// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/force/forcelaw.h"

namespace model::haptics {

/// The forces of reference 003, chapter 5.3, kept for comparison; each of its parts can be left out.
///
/// It knows no material, has no memory, and does not yield: its author's verdict was that resistance is felt, but not
/// sand. Lengths of the reference are those of its application, whose unit square is 0.2 m of the hand.
class Law2009 final : public ForceLaw
{
public:
    enum class Sideways : std::uint8_t {
        None,
        AlongMotion, ///< 5.3.4: of the material in the direction of motion; trembles when the tool hardly moves
        Averaged     ///< 5.3.5: the mean over the directions to all control points
    };
    struct Parts
    {
        bool early = true; ///< 5.3.3: acts already 0.05 above the ground
        bool gel = true;   ///< 5.3.3: in contact never less than 0.2 N
        Sideways sideways = Sideways::Averaged;
    };

    static constexpr double MetresPerUnit = 0.2; ///< formula 5.3.1: 200 mm of the device are 1
    static constexpr double Stiffness = 10;      ///< N for a unit of depth
    static constexpr double Early = 0.05;        ///< units
    static constexpr double Gel = 0.2;           ///< N

    Law2009() = default;
    explicit Law2009(Parts parts)
        : mParts(parts)
    {}
    Vec3d force(const Contact &contact, const Feel &feel, LawMemory &memory) const override;

private:
    Vec3d sideways(const Contact &contact) const;

    Parts mParts;
};

} // namespace model::haptics
