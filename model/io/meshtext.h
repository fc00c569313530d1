// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/animationwriter.h"

#include <span>
#include <string>

namespace model::io {

/// The bytes of a mesh file, in `out` (whose memory is reused): OBJ and OFF with the shortest numbers that read as the
/// same floats, PLY binary little-endian.
void formatMesh(std::span<const Vec3f> positions, const Connectivity &connectivity, MeshFormat format,
                std::string &out);
/// The same of faces with any number of corners.
void formatMesh(std::span<const Vec3f> positions, const Faces &faces, MeshFormat meshFormat, std::string &out);

/// File name ending, without dot.
const char *endingOf(MeshFormat format);

} // namespace model::io
