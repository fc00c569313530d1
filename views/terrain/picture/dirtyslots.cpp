// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/picture/dirtyslots.h"

#include <algorithm>
#include <utility>

namespace views {

void DirtySlots::clear()
{
    std::fill(mWords.begin(), mWords.end(), 0);
    mCount = 0;
}

std::vector<model::terrain::SlotRange> DirtySlots::take(std::uint32_t limit, std::uint32_t gap, std::size_t most)
{
    std::vector<model::terrain::SlotRange> ranges;
    const auto add = [&](std::uint32_t slot) {
        const bool isNear =
            !ranges.empty() && slot >= ranges.back().first && slot <= ranges.back().first + ranges.back().count + gap;
        if (isNear)
            ranges.back().count = slot - ranges.back().first + 1;
        else
            ranges.push_back({slot, 1});
    };
    std::size_t taken = 0;
    for (std::size_t visited = 0; visited < mWords.size() && mCount > 0 && taken < most; ++visited) {
        mNext = mNext < mWords.size() ? mNext : 0;
        std::uint64_t bits = std::exchange(mWords[mNext], 0);
        for (; bits != 0; bits &= bits - 1) {
            const auto slot = std::uint32_t(mNext * 64 + std::size_t(std::countr_zero(bits)));
            if (slot < limit)
                add(slot);
            --mCount;
            ++taken;
        }
        ++mNext;
    }
    if (mCount == 0)
        mNext = 0;
    return ranges;
}

} // namespace views
