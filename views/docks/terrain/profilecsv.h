// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/query/profile.h"

#include <QString>

namespace views {

/// A cross-section as a table for spreadsheets: a line for each place where one of the curves bends, with decimal
/// points and commas whatever the language. The last column is there if `before` is; a void has no height.
QString profileCsv(std::span<const model::terrain::ProfilePoint> now,
                   std::span<const model::terrain::ProfilePoint> before);

} // namespace views
