// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/recovery/recoveryentry.h"

#include "model/io/savefile.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <QUuid>

#include <algorithm>

namespace editor {

namespace {

const QString JournalPattern = QStringLiteral("*.journal");
const QString FactsFile = QStringLiteral("document.json");

QString rootFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/recovery");
}

/// Their names are numbers of one length: newest first.
QStringList journalsIn(const QString &folder)
{
    QStringList paths;
    const QDir place(folder);
    const QStringList names = place.entryList({JournalPattern}, QDir::Files, QDir::Name | QDir::Reversed);
    for (const QString &name : names)
        paths << place.filePath(name);
    return paths;
}

QJsonObject factsOf(const QString &folder)
{
    QFile file(QDir(folder).filePath(FactsFile));
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object() : QJsonObject();
}

} // namespace

RecoveryEntry::RecoveryEntry(const QString &folder)
    : mFolder(folder)
    , mLock(folder + QStringLiteral(".lock")) // beside it: the folder can then be removed while it is locked
{
    mLock.setStaleLockTime(0); // only a program that is gone has left its lock, however long ago
}

std::unique_ptr<RecoveryEntry> RecoveryEntry::make(const QString &title, const QString &path)
{
    const QString folder = QDir(rootFolder()).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces));
    if (!QDir().mkpath(rootFolder()))
        return nullptr;
    std::unique_ptr<RecoveryEntry> entry(new RecoveryEntry(folder));
    // The lock first: a program that starts now must not find the folder without it.
    if (!entry->mLock.tryLock() || !QDir().mkpath(folder))
        return nullptr;
    const QByteArray facts = QJsonDocument(QJsonObject{{"title", title}, {"path", path}}).toJson();
    const auto *const bytes = reinterpret_cast<const std::uint8_t *>(facts.constData());
    // Without them it is recovered all the same, under no name.
    (void)model::io::saveBytes(QDir(folder).filePath(FactsFile), {bytes, std::size_t(facts.size())});
    return entry;
}

std::unique_ptr<RecoveryEntry> RecoveryEntry::adopt(const QString &folder)
{
    std::unique_ptr<RecoveryEntry> entry(new RecoveryEntry(folder));
    return entry->mLock.tryLock() && QFileInfo::exists(folder) ? std::move(entry) : nullptr;
}

QString RecoveryEntry::newJournal() const
{
    const QStringList journals = journalsIn(mFolder);
    const int newest = journals.isEmpty() ? 0 : QFileInfo(journals.constFirst()).completeBaseName().toInt();
    return QDir(mFolder).filePath(QStringLiteral("%1.journal").arg(newest + 1, 6, 10, QLatin1Char('0')));
}

void RecoveryEntry::keepNewest(int count) const
{
    const QStringList old = journalsIn(mFolder).mid(count);
    for (const QString &path : old)
        QFile::remove(path);
}

void RecoveryEntry::remove()
{
    QDir(mFolder).removeRecursively();
}

std::vector<Leftover> RecoveryEntry::leftovers()
{
    std::vector<Leftover> result;
    const QDir root(rootFolder());
    const QStringList folders = root.entryList(QDir::Dirs | QDir::NoDotAndDotDot);
    for (const QString &name : folders) {
        const std::unique_ptr<RecoveryEntry> entry = adopt(root.filePath(name));
        if (!entry)
            continue;
        const QStringList journals = journalsIn(entry->folder());
        if (journals.isEmpty()) {
            entry->remove();
            continue;
        }
        const QJsonObject facts = factsOf(entry->folder());
        const QFileInfo newest(journals.constFirst());
        result.push_back({entry->folder(), facts["title"].toString(), facts["path"].toString(), newest.lastModified(),
                          newest.size(), journals});
    }
    std::sort(result.begin(), result.end(), [](const Leftover &a, const Leftover &b) { return a.changed > b.changed; });
    return result;
}

} // namespace editor
