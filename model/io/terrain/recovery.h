// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/terrain/terrainfile.h"
#include "model/terrain/tools/paintmask.h"

#include <QElapsedTimer>
#include <QFile>

#include <memory>

namespace model::io {

/// What a journal continues: the file as it was saved last, or a terrain that was never saved.
struct RecoveryBase
{
    QString path;            ///< of the document, for people; may be empty
    std::uint32_t crc = 0;   ///< of the saved file's bytes
    std::uint64_t bytes = 0; ///< of the saved file; 0: there is none, and the journal begins with a snapshot
};

/// The base that the file at `path` is. \error NotFound, CannotOpen, CannotRead
Result<RecoveryBase> recoveryBaseOf(const QString &path);

/// What RecoveryJournal::add() appends: made where the terrain is edited, written where nobody waits.
struct JournalFrame
{
    std::uint8_t kind = 0;
    Bytes payload;
};
/// What edits did to vertices and constraints. \param changes  on whose new side `tin` is; not of the layers' number
JournalFrame frameOfChanges(const terrain::EditChanges &changes, const terrain::TinArrays &tin);
/// The materials and the georeference.
JournalFrame frameOfSettings(const terrain::Terrain &terrain);
/// The painted mask; null: none. Cost: O(cells), it is compressed.
JournalFrame frameOfMask(const terrain::PaintMask *mask);

/// Everything since the last save, appended as it happens, so that it comes back after a crash. FORMAT.md, 8.
///
/// A frame is its length, its checksum, and what changed as it is afterwards, by points: replaying needs no numbers of
/// vertices, and a tail that is torn off takes nothing with it. Not thread-safe.
class RecoveryJournal
{
public:
    /// Begins one in place of whatever is at `path`. Without a saved file it begins with all of `terrain`.
    /// \error CannotOpen, CannotWrite
    static Result<std::unique_ptr<RecoveryJournal>> begin(const QString &path, const RecoveryBase &base,
                                                          const terrain::Terrain &terrain);

    /// After an edit of the terrain was done, undone or redone. \error CannotWrite
    Result<void> addEdit(const terrain::Edit &edit, const terrain::Terrain &terrain);
    /// After materials or georeference were changed. \error CannotWrite
    Result<void> addSettings(const terrain::Terrain &terrain);

    /// \error CannotWrite
    Result<void> add(const JournalFrame &frame) { return append(frame.kind, frame.payload); }

    /// Makes what was added safe from a power cut, if the last time was `interval` milliseconds ago or more. A crash of
    /// the program alone loses nothing in any case. \error CannotWrite
    Result<void> sync(int interval = 0);

    /// Of the journal so far.
    std::uint64_t byteSize() const { return mBytes; }

private:
    explicit RecoveryJournal(const QString &path)
        : mFile(path)
    {}
    Result<void> append(std::uint8_t kind, std::span<const std::uint8_t> payload);

    QFile mFile;
    QElapsedTimer mSinceSync;
    std::uint64_t mBytes = 0;
    bool mIsDirty = false;
};

/// What a journal says that it continues, without reading more of it than that.
/// \error NotFound, CannotOpen, CannotRead; BadMagic, UnsupportedVersion, Truncated
Result<RecoveryBase> journalBaseOf(const QString &journalPath);

/// What a journal gives back.
struct RecoveredTerrain
{
    terrain::Terrain terrain;
    TerrainExtras extras; ///< of the saved file, with the mask as it was painted since
    QString path;         ///< of the document
    std::uint64_t frames = 0;
    std::uint64_t tornBytes = 0; ///< at the end, of a frame that was not finished
};

/// Applies a journal to the file that it continues.
/// \error as openTerrain() for the file; BadMagic, UnsupportedVersion, Truncated: no journal, or not even a beginning;
///        ChecksumMismatch: the file is not the one that the journal continues; BrokenTerrain, BadValue
Result<RecoveredTerrain> recoverTerrain(const QString &journalPath, const Progress &progress = Progress());

/// The same of bytes; `saved` are those of the file that the journal continues, empty if there is none.
Result<RecoveredTerrain> replayJournal(std::span<const std::uint8_t> journal, std::span<const std::uint8_t> saved,
                                       std::uint64_t memoryLimit, const Progress &progress = Progress());

} // namespace model::io
