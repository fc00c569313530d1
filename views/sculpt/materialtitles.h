// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/material/material.h"

#include <QString>

namespace views {

/// What people call a preset and a material. Materials that a preset named are called in the user's language.
QString titleOf(model::terrain::MaterialPreset preset);
QString titleOf(const model::terrain::Material &material);

} // namespace views
