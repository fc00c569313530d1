// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace model::terrain {

/// One bit for each slot of an array, for those who visit a few of many: whoever set bits clears them again.
class SlotMarks
{
public:
    void resize(std::size_t count)
    {
        if (mWords.size() < (count + 63) / 64)
            mWords.resize((count + 63) / 64);
    }
    bool isSet(std::size_t i) const { return mWords[i >> 6] >> (i & 63) & 1; }
    /// Sets a bit; true if it was clear.
    bool set(std::size_t i)
    {
        const std::uint64_t bit = std::uint64_t(1) << (i & 63);
        const bool isNew = !(mWords[i >> 6] & bit);
        mWords[i >> 6] |= bit;
        return isNew;
    }
    /// Clears a bit and, being meant for clearing all that were set, its neighbours.
    void clear(std::size_t i) { mWords[i >> 6] = 0; }
    /// Ascending.
    template <class Visit>
    void forEachSet(Visit visit) const
    {
        for (std::size_t w = 0; w < mWords.size(); ++w)
            for (std::uint64_t word = mWords[w]; word; word &= word - 1)
                visit(64 * w + std::size_t(std::countr_zero(word)));
    }
    std::size_t byteSize() const { return mWords.size() * sizeof(std::uint64_t); }

private:
    std::vector<std::uint64_t> mWords;
};

} // namespace model::terrain
