// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/terraindocument.h"
#include "views/jobs/job.h"

#include <QObject>

#include <memory>

namespace views {

/// The moment that Restore goes back to, and that cut and fill and cross-sections compare with: the one that the user
/// has chosen, until then that when the terrain was opened or saved last. A copy of the terrain, made in the
/// background.
class GroundReference final : public QObject
{
    Q_OBJECT

public:
    using TerrainPtr = std::shared_ptr<const model::terrain::Terrain>;

    /// Begins to copy the terrain as it is.
    explicit GroundReference(const model::TerrainDocument &document, QObject *parent = nullptr);

    /// The user wants the terrain as it is now; changed() follows.
    void take();
    bool isTaken() const { return mIsTaken; }
    /// The terrain was saved like this.
    void noteSaved(TerrainPtr saved);

    /// Null until the first copy is there.
    const TerrainPtr &terrain() const { return mTerrain; }
    bool isCopying() const { return mCopying.isRunning(); }

signals:
    void changed();

private:
    void copy();

    const model::TerrainDocument &mDocument;
    TerrainPtr mTerrain;
    bool mIsTaken = false;
    Job mCopying;
};

} // namespace views
