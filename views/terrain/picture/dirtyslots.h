// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/journal/journal.h"

#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

namespace views {

/// Slots that wait to be uploaded, each once: a bit for each.
class DirtySlots
{
public:
    void add(std::uint32_t slot)
    {
        const std::size_t word = slot / 64;
        if (word >= mWords.size())
            mWords.resize(word + 1);
        const std::uint64_t bit = std::uint64_t(1) << (slot % 64);
        mCount += (mWords[word] & bit) == 0;
        mWords[word] |= bit;
    }
    std::size_t count() const { return mCount; }
    void clear();

    /// Calls `visit` for each slot, ascending.
    template <class Visit>
    void forEach(Visit visit) const
    {
        for (std::size_t word = 0; word < mWords.size() && mCount > 0; ++word)
            for (std::uint64_t bits = mWords[word]; bits != 0; bits &= bits - 1)
                visit(std::uint32_t(word * 64 + std::size_t(std::countr_zero(bits))));
    }

    /// Takes slots out, `most` or some 60 more: those after the ones taken last, so that none waits for ever. \returns
    /// those below `limit`, as ranges; ranges with no more than `gap` clean slots between them become one: a call costs
    /// more than a few bytes
    std::vector<model::terrain::SlotRange> take(std::uint32_t limit, std::uint32_t gap,
                                                std::size_t most = std::numeric_limits<std::size_t>::max());

private:
    std::vector<std::uint64_t> mWords;
    std::size_t mCount = 0;
    std::size_t mNext = 0; ///< word to go on with
};

} // namespace views
