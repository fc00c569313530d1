// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/framesource.h"
#include "model/base/error.h"

#include <span>
#include <vector>

namespace model {

/// Two animations of the same vertices, seen in one order of vertices: that of the first. Refers to both.
class FramePair
{
public:
    /// \param permutation  for each vertex of `test` the vertex of `reference` that it is; empty: the same order
    /// \error MeshesDiffer    frame or vertex counts differ
    /// \error BadPermutation  not a permutation of the vertices
    static Result<FramePair> of(const FrameSource &reference, const FrameSource &test,
                                std::span<const std::uint32_t> permutation = {});

    std::uint32_t frameCount() const { return mReference->frameCount(); }
    std::uint32_t vertexCount() const { return mReference->vertexCount(); }
    const FrameSource &reference() const { return *mReference; }

    struct Frame
    {
        std::vector<Vec3f> reference, test; ///< #V each; test[i] is what became of reference[i]
    };
    /// Any thread, several at once.
    Frame frame(std::uint32_t index) const;
    /// Only what became of each vertex. \param out  #V
    void testPositions(std::uint32_t index, std::span<Vec3f> out) const;
    /// Triangles of the test animation, in indices of the reference.
    std::vector<Triangle> testTriangles() const;

private:
    FramePair(const FrameSource &reference, const FrameSource &test, std::span<const std::uint32_t> permutation);

    const FrameSource *mReference;
    const FrameSource *mTest;
    std::vector<std::uint32_t> mPermutation;
};

} // namespace model
