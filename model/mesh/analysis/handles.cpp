// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: J. Erickson, K. Whittlesey: Greedy Optimal Homotopy and Homology Generators, 2005 (a shortest basis is
// found greedily: the shortest loop that is independent of those before; independence is told by the edges of a
// cotree's cycles that a loop crosses) Differs: roots are some vertices, not all; the loops of the basis are matched
// into pairs that cross.
#include "model/mesh/analysis/handles.h"

#include "model/base/parallel.h"
#include "model/mesh/analysis/homologysignature.h"
#include "model/mesh/analysis/matching.h"

#include <algorithm>
#include <memory>

namespace model {

namespace {

/// Half-edges that all roots of a component may look at together: bounds the time, to about a second a core.
constexpr std::uint64_t WorkLimit = 16'000'000;
/// Roots for each loop of the basis: one where a first loop was found, one where a better one was found.
constexpr std::size_t Rounds = 2;

class HandleFinder
{
public:
    HandleFinder(const ClosedSurface &surface, const Progress &progress)
        : mGraph(surface)
        , mProgress(progress)
        , mFirst(mGraph, 0, progress)
    {}

    std::vector<std::array<EdgeLoop, 2>> find()
    {
        if (mProgress.isCancelled())
            return {};
        mSignatures = std::make_unique<HomologySignature>(mGraph.surface, mFirst);
        mLoops = mFirst.loops();
        chooseBasis();
        const std::size_t rootLimit = std::size_t(WorkLimit / mGraph.surface.halfEdgeCount());
        for (std::size_t round = 0; round < Rounds; ++round) {
            addLoops(rootLimit / Rounds);
            if (mProgress.isCancelled())
                return {};
            chooseBasis();
            mProgress.report(0.2 + 0.8 * double(round + 1) / double(Rounds));
        }
        return pairs();
    }

private:
    /// Loops from vertices of the basis's loops, opposite to where each was looked for before.
    void addLoops(std::size_t limit)
    {
        std::vector<std::uint32_t> roots;
        const std::size_t count = std::min(limit, mLoops.size());
        for (std::size_t i = 0; i < count; ++i) {
            const EdgeLoop &loop = mLoops[i * mLoops.size() / count];
            roots.push_back(loop.vertices[loop.vertices.size() / 2]);
        }
        std::sort(roots.begin(), roots.end());
        roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
        std::vector<std::vector<EdgeLoop>> found(roots.size());
        parallelFor(roots.size(), [&](std::size_t i) {
            if (mProgress.isCancelled())
                return;
            const TreeCotree tree(mGraph, roots[i], mProgress);
            if (!mProgress.isCancelled())
                found[i] = tree.loops();
        });
        for (std::vector<EdgeLoop> &loops : found)
            std::move(loops.begin(), loops.end(), std::back_inserter(mLoops));
    }

    /// Keeps of all loops the shortest ones that are independent.
    void chooseBasis()
    {
        std::stable_sort(mLoops.begin(), mLoops.end(),
                         [](const EdgeLoop &a, const EdgeLoop &b) { return a.length < b.length; });
        BitBasis basis(mFirst.leftover().size());
        std::vector<EdgeLoop> chosen;
        mBits.clear();
        for (EdgeLoop &loop : mLoops) {
            Bits bits = mSignatures->of(loop);
            if (!basis.add(bits))
                continue;
            mBits.push_back(std::move(bits));
            chosen.push_back(std::move(loop));
            if (chosen.size() == mFirst.leftover().size())
                break;
        }
        mLoops = std::move(chosen);
    }

    /// Loops of the basis that cross an odd number of times, in pairs. That the basis can be matched so follows from
    /// the determinant of the intersection form, which is 1: its Pfaffian, a sum over all matchings, is odd.
    std::vector<std::array<EdgeLoop, 2>> pairs()
    {
        std::vector<std::vector<std::uint32_t>> crossing(mLoops.size());
        for (std::uint32_t i = 0; i < mLoops.size(); ++i) {
            const Bits dual = mSignatures->dual(mBits[i]);
            for (std::uint32_t j = 0; j < mLoops.size(); ++j)
                if (isOddProduct(dual, mBits[j]))
                    crossing[i].push_back(j);
        }
        const std::vector<std::uint32_t> partner = maximumMatching(crossing);
        std::vector<std::array<EdgeLoop, 2>> result;
        for (std::uint32_t i = 0; i < mLoops.size(); ++i)
            if (partner[i] != NoPartner && i < partner[i])
                result.push_back({std::move(mLoops[i]), std::move(mLoops[partner[i]])});
        return result;
    }

    const TreeCotree::Graph mGraph;
    const Progress &mProgress;
    const TreeCotree mFirst;
    std::unique_ptr<const HomologySignature> mSignatures;
    std::vector<EdgeLoop> mLoops; ///< the basis so far, shortest first
    std::vector<Bits> mBits;      ///< their signatures
};

} // namespace

Result<std::vector<HandleReport>> findHandles(const Faces &faces, std::span<const Vec3f> positions,
                                              const MeshReport &report, const Progress &progress)
{
    std::vector<std::uint32_t> components;
    double work = 0, done = 0;
    for (std::uint32_t c = 0; c < report.components.size(); ++c)
        if (const ComponentReport &component = report.components[c]; component.isOrientable && component.genus > 0u) {
            components.push_back(c);
            work += component.edges;
        }
    std::vector<HandleReport> handles;
    if (components.empty())
        return handles;
    const FaceLinks links(faces);
    const MeshParts parts = findParts(links);
    SurfaceCutter cutter(links, parts);
    for (const std::uint32_t c : components) {
        if (progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        const ClosedSurface surface = cutter.cut(c, positions);
        const double share = report.components[c].edges;
        const Progress part = progress.part(done / work, (done + share) / work);
        done += share;
        for (auto &pair : HandleFinder(surface, part).find()) {
            HandleReport handle{c, {}};
            for (std::size_t i = 0; i < 2; ++i) {
                handle.loops[i].length = pair[i].length;
                for (const std::uint32_t vertex : pair[i].vertices)
                    handle.loops[i].vertices.push_back(surface.inputVertex[vertex]);
            }
            handles.push_back(std::move(handle));
        }
    }
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    return handles;
}

} // namespace model
