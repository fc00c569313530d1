// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/snapshot/terrainpatch.h"

#include <array>

namespace model::haptics {

/// How the hand's metres become the terrain's: the servo and the laws work in the hand's.
struct Workspace
{
    terrain::Point3 origin;  ///< in the terrain, where the hand's origin lies
    double scale = 1;        ///< metres of terrain for a metre of hand
    double toolRadius = 0.1; ///< of the tool's outer ring, in the terrain

    terrain::Point3 toTerrain(Vec3d hand) const
    {
        return {origin.x + scale * hand.x, origin.y + scale * hand.y, origin.z + scale * hand.z};
    }
    Vec3d toHand(terrain::Point3 p) const
    {
        return Vec3d(p.x - origin.x, p.y - origin.y, p.z - origin.z) * (1 / scale);
    }
    friend bool operator==(const Workspace &a, const Workspace &b)
    {
        return a.origin.x == b.origin.x && a.origin.y == b.origin.y && a.origin.z == b.origin.z && a.scale == b.scale &&
               a.toolRadius == b.toolRadius;
    }
};

/// Control points on the tool's outer ring, as reference 003 has them.
inline constexpr std::uint32_t RingPoints = 12;
/// Unit vectors from the centre to the control points.
extern const std::array<terrain::Point2, RingPoints> RingDirections;

/// Where the tool is in the ground: all that a force law may look at. Metres and seconds of the hand.
struct Contact
{
    bool isKnown = false; ///< false: there is no ground under the centre to say anything of
    Vec3d position, velocity;
    double centreDepth = 0;                     ///< of the tool's sole below the ground under its centre
    std::array<double, RingPoints> ringDepth{}; ///< below the ground at each control point
    double dt = 0;                              ///< since the step before
    /// N/m, N s/m: what the loop can render stably at the rate it has; laws stay below.
    double stiffnessLimit = 1000, dampingLimit = 1;
};

/// \param position, velocity  of the tool, in the hand's metres. Control points beyond the patch count as its centre.
/// No allocation, no lock. Cost: 13 look-ups in the patch.
Contact contactAt(const TerrainPatch &patch, const Workspace &workspace, Vec3d position, Vec3d velocity);

} // namespace model::haptics
