// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/direct/grid.h"

#include "model/base/parallel.h"
#include "model/codec/framestack.h"

#include <cmath>
#include <limits>

namespace model::codec {

namespace {

struct Box
{
    std::array<double, 3> least, most;

    Box()
    {
        least.fill(std::numeric_limits<double>::infinity());
        most.fill(-std::numeric_limits<double>::infinity());
    }
    void add(const Box &other)
    {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            least[axis] = std::min(least[axis], other.least[axis]);
            most[axis] = std::max(most[axis], other.most[axis]);
        }
    }
};

Box boxOf(std::span<const Vec3f> positions)
{
    Box box;
    for (const Vec3f p : positions) {
        const double values[] = {double(p.x), double(p.y), double(p.z)};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            box.least[axis] = std::min(box.least[axis], values[axis]);
            box.most[axis] = std::max(box.most[axis], values[axis]);
        }
    }
    return box;
}

} // namespace

CellGrid CellGrid::around(const FrameStack &frames, std::uint32_t resolution)
{
    std::vector<Box> boxes(frames.frameCount());
    parallelFor(boxes.size(), [&](std::size_t f) { boxes[f] = boxOf(frames.frame(f)); });
    Box box;
    for (const Box &one : boxes)
        box.add(one);
    double longest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        longest = std::max(longest, box.most[axis] - box.least[axis]);

    CellGrid grid;
    grid.resolution = resolution;
    grid.cell = longest / resolution;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double side = box.most[axis] - box.least[axis];
        const double cells = grid.cell > 0 ? std::clamp(std::ceil(side / grid.cell), 1.0, double(resolution)) : 1;
        grid.origin[axis] = box.least[axis] + (side - (cells - 1) * grid.cell) / 2;
    }
    return grid;
}

Cell CellGrid::cellOf(Vec3f position) const
{
    Cell result{};
    const double values[] = {double(position.x), double(position.y), double(position.z)};
    if (cell > 0)
        for (std::size_t axis = 0; axis < 3; ++axis)
            result[axis] =
                std::int32_t(std::clamp(std::round((values[axis] - origin[axis]) / cell), 0.0, double(resolution - 1)));
    return result;
}

Vec3f CellGrid::middleOf(const Cell &at) const
{
    constexpr double Most = std::numeric_limits<float>::max();
    std::array<float, 3> p;
    for (std::size_t axis = 0; axis < 3; ++axis)
        p[axis] = float(std::clamp(origin[axis] + at[axis] * cell, -Most, Most));
    return {p[0], p[1], p[2]};
}

} // namespace model::codec
