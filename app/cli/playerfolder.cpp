// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/playerfolder.h"

#include "model/io/failure.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

namespace cli {

namespace {

using model::ErrorCode;
using model::io::failIn;

constexpr QLatin1String ListName("list.json");
constexpr QLatin1String PageName("index.html");
constexpr QLatin1String ScriptName("player.js");

constexpr int ListVersion = 1;

/// Where the page is, seen from the program: installed, or where `build_player` of app/setup.sh puts it.
QStringList pageFolders()
{
    if (const QString chosen = qEnvironmentVariable("SANDREEL_PLAYER"); !chosen.isEmpty())
        return {chosen};
    const QDir program(QCoreApplication::applicationDirPath());
    return {QDir::cleanPath(program.filePath(QStringLiteral("../share/sandreel/player"))),
            QDir::cleanPath(program.filePath(QStringLiteral("../../web/player")))};
}

/// Whether a folder may be replaced: it is empty, or an earlier export.
bool isReplaceable(const QString &path)
{
    const QDir folder(path);
    return folder.isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot) ||
           (folder.exists(ListName) && folder.exists(PageName) && folder.exists(ScriptName));
}

} // namespace

PlayerFolder::PlayerFolder(const QString &path, const QString &part)
    : mPath(path)
    , mPart(part)
{}

model::Result<std::unique_ptr<PlayerFolder>> PlayerFolder::begin(const QString &path)
{
    const QFileInfo place(QDir::cleanPath(path));
    if (place.exists() && !place.isDir())
        return failIn(path, ErrorCode::CannotWrite, "it is not a folder");
    if (place.isDir() && !isReplaceable(place.absoluteFilePath()))
        return failIn(path, ErrorCode::CannotWrite, "the folder holds other files");
    const QStringList candidates = pageFolders();
    QString page;
    for (const QString &candidate : candidates)
        if (page.isEmpty() && QFileInfo(candidate + QLatin1Char('/') + PageName).isFile())
            page = candidate;
    if (page.isEmpty())
        return failIn(candidates.last() + QLatin1Char('/') + PageName, ErrorCode::NotFound);

    std::unique_ptr<PlayerFolder> folder(
        new PlayerFolder(place.absoluteFilePath(), place.absoluteFilePath() + QStringLiteral(".part-XXXXXX")));
    if (!folder->mPart.isValid())
        return failIn(path, ErrorCode::CannotWrite, folder->mPart.errorString().toStdString());
    for (const QFileInfo &file : QDir(page).entryInfoList(QDir::Files)) {
        QFile source(file.filePath());
        if (!source.open(QIODevice::ReadOnly))
            return failIn(file.filePath(), ErrorCode::CannotRead, source.errorString().toStdString());
        if (const auto written = folder->write(file.fileName(), source.readAll()); !written)
            return model::fail(written.error());
    }
    return folder;
}

model::Result<void> PlayerFolder::write(const QString &name, const QByteArray &bytes)
{
    const QString path = mPart.filePath(name);
    if (QFileInfo::exists(path)) // names tell the content
        return {};
    QFile file(path);
    if (!QDir().mkpath(QFileInfo(path).path()) || !file.open(QIODevice::WriteOnly) ||
        file.write(bytes) != bytes.size() || !file.flush())
        return failIn(mPath + QLatin1Char('/') + name, ErrorCode::CannotWrite, file.errorString().toStdString());
    return {};
}

model::Result<void> PlayerFolder::finish(const QJsonArray &animations)
{
    const QJsonObject list{{"version", ListVersion}, {"animations", animations}};
    if (auto written = write(ListName, QJsonDocument(list).toJson()); !written)
        return written;
    // A temporary folder is its owner's alone; a web server has to read this one.
    constexpr auto Readable = QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner | QFile::ReadGroup |
                              QFile::ExeGroup | QFile::ReadOther | QFile::ExeOther;
    QFile::setPermissions(mPart.path(), Readable);
    const QString old = mPart.path() + QStringLiteral(".old");
    const bool replaces = QFileInfo::exists(mPath);
    if (replaces && !QDir().rename(mPath, old))
        return failIn(mPath, ErrorCode::CannotWrite, "the old folder cannot be moved away");
    if (!QDir().rename(mPart.path(), mPath)) {
        if (replaces)
            QDir().rename(old, mPath);
        return failIn(mPath, ErrorCode::CannotWrite, "the folder cannot be put in place");
    }
    mPart.setAutoRemove(false);
    if (replaces)
        QDir(old).removeRecursively();
    return {};
}

} // namespace cli
