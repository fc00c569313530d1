// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/documents/document.h"
#include "app/editor/documents/filelock.h"
#include "app/editor/recovery/recoveryrecord.h"
#include "commands/terrain/terraincontext.h"
#include "model/document/groundmask.h"
#include "model/document/terrainsnapshot.h"
#include "model/io/terrain/newterrain.h"
#include "model/io/terrain/terrainfile.h"
#include "model/io/terrain/terrainimport.h"

#include <functional>
#include <memory>
#include <optional>

namespace editor {

/// A terrain, with the record that brings it back after a crash, and the lock of its file. Opened from a file, or made:
/// then it has no path until it is saved.
class OpenTerrain final : public Document
{
    Q_OBJECT

public:
    explicit OpenTerrain(QObject *parent = nullptr);
    ~OpenTerrain() override;

    /// Begins to make a new one; opened() or failed() follow, as with open().
    void create(const QString &name, const model::io::NewTerrain &description);
    /// Begins to read somebody else's file.
    void import(const QString &path, const model::io::TerrainImportOptions &options,
                std::vector<model::io::NewLayer> layers = {});
    /// Begins to bring back what a crash left.
    void recover(const Leftover &leftover);

    DocumentKind kind() const override { return DocumentKind::Terrain; }
    QString title() const override;
    QString origin() const override;
    QString summary() const override;
    QString warning() const override;
    QString holder() const override { return mLock.holder(); }
    bool isModified() const override;
    bool isSaving() const override;
    commands::TerrainContext *context() const override { return mContext.get(); }
    void abandon() override;

    /// Precondition: isOpen().
    const model::TerrainDocument &terrain() const { return *mState->document; }
    /// What tools leave alone. It is kept with the state of the tools. Precondition: isOpen().
    const std::shared_ptr<model::GroundMask> &mask() { return mState->mask; }
    /// What its file holds beside the terrain. Precondition: isOpen().
    const model::io::TerrainExtras &extras() const { return mState->extras; }
    RecoveryRecord &record() { return mState->record; }
    /// Takes a snapshot without stopping the editor; in place of one that is being taken for the same purpose.
    void takeSnapshot(model::TerrainSnapshot::Taken taken);

signals:
    /// It was saved like this: sent before saved().
    void terrainSaved(const std::shared_ptr<const model::terrain::Terrain> &terrain);
    /// Edits are not being written down for now.
    void recoveryFailed(const model::Error &error);

protected:
    void read(const QString &path) override;
    void write(const QString &path) override;

private:
    enum class Origin { File, New, Import, Recovery };

    /// What a worker gives.
    struct Opened
    {
        model::io::TerrainFile file;
        FileStamp stamp;
        std::optional<model::io::RecoveryBase> base;
        QString path; ///< of a recovered document
    };
    /// Everything that is replaced at once. In the order in which it depends on one another.
    struct State
    {
        State(model::io::TerrainFile file);

        std::unique_ptr<model::TerrainDocument> document;
        model::io::TerrainExtras extras;
        std::shared_ptr<model::GroundMask> mask;
        model::TerrainSnapshot saving;
        model::TerrainSnapshot other;
        RecoveryRecord record;
    };

    void start(Origin origin, const QString &name, std::function<model::Result<Opened>(const model::Progress &)> work);
    void take(Opened opened);
    void writeSnapshot(const QString &path, std::shared_ptr<const model::terrain::Terrain> terrain);
    /// What goes into the file beside the terrain, as it is now.
    model::io::TerrainExtras extrasToSave() const;

    Origin mOrigin = Origin::File;
    QString mName;                             ///< of what has no path
    std::unique_ptr<RecoveryEntry> mRecovered; ///< until its document takes it
    bool mIsNewer = false;
    bool mWasRecovered = false; ///< and not saved since
    FileLock mLock;
    std::unique_ptr<State> mState;
    std::unique_ptr<commands::TerrainContext> mContext;
};

} // namespace editor
