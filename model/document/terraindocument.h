// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/terrainchange.h"
#include "model/terrain/terrain.h"
#include "model/terrain/tin/tinedit.h"

#include <QObject>

#include <functional>
#include <memory>
#include <mutex>

namespace model {

/// A terrain being edited. Knows nothing of undo, files or views: commands call the functions that change something,
/// each of which emits one notice, only when something differs.
class TerrainDocument final : public QObject
{
    Q_OBJECT

public:
    explicit TerrainDocument(terrain::Terrain terrain, QObject *parent = nullptr);

    const terrain::Terrain &terrain() const { return mState->terrain; }
    const terrain::Tin &tin() const { return mState->terrain.tin; }

    /// Carries out `work(TinEdit &)` as one edit, which a command keeps: its undo and redo are swap(). Nothing is
    /// emitted for an edit that wrote nothing, or that `work` has rolled back.
    template <class Work>
    terrain::Edit edit(Work work, terrain::VolumeRule rule = terrain::VolumeRule::GiveBack)
    {
        terrain::Edit done;
        {
            const std::lock_guard lock(mState->changing);
            terrain::TinEdit open(mState->terrain.tin, rule);
            work(open);
            if (open.isOpen())
                done = open.commit();
        }
        notify(done);
        return done;
    }
    /// Undoes an edit that is done, or does one that is undone. Precondition: those since it have been undone, in
    /// order.
    void swap(terrain::Edit &edit);

    /// Precondition: validate() holds with them: a material for each layer. \returns the list before
    std::vector<terrain::Material> setMaterials(std::vector<terrain::Material> materials);
    terrain::GeoReference setGeoReference(terrain::GeoReference geoReference);

    /// The terrain as it is now, for a worker that saves it while the user edits on. Cost: a copy of all memory.
    std::shared_ptr<const terrain::Terrain> snapshot() const;

    /// Copies the terrain as it is when it is called, for a worker that must not keep the window waiting: it may be
    /// called in any thread, after the document is gone too. A change that comes while it copies waits for it.
    std::function<terrain::Terrain()> copier() const;

    /// A digest of everything that is saved: equal fingerprints mean that the same terrain comes back from the file. It
    /// does not depend on the numbers of vertices, triangles and constraints, which are no part of that. Cost: O(n).
    std::uint64_t fingerprint() const;

signals:
    void changed(const model::TerrainChange &change);

private:
    void notify(const terrain::Edit &edit);

    struct State
    {
        terrain::Terrain terrain;
        std::mutex changing; ///< held by changes, which come from one thread, and by copier()'s copies
    };
    const std::shared_ptr<State> mState;
};

/// The fingerprint of a terrain that is no document's.
std::uint64_t savedFingerprint(const terrain::Terrain &terrain);

} // namespace model
