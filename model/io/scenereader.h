// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/sequence.h"
#include "model/base/error.h"
#include "model/base/progress.h"

#include <QString>

namespace model::io {

/// Reads a scene (glTF, GLB, FBX, Collada) and bakes one of its animations to vertices: node transforms, skins and
/// morph targets at the first key and 1/rate, 2/rate, ... after it. All meshes become one connectivity, in the scene's
/// coordinates; polygons become fans; points and lines are skipped. A scene without animations gives one frame. The
/// animations of a Collada file are one, as each exporter writes one for each object, unless it has clips.
///
/// Such files split vertices where normals or texture coordinates have seams, which matter to nobody here: vertices
/// that are at exactly the same place in every frame become one, the first of them.
///
/// \param frameRate       0: that of the file's keys, else 25
/// \param animationIndex  below the number of animations
/// \error ImporterFailed, NoAnimation (no mesh), BadSetting (animationIndex), NonFinite, LimitExceeded, OutOfMemory,
///        Cancelled; those of FileBuffer
/// Only files in the scene's own folder and below are opened, whatever the scene refers to.
Result<std::shared_ptr<const Sequence>> readScene(const QString &path, double frameRate, int animationIndex,
                                                  std::string name, const Progress &progress);

/// Lower case, without dot.
QStringList sceneEndings();

} // namespace model::io
