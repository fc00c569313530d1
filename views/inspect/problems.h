// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/analysis/meshreport.h"

#include <QString>

namespace views {

/// What the numbers of a problem count.
enum class IdsName : std::uint8_t { Vertices, Faces, Components };
IdsName namesOf(model::ProblemKind kind);

/// "Non-manifold edge"
QString problemTitle(model::ProblemKind kind);
/// "Edge 12–40", numbered from 0 as in files and by the command line.
QString problemPlace(model::ProblemKind kind, const model::ProblemIds &ids);

} // namespace views
