// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/journal/journal.h"

namespace model::terrain {

/// Makes one edit of several that follow each other: what a slide of an hour keeps is then bounded by the slots that it
/// wrote, and not by the number of its frames. Undo and redo of the one are those of all, to the byte.
class EditJoiner
{
public:
    /// Joins others to `first`, which is done. Cost: that of the edit.
    explicit EditJoiner(const Edit &first);

    /// Joins `next` to `edit`, the one that the joiner was made for. False, and nothing is done, if they cannot be one:
    /// one of them changes the number or the kind of layers.
    /// Precondition: both are done, `next` directly after `edit`. Cost: that of `next`.
    bool join(Edit &edit, const Edit &next);

private:
    SlotMarks mPoints, mHeights, mColumns, mLinks, mTriangles, mRecords; ///< slots that the edit has saved
};

} // namespace model::terrain
