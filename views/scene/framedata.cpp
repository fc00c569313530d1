// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/framedata.h"

#include "model/mesh/normals.h"

#include <QElapsedTimer>

#include <algorithm>

namespace views {

namespace {

void measureErrors(FrameData &data)
{
    data.errors.clear();
    data.largestError = 0;
    if (!data.original)
        return;
    const std::vector<model::Vec3f> original = data.original->frames->frame(data.frame);
    const std::vector<std::uint32_t> &permutation = data.original->permutation;
    data.errors.resize(data.positions.size());
    for (std::size_t i = 0; i < data.errors.size(); ++i) {
        data.errors[i] = model::length(data.positions[i] - original[permutation.empty() ? i : permutation[i]]);
        data.largestError = std::max(data.largestError, data.errors[i]);
    }
}

} // namespace

void makeFrame(const model::FrameSourcePtr &source, std::uint32_t frame, FrameData &data, const OriginalPtr &original)
{
    QElapsedTimer timer;
    timer.start();
    data.source = source;
    data.frame = frame;
    data.original = original;
    data.positions.resize(source->vertexCount());
    data.normals.resize(source->vertexCount());
    source->positions(frame, data.positions);
    model::computeVertexNormals(data.positions, source->connectivity().triangles, data.normals);
    measureErrors(data);
    data.computeMilliseconds = double(timer.nsecsElapsed()) * 1e-6;
}

} // namespace views
