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
    /// \error ImporterFailed, OutOfMemory, Cancelled, NotFound, CannotOpen
    static Result<ImportedScene> read(const QString &path, const Progress &progress);

    ImportedScene(ImportedScene &&) noexcept;
    ~ImportedScene();

    const aiScene &scene() const;

private:
    explicit ImportedScene(std::unique_ptr<Assimp::Importer> importer);
    std::unique_ptr<Assimp::Importer> mImporter;
};

} // namespace model::io
