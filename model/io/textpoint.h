// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/geometry/vec3d.h"
#include "model/io/textcursor.h"

#include <utility>

namespace model::io {

/// Reads three coordinates. False, with the cursor at what is no number, if one is missing.
/// \param skip  walks the cursor over what may stand before each
/// \param wide  if not null, receives them to the nearest double too; `point` is then rounded from it
template <class Skip>
bool readPoint(TextCursor &cursor, Skip skip, Vec3f &point, Vec3d *wide)
{
    for (const auto &[single, full] :
         {std::pair(&Vec3f::x, &Vec3d::x), std::pair(&Vec3f::y, &Vec3d::y), std::pair(&Vec3f::z, &Vec3d::z)}) {
        skip(cursor);
        if (!(wide ? cursor.number(wide->*full) : cursor.number(point.*single)))
            return false;
        if (wide)
            point.*single = float(wide->*full);
    }
    return true;
}

} // namespace model::io
