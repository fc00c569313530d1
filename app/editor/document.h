// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/filestamp.h"
#include "commands/animation/animationcontext.h"
#include "model/document/animationdocument.h"
#include "views/docks/filefacts.h"
#include "views/jobs/job.h"
#include "views/scene/comparison.h"
#include "views/scene/player.h"

#include <QObject>

#include <memory>
#include <optional>

namespace editor {

/// One animation that is open, or being opened: the document with its undo stack, its player, its file, and the
/// opening and saving in the background.
class Document final : public QObject
{
    Q_OBJECT

public:
    explicit Document(QObject *parent = nullptr);
    ~Document() override;

    /// Begins to read an `.anim`; opened() or failed() follow. Again with the same path: reads it anew, drops all
    /// edits, and keeps frame and play. A path in the program's resources is a sample: it opens without a file.
    void open(const QString &path);
    void reload();
    /// failed(Cancelled) follows, unless it is too late.
    void cancelOpening() { mOpening.cancel(); }
    /// Begins to write the document as it is now; saved() or saveFailed() follow. What is edited meanwhile stays
    /// unsaved. Precondition: canSave().
    void save(const QString &path);

    bool isOpening() const { return mOpening.isRunning(); }
    bool isSaving() const { return mSaving.isRunning(); }
    bool isOpen() const { return mContext != nullptr; }
    bool canSave() const { return isOpen() && !isSaving() && !isOpening(); }
    views::Job &openingJob() { return mOpening; }
    views::Job &savingJob() { return mSaving; }

    /// Where it is saved; empty for a sample, or what is there of a file that was cut, that was not saved yet.
    const QString &path() const { return mPath; }
    /// For tabs and titles: the file's name, or the sample's.
    QString title() const;
    /// What a file that was cut shows, as long as it was not saved.
    struct Cut
    {
        std::uint32_t details = 0, detailsInFile = 0; ///< basis trajectories
    };
    const std::optional<Cut> &cut() const { return mCut; }
    /// There is something that the file does not hold.
    bool isModified() const;
    /// Another program wrote, or removed, the file since we read or wrote it.
    bool isChangedOnDisk() const { return !mPath.isEmpty() && FileStamp::of(mPath) != mStamp; }

    /// Null until it is open; another one after a reload.
    commands::AnimationContext *context() const { return mContext.get(); }
    views::Player &player() { return mPlayer; }
    /// What it lost of its original; not saved.
    views::Comparison &comparison() { return mComparison; }
    /// Of the file as it was last read or written.
    const std::optional<views::FileFacts> &fileFacts() const { return mFacts; }

signals:
    /// Opened for the first time, or anew.
    void opened();
    void failed(const model::Error &error);
    void saved();
    void saveFailed(const model::Error &error);
    /// Title, modified, opening or saving: what a tab shows.
    void stateChanged();
    /// Before context() is replaced or destroyed.
    void aboutToBeReplaced();

private:
    /// All that saving writes, besides the source.
    struct Content
    {
        model::Timing timing;
        model::Similarity placement;
        std::string name;
        model::CompressionSettings compression;

        static Content of(const model::AnimationDocument &document);
        friend bool operator==(const Content &, const Content &) = default;
    };

    void take(std::shared_ptr<const model::codec::DecodedAnimation> animation);
    void contentChanged(const model::AnimationChange &change);
    void updateModified();

    QString mSource; ///< as given to open()
    QString mPath;
    std::optional<Cut> mCut;
    FileStamp mStamp;
    std::optional<views::FileFacts> mFacts;
    std::unique_ptr<model::AnimationDocument> mDocument;
    std::unique_ptr<commands::AnimationContext> mContext;
    std::optional<Content> mSavedContent;
    bool mWasModified = false;
    views::Player mPlayer;
    views::Comparison mComparison{mPlayer};
    // Last: destroyed first, so that no result comes to what is half gone.
    views::Job mOpening;
    views::Job mSaving;
};

} // namespace editor
