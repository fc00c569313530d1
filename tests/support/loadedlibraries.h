// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QSet>
#include <QStringList>

namespace tests {

/// The files of the shared libraries that this process has loaded.
inline QStringList loadedLibraries()
{
    QFile maps(QStringLiteral("/proc/self/maps"));
    QSet<QString> files;
    if (maps.open(QIODevice::ReadOnly))
        for (const QByteArray &line : maps.readAll().split('\n'))
            if (const qsizetype path = line.indexOf('/'); path >= 0 && line.contains(".so"))
                files.insert(QString::fromLocal8Bit(line.mid(path)));
    return {files.begin(), files.end()};
}

/// Two Qts in one process crash; VTK of Debian is built with Qt 5.
inline QStringList loadedQt5Libraries()
{
    return loadedLibraries().filter(QStringLiteral("Qt5"));
}

} // namespace tests
