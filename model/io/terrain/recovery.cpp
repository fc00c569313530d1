// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/recovery.h"

#include "model/base/memory.h"
#include "model/io/failure.h"
#include "model/io/filebuffer.h"
#include "model/io/savefile.h"
#include "model/io/terrain/recovery/journalframes.h"

#include <cerrno>
#include <cstring>

#include <unistd.h>

namespace model::io {

using namespace terrain;

namespace {

std::span<const std::uint8_t> bytesOf(std::string_view text)
{
    return {reinterpret_cast<const std::uint8_t *>(text.data()), text.size()};
}

} // namespace

Result<RecoveryBase> recoveryBaseOf(const QString &path)
{
    FileBuffer buffer;
    const auto bytes = buffer.load(path);
    if (!bytes)
        return fail(bytes.error());
    return RecoveryBase{path, journalCrcOf(bytesOf(*bytes)), bytes->size()};
}

Result<std::unique_ptr<RecoveryJournal>> RecoveryJournal::begin(const QString &path, const RecoveryBase &base,
                                                                const Terrain &terrain)
{
    Bytes start(std::begin(JournalMagic), std::end(JournalMagic));
    const Bytes head = frameOfBase(base);
    start.insert(start.end(), head.begin(), head.end());
    if (base.bytes == 0) {
        const Result<Bytes> snapshot = formatTerrain(terrain, {});
        if (!snapshot)
            return fail(snapshot.error());
        const Bytes frame = frameOf(SnapshotFrame, *snapshot);
        start.insert(start.end(), frame.begin(), frame.end());
    }
    if (auto saved = saveBytes(path, start); !saved)
        return fail(saved.error());
    std::unique_ptr<RecoveryJournal> journal(new RecoveryJournal(path));
    if (!journal->mFile.open(QIODevice::ReadWrite | QIODevice::Unbuffered) ||
        !journal->mFile.seek(qint64(start.size())))
        return failIn(journal->mFile, ErrorCode::CannotOpen);
    journal->mBytes = start.size();
    journal->mSinceSync.start();
    return journal;
}

Result<void> RecoveryJournal::append(std::uint8_t kind, std::span<const std::uint8_t> payload)
{
    const Bytes frame = frameOf(kind, payload);
    if (auto written = writeAll(mFile, frame); !written) {
        // Half a frame would hide all that come after it.
        (void)mFile.resize(qint64(mBytes));
        (void)mFile.seek(qint64(mBytes));
        return written;
    }
    mBytes += frame.size();
    mIsDirty = true;
    return {};
}

Result<void> RecoveryJournal::addEdit(const Edit &edit, const Terrain &terrain)
{
    if (edit.isEmpty())
        return {};
    const EditChanges changes = changesOf(edit, terrain.tin.arrays());
    if (!changes.changesLayers)
        return add(frameOfChanges(changes, terrain.tin.arrays()));
    // Every vertex has other layers now.
    const Result<Bytes> snapshot = formatTerrain(terrain, {});
    return snapshot ? append(SnapshotFrame, *snapshot) : fail(snapshot.error());
}

Result<void> RecoveryJournal::addSettings(const Terrain &terrain)
{
    return add(frameOfSettings(terrain));
}

Result<void> RecoveryJournal::sync(int interval)
{
    if (!mIsDirty || mSinceSync.elapsed() < interval)
        return {};
    if (::fdatasync(mFile.handle()) != 0)
        return failIn(mFile.fileName(), ErrorCode::CannotWrite, std::strerror(errno));
    mIsDirty = false;
    mSinceSync.restart();
    return {};
}

Result<RecoveryBase> journalBaseOf(const QString &journalPath)
{
    // The base is the first frame: a snapshot after it may be large, and is not wanted here.
    constexpr qint64 MostBytes = 64 * 1024;
    QFile file(journalPath);
    if (!file.exists())
        return failIn(journalPath, ErrorCode::NotFound);
    if (!file.open(QIODevice::ReadOnly))
        return failIn(file, ErrorCode::CannotOpen);
    const QByteArray bytes = file.read(MostBytes);
    std::uint64_t tornBytes = 0;
    auto base =
        readFrames({reinterpret_cast<const std::uint8_t *>(bytes.constData()), std::size_t(bytes.size())}, tornBytes)
            .and_then(readBase);
    return base ? base : failIn(journalPath, base.error());
}

Result<RecoveredTerrain> recoverTerrain(const QString &journalPath, const Progress &progress)
{
    FileBuffer journal, saved;
    const auto bytes = journal.load(journalPath);
    if (!bytes)
        return fail(bytes.error());
    std::uint64_t tornBytes = 0;
    const auto base = readFrames(bytesOf(*bytes), tornBytes).and_then(readBase);
    if (!base)
        return failIn(journalPath, base.error());
    std::string_view savedBytes;
    if (base->bytes > 0) {
        const auto loaded = saved.load(base->path);
        if (!loaded)
            return fail(loaded.error());
        savedBytes = *loaded;
    }
    const std::uint64_t memory = physicalMemory();
    auto recovered =
        replayJournal(bytesOf(*bytes), bytesOf(savedBytes), memory > 0 ? memory / 2 : std::uint64_t(8) << 30, progress);
    if (!recovered)
        return failIn(journalPath, recovered.error());
    return recovered;
}

} // namespace model::io
