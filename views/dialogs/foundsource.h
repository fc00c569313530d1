// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/animationreader.h"

#include <QString>

namespace views {

/// What a path promises to be, judged by its ending; decides which questions are asked about it.
enum class SourceKind : std::uint8_t {
    None,       ///< nothing there, or nothing that we read
    Folder,     ///< of frames
    Mesh,       ///< one frame
    PointCache, ///< needs a base mesh
    Scene,      ///< baked at a frame rate; may hold several animations
    Encoded,    ///< an `.anim`
};

SourceKind sourceKindOf(const QString &path);

/// Why `path` cannot be a source, as a sentence; empty if it may be one.
QString sourceProblem(const QString &path);

/// A source that was read.
struct FoundSource
{
    QString path;
    SourceKind kind = SourceKind::None;
    QString format; ///< for people: "Folder of OBJ frames"
    model::FrameSourcePtr frames;
    model::Box3f box; ///< over all frames

    /// Positions alone, as float32.
    std::uint64_t rawBytes() const
    {
        return std::uint64_t(frames->vertexCount()) * frames->frameCount() * sizeof(model::Vec3f);
    }
};

/// Reads a source and measures it. \error as model::io::readAnimation
model::Result<FoundSource> readSource(const QString &path, const model::io::ReadOptions &options,
                                      const model::Progress &progress);

/// For QFileDialog: all that can be read, then each group of formats.
QString sourceFileFilter();

} // namespace views
