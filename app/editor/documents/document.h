// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/documents/documentkind.h"
#include "app/editor/documents/filestamp.h"
#include "commands/base/editcontext.h"
#include "model/base/error.h"
#include "views/jobs/job.h"

#include <QObject>
#include <QString>

namespace editor {

/// One document that is open, or being opened, with its file, and the opening and saving in the background. What is in
/// it, and how it is read and written, the kinds of documents say.
class Document : public QObject
{
    Q_OBJECT

public:
    virtual DocumentKind kind() const = 0;

    /// Begins to read a file; opened() or failed() follow. Again with the same path: reads it anew and drops all edits.
    /// A path in the program's resources is a sample: it opens without a file.
    void open(const QString &path);
    /// Precondition: canReload().
    void reload() { open(mSource); }
    /// failed(Cancelled) follows, unless it is too late.
    void cancelOpening() { mOpening.cancel(); }
    /// Begins to write the document as it is now; saved() or saveFailed() follow. What is edited meanwhile stays
    /// unsaved. Precondition: canSave().
    void save(const QString &path);

    /// The user closes it, whether it is saved or not: nothing of it is to be brought back.
    virtual void abandon() {}

    bool isOpening() const { return mOpening.isRunning(); }
    virtual bool isSaving() const { return mSaving.isRunning(); }
    bool isOpen() const { return context() != nullptr; }
    bool canSave() const { return isOpen() && !isSaving() && !isOpening(); }
    bool canReload() const { return canSave() && !mSource.isEmpty(); }
    views::Job &openingJob() { return mOpening; }
    views::Job &savingJob() { return mSaving; }

    /// Where it is saved; empty for what was not saved yet, as a sample.
    const QString &path() const { return mPath; }
    /// For tabs and titles: the file's name, or the sample's.
    virtual QString title() const;
    /// What it is as long as it has no path, as a sentence without a full stop.
    virtual QString origin() const;
    /// What is in it, in a few words: "1,234 vertices".
    virtual QString summary() const = 0;
    /// What the user should know of the file that was opened; mostly nothing.
    virtual QString warning() const { return {}; }

    /// Another program that has the file open, as text; mostly none.
    virtual QString holder() const { return {}; }

    /// There is something that the file does not hold.
    virtual bool isModified() const = 0;
    /// Another program wrote, or removed, the file since we read or wrote it.
    bool isChangedOnDisk() const { return !mPath.isEmpty() && FileStamp::of(mPath) != mStamp; }
    /// Of the file as it was last read or written.
    std::uint64_t fileBytes() const { return std::uint64_t(std::max<qint64>(0, mStamp.size)); }

    /// Null until it is open; another one after a reload.
    virtual commands::EditContext *context() const = 0;

signals:
    /// Opened for the first time, or anew.
    void opened();
    void failed(const model::Error &error);
    void saved();
    void saveFailed(const model::Error &error);
    /// Title, modified, opening or saving: what a tab shows.
    void stateChanged();
    /// Before context() is replaced or destroyed: kinds of documents emit it.
    void aboutToBeReplaced();

protected:
    explicit Document(QObject *parent);

    /// Begins to read `path` in openingJob(). Ends with finishOpening(), or emits failed().
    virtual void read(const QString &path) = 0;
    /// Begins to write the present state to `path` in savingJob(). Ends with finishSaving(), or emits saveFailed().
    virtual void write(const QString &path) = 0;

    /// \param stamp  of the file from before it was read: a later writer is then noticed
    void finishOpening(const FileStamp &stamp);
    /// \param step  of the undo stack that was written
    void finishSaving(const QString &path, const FileStamp &stamp, int step);
    /// As given to open(); empty for what comes from no file.
    const QString &source() const { return mSource; }
    /// Where it is saved from now on; empty: saving asks.
    void setPath(const QString &path) { mPath = path; }
    /// To be called when it may have become modified, or the file's.
    void updateModified();

private:
    QString mSource;
    QString mPath;
    FileStamp mStamp;
    bool mWasModified = false;
    views::Job mOpening;
    views::Job mSaving;
};

} // namespace editor
