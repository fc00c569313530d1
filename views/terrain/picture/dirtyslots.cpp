// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/picture/dirtyslots.h"

#include <algorithm>

namespace views {

std::vector<model::terrain::SlotRange> DirtySlots::take(std::uint32_t limit, std::uint32_t gap)
{
    std::sort(mSlots.begin(), mSlots.end());
    std::vector<model::terrain::SlotRange> ranges;
    for (const std::uint32_t slot : mSlots) {
        mMarks.clear(slot);
        if (slot >= limit)
            continue;
        if (ranges.empty() || slot > ranges.back().first + ranges.back().count + gap)
            ranges.push_back({slot, 1});
        else
            ranges.back().count = slot - ranges.back().first + 1;
    }
    mSlots.clear();
    return ranges;
}

} // namespace views
