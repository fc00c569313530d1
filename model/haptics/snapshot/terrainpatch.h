// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/geometry/vec3d.h"
#include "model/haptics/feel/feel.h"
#include "model/haptics/time.h"
#include "model/terrain/tin/ids.h"

#include <array>
#include <cstdint>
#include <span>

namespace model::haptics {

/// The surface at a place.
struct Ground
{
    double height = 0; ///< in the terrain
    double slopeX = 0, slopeY = 0;
    bool isKnown = false; ///< false: beyond the patch, or void
};

/// The ground near the tool, as it was at one moment: what the servo feels until the next one comes. About 60 KiB of
/// plain memory without pointers, so that it is handed over whole.
class TerrainPatch
{
public:
    static constexpr std::uint32_t MaxTriangles = 512;
    static constexpr std::uint32_t CellsPerSide = 16;

    std::uint64_t id = 0; ///< counts up from 1; 0: no patch yet
    Time time{0};         ///< when the terrain was so
    terrain::Point2 centre;
    double centreHeight = 0; ///< heights of `triangles` are above it
    double radius = 0;       ///< metres; the patch covers the square around the centre with this half side
    Feel feel;

    /// Corners relative to the centre, metres. As floats they are exact enough for a hand, and a recording that keeps
    /// them rebuilds the very same patch.
    std::array<std::array<Vec3f, 3>, MaxTriangles> triangles;
    std::uint32_t triangleCount = 0;

    /// Prepares groundAt() for the triangles as they are now; leaves out those without an area. To be called by who
    /// fills them. \returns false if they lie so that no index of bounded size holds them; nothing is known then
    bool index();
    /// Of a place in the terrain. Cost: the triangles that touch one cell.
    Ground groundAt(terrain::Point2 p) const;
    std::span<const std::array<Vec3f, 3>> surface() const { return {triangles.data(), triangleCount}; }

private:
    /// Two barycentric coordinates and the height as functions a x + b y + c.
    struct Plane
    {
        double first[3], second[3], height[3];
    };
    static constexpr std::uint32_t MaxCellEntries = 8192;
    static constexpr std::uint32_t CellCount = CellsPerSide * CellsPerSide;

    std::uint32_t cellOf(double x) const;
    template <class Visit>
    void forEachCellOf(std::uint32_t triangle, Visit visit) const;

    std::array<Plane, MaxTriangles> mPlanes;
    std::array<std::uint16_t, CellCount + 1> mCellBegins{};
    std::array<std::uint16_t, MaxCellEntries> mCellEntries;
};

} // namespace model::haptics
