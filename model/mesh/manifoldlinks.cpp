// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/manifoldlinks.h"

#include "model/base/parallel.h"
#include "model/mesh/edgesides.h"

#include <atomic>
#include <bit>

namespace model {

namespace {

/// The corners of each vertex as lists: in how many parts the triangles are taken, each by a thread with lists of its
/// own. More would cost memory for lists that are empty.
constexpr std::size_t Parts = 2;

struct CornerLists
{
    std::array<std::vector<Corner>, Parts> first; ///< #V
    std::vector<Corner> next;                     ///< #C
};

/// \returns nothing if a triangle has a repeated index
std::optional<CornerLists> cornerLists(const Connectivity &connectivity)
{
    CornerLists lists;
    lists.next.resize(3 * connectivity.triangles.size());
    std::atomic<bool> isClean = true;
    parallelFor(Parts, [&](std::size_t part) {
        std::vector<Corner> &first = lists.first[part];
        first.assign(connectivity.vertexCount, NoCorner);
        const std::size_t begin = connectivity.triangles.size() * part / Parts;
        const std::size_t end = connectivity.triangles.size() * (part + 1) / Parts;
        Corner corner = Corner(3 * begin);
        for (std::size_t t = begin; t < end; ++t) {
            const Triangle &triangle = connectivity.triangles[t];
            if (isDegenerate(triangle))
                isClean = false;
            for (unsigned i = 0; i < 3; ++i, ++corner) {
                lists.next[corner] = first[triangle[i]];
                first[triangle[i]] = corner;
            }
        }
    });
    return isClean ? std::optional(std::move(lists)) : std::nullopt;
}

/// The triangles at one vertex, no more than fit a mask: which of them follows which.
class Star
{
public:
    static constexpr std::size_t Most = 32; ///< triangles at a vertex

    /// \returns false if there are too many
    bool gather(const Connectivity &connectivity, const CornerLists &lists, std::size_t vertex)
    {
        mCount = 0;
        for (const std::vector<Corner> &first : lists.first)
            for (Corner c = first[vertex]; c != NoCorner; c = lists.next[c]) {
                if (mCount == Most)
                    return false;
                const Triangle &t = connectivity.triangles[c / 3];
                const unsigned at = c % 3, next = at == 2 ? 0 : at + 1, previous = at == 0 ? 2 : at - 1;
                mNextCorner[mCount] = c - at + next;
                mPreviousCorner[mCount] = c - at + previous;
                mNext[mCount] = t[next];
                mPrevious[mCount] = t[previous];
                ++mCount;
            }
        return true;
    }

    /// Links the edges that start at the vertex. \returns false if two triangles have one of them
    bool link(std::vector<Corner> &opposites)
    {
        std::uint32_t unlinked = 0, twice = 0;
        mReached = 0;
        for (std::uint32_t i = 0; i < mCount; ++i) {
            const std::uint32_t found = places(mPrevious, mNext[i]);
            twice |= found & mReached;
            mReached |= found;
            unlinked |= found ? 0 : Bits[i];
            mAcross[i] = found ? std::uint32_t(std::countr_zero(found)) : Most;
            opposites[mPreviousCorner[i]] = found ? mNextCorner[mAcross[i]] : NoCorner;
        }
        for (; unlinked & (unlinked - 1); unlinked &= unlinked - 1) // two at least
            twice |= places(mNext, mNext[std::uint32_t(std::countr_zero(unlinked))]) & (unlinked & (unlinked - 1));
        return twice == 0;
    }

    /// Whether the triangles, linked, are one fan or ring.
    bool isOneFan() const
    {
        if (mCount == 0)
            return true;
        const std::uint32_t first = ~mReached & (Bits[mCount - 1] | (Bits[mCount - 1] - 1));
        if (first & (first - 1))
            return false;
        const std::uint32_t begin = first ? std::uint32_t(std::countr_zero(first)) : 0;
        std::uint32_t length = 1;
        for (std::uint32_t i = mAcross[begin]; i != Most && i != begin; i = mAcross[i])
            ++length;
        return length == mCount;
    }

private:
    using Row = std::array<std::uint32_t, Most>;
    static constexpr Row Bits = [] {
        Row bits{};
        for (std::uint32_t i = 0; i < Most; ++i)
            bits[i] = std::uint32_t(1) << i;
        return bits;
    }();

    /// A bit for each place of `value`.
    std::uint32_t places(const Row &row, std::uint32_t value) const
    {
        // In eights, for the sake of vector instructions; what lies behind the end is masked out.
        std::uint32_t found = 0;
        for (std::uint32_t begin = 0; begin < mCount; begin += 8)
            for (std::uint32_t i = begin; i < begin + 8; ++i)
                found |= row[i] == value ? Bits[i] : 0;
        return found & (Bits[mCount - 1] | (Bits[mCount - 1] - 1));
    }

    std::uint32_t mCount = 0;
    std::uint32_t mReached = 0;
    Row mNextCorner{}, mPreviousCorner{};
    Row mNext{}, mPrevious{}; ///< vertices
    Row mAcross{};            ///< which triangle has the edge to mNext too; Most if none
};

} // namespace

std::optional<ManifoldLinks> manifoldLinks(const Connectivity &connectivity)
{
    const std::optional<CornerLists> lists = cornerLists(connectivity);
    if (!lists)
        return {};
    ManifoldLinks links;
    links.opposites.resize(lists->next.size());
    std::atomic<bool> isClean = true, hasManyFans = false;
    constexpr std::size_t Grain = 1 << 14; // vertices
    parallelRanges(connectivity.vertexCount, Grain, [&](std::size_t begin, std::size_t end) {
        Star star;
        for (std::size_t v = begin; v < end && isClean; ++v) {
            // Each corner is written once: the edge opposite to it starts at one vertex.
            if (!star.gather(connectivity, *lists, v) || !star.link(links.opposites))
                isClean = false;
            else if (!star.isOneFan())
                hasManyFans = true;
        }
    });
    if (!isClean)
        return {};
    links.hasManyFans = hasManyFans;
    return links;
}

} // namespace model
