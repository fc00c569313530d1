// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/foundsource.h"

#include "model/animation/normalisation.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace views {

namespace {

struct FoundSourceText
{
    Q_DECLARE_TR_FUNCTIONS(views::FoundSource)
};

const QStringList MeshEndings{QStringLiteral("obj"), QStringLiteral("off"), QStringLiteral("ply"),
                              QStringLiteral("stl")};
const QStringList CacheEndings{QStringLiteral("pc2"), QStringLiteral("mdd")};

SourceKind kindOfFile(const QString &ending)
{
    if (MeshEndings.contains(ending))
        return SourceKind::Mesh;
    if (CacheEndings.contains(ending))
        return SourceKind::PointCache;
    if (ending == QLatin1String("anim"))
        return SourceKind::Encoded;
    return model::io::readableEndings().contains(ending) ? SourceKind::Scene : SourceKind::None;
}

QString formatOf(const QString &path, SourceKind kind)
{
    QString ending = QFileInfo(path).suffix().toUpper();
    switch (kind) {
    case SourceKind::None:
        return {};
    case SourceKind::Folder:
        if (const auto files = model::io::frameFilesIn(path); files && !files->isEmpty())
            ending = QFileInfo(files->first()).suffix().toUpper();
        return FoundSourceText::tr("Folder of %1 frames").arg(ending);
    case SourceKind::Mesh:
        return FoundSourceText::tr("%1 mesh").arg(ending);
    case SourceKind::PointCache:
        return FoundSourceText::tr("%1 point cache").arg(ending);
    case SourceKind::Scene:
        return FoundSourceText::tr("%1 scene").arg(ending);
    case SourceKind::Encoded:
        return FoundSourceText::tr("Encoded animation");
    }
    return {};
}

} // namespace

SourceKind sourceKindOf(const QString &path)
{
    const QFileInfo info(path);
    if (path.isEmpty() || !info.exists())
        return SourceKind::None;
    return info.isDir() ? SourceKind::Folder : kindOfFile(info.suffix().toLower());
}

QString sourceProblem(const QString &path)
{
    const QFileInfo info(path);
    if (!info.exists())
        return FoundSourceText::tr("There is no such file or folder.");
    if (!info.isReadable())
        return FoundSourceText::tr("You may not read it.");
    if (sourceKindOf(path) == SourceKind::None)
        return info.suffix().isEmpty()
                   ? FoundSourceText::tr("The file has no ending that tells its format.")
                   : FoundSourceText::tr("Files with the ending “.%1” cannot be read.").arg(info.suffix());
    return {};
}

model::Result<FoundSource> readSource(const QString &path, const model::io::ReadOptions &options,
                                      const model::Progress &progress)
{
    auto frames = model::io::readAnimation(path, options, progress.part(0, 0.9));
    if (!frames)
        return model::fail(frames.error());
    const auto box = model::boundingBoxOfAll(**frames, progress.part(0.9, 1));
    if (!box)
        return model::fail(box.error());
    const SourceKind kind = sourceKindOf(path);
    return FoundSource{path, kind, formatOf(path, kind), *frames, *box};
}

QString sourceFileFilter()
{
    const auto patterns = [](const QStringList &endings) {
        QStringList result;
        for (const QString &ending : endings)
            result << QStringLiteral("*.") + ending;
        return result.join(u' ');
    };
    const QStringList all = model::io::readableEndings();
    QStringList scenes;
    for (const QString &ending : all)
        if (kindOfFile(ending) == SourceKind::Scene)
            scenes << ending;
    return QStringList{FoundSourceText::tr("Everything Readable (%1)").arg(patterns(all)),
                       FoundSourceText::tr("Point Caches (%1)").arg(patterns(CacheEndings)),
                       FoundSourceText::tr("Scenes (%1)").arg(patterns(scenes)),
                       FoundSourceText::tr("Meshes (%1)").arg(patterns(MeshEndings)),
                       FoundSourceText::tr("Encoded Animations (%1)").arg(QStringLiteral("*.anim")),
                       FoundSourceText::tr("All Files (%1)").arg(QStringLiteral("*"))}
        .join(QStringLiteral(";;"));
}

} // namespace views
