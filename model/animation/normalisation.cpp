// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/normalisation.h"

#include "model/base/parallel.h"

#include <algorithm>
#include <atomic>

namespace model {

namespace {

Similarity fittingCube(const Box3f &box)
{
    if (box.isEmpty())
        return {};
    // In double: a box of the largest floats has a side that no float holds.
    const double min[] = {box.min.x, box.min.y, box.min.z};
    const double max[] = {box.max.x, box.max.y, box.max.z};
    double side = 0;
    for (int axis = 0; axis < 3; ++axis)
        side = std::max(side, max[axis] - min[axis]);
    Similarity result;
    result.scale = side > 0 ? 2 / side : 1;
    for (int axis = 0; axis < 3; ++axis)
        result.offset[axis] = -result.scale * ((min[axis] + max[axis]) / 2);
    return result;
}

} // namespace

Box3f boundingBoxOf(const FrameSource &source, std::uint32_t frame)
{
    return boundingBox(source.frame(frame));
}

Result<Box3f> boundingBoxOfAll(const FrameSource &source, const Progress &progress)
{
    const std::size_t frameCount = source.frameCount();
    std::vector<Box3f> boxes(frameCount);
    std::atomic<std::size_t> done = 0;
    parallelFor(frameCount, [&](std::size_t frame) {
        if (progress.isCancelled())
            return;
        boxes[frame] = boundingBoxOf(source, std::uint32_t(frame));
        progress.report(double(++done) / double(frameCount));
    });
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    Box3f all;
    for (const Box3f &box : boxes)
        all.add(box);
    return all;
}

Result<Similarity> normalisingSimilarity(const FrameSource &source, Normalisation mode, const Progress &progress)
{
    switch (mode) {
    case Normalisation::None:
        return Similarity{};
    case Normalisation::FirstFrame:
        return fittingCube(boundingBoxOf(source, 0));
    case Normalisation::AllFrames:
        break;
    }
    return boundingBoxOfAll(source, progress).map(fittingCube);
}

Result<Similarity> normalisingPlacement(const EditedFrames &frames, Normalisation mode, const Progress &progress)
{
    const EditedFrames unplaced(frames.source(), frames.timeMap(), {}, frames.frameRate(), frames.name());
    return normalisingSimilarity(unplaced, mode, progress);
}

} // namespace model
