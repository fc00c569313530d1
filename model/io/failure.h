// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"

#include <QFileDevice>
#include <QString>

/// Marks a phrase that becomes an argument of an Error, so that errorText() finds its translation.
#define SANDREEL_PHRASE(text) QT_TRANSLATE_NOOP("ErrorText", text)

namespace model::io {

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
