// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/recovery/recoveryrecord.h"

#include "model/base/outofmemory.h"

#include <QMetaObject>

namespace editor {

namespace {

/// Lost of the last moments, at most, when the program crashes.
constexpr int GatherMilliseconds = 250;
/// Lost at most when the power goes.
constexpr int SyncMilliseconds = 3000;
/// A frame of so many vertices takes some 5 ms to put together, in the thread that edits.
constexpr std::size_t MostVerticesInAFrame = 100'000;
/// An erosion that moves everything all the time must not keep the disk busy all the time.
constexpr qint64 MillisecondsBetweenSnapshots = 10'000;
constexpr int RetryMilliseconds = 30'000;

} // namespace

struct RecoveryRecord::Writer
{
    std::unique_ptr<RecoveryEntry> entry;
    std::unique_ptr<model::io::RecoveryJournal> journal;

    /// \param terrain  null: the base says it all
    model::Result<void> begin(const QString &title, const model::io::RecoveryBase &base,
                              const model::terrain::Terrain *terrain)
    {
        journal.reset();
        if (!entry)
            entry = RecoveryEntry::make(title, base.path);
        if (!entry)
            return model::fail(model::ErrorCode::CannotWrite, "recovery");
        static const model::terrain::Terrain nothing(model::terrain::Tin({{0, 0}, {1, 1}}));
        auto begun = model::io::RecoveryJournal::begin(entry->newJournal(), base, terrain ? *terrain : nothing);
        if (!begun)
            return model::fail(begun.error());
        journal = std::move(*begun);
        entry->keepNewest(Generations);
        return journal->sync();
    }
    model::Result<void> add(const model::io::JournalFrame &frame)
    {
        return journal ? journal->add(frame) : model::Result<void>();
    }
    void drop()
    {
        journal.reset();
        if (entry)
            entry->remove();
        entry.reset();
    }
};

RecoveryRecord::RecoveryRecord(const model::TerrainDocument &document, std::shared_ptr<const model::GroundMask> mask,
                               QObject *parent)
    : QObject(parent)
    , mDocument(document)
    , mSnapshot(document)
    , mMask(std::move(mask))
    , mWriter(std::make_shared<Writer>())
{
    mThread.setMaxThreadCount(1);
    mSoon.setSingleShot(true);
    connect(&mSoon, &QTimer::timeout, this, &RecoveryRecord::flush);
    connect(&mSyncing, &QTimer::timeout, this, [this] {
        post([](Writer &writer) -> model::Result<void> {
            return writer.journal ? writer.journal->sync() : model::Result<void>();
        });
    });
    connect(&document, &model::TerrainDocument::changed, this, &RecoveryRecord::noteChange);
    connect(mMask.get(), &model::GroundMask::changed, this, &RecoveryRecord::noteMask);
}

RecoveryRecord::~RecoveryRecord()
{
    mThread.waitForDone();
}

void RecoveryRecord::post(std::function<model::Result<void>(Writer &)> work)
{
    mThread.start([this, writer = mWriter, work = std::move(work)] {
        const auto done = model::catchBadAlloc([&] { return work(*writer); });
        if (done)
            return;
        writer->journal.reset(); // without this frame those that follow would say something else
        QMetaObject::invokeMethod(
            this, [this, error = done.error()] { fail(error); }, Qt::QueuedConnection);
    });
}

void RecoveryRecord::continueFile(const QString &title, const model::io::RecoveryBase &base)
{
    mTitle = title;
    mBase = base;
}

void RecoveryRecord::continueUnsaved(const QString &title, const QString &path, std::unique_ptr<RecoveryEntry> entry)
{
    mTitle = title;
    mBase = {path, 0, 0};
    if (entry)
        mWriter->entry = std::move(entry); // nothing was posted yet
    beginWithSnapshot();
}

void RecoveryRecord::writeSoon()
{
    ++mChangeCount;
    if (!mSoon.isActive())
        mSoon.start(mIsBroken ? RetryMilliseconds : GatherMilliseconds);
}

void RecoveryRecord::noteMask()
{
    writeSoon();
    mMaskChanged = true;
}

void RecoveryRecord::noteChange(const model::TerrainChange &change)
{
    writeSoon();
    if (const auto *const surface = std::get_if<model::SurfaceChanged>(&change))
        mPending.add(*surface->edit, mDocument.tin().arrays());
    else
        mSettingsChanged = true;
}

void RecoveryRecord::flush()
{
    mSoon.stop();
    if (mSnapshot.isRunning() || (mPending.isEmpty() && !mSettingsChanged && !mMaskChanged && !mIsBroken))
        return; // a snapshot has all of it
    const bool beginsOfFile = !mHasJournal && mBase.bytes > 0;
    if (mIsBroken || mPending.needsSnapshot() || mPending.vertexCount() > MostVerticesInAFrame ||
        (!mHasJournal && !beginsOfFile)) {
        const qint64 wait = mSinceSnapshot.isValid() ? MillisecondsBetweenSnapshots - mSinceSnapshot.elapsed() : 0;
        if (wait > 0 && !mIsBroken)
            mSoon.start(int(wait));
        else
            beginWithSnapshot();
        return;
    }
    if (beginsOfFile) {
        mHasJournal = true;
        post([title = mTitle, base = mBase](Writer &writer) { return writer.begin(title, base, nullptr); });
        mSyncing.start(SyncMilliseconds);
    }
    std::vector<model::io::JournalFrame> frames;
    if (!mPending.isEmpty())
        frames.push_back(mPending.take(mDocument.tin().arrays()));
    if (std::exchange(mSettingsChanged, false))
        frames.push_back(model::io::frameOfSettings(mDocument.terrain()));
    const bool hasMask = std::exchange(mMaskChanged, false);
    post([frames = std::move(frames), hasMask, mask = mMask->value()](Writer &writer) -> model::Result<void> {
        for (const model::io::JournalFrame &frame : frames)
            if (auto added = writer.add(frame); !added)
                return added;
        return hasMask ? writer.add(model::io::frameOfMask(mask.get())) : model::Result<void>();
    });
}

void RecoveryRecord::beginWithSnapshot()
{
    mSinceSnapshot.start();
    mSnapshot.start([this](std::shared_ptr<const model::terrain::Terrain> terrain) {
        mPending.clear();
        mSettingsChanged = mMaskChanged = false;
        mHasJournal = true;
        post([this, title = mTitle, path = mBase.path, terrain = std::move(terrain),
              mask = mMask->value()](Writer &writer) {
            auto begun = writer.begin(title, {path, 0, 0}, terrain.get());
            if (begun && mask)
                begun = writer.add(model::io::frameOfMask(mask.get()));
            if (begun) // it works again: the next failure is told again
                QMetaObject::invokeMethod(
                    this, [this] { mIsBroken = false; }, Qt::QueuedConnection);
            return begun;
        });
        mSyncing.start(SyncMilliseconds);
    });
}

void RecoveryRecord::fileSaved(const QString &title, const model::io::RecoveryBase &base, std::uint64_t changeCount)
{
    mTitle = title;
    mBase = base;
    mHasJournal = false;
    mIsBroken = false;
    mSyncing.stop();
    if (changeCount != mChangeCount) { // edited while it was saved: the old journals go when the new one is there
        beginWithSnapshot();
        return;
    }
    mSnapshot.cancel();
    mSoon.stop();
    mPending.clear();
    mSettingsChanged = mMaskChanged = false;
    post([](Writer &writer) -> model::Result<void> {
        writer.drop();
        return {};
    });
}

void RecoveryRecord::discard()
{
    mSnapshot.cancel();
    mSoon.stop();
    mSyncing.stop();
    disconnect(&mDocument, nullptr, this, nullptr);
    disconnect(mMask.get(), nullptr, this, nullptr);
    post([](Writer &writer) -> model::Result<void> {
        writer.drop();
        return {};
    });
}

void RecoveryRecord::waitUntilWritten()
{
    flush();
    mThread.waitForDone();
}

void RecoveryRecord::fail(const model::Error &error)
{
    mHasJournal = false;
    mSyncing.stop();
    mSoon.start(RetryMilliseconds);
    if (!std::exchange(mIsBroken, true))
        emit failed(error);
}

} // namespace editor
