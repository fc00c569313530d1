// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"

#include <QByteArray>
#include <QJsonArray>
#include <QString>
#include <QTemporaryDir>

#include <memory>

namespace cli {

/// A folder with the player page, its animations and their list, being written: beside the place where it will be, and
/// moved there when it is whole. What is not finished leaves nothing behind.
class PlayerFolder
{
public:
    /// \error CannotWrite  something else is in that place, or it cannot be written to
    /// \error NotFound     the page was not built; the error names where it was looked for
    static model::Result<std::unique_ptr<PlayerFolder>> begin(const QString &path);

    /// \param name  relative to the folder. Bytes that are there under that name already are not written again.
    /// \error CannotWrite
    model::Result<void> write(const QString &name, const QByteArray &bytes);

    /// Writes the list and puts everything in place. An old folder goes only when the new one is there.
    /// \error CannotWrite
    model::Result<void> finish(const QJsonArray &animations);

private:
    PlayerFolder(const QString &path, const QString &part);

    QString mPath; ///< absolute
    QTemporaryDir mPart;
};

} // namespace cli
