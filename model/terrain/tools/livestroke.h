// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/journal/earlier.h"
#include "model/terrain/tools/stroke.h"

#include <deque>
#include <limits>

namespace model::terrain {

/// A stroke while it is drawn: the pen's points come one after another, and each makes the stamps that are due. However
/// many points come at a time, and however many edits the stamps are spread over, the terrain ends as if the whole path
/// had been drawn at once, to the byte: draw() of a Stroke is made of this. Other changes between the stamps (sand that
/// slides) make another terrain, but do not lead the tool astray: its depth goes by the ground as it was before.
///
/// Ramp and Breakline need their whole path: they come when it ends. An imprint or a rake waits for the next stamp's
/// place, which says where it is going.
class LiveStroke
{
public:
    /// \param owner  of the first stamp's constraints; the next ones follow
    /// \error BadSetting, NonFinite, LimitExceeded  as the tool and the symmetry say
    static Result<LiveStroke> begin(const Tin &tin, const Tool &tool, const Symmetry &symmetry, OwnerId owner);

    /// The pen has come to `point`.
    /// \error as PathSampler::add(); the stroke can go on, or end
    Result<void> add(const PathPoint &point);
    /// The pen was lifted.
    void end();
    bool isEnded() const { return mIsEnded; }

    /// Stamps that draw() would make now, copies counted.
    bool isDue() const;
    /// Makes stamps that are due: `most` places of the pen, each with all its copies.
    /// \error CrossingConstraints  a breakline that meets what it may not cross: roll the edit back
    Result<void> draw(TinEdit &edit, ToolMemory &memory, std::size_t most = std::numeric_limits<std::size_t>::max());
    /// An edit was done since the stroke began: with its stamps, or with anything else. To be called for each, in
    /// order, if the stroke is to go on.
    void note(const Edit &edit);

    /// All that was drawn.
    const StrokeReport &report() const { return mReport; }
    const Tool &tool() const { return mTool; }
    const Symmetry &symmetry() const { return mSymmetry; }
    /// The pen's points so far.
    std::span<const PathPoint> path() const { return mPath; }

private:
    struct Copy
    {
        StampPose pose;
        std::uint32_t copy;
        double sole; ///< Imprint
    };

    LiveStroke(const Tin &tin, const Tool &tool, const Symmetry &symmetry, OwnerId owner);
    bool isWhole() const;
    std::size_t readyCount() const;
    std::vector<Copy> copiesOf(const StampPose &pose) const;
    void prepare();
    void stampAt(TinEdit &edit, const std::vector<Copy> &copies, ToolMemory &memory);
    Result<void> drawWhole(TinEdit &edit, ToolMemory &memory);
    Point2 inDomain(Point2 p) const;
    bool isMaskedOut(const Mask &mask, Point2 p) const;

    Tool mTool;
    Symmetry mSymmetry;
    Rectangle mDomain;
    std::vector<PathPoint> mPath;
    std::optional<PathSampler> mSampler;     ///< none for Ramp and Breakline
    std::optional<ImprintStroke> mImprint;   ///< for Imprint
    EarlierSurface mGround;                  ///< before the stroke; noted only where it is asked
    std::vector<double> mLevels;             ///< Flatten: of each copy
    std::deque<std::vector<Copy>> mPrepared; ///< the places that are due, with what the ground before says of them
    std::size_t mPreparedCount = 0;          ///< those drawn included
    OwnerId mOwner;
    bool mIsEnded = false;
    StrokeReport mReport;
};

} // namespace model::terrain
