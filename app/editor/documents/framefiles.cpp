// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/documents/framefiles.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>

namespace editor {

QString framePatternOf(const QString &path)
{
    const QFileInfo file(path);
    const QString name = file.completeBaseName();
    qsizetype end = name.size();
    while (end > 0 && !name[end - 1].isDigit())
        --end;
    qsizetype begin = end;
    while (begin > 0 && name[begin - 1].isDigit())
        --begin;
    if (begin == end)
        return {};
    const QString pattern = name.left(begin) + QLatin1Char('#') + name.mid(end);
    return file.absoluteDir().filePath(pattern + QLatin1Char('.') + file.suffix());
}

int alikeFileCount(const QString &path)
{
    const QString pattern = framePatternOf(path);
    if (pattern.isEmpty())
        return 1;
    const QDir folder = QFileInfo(path).absoluteDir();
    const QStringList names = folder.entryList({QStringLiteral("*.") + QFileInfo(path).suffix()}, QDir::Files);
    return std::max(1, int(std::count_if(names.begin(), names.end(), [&](const QString &name) {
                        return framePatternOf(folder.filePath(name)) == pattern;
                    })));
}

} // namespace editor
