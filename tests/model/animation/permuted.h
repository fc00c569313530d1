// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/sequence.h"

#include <memory>
#include <numeric>
#include <random>
#include <vector>

namespace tests {

using Permutation = std::vector<std::uint32_t>;

inline Permutation shuffled(std::uint32_t count, std::uint32_t seed)
{
    Permutation permutation(count);
    std::iota(permutation.begin(), permutation.end(), 0u);
    std::mt19937 random(seed);
    for (std::uint32_t i = count; i > 1; --i)
        std::swap(permutation[i - 1], permutation[random() % i]);
    return permutation;
}

/// Vertex i of the result is vertex permutation[i] of the sequence; its triangles come in reverse order.
inline std::shared_ptr<model::Sequence> permuted(const model::Sequence &sequence, const Permutation &permutation)
{
    std::vector<model::Vec3f> positions;
    for (std::uint32_t frame = 0; frame < sequence.frameCount(); ++frame)
        for (const std::uint32_t vertex : permutation)
            positions.push_back(sequence.frameView(frame)[vertex]);
    Permutation inverse(permutation.size());
    for (std::uint32_t i = 0; i < permutation.size(); ++i)
        inverse[permutation[i]] = i;
    const std::vector<model::Triangle> &triangles = sequence.connectivity().triangles;
    model::Connectivity connectivity{sequence.vertexCount(), {triangles.rbegin(), triangles.rend()}};
    for (model::Triangle &triangle : connectivity.triangles)
        triangle = {inverse[triangle[1]], inverse[triangle[2]], inverse[triangle[0]]};
    return std::make_shared<model::Sequence>(std::move(connectivity), std::move(positions));
}

/// The same animation with every coordinate moved at random by up to `reach`.
inline std::shared_ptr<model::Sequence> shaken(const model::Sequence &sequence, float reach, std::uint32_t seed = 7)
{
    std::vector<model::Vec3f> positions(sequence.allPositions().begin(), sequence.allPositions().end());
    std::mt19937 random(seed);
    const auto number = [&] { return (float(random() % 2001) / 1000 - 1) * reach; };
    for (model::Vec3f &p : positions)
        p = p + model::Vec3f{number(), number(), number()};
    return std::make_shared<model::Sequence>(sequence.connectivity(), std::move(positions));
}

inline bool isNear(double a, double b, double tolerance = 1e-11)
{
    return std::abs(a - b) <= tolerance * std::max({1.0, std::abs(a), std::abs(b)});
}

} // namespace tests
