// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/framesource.h"
#include "model/base/error.h"
#include "model/base/progress.h"

#include <QString>
#include <QStringList>

namespace model::io {

/// What a reader cannot know from the input alone.
struct ReadOptions
{
    /// Connectivity for a point cache (PC2, MDD): a mesh file with as many vertices. Empty: a mesh of the same stem
    /// beside the cache is taken (walk.pc2 + walk.obj).
    QString baseMesh;
    /// Frames per second; also the rate at which skinned and morphed scenes are baked. 0: as the input says, else 25.
    double frameRate = 0;
    /// For scenes with several animations: which one, 0-based.
    int animationIndex = 0;
};

/// Reads an animation of any kind that we know, by what it is:
///   a folder of OBJ, OFF, PLY or STL frames in natural order; a single mesh file of these (one frame);
///   PC2 and MDD point caches; glTF, GLB, FBX and what else assimp animates; `.anim`.
/// Text is parsed in parallel, with at most one file per thread in memory.
/// Every error names the file, and the line or byte.
Result<FrameSourcePtr> readAnimation(const QString &path, const ReadOptions &options = {},
                                     const Progress &progress = Progress());

/// The frame files of a folder in natural order (2 before 10), all of one ending: the most frequent one of those that
/// we read. \error NotFound, NoFrames
Result<QStringList> frameFilesIn(const QString &folder);

/// One mesh file (OBJ, OFF, PLY, STL).
Result<TriangleMesh> readMesh(const QString &path);

/// Endings, lower case without dot, that readAnimation takes as a file; for dialogs and drag and drop.
QStringList readableEndings();

} // namespace model::io
