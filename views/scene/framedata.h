// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/framesource.h"

#include <memory>
#include <vector>

namespace views {

/// What an animation is compared with.
struct Original
{
    model::FrameSourcePtr frames;           ///< as many frames and vertices as the animation
    std::vector<std::uint32_t> permutation; ///< for each vertex of the animation that of the original; empty: the same
};
using OriginalPtr = std::shared_ptr<const Original>;

/// What is drawn for one frame; immutable once made.
struct FrameData
{
    model::FrameSourcePtr source; ///< whose frame it is; its connectivity goes with the positions
    std::uint32_t frame = 0;
    std::vector<model::Vec3f> positions; ///< #V x 3
    std::vector<model::Vec3f> normals;   ///< #V x 3, unit
    OriginalPtr original;                ///< null: not compared
    std::vector<float> errors;           ///< #V, distances from the original's vertices; empty without one
    float largestError = 0;
    double computeMilliseconds = 0; ///< decoding and normals
};
using FrameDataPtr = std::shared_ptr<const FrameData>;

/// Decodes a frame and computes its normals, and its errors if there is an original, into `data`, whose buffers are
/// reused. Any thread. Precondition: frame < source->frameCount().
void makeFrame(const model::FrameSourcePtr &source, std::uint32_t frame, FrameData &data,
               const OriginalPtr &original = nullptr);

} // namespace views
