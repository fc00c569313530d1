// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/geometry/vec.h"

namespace model {

/// p -> scale * p + offset: moves and scales, one factor for all axes. In double, so that a chain of them and its
/// inverse stay exact to float precision.
struct Similarity
{
    double scale = 1; ///< above zero
    double offset[3] = {0, 0, 0};

    friend bool operator==(const Similarity &, const Similarity &) = default;
    bool isIdentity() const { return *this == Similarity{}; }
    Vec3f operator()(Vec3f p) const
    {
        return {float(scale * p.x + offset[0]), float(scale * p.y + offset[1]), float(scale * p.z + offset[2])};
    }
    Similarity inverse() const { return {1 / scale, {-offset[0] / scale, -offset[1] / scale, -offset[2] / scale}}; }
};

/// First `first`, then `second`.
inline Similarity compose(const Similarity &first, const Similarity &second)
{
    return {second.scale * first.scale,
            {second.scale * first.offset[0] + second.offset[0], second.scale * first.offset[1] + second.offset[1],
             second.scale * first.offset[2] + second.offset[2]}};
}

} // namespace model
