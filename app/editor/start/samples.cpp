// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/start/samples.h"

#include "app/editor/documents/documentkind.h"

#include <QCoreApplication>
#include <QDir>

namespace editor {

namespace {

constexpr std::pair<const char *, const char *> Names[] = {
    {"cloth", QT_TRANSLATE_NOOP("Samples", "Cloth")},
    {"dunes", QT_TRANSLATE_NOOP("Samples", "Dunes")},
    {"jellyfish", QT_TRANSLATE_NOOP("Samples", "Jellyfish")},
    {"walker", QT_TRANSLATE_NOOP("Samples", "Walker")},
};

} // namespace

QString sampleName(const QString &path)
{
    const QString stem = QFileInfo(path).completeBaseName();
    for (const auto &[file, name] : Names)
        if (stem == QLatin1String(file))
            return QCoreApplication::translate("Samples", name);
    return stem;
}

std::vector<Sample> samples()
{
    const QDir folder(QStringLiteral(":/samples"));
    std::vector<Sample> result;
    const QStringList files = folder.entryList(QDir::Files, QDir::Name);
    for (const QString &file : files)
        if (kindOfFile(file))
            result.push_back({folder.filePath(file), sampleName(file)});
    return result;
}

} // namespace editor
