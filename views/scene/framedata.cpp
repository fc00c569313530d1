// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/framedata.h"

#include "model/mesh/normals.h"

#include <QElapsedTimer>

namespace views {

void makeFrame(const model::FrameSourcePtr &source, std::uint32_t frame, FrameData &data)
{
    QElapsedTimer timer;
    timer.start();
    data.source = source;
    data.frame = frame;
    data.positions.resize(source->vertexCount());
    data.normals.resize(source->vertexCount());
    source->positions(frame, data.positions);
    model::computeVertexNormals(data.positions, source->connectivity().triangles, data.normals);
    data.computeMilliseconds = double(timer.nsecsElapsed()) * 1e-6;
}

} // namespace views
