// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QString>
#include <QStringList>

#include <memory>
#include <vector>

namespace editor {

/// What was left of a document by a program that ended without closing it.
struct Leftover
{
    QString folder;
    QString title;
    QString path;         ///< of the document; empty if it was never saved
    QDateTime changed;    ///< when something was last written
    qint64 bytes = 0;     ///< of the newest journal
    QStringList journals; ///< newest first: what cannot be read of one, an older one may give back
};

/// A folder in the program's data for the recovery journals of one document. While the object lives its folder is
/// locked, so that another program that runs, or starts, does not take the journals for left over.
class RecoveryEntry
{
public:
    /// A new folder; null if none can be made.
    static std::unique_ptr<RecoveryEntry> make(const QString &title, const QString &path);
    /// Null if somebody else has it.
    static std::unique_ptr<RecoveryEntry> adopt(const QString &folder);

    const QString &folder() const { return mFolder; }
    /// Where the next journal goes.
    QString newJournal() const;
    /// Removes all but the `count` newest journals.
    void keepNewest(int count) const;
    /// Removes everything.
    void remove();

    /// Of programs that are gone, newest first. Folders without a journal are removed.
    static std::vector<Leftover> leftovers();

private:
    explicit RecoveryEntry(const QString &folder);

    const QString mFolder;
    QLockFile mLock;
};

} // namespace editor
