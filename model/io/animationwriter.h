// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/framesource.h"
#include "model/base/error.h"
#include "model/base/progress.h"
#include "model/mesh/faces.h"

#include <QString>

namespace model::io {

/// Formats for single frames.
enum class MeshFormat : std::uint8_t { Obj, Off, Ply };

/// Writes one mesh as it would be read again: shortest text that gives the same float (OBJ, OFF), binary
/// little-endian (PLY). Through SaveFile: all or nothing.
/// \error CannotOpen, CannotWrite
Result<void> writeMesh(const QString &path, std::span<const Vec3f> positions, const Connectivity &connectivity,
                       MeshFormat format);
/// The same with its faces as they are: they come back so from readPolygonMesh().
Result<void> writePolygonMesh(const QString &path, const PolygonMesh &mesh, MeshFormat format);

/// Writes every frame as FOLDER/frame_0001.obj and so on. Makes the folder if need be; on an error or a cancel removes
/// what it wrote, and only that.
/// \error CannotOpen, CannotWrite, Cancelled; also CannotWrite if the folder holds frames already
Result<void> writeFrames(const QString &folder, const FrameSource &source, MeshFormat format,
                         const Progress &progress = Progress());

/// Writes a PC2 point cache (float32, in the source's vertex order); the base mesh is not part of it.
/// \error CannotOpen, CannotWrite, Cancelled
Result<void> writePc2(const QString &path, const FrameSource &source, const Progress &progress = Progress());

} // namespace model::io
