// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/recovery/recoveryentry.h"
#include "model/document/groundmask.h"
#include "model/document/terrainsnapshot.h"
#include "model/io/terrain/pendingedits.h"

#include <QElapsedTimer>
#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include <functional>
#include <memory>

namespace editor {

/// Writes down what happens to a terrain, so that it comes back after a crash: a model::io::RecoveryJournal, written by
/// a thread of its own. Edits are put together for a fraction of a second. What is too much for that, as an erosion of
/// everything, makes a new journal that begins with a snapshot; the ones before stay as older generations.
///
/// The journals go when the document is saved, or discard() is called; else they stay, and are offered at the next
/// start.
class RecoveryRecord final : public QObject
{
    Q_OBJECT

public:
    /// Journals that are kept of one document.
    static constexpr int Generations = 3;

    /// Must not outlive the document. \param mask  written down with it
    RecoveryRecord(const model::TerrainDocument &document, std::shared_ptr<const model::GroundMask> mask,
                   QObject *parent = nullptr);
    /// Waits for what is being written.
    ~RecoveryRecord() override;

    /// The document is as this file.
    void continueFile(const QString &title, const model::io::RecoveryBase &base);
    /// There is no such file: all of the document is written at once. \param entry  of the journals that it came from
    void continueUnsaved(const QString &title, const QString &path, std::unique_ptr<RecoveryEntry> entry = nullptr);

    /// Counts the document's changes; to be kept with a snapshot that is saved.
    std::uint64_t changeCount() const { return mChangeCount; }
    /// The file holds the document as it was at `changeCount`, and was read again to be sure.
    void fileSaved(const QString &title, const model::io::RecoveryBase &base, std::uint64_t changeCount);

    /// Hands over what waits; without it that happens soon.
    void flush();
    /// The user does not want it back.
    void discard();
    /// Waits until everything is on the disk: for tests.
    void waitUntilWritten();

signals:
    /// Nothing is written for now; it is tried again. Told once until it works again.
    void failed(const model::Error &error);

private:
    struct Writer;

    void noteChange(const model::TerrainChange &change);
    void noteMask();
    void writeSoon();
    void beginWithSnapshot();
    void post(std::function<model::Result<void>(Writer &)> work);
    void fail(const model::Error &error);

    const model::TerrainDocument &mDocument;
    model::TerrainSnapshot mSnapshot;
    model::io::PendingEdits mPending;
    const std::shared_ptr<const model::GroundMask> mMask;
    bool mSettingsChanged = false;
    bool mMaskChanged = false;
    std::uint64_t mChangeCount = 0;
    QString mTitle;
    model::io::RecoveryBase mBase;
    bool mHasJournal = false; ///< or has asked for one
    bool mIsBroken = false;
    QTimer mSoon;
    QTimer mSyncing;
    QElapsedTimer mSinceSnapshot;
    std::shared_ptr<Writer> mWriter; ///< touched by the thread alone
    QThreadPool mThread;             ///< one thread, which takes its work in order
};

} // namespace editor
