// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/geometry/vec.h"

#include <algorithm>

namespace model {

void Box3f::add(Vec3f p)
{
    min = {std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z)};
}

void Box3f::add(const Box3f &box)
{
    if (box.isEmpty())
        return;
    add(box.min);
    add(box.max);
}

float Box3f::longestSide() const
{
    const Vec3f s = size();
    return std::max({s.x, s.y, s.z});
}

Box3f boundingBox(std::span<const Vec3f> points)
{
    Box3f box;
    for (const Vec3f &p : points)
        box.add(p);
    return box;
}

} // namespace model
