// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/slotmarks.h"
#include "model/terrain/tools/brush.h"
#include "model/terrain/tools/outline.h"

#include <optional>

namespace model::terrain {

/// How the material that a tool digs out lies around it.
struct Rim
{
    double criticalAngle = 33;  ///< degrees: how steep its outside gets; the more material, the wider it is
    double compressibility = 0; ///< 0 ... 1: the part of the dug volume that is pressed together, not pushed out
    double crest = 0.35;        ///< where it is highest, of its width
    /// Metres a second at which as much is pushed ahead as is left at the sides; slower tools leave more at the sides.
    double directedSpeed = 1;

    friend bool operator==(const Rim &, const Rim &) = default;
};

struct Material;

/// `rim` with the outside slope and the compression of a material.
Rim rimOf(const Material &material, Rim rim = {});

/// A rigid tool with a flat sole, pressed into the ground.
struct Imprint
{
    Outline outline = Outline::disc();
    double radius = 1;                ///< metres
    double depth = 0.1;               ///< metres below the ground as it was before the stroke
    std::optional<double> level;      ///< the height of the sole, instead of a depth
    double gap = 0.05;                ///< how far the sole's edge lies inside the outline, in radii: the walls lean
    double spacing = 0.25;            ///< between stamps, in radii
    double rotation = 0;              ///< degrees, counter-clockwise
    bool doesFollowDirection = false; ///< the outline's +x turns to where the pen goes
    bool doesPressureScaleDepth = true;
    Rim rim;
    bool isRimOfMaterial = true; ///< whoever knows the material under the stroke puts rimOf() it in place of `rim`
    Mask mask;                   ///< a stamp whose centre it covers by half or more is left out
};

/// What stamps did, in cubic metres and pieces.
struct ImprintReport
{
    double dug = 0;        ///< volume that the tool took the place of
    double compressed = 0; ///< of that, what was pressed together
    double lost = 0;       ///< of that, what found no place around: the tool covers the terrain
    std::uint32_t stamps = 0;
};

/// One tool for one stroke. Each stamp: puts the outline's corners on the ground, constrains the outline, its edges
/// divided so that they follow the ground; constrains the edge of the sole; forces what lies inside down to the sole;
/// takes away vertices that this made superfluous and constraints of older stamps; pushes what was dug out into a rim,
/// exactly.
class ImprintStroke
{
public:
    /// \error BadSetting  a setting outside its range, or an outline so narrow that no sole is left
    static Result<ImprintStroke> prepare(const Imprint &tool);

    /// The sole's height. \param ground  the height under the pose, in the domain, before the stroke
    double soleAt(const StampPose &pose, double ground) const;

    /// \param owner  of this stamp's constraints
    /// \param sole   from soleAt()
    void stamp(TinEdit &edit, const StampPose &pose, double sole, OwnerId owner, ToolMemory &memory);

    const ImprintReport &report() const { return mReport; }

private:
    /// A ring of constrained edges: the vertices along it.
    struct Ring
    {
        std::vector<VertexId> vertices;
        bool isClosed = true; ///< false if a void stopped one of its edges
    };
    struct Placed
    {
        Point2 centre;
        std::vector<Point2> outline;
    };

    explicit ImprintStroke(const Imprint &tool, std::vector<Point2> sole)
        : mTool(tool)
        , mSoleOutline(std::move(sole))
        , mReach(tool.outline.reach() * tool.radius)
    {}

    std::vector<Point2> place(std::span<const Point2> outline, const StampPose &pose) const;
    VertexId putVertex(TinEdit &edit, Point2 p, VertexId near, double nearEnough) const;
    double snap() const;
    void follow(TinEdit &edit, VertexId a, VertexId b, int halvings, std::vector<VertexId> &chain) const;
    Ring constrain(TinEdit &edit, std::vector<VertexId> corners, OwnerId owner, Crossing crossing) const;
    void collectInside(const TinArrays &tin, const Ring &ring, OwnerId owner, std::span<const Point2> outline,
                       Point2 centre);
    void releaseOlder(TinEdit &edit);
    void clearSole(TinEdit &edit, const Ring &ring, std::span<const VertexId> inside, double sole);
    void dropFlatEdges(TinEdit &edit, const Ring &outer, const Ring &inner, double sole, OwnerId owner);
    void thinOut(TinEdit &edit, std::span<const VertexId> vertices, OwnerId owner) const;
    double aheadWeight(const StampPose &pose, Point2 outwards) const;
    bool isInEarlierStamp(Point2 p) const;
    void heap(TinEdit &edit, const StampPose &pose, std::span<const Point2> outline, OwnerId owner, double dug,
              double leak, ToolMemory &memory);
    void levelOut(TinEdit &edit, const StampPose &pose, std::span<const Point2> outline, OwnerId owner, double volume,
                  ToolMemory &memory);

    Imprint mTool;
    std::vector<Point2> mSoleOutline; ///< the outline inset by the gap, in radii
    double mReach = 0;
    ImprintReport mReport;
    std::vector<Placed> mEarlier; ///< the stamps of this stroke that a rim may reach
    // Of the stamp at work.
    std::vector<TriangleId> mTriangles;
    std::vector<VertexId> mInside, mLookedAt;
    std::vector<std::uint32_t> mOlder; ///< records
    std::vector<std::pair<VertexId, VertexId>> mFlat;
    std::vector<const Placed *> mNearEarlier;
    std::vector<VertexId> mRim;
    std::vector<double> mWeights;
    double mRimWidth = 0;
    SlotMarks mTriangleMarks, mVertexMarks;
};

} // namespace model::terrain
