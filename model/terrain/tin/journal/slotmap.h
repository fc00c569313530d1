// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

namespace model::terrain {

/// A value for some slots of an array, kept in pages of neighbours. It never moves what it holds, so that no insertion
/// takes longer than one page: a hash table of some hundred thousand values stops for a frame when it grows.
template <class T>
class SlotMap
{
    static_assert(std::is_trivially_copyable_v<T>);

public:
    bool isEmpty() const { return mPages.empty(); }
    /// Null if there is none.
    const T *find(std::uint32_t slot) const
    {
        const std::size_t p = slot / PageSize;
        const Page *const page = p < mPages.size() ? mPages[p].get() : nullptr;
        return page && page->isThere[slot % PageSize] ? &page->values[slot % PageSize] : nullptr;
    }
    /// Unless the slot has a value already.
    void emplace(std::uint32_t slot, const T &value)
    {
        if (Page &page = pageOf(slot); !page.isThere[slot % PageSize])
            page.set(slot % PageSize, value);
    }
    void set(std::uint32_t slot, const T &value) { pageOf(slot).set(slot % PageSize, value); }

private:
    static constexpr std::size_t PageSize = 256;
    struct Page
    {
        std::bitset<PageSize> isThere;
        std::array<T, PageSize> values;

        void set(std::size_t i, const T &value)
        {
            isThere[i] = true;
            values[i] = value;
        }
    };
    Page &pageOf(std::uint32_t slot)
    {
        const std::size_t p = slot / PageSize;
        if (p >= mPages.size())
            mPages.resize(p + 1);
        if (!mPages[p])
            mPages[p].reset(new Page); // values are not initialised
        return *mPages[p];
    }

    std::vector<std::unique_ptr<Page>> mPages;
};

} // namespace model::terrain
