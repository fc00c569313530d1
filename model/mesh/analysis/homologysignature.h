// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/analysis/treecotree.h"

#include <bit>

namespace model {

using Bits = std::vector<std::uint64_t>;

inline bool isOddProduct(const Bits &a, const Bits &b)
{
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum ^= a[i] & b[i];
    return std::popcount(sum) % 2 == 1;
}

/// Independent vectors over the field of two elements.
class BitBasis
{
public:
    explicit BitBasis(std::size_t dimension)
        : mWithFirst(dimension)
    {}
    /// \returns whether it is independent of those added before
    bool add(Bits bits);

private:
    std::vector<Bits> mWithFirst; ///< for each place the vector whose first bit it is; empty if none
};

/// Which loops are the same up to what bounds a piece of surface, counted modulo 2.
class HomologySignature
{
public:
    /// Keeps references.
    HomologySignature(const ClosedSurface &surface, const TreeCotree &tree);

    /// In the basis tree.loops(): how often the loop crosses the cycle of the cotree through each leftover edge. Zero
    /// if and only if the loop bounds a piece of the surface.
    Bits of(const EdgeLoop &loop) const;
    /// The product of this and another loop's signature is the parity of their crossings.
    Bits dual(const Bits &signature) const;

private:
    void numberFaces();
    void findCrossings();
    Bits zero() const { return Bits(mTree.leftover().size() / 64 + 1); }

    const ClosedSurface &mSurface;
    const TreeCotree &mTree;
    // The cotree, numbered so that a face and what hangs below it are one range.
    std::vector<std::uint32_t> mEnter, mLeave; ///< #F
    /// The numbers of the faces at the leftover edges, ascending, and which leftover edges are among the first i.
    std::vector<std::uint32_t> mEnds;
    std::vector<Bits> mAmongFirst;
    std::vector<Bits> mCrossings; ///< of the loops of the basis with one another
};

} // namespace model
