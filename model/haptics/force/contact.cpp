// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/force/contact.h"

#include <cmath>
#include <numbers>

namespace model::haptics {

namespace {

std::array<terrain::Point2, RingPoints> ringDirections()
{
    std::array<terrain::Point2, RingPoints> directions;
    for (std::uint32_t i = 0; i < RingPoints; ++i) {
        const double angle = 2 * std::numbers::pi * i / RingPoints;
        directions[i] = {std::cos(angle), std::sin(angle)};
    }
    return directions;
}

} // namespace

const std::array<terrain::Point2, RingPoints> RingDirections = ringDirections();

Contact contactAt(const TerrainPatch &patch, const Workspace &workspace, Vec3d position, Vec3d velocity)
{
    Contact contact;
    contact.position = position;
    contact.velocity = velocity;
    const terrain::Point3 tool = workspace.toTerrain(position);
    const Ground centre = patch.groundAt({tool.x, tool.y});
    if (!centre.isKnown)
        return contact;
    contact.isKnown = true;
    contact.centreDepth = (centre.height - tool.z) / workspace.scale;
    for (std::uint32_t i = 0; i < RingPoints; ++i) {
        const Ground ground = patch.groundAt(
            {tool.x + workspace.toolRadius * RingDirections[i].x, tool.y + workspace.toolRadius * RingDirections[i].y});
        contact.ringDepth[i] = ground.isKnown ? (ground.height - tool.z) / workspace.scale : contact.centreDepth;
    }
    return contact;
}

} // namespace model::haptics
