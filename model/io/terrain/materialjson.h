// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/material/material.h"

#include <QJsonObject>

namespace model::io {

/// A material as files and scripts have it. FORMAT.md, 6.
QJsonObject jsonOf(const terrain::Material &material);
/// What `json` does not say stays as it is in `material`. \error BadSetting: the key, its value, what it has to be
Result<void> readMaterial(const QJsonObject &json, terrain::Material &material);

} // namespace model::io
