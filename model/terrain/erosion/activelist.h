// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/ids.h"

#include <cstddef>
#include <vector>

namespace model::terrain {

/// A triangle that may slide, and whether it does already (hysteresis).
struct ActiveTriangle
{
    TriangleId triangle;
    bool isMoving;
};

/// Triangles that wait for their turn, each of them once, in the order in which they came.
class ActiveList
{
public:
    /// Appends `t`, unless it waits already: then it moves if either says so.
    void add(ActiveTriangle active)
    {
        const TriangleId t = active.triangle;
        if (mIsListed.size() <= t) {
            mIsListed.resize(std::size_t(t) + 1);
            mIsMoving.resize(std::size_t(t) + 1);
        }
        mIsMoving[t] = mIsMoving[t] || active.isMoving;
        if (mIsListed[t])
            return;
        mIsListed[t] = true;
        mTriangles.push_back(t);
    }
    /// Takes the first `count` off the list. Precondition: there are as many.
    std::vector<ActiveTriangle> take(std::size_t count)
    {
        std::vector<ActiveTriangle> taken;
        taken.reserve(count);
        for (const std::size_t end = mFirst + count; mFirst < end; ++mFirst) {
            const TriangleId t = mTriangles[mFirst];
            taken.push_back({t, mIsMoving[t]});
            mIsListed[t] = mIsMoving[t] = false;
        }
        if (2 * mFirst >= mTriangles.size()) {
            mTriangles.erase(mTriangles.begin(), mTriangles.begin() + std::ptrdiff_t(mFirst));
            mFirst = 0;
        }
        return taken;
    }
    void clear() { take(size()); }
    std::size_t size() const { return mTriangles.size() - mFirst; }
    bool isEmpty() const { return size() == 0; }
    /// Those that wait.
    std::vector<TriangleId> triangles() const
    {
        return {mTriangles.begin() + std::ptrdiff_t(mFirst), mTriangles.end()};
    }

private:
    std::vector<TriangleId> mTriangles;
    std::size_t mFirst = 0; ///< those before it are taken
    std::vector<bool> mIsListed, mIsMoving;
};

} // namespace model::terrain
