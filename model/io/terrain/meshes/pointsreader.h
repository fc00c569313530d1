// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"
#include "model/terrain/tin/ids.h"

#include <string_view>
#include <vector>

namespace model::io {

/// Parses text with a point x y z in each line: numbers between blanks, commas or semicolons, with a decimal point;
/// what follows the third is ignored. Empty lines, lines that begin with # or //, and a first line without numbers are
/// skipped.
/// \error SyntaxError, NonFinite, each with its line; NoVertices; Cancelled
Result<std::vector<terrain::Point3>> parsePoints(std::string_view text, const Progress &progress = Progress());

} // namespace model::io
