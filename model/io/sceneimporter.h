// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"

#include <memory>

#include <QString>

struct aiScene;
namespace Assimp {
class Importer;
}

namespace model::io {

/// A scene as assimp's importer read it, checked so that every index in it is in range. Private to scenereader.cpp.
class ImportedScene
{
public:
    /// Returns at once on a cancel; the importer then ends by itself, and its scene is dropped.
    /// \error ImporterFailed, OutOfMemory, Cancelled, NotFound, CannotOpen
    static Result<ImportedScene> read(const QString &path, const Progress &progress);

    ImportedScene(ImportedScene &&) noexcept;
    ~ImportedScene();

    const aiScene &scene() const;

    /// Its animations are parts of one, not to choose from.
    bool playsAllAnimations() const { return mPlaysAllAnimations; }

private:
    static Result<ImportedScene> readHere(const QString &path, const Progress &progress);
    ImportedScene(std::unique_ptr<Assimp::Importer> importer, bool playsAllAnimations);
    std::unique_ptr<Assimp::Importer> mImporter;
    bool mPlaysAllAnimations;
};

} // namespace model::io
