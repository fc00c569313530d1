// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/sequence.h"
#include "model/base/error.h"
#include "model/base/progress.h"

#include <QString>

namespace model::io {

/// Reads a PC2 or MDD point cache, by its ending, with the connectivity of a mesh file of as many vertices.
/// \param baseMesh   empty: the mesh of the same stem beside it
/// \param frameRate  0: as an MDD's times say, else 25
/// \error BadMagic, UnsupportedVersion, BadValue, NoVertices, Truncated, TrailingBytes, NonFinite, each with its byte;
///        MissingBaseMesh; VertexCountDiffers; LimitExceeded, OutOfMemory; those of FileBuffer and of the mesh's
///        parser; Cancelled
/// Formats: PC2, 3ds Max point cache 2 (12 bytes of name, version, points, first frame, step, samples, all
/// little-endian, then the positions of each sample). MDD, LightWave motion designer (frames, points, the time of each
/// frame in seconds, then the positions of each frame, all big-endian).
Result<std::shared_ptr<const Sequence>> readPointCache(const QString &path, const QString &baseMesh, double frameRate,
                                                       std::string name, const Progress &progress);

/// Lower case, without dot.
QStringList pointCacheEndings();

} // namespace model::io
