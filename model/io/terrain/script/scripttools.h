// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/terrain/script/scriptobject.h"
#include "model/terrain/erosion/erosionsettings.h"
#include "model/terrain/tools/stroke.h"

namespace model::io {

/// The stroke that an object describes: `tool`, `path`, `symmetry`.
terrain::Stroke readStroke(ScriptObject &object);
/// A material: `preset`, and its parameters over that.
terrain::Material readScriptMaterial(const QJsonValue &value, const std::string &path, ScriptErrors &errors);
/// Keys of an object that are erosion's settings.
terrain::ErosionSettings readErosion(ScriptObject &object);

} // namespace model::io
