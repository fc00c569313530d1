// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/showinfolder.h"

#include <QDesktopServices>
#include <QFileInfo>
#include <QUrl>

namespace views {

void showInFolder(const QString &path)
{
    const QFileInfo info(path);
    QDesktopServices::openUrl(QUrl::fromLocalFile(info.isDir() ? path : info.absolutePath()));
}

} // namespace views
