// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/filebuffer.h"

#include "model/io/failure.h"

#include <algorithm>
#include <new>

#include <QFileInfo>

namespace model::io {

Result<void> openFile(QFile &file)
{
    const QFileInfo info(file.fileName());
    if (!info.exists())
        return failIn(file.fileName(), ErrorCode::NotFound);
    if (info.isDir())
        return failIn(file.fileName(), ErrorCode::CannotOpen, QT_TRANSLATE_NOOP("ErrorText", "it is a folder"));
    if (!info.isFile())
        return failIn(file.fileName(), ErrorCode::CannotOpen,
                      QT_TRANSLATE_NOOP("ErrorText", "it is not an ordinary file"));
    if (!file.open(QIODevice::ReadOnly | QIODevice::Unbuffered))
        return failIn(file.fileName(), ErrorCode::CannotOpen, file.errorString().toStdString());
    return {};
}

Result<std::uint64_t> readInto(QFile &file, char *out, std::uint64_t count, const Progress &progress)
{
    constexpr std::uint64_t Piece = 8 << 20; // a few milliseconds, so that a cancel is noticed
    std::uint64_t done = 0;
    while (done < count) {
        if (progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        const qint64 got = file.read(out + done, qint64(std::min(Piece, count - done)));
        if (got < 0)
            return failIn(file.fileName(), ErrorCode::CannotRead, file.errorString().toStdString());
        if (got == 0)
            break;
        done += std::uint64_t(got);
    }
    return done;
}

Result<std::string_view> FileBuffer::load(const QString &path, const Progress &progress)
{
    QFile file(path);
    if (const auto opened = openFile(file); !opened)
        return fail(opened.error());
    const auto size = std::uint64_t(file.size());
    if (size > MaxFileBytes)
        return failIn(path, ErrorCode::LimitExceeded, QT_TRANSLATE_NOOP("ErrorText", "the size of the file in bytes"),
                      std::to_string(size), std::to_string(MaxFileBytes));
    if (size > mCapacity) {
        // A little more, so that frames of slightly growing length do not allocate each time.
        const std::uint64_t capacity = size + size / 16;
        mMemory.reset();
        mCapacity = 0;
        mMemory.reset(new (std::nothrow) char[capacity]);
        if (!mMemory)
            return failIn(path, ErrorCode::OutOfMemory, std::to_string(capacity));
        mCapacity = capacity;
    }
    const auto got = readInto(file, mMemory.get(), size, progress);
    if (!got)
        return failIn(path, got.error());
    return std::string_view(mMemory.get(), *got);
}

} // namespace model::io
