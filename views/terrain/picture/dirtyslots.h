// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/journal.h"
#include "model/terrain/tin/slotmarks.h"

#include <vector>

namespace views {

/// Slots that wait to be uploaded, each once.
class DirtySlots
{
public:
    void add(std::uint32_t slot)
    {
        mMarks.resize(std::size_t(slot) + 1);
        if (mMarks.set(slot))
            mSlots.push_back(slot);
    }
    std::size_t count() const { return mSlots.size(); }
    const std::vector<std::uint32_t> &all() const { return mSlots; }

    /// The slots below `limit`, ascending, as ranges; ranges with no more than `gap` clean slots between them become
    /// one: a call costs more than a few bytes. Empties this.
    std::vector<model::terrain::SlotRange> take(std::uint32_t limit, std::uint32_t gap);

private:
    std::vector<std::uint32_t> mSlots;
    model::terrain::SlotMarks mMarks;
};

} // namespace views
