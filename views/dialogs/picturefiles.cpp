// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/picturefiles.h"

#include <QDir>
#include <QSaveFile>

namespace views {

using namespace model;

namespace {

Error fileError(ErrorCode code, const QFileDevice &file)
{
    return Error{code, {file.errorString().toStdString()}, file.fileName().toStdString(), Error::None, Error::None};
}

QString pictureName(std::size_t index)
{
    return QStringLiteral("frame_%1.png").arg(index + 1, 4, 10, QLatin1Char('0'));
}

Result<void> writeAll(const QDir &folder, const FrameSourcePtr &source, const std::vector<std::uint32_t> &order,
                      const DrawFrame &draw, const Progress &progress, QStringList &written)
{
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto data = std::make_shared<FrameData>();
        makeFrame(source, order[i], *data);
        const std::optional<QImage> picture = draw(data, progress);
        if (!picture || progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        if (picture->isNull())
            return fail(ErrorCode::OutOfMemory);
        const QString path = folder.filePath(pictureName(i));
        if (const auto saved = savePng(path, *picture); !saved)
            return saved;
        written << path;
        progress.report(double(i + 1) / double(order.size()));
    }
    return {};
}

} // namespace

Result<void> savePng(const QString &path, const QImage &picture)
{
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return fail(fileError(ErrorCode::CannotOpen, file));
    if (!picture.save(&file, "PNG") || !file.commit())
        return fail(fileError(ErrorCode::CannotWrite, file));
    return {};
}

Result<void> savePictures(const QString &folder, const FrameSourcePtr &source, const std::vector<std::uint32_t> &order,
                          const DrawFrame &draw, const Progress &progress)
{
    const bool wasThere = QDir(folder).exists();
    if (!QDir().mkpath(folder))
        return fail(
            Error{ErrorCode::CannotWrite, {"cannot make the folder"}, folder.toStdString(), Error::None, Error::None});
    QStringList written;
    auto outcome = writeAll(QDir(folder), source, order, draw, progress, written);
    if (!outcome) {
        for (const QString &path : written)
            QFile::remove(path);
        if (!wasThere)
            QDir().rmdir(folder);
    }
    return outcome;
}

} // namespace views
