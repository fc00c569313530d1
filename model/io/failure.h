// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"

#include <QFileDevice>
#include <QString>

namespace model::io {

// Arguments that are phrases are marked with QT_TRANSLATE_NOOP("ErrorText", ...), and errorText() translates them.

/// fail(code, args...) about a file.
template <class... Args>
tl::unexpected<Error> failIn(const QString &path, ErrorCode code, Args &&...args)
{
    return fail(fail(code, std::forward<Args>(args)...).value().in(path.toStdString()));
}

/// fail(code, args...) at a line of a text file.
template <class... Args>
tl::unexpected<Error> failAtLine(std::uint64_t line, ErrorCode code, Args &&...args)
{
    return fail(fail(code, std::forward<Args>(args)...).value().atLine(line));
}

/// fail(code, args...) at a byte of a binary file.
template <class... Args>
tl::unexpected<Error> failAtByte(std::uint64_t offset, ErrorCode code, Args &&...args)
{
    return fail(fail(code, std::forward<Args>(args)...).value().atByte(offset));
}

/// An error on its way up gets its file, unless it has one.
inline tl::unexpected<Error> failIn(const QString &path, Error error)
{
    return fail(std::move(error).in(path.toStdString()));
}

/// What the system says of the last operation on `file`.
inline tl::unexpected<Error> failIn(const QFileDevice &file, ErrorCode code)
{
    return failIn(file.fileName(), code, file.errorString().toStdString());
}

} // namespace model::io
