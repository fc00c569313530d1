// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/analysis/homologysignature.h"

#include <algorithm>

namespace model {

namespace {

void flip(Bits &bits, std::size_t i)
{
    bits[i / 64] ^= std::uint64_t(1) << i % 64;
}

void add(Bits &to, const Bits &bits)
{
    for (std::size_t i = 0; i < to.size(); ++i)
        to[i] ^= bits[i];
}

} // namespace

bool BitBasis::add(Bits bits)
{
    for (std::size_t i = 0; i < mWithFirst.size(); ++i) {
        if (!(bits[i / 64] >> i % 64 & 1))
            continue;
        if (mWithFirst[i].empty()) {
            mWithFirst[i] = std::move(bits);
            return true;
        }
        model::add(bits, mWithFirst[i]);
    }
    return false;
}

HomologySignature::HomologySignature(const ClosedSurface &surface, const TreeCotree &tree)
    : mSurface(surface)
    , mTree(tree)
{
    numberFaces();
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends; // number of the face, leftover edge
    for (std::uint32_t i = 0; i < tree.leftover().size(); ++i)
        for (const std::uint32_t h : {tree.leftover()[i], surface.opposite[tree.leftover()[i]]})
            ends.push_back({mEnter[surface.face[h]], i});
    std::sort(ends.begin(), ends.end());
    mAmongFirst.push_back(zero());
    for (const auto &[number, i] : ends) {
        mEnds.push_back(number);
        Bits bits = mAmongFirst.back();
        flip(bits, i);
        mAmongFirst.push_back(std::move(bits));
    }
    findCrossings();
}

void HomologySignature::numberFaces()
{
    // Depth first over the cotree, along the half-edges of each face.
    std::vector<std::uint32_t> halfEdgeOf(mSurface.faceCount);
    for (std::uint32_t h = 0; h < mSurface.halfEdgeCount(); ++h)
        halfEdgeOf[mSurface.face[h]] = h;
    mEnter.resize(mSurface.faceCount);
    mLeave.resize(mSurface.faceCount);
    struct Visit
    {
        std::uint32_t first, at;
        bool hasStarted;
    };
    std::uint32_t number = 0;
    std::vector<Visit> stack{{halfEdgeOf[0], halfEdgeOf[0], false}};
    mEnter[0] = number++;
    while (!stack.empty()) {
        Visit &visit = stack.back();
        if (visit.hasStarted && visit.at == visit.first) {
            mLeave[mSurface.face[visit.first]] = number;
            stack.pop_back();
            continue;
        }
        visit.hasStarted = true;
        const std::uint32_t h = visit.at;
        visit.at = mSurface.next[h];
        // The first half-edge of a face below is that to the face above it.
        const bool isBack = stack.size() > 1 && h == visit.first;
        if (!mTree.isInCotree(h) || isBack)
            continue;
        const std::uint32_t below = mSurface.opposite[h];
        mEnter[mSurface.face[below]] = number++;
        stack.push_back({below, below, false});
    }
}

void HomologySignature::findCrossings()
{
    // The tree, drawn together to a point, is a vertex from which the leftover edges start and at which they end. In
    // the order around it, two loops cross if their ends take turns.
    const std::size_t count = mTree.leftover().size();
    std::vector<std::uint32_t> leftoverAt(mSurface.halfEdgeCount(), ~std::uint32_t(0));
    for (std::uint32_t i = 0; i < count; ++i)
        leftoverAt[mTree.leftover()[i]] = leftoverAt[mSurface.opposite[mTree.leftover()[i]]] = i;
    std::vector<std::uint32_t> order;
    std::uint32_t h = 0;
    do {
        if (leftoverAt[h] != ~std::uint32_t(0))
            order.push_back(leftoverAt[h]);
        h = mSurface.clockwise(mTree.isInTree(h) ? mSurface.opposite[h] : h);
    } while (h != 0);
    // Those met once between the ends of an edge.
    mCrossings.assign(count, zero());
    std::vector<Bits> opened(count); // empty before
    Bits met = zero();
    for (const std::uint32_t i : order) {
        if (opened[i].empty()) {
            flip(met, i);
            opened[i] = met;
        } else {
            mCrossings[i] = opened[i];
            add(mCrossings[i], met);
            flip(met, i);
        }
    }
}

Bits HomologySignature::of(const EdgeLoop &loop) const
{
    Bits bits = zero();
    for (const std::uint32_t h : loop.halfEdges) {
        if (mTree.isInCotree(h)) {
            // The cycles through this edge are those with one end below it.
            const std::uint32_t a = mSurface.face[h], b = mSurface.face[mSurface.opposite[h]];
            const std::uint32_t below = mEnter[a] > mEnter[b] ? a : b;
            const auto place = [&](std::uint32_t number) {
                return std::size_t(std::lower_bound(mEnds.begin(), mEnds.end(), number) - mEnds.begin());
            };
            add(bits, mAmongFirst[place(mEnter[below])]);
            add(bits, mAmongFirst[place(mLeave[below])]);
        } else if (!mTree.isInTree(h)) {
            const auto &leftover = mTree.leftover();
            const std::uint32_t edge = std::min(h, mSurface.opposite[h]);
            flip(bits, std::size_t(std::lower_bound(leftover.begin(), leftover.end(), edge) - leftover.begin()));
        }
    }
    return bits;
}

Bits HomologySignature::dual(const Bits &signature) const
{
    Bits bits = zero();
    for (std::size_t i = 0; i < mCrossings.size(); ++i)
        if (signature[i / 64] >> i % 64 & 1)
            add(bits, mCrossings[i]);
    return bits;
}

} // namespace model
