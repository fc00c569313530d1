// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/documents/openterrain.h"

#include "app/editor/start/samples.h"
#include "model/io/terrain/maskjson.h"
#include "views/dialogs/terrainpicture.h"

#include <QFileInfo>

namespace editor {

namespace {

using TerrainPtr = std::shared_ptr<const model::terrain::Terrain>;

struct Saved
{
    FileStamp stamp;
    model::io::RecoveryBase base;
};

/// Writes the file and reads it again: only then is it said to be saved.
model::Result<Saved> saveToFile(const model::terrain::Terrain &terrain, model::io::TerrainExtras extras,
                                const QString &path, const model::Progress &progress)
{
    extras.thumbnail = views::thumbnailOf(terrain, progress.part(0, 0.1));
    if (auto saved = model::io::saveTerrain(path, terrain, extras, progress.part(0.1, 0.5)); !saved)
        return model::fail(saved.error());
    const FileStamp stamp = FileStamp::of(path);
    // From here on the file is there: what follows is told even if a cancel comes.
    auto base = model::io::recoveryBaseOf(path);
    if (!base)
        return model::fail(base.error());
    const auto again = model::io::openTerrain(path);
    if (!again)
        return model::fail(again.error());
    if (model::savedFingerprint(again->terrain) != model::savedFingerprint(terrain))
        return model::fail(model::Error{model::ErrorCode::ChecksumMismatch, {}, path.toStdString()});
    return Saved{stamp, std::move(*base)};
}

/// Null if there is none, or none that can be read: the terrain is worth more than a mask.
model::GroundMask::Value savedMask(const model::io::TerrainExtras &extras, const model::terrain::Rectangle &domain)
{
    const auto mask = model::io::maskOf(extras.tools[model::io::MaskKey].toObject(), domain);
    return mask ? std::make_shared<const model::terrain::PaintMask>(*mask) : nullptr;
}

} // namespace

OpenTerrain::State::State(model::io::TerrainFile file)
    : document(std::make_unique<model::TerrainDocument>(std::move(file.terrain)))
    , extras(std::move(file.extras))
    , mask(std::make_shared<model::GroundMask>(savedMask(extras, document->tin().domain())))
    , saving(*document)
    , other(*document)
    , record(*document, mask)
{}

OpenTerrain::OpenTerrain(QObject *parent)
    : Document(parent)
{}

OpenTerrain::~OpenTerrain()
{
    emit aboutToBeReplaced();
}

void OpenTerrain::start(Origin origin, const QString &name,
                        std::function<model::Result<Opened>(const model::Progress &)> work)
{
    mOrigin = origin;
    mName = name;
    openingJob().start(std::move(work), [this](model::Result<Opened> result) {
        if (result)
            take(std::move(*result));
        else
            emit failed(result.error());
    });
}

void OpenTerrain::read(const QString &path)
{
    const bool isSample = Document::path().isEmpty();
    start(Origin::File, sampleName(path), [path, isSample](const model::Progress &progress) -> model::Result<Opened> {
        const FileStamp stamp = FileStamp::of(path);
        std::optional<model::io::RecoveryBase> base;
        if (!isSample) {
            auto found = model::io::recoveryBaseOf(path);
            if (!found)
                return model::fail(found.error());
            base = std::move(*found);
        }
        auto file = model::io::openTerrain(path, progress);
        if (!file)
            return model::fail(file.error());
        return Opened{std::move(*file), stamp, std::move(base), {}};
    });
}

void OpenTerrain::create(const QString &name, const model::io::NewTerrain &description)
{
    start(Origin::New, name, [description](const model::Progress &progress) -> model::Result<Opened> {
        auto terrain = model::io::makeTerrain(description, progress);
        if (!terrain)
            return model::fail(terrain.error());
        return Opened{{std::move(*terrain), {}}, {}, {}, {}};
    });
}

void OpenTerrain::import(const QString &path, const model::io::TerrainImportOptions &options,
                         std::vector<model::io::NewLayer> layers)
{
    start(Origin::Import, QFileInfo(path).completeBaseName(),
          [path, options, layers = std::move(layers)](const model::Progress &progress) -> model::Result<Opened> {
              auto imported = model::io::importTerrain(path, options, progress);
              if (!imported)
                  return model::fail(imported.error());
              if (auto added = model::io::addLayers(imported->terrain, layers); !added)
                  return model::fail(added.error());
              model::io::TerrainExtras extras;
              extras.step = imported->step;
              return Opened{{std::move(imported->terrain), std::move(extras)}, {}, {}, {}};
          });
}

void OpenTerrain::recover(const Leftover &leftover)
{
    mRecovered = RecoveryEntry::adopt(leftover.folder);
    start(Origin::Recovery, leftover.title,
          [journals = leftover.journals](const model::Progress &progress) -> model::Result<Opened> {
              std::optional<model::Error> newestError;
              for (const QString &journal : journals) {
                  auto recovered = model::io::recoverTerrain(journal, progress);
                  if (recovered)
                      return Opened{{std::move(recovered->terrain), std::move(recovered->extras)},
                                    FileStamp::of(recovered->path),
                                    {},
                                    recovered->path};
                  if (!newestError)
                      newestError = recovered.error();
              }
              return model::fail(newestError.value_or(model::Error{model::ErrorCode::NotFound, {}, {}}));
          });
}

void OpenTerrain::take(Opened opened)
{
    emit aboutToBeReplaced();
    mContext.reset();
    if (mState)
        mState->record.discard(); // reading it anew drops all edits
    mIsNewer = opened.file.isNewer;
    mWasRecovered = mOrigin == Origin::Recovery;
    mState = std::make_unique<State>(std::move(opened.file));
    mContext = std::make_unique<commands::TerrainContext>(*mState->document);
    connect(&mContext->undoStack(), &QUndoStack::cleanChanged, this, &OpenTerrain::updateModified);
    connect(&mState->record, &RecoveryRecord::failed, this, &OpenTerrain::recoveryFailed);
    if (mWasRecovered && !opened.path.isEmpty())
        setPath(opened.path);
    mLock.hold(path());
    // What was made or came from elsewhere can be had again: it is written down from its first change on.
    if (opened.base)
        mState->record.continueFile(title(), *opened.base);
    else if (mWasRecovered)
        mState->record.continueUnsaved(title(), path(), std::move(mRecovered));
    else
        mState->record.continueFile(title(), {});
    finishOpening(opened.stamp);
}

void OpenTerrain::write(const QString &path)
{
    mState->saving.start([this, path](TerrainPtr terrain) { writeSnapshot(path, std::move(terrain)); });
    emit stateChanged();
}

void OpenTerrain::writeSnapshot(const QString &path, TerrainPtr terrain)
{
    savingJob().start(
        [terrain, extras = extrasToSave(), path](const model::Progress &progress) {
            return saveToFile(*terrain, extras, path, progress);
        },
        [this, path, terrain, changes = mState->record.changeCount()](const model::Result<Saved> &result) {
            if (!result) {
                emit saveFailed(result.error());
                return;
            }
            mIsNewer = mWasRecovered = false;
            mOrigin = Origin::File;
            emit terrainSaved(terrain);
            // A step that was not finished may have grown, and old ones may have been dropped: numbers
            // say nothing.
            constexpr int NoStep = -1;
            const bool isTheSame = changes == mState->record.changeCount();
            finishSaving(path, result->stamp, isTheSame ? mContext->undoStack().index() : NoStep);
            mLock.hold(path);
            mState->record.fileSaved(title(), result->base, changes);
        });
}

model::io::TerrainExtras OpenTerrain::extrasToSave() const
{
    model::io::TerrainExtras extras = mState->extras;
    if (const model::GroundMask::Value &mask = mState->mask->value())
        extras.tools[model::io::MaskKey] = model::io::jsonOf(*mask);
    else
        extras.tools.remove(model::io::MaskKey);
    return extras;
}

void OpenTerrain::takeSnapshot(model::TerrainSnapshot::Taken taken)
{
    mState->other.start(std::move(taken));
}

void OpenTerrain::abandon()
{
    if (mState)
        mState->record.discard();
    if (mRecovered)
        mRecovered.reset(); // it was never opened: it is offered again
}

QString OpenTerrain::title() const
{
    return path().isEmpty() ? mName : Document::title();
}

QString OpenTerrain::origin() const
{
    switch (mOrigin) {
    case Origin::New:
        return tr("New, not saved to a file yet");
    case Origin::Import:
        return tr("Imported, not saved to a file yet");
    case Origin::Recovery:
        return tr("Recovered, not saved to a file yet");
    case Origin::File:
        break;
    }
    return Document::origin();
}

QString OpenTerrain::summary() const
{
    return tr("%L1 vertices, %L2 triangles").arg(terrain().tin().vertexCount()).arg(terrain().tin().triangleCount());
}

QString OpenTerrain::warning() const
{
    if (!mLock.holder().isEmpty())
        return tr("%1 is open elsewhere too: %2. Whoever saves last replaces what the other saved.")
            .arg(title(), mLock.holder());
    if (mIsNewer)
        return tr("%1 is of a newer Sandreel. Saving it here may lose what this one does not know.").arg(title());
    return {};
}

bool OpenTerrain::isModified() const
{
    return mContext && (mWasRecovered || !mContext->undoStack().isClean());
}

bool OpenTerrain::isSaving() const
{
    return Document::isSaving() || (mState && mState->saving.isRunning());
}

} // namespace editor
