// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/geometry/vec3d.h"
#include "model/haptics/time.h"

namespace model::haptics {

/// Hides the jump of force when a new snapshot comes.
///
/// At the change the law is asked twice at the same place, with the old ground and the new; what differs is carried on
/// and fades over about one period of snapshots. It is fading still when the next one comes early, and is then part
/// of what differs.
/// Source: force transitions of W. Mark and others, Adding Force Feedback to Graphics Systems, 1996; reference 003,
/// 5.3.7. Differs from both: the time also grows with the difference, so that no step is above LargestRate.
class ForceBlend
{
public:
    /// N/s: 0.05 N in a step, half of what may be felt as a jump.
    static constexpr double LargestRate = 50;
    static constexpr Time ShortestFade = std::chrono::milliseconds(5);
    static constexpr Time LongestFade = std::chrono::milliseconds(250);

    /// \param before, after  what the law says here of the old ground and the new, without this blend's share
    /// \param period         since the snapshot before
    void change(Vec3d before, Vec3d after, Time period);
    /// What to add to the law's force of this step, which is `elapsed` after the one before.
    Vec3d advance(Time elapsed);
    void reset() { *this = {}; }
    /// What is still carried on.
    Vec3d remainder() const { return mDifference * mShare; }

private:
    Vec3d mDifference;
    double mShare = 0; ///< of it, 1 ... 0
    double mPerSecond = 0;
};

} // namespace model::haptics
