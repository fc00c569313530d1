// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/framepair.h"

#include <optional>

namespace model {

namespace {

std::optional<Error> errorOfPermutation(std::span<const std::uint32_t> permutation, std::uint32_t vertexCount)
{
    const auto bad = [](std::string what) {
        return Error{ErrorCode::BadPermutation, {std::move(what)}, {}, Error::None, Error::None};
    };
    if (permutation.size() != vertexCount)
        return bad(std::to_string(permutation.size()) + " entries for " + std::to_string(vertexCount) + " vertices");
    std::vector<bool> seen(vertexCount);
    for (const std::uint32_t vertex : permutation) {
        if (vertex >= vertexCount)
            return bad("vertex " + std::to_string(vertex) + " of " + std::to_string(vertexCount));
        if (seen[vertex])
            return bad("vertex " + std::to_string(vertex) + " twice");
        seen[vertex] = true;
    }
    return {};
}

} // namespace

FramePair::FramePair(const FrameSource &reference, const FrameSource &test, std::span<const std::uint32_t> permutation)
    : mReference(&reference)
    , mTest(&test)
    , mPermutation(permutation.begin(), permutation.end())
{}

Result<FramePair> FramePair::of(const FrameSource &reference, const FrameSource &test,
                                std::span<const std::uint32_t> permutation)
{
    const std::uint32_t vertexCount = reference.vertexCount(), frameCount = reference.frameCount();
    if (test.vertexCount() != vertexCount)
        return fail(ErrorCode::MeshesDiffer, "vertices", std::to_string(vertexCount),
                    std::to_string(test.vertexCount()));
    if (test.frameCount() != frameCount)
        return fail(ErrorCode::MeshesDiffer, "frames", std::to_string(frameCount), std::to_string(test.frameCount()));
    if (!permutation.empty())
        if (std::optional<Error> error = errorOfPermutation(permutation, vertexCount))
            return fail(std::move(*error));
    return FramePair(reference, test, permutation);
}

void FramePair::testPositions(std::uint32_t index, std::span<Vec3f> out) const
{
    if (mPermutation.empty()) {
        mTest->positions(index, out);
        return;
    }
    const std::vector<Vec3f> own = mTest->frame(index);
    for (std::size_t i = 0; i < own.size(); ++i)
        out[mPermutation[i]] = own[i];
}

FramePair::Frame FramePair::frame(std::uint32_t index) const
{
    Frame result{mReference->frame(index), std::vector<Vec3f>(vertexCount())};
    testPositions(index, result.test);
    return result;
}

std::vector<Triangle> FramePair::testTriangles() const
{
    std::vector<Triangle> triangles = mTest->connectivity().triangles;
    if (!mPermutation.empty())
        for (Triangle &triangle : triangles)
            for (std::uint32_t &vertex : triangle)
                vertex = mPermutation[vertex];
    return triangles;
}

} // namespace model
