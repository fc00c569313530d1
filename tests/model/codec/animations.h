// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/framesource.h"
#include "model/base/error.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tests {

/// An animation given by its positions, apart from the product's own Sequence.
class PlainAnimation final : public model::FrameSource
{
public:
    PlainAnimation(std::uint32_t frames, std::uint32_t vertices, std::vector<model::Triangle> triangles,
                   const std::function<model::Vec3f(std::uint32_t, std::uint32_t)> &position);

    std::uint32_t frameCount() const override { return std::uint32_t(mFrames.size()); }
    const model::Connectivity &connectivity() const override { return mConnectivity; }
    void positions(std::uint32_t frame, std::span<model::Vec3f> out) const override;
    double frameRate() const override { return rate; }
    const std::string &name() const override { return title; }
    std::uint64_t digest() const override { return 0; }
    std::size_t memoryBytes() const override { return 0; }

    std::vector<std::vector<model::Vec3f>> &frames() { return mFrames; }

    double rate = 24;
    std::string title = "plain";

private:
    model::Connectivity mConnectivity;
    std::vector<std::vector<model::Vec3f>> mFrames;
};

/// A strip of triangles over `vertices` vertices.
std::vector<model::Triangle> strip(std::uint32_t vertices);

/// A soft sheet whose bending, swaying and turning has about `modes` + 3 independent motions; the same every time.
PlainAnimation waves(std::uint32_t frames, std::uint32_t vertices, unsigned modes);

/// Strips of triangles of `vertices` each that move each in its own way; the same every time.
PlainAnimation flock(std::uint32_t frames, std::uint32_t bodies, std::uint32_t vertices);

struct NamedAnimation
{
    std::string name;
    std::shared_ptr<PlainAnimation> animation;
};
/// The shapes that every codec must take: see the names.
std::vector<NamedAnimation> animationTable();

/// One of the real sequences that come as a point cache (PC2) with a base OBJ. \param folder  ends in its name
std::shared_ptr<PlainAnimation> readPointCache(const std::string &folder);

/// Moved and scaled to fit the cube -1 ... 1.
PlainAnimation normalised(const PlainAnimation &animation);

/// The animation with its vertices in another order, without triangles: vertex v is what vertex permutation[v] was.
PlainAnimation reordered(const PlainAnimation &animation, const std::vector<std::uint32_t> &permutation);

/// 100 * |v - w| / |v - mean of the frame|, Frobenius, in plain double.
double kgErrorPercent(const model::FrameSource &reference, const model::FrameSource &test);
/// The largest difference of a coordinate.
double largestError(const model::FrameSource &reference, const model::FrameSource &test);

} // namespace tests
