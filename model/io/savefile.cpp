// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/savefile.h"

#include "model/io/failure.h"

#include <QFileInfo>

#ifdef Q_OS_UNIX
#include <cerrno>
#include <cstring>
#include <unistd.h>
#endif

namespace model::io {

SaveFile::SaveFile(const QString &path)
    : mFile(path)
{}

Result<void> SaveFile::open()
{
    const QFileInfo info(mFile.fileName());
    if (info.isDir())
        return failIn(mFile.fileName(), ErrorCode::CannotOpen, QT_TRANSLATE_NOOP("ErrorText", "it is a folder"));
    if (info.exists() && !info.isFile())
        return failIn(mFile.fileName(), ErrorCode::CannotOpen,
                      QT_TRANSLATE_NOOP("ErrorText", "it is not an ordinary file"));
    if (!mFile.open(QIODevice::WriteOnly | QIODevice::Unbuffered))
        return failIn(mFile, ErrorCode::CannotOpen);
    return {};
}

Result<void> SaveFile::write(std::span<const std::uint8_t> bytes)
{
    return writeAll(mFile, bytes);
}

Result<void> SaveFile::commit()
{
#ifdef Q_OS_UNIX
    // Some file systems find out only now that there is no room, and QSaveFile does not ask them.
    if (::fsync(mFile.handle()) != 0 && errno != EINVAL && errno != ENOTSUP)
        return failIn(mFile.fileName(), ErrorCode::CannotWrite, std::strerror(errno));
#endif
    if (!mFile.commit())
        return failIn(mFile, ErrorCode::CannotWrite);
    return {};
}

Result<void> saveBytes(const QString &path, std::span<const std::uint8_t> bytes)
{
    SaveFile file(path);
    return file.open().and_then([&] { return file.write(bytes); }).and_then([&] { return file.commit(); });
}

Result<void> writeAll(QFileDevice &file, std::span<const std::uint8_t> bytes)
{
    // A disk that fills up takes a part first; only the next call says why it takes no more.
    while (!bytes.empty()) {
        const qint64 taken = file.write(reinterpret_cast<const char *>(bytes.data()), qint64(bytes.size()));
        if (taken <= 0)
            return failIn(file, ErrorCode::CannotWrite);
        bytes = bytes.subspan(std::size_t(taken));
    }
    return {};
}

} // namespace model::io
