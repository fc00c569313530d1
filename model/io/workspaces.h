// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>
#include <vector>

namespace model::io {

/// Scratch memory for parallel work: as many workspaces as threads use at once, each used again and again.
template <class Workspace>
class Workspaces
{
public:
    /// A workspace of one's own until it goes out of scope.
    auto take()
    {
        std::unique_ptr<Workspace> free;
        {
            const std::lock_guard lock(mMutex);
            if (!mFree.empty()) {
                free = std::move(mFree.back());
                mFree.pop_back();
            }
        }
        if (!free)
            free = std::make_unique<Workspace>();
        const auto giveBack = [this](Workspace *workspace) {
            const std::lock_guard lock(mMutex);
            mFree.emplace_back(workspace);
        };
        return std::unique_ptr<Workspace, decltype(giveBack)>(free.release(), giveBack);
    }

private:
    std::mutex mMutex;
    std::vector<std::unique_ptr<Workspace>> mFree;
};

} // namespace model::io
