// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/vertexmotion.h"

#include "model/geometry/vec3d.h"

#include <cmath>

namespace model {

Result<std::vector<float>> trajectoryLengths(const FrameSource &source, const Progress &progress)
{
    std::vector<double> lengths(source.vertexCount());
    std::vector<Vec3f> before(source.vertexCount()), now(source.vertexCount());
    for (std::uint32_t frame = 0; frame < source.frameCount(); ++frame) {
        if (progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        source.positions(frame, now);
        if (frame > 0)
            for (std::size_t v = 0; v < lengths.size(); ++v)
                lengths[v] += distance(now[v], before[v]);
        now.swap(before);
        progress.report(double(frame + 1) / source.frameCount());
    }
    return std::vector<float>(lengths.begin(), lengths.end());
}

Result<std::vector<float>> vertexErrors(const FramePair &pair, const Progress &progress)
{
    std::vector<double> sums(pair.vertexCount());
    for (std::uint32_t frame = 0; frame < pair.frameCount(); ++frame) {
        if (progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        const FramePair::Frame both = pair.frame(frame);
        for (std::size_t v = 0; v < sums.size(); ++v)
            sums[v] += squaredDistance(both.reference[v], both.test[v]);
        progress.report(double(frame + 1) / pair.frameCount());
    }
    std::vector<float> errors;
    for (const double sum : sums)
        errors.push_back(float(std::sqrt(sum / pair.frameCount())));
    return errors;
}

} // namespace model
