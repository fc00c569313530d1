// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/picturefiles.h"

#include "model/io/savefile.h"

#include <QBuffer>
#include <QDir>
#include <QFile>

namespace views {

using namespace model;

namespace {

/// Takes no more once the work was cancelled: to write a large picture takes a second and more.
class StoppableBuffer final : public QBuffer
{
public:
    explicit StoppableBuffer(const Progress &progress)
        : mProgress(progress)
    {}

protected:
    qint64 writeData(const char *data, qint64 size) override
    {
        return mProgress.isCancelled() ? -1 : QBuffer::writeData(data, size);
    }

private:
    const Progress mProgress;
};

QString pictureName(std::size_t index)
{
    return QStringLiteral("frame_%1.png").arg(index + 1, 4, 10, QLatin1Char('0'));
}

Result<void> writeAll(const QDir &folder, std::size_t count, const DrawPicture &draw, const Progress &progress,
                      QStringList &written)
{
    for (std::size_t i = 0; i < count; ++i) {
        const std::optional<QImage> picture = draw(i, progress);
        if (!picture || progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        if (picture->isNull())
            return fail(ErrorCode::OutOfMemory);
        const QString path = folder.filePath(pictureName(i));
        if (const auto saved = savePng(path, *picture, progress); !saved)
            return saved;
        written << path;
        progress.report(double(i + 1) / double(count));
    }
    return {};
}

} // namespace

Result<void> savePng(const QString &path, const QImage &picture, const Progress &progress)
{
    StoppableBuffer buffer(progress);
    buffer.open(QIODevice::WriteOnly);
    const bool isWhole = picture.save(&buffer, "PNG");
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    if (!isWhole)
        return fail(ErrorCode::OutOfMemory);
    const QByteArray &png = buffer.data();
    return io::saveBytes(path, {reinterpret_cast<const std::uint8_t *>(png.constData()), std::size_t(png.size())});
}

Result<void> savePictures(const QString &folder, std::size_t count, const DrawPicture &draw, const Progress &progress)
{
    const bool wasThere = QDir(folder).exists();
    if (!QDir().mkpath(folder))
        return fail(
            Error{ErrorCode::CannotWrite, {"cannot make the folder"}, folder.toStdString(), Error::None, Error::None});
    QStringList written;
    auto outcome = writeAll(QDir(folder), count, draw, progress, written);
    if (!outcome) {
        for (const QString &path : written)
            QFile::remove(path);
        if (!wasThere)
            QDir().rmdir(folder);
    }
    return outcome;
}

Result<void> savePictures(const QString &folder, const FrameSourcePtr &source, const std::vector<std::uint32_t> &order,
                          const DrawFrame &draw, const Progress &progress)
{
    const auto drawFrame = [&](std::size_t picture, const Progress &of) {
        const auto data = std::make_shared<FrameData>();
        makeFrame(source, order[picture], *data);
        return draw(data, of);
    };
    return savePictures(folder, order.size(), drawFrame, progress);
}

} // namespace views
