// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/terrain/recovery.h"
#include "model/terrain/tin/slotmarks.h"

#include <map>

namespace model::io {

/// Edits of a TIN that still have to be written to a RecoveryJournal, put together into one frame: a stroke or an
/// erosion that writes the same vertices again and again takes them once.
class PendingEdits
{
public:
    /// After an edit was done, undone or redone. Cost: that of the edit.
    void add(const terrain::Edit &edit, const terrain::TinArrays &tin);

    bool isEmpty() const { return mVertices.empty() && mRemoved.empty() && mLines.empty() && !mNeedsSnapshot; }
    /// The edits cannot be said as a frame: every vertex has other layers now.
    bool needsSnapshot() const { return mNeedsSnapshot; }
    /// What take() has to write.
    std::size_t vertexCount() const { return mVertices.size(); }

    /// What the edits did, as a RecoveryJournal takes it; forgets them. Cost: O(vertexCount()).
    /// Precondition: !needsSnapshot()
    JournalFrame take(const terrain::TinArrays &tin);
    void clear();

private:
    using Line = terrain::EditChanges::Line;
    struct LineOrder
    {
        bool operator()(const Line &a, const Line &b) const;
    };

    bool addValues(const terrain::Edit &edit, const terrain::TinArrays &tin);

    terrain::SlotMarks mMarks;
    std::vector<terrain::VertexId> mVertices; ///< marked, in the order in which they came
    std::vector<terrain::Point2> mRemoved;
    std::map<Line, bool, LineOrder> mLines; ///< whether it is there now
    bool mNeedsSnapshot = false;
};

} // namespace model::io
