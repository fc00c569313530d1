// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"

#include <atomic>
#include <limits>
#include <mutex>

namespace model::io {

/// Of the errors of parallel work on items 0, 1, 2, ... the one of the first item, however the threads ran: items
/// behind an error are skipped, items before it are not. Thread-safe.
class FirstError
{
public:
    /// An item before `item` has failed: this one need not be done.
    bool isBefore(std::size_t item) const { return mItem.load(std::memory_order_relaxed) < item; }

    void set(std::size_t item, Error error)
    {
        const std::lock_guard lock(mMutex);
        if (item >= mItem.load(std::memory_order_relaxed))
            return;
        mItem.store(item, std::memory_order_relaxed);
        mError = std::move(error);
    }

    /// True if anything failed. Call these two when the work is over.
    explicit operator bool() const { return mItem != None; }
    Error take() { return std::move(mError); }

private:
    static constexpr std::size_t None = std::numeric_limits<std::size_t>::max();

    std::atomic<std::size_t> mItem = None;
    std::mutex mMutex;
    Error mError;
};

} // namespace model::io
