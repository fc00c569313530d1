// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>

namespace editor {

/// By what it is noticed that another program wrote a file.
struct FileStamp
{
    qint64 size = -1; ///< -1: there is no such file
    QDateTime modified;

    static FileStamp of(const QString &path);
    friend bool operator==(const FileStamp &, const FileStamp &) = default;
};

} // namespace editor
