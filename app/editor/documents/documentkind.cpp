// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/documents/documentkind.h"

#include "app/editor/documents/animationtab.h"
#include "app/editor/documents/meshtab.h"
#include "app/editor/documents/terraintab.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStringList>

namespace editor {

namespace {

template <class Tab>
DocumentTab *make(bool canDraw)
{
    return new Tab(canDraw);
}

struct Traits
{
    DocumentKind kind;
    const char *name;
    const char *endings; ///< the first is that of new files
    int writtenCount;    ///< so many of them, from the first, are saved too
    const char *files;   ///< in the translation context "Documents"
    DocumentTab *(*makeTab)(bool canDraw);
};

constexpr Traits Kinds[] = {
    {DocumentKind::Animation, "animation", "anim", 1, QT_TRANSLATE_NOOP("Documents", "Animations"), make<AnimationTab>},
    {DocumentKind::Terrain, "terrain", "terrain", 1, QT_TRANSLATE_NOOP("Documents", "Terrains"), make<TerrainTab>},
    {DocumentKind::Mesh, "mesh", "obj off ply stl glb gltf", 3, QT_TRANSLATE_NOOP("Documents", "Meshes"),
     make<MeshTab>},
};

const Traits &traitsOf(DocumentKind kind)
{
    const Traits &traits = Kinds[std::size_t(kind)];
    Q_ASSERT(traits.kind == kind);
    return traits;
}

QStringList endingsOf(DocumentKind kind)
{
    return QString::fromLatin1(traitsOf(kind).endings).split(QLatin1Char(' '));
}

QStringList writtenEndingsOf(DocumentKind kind)
{
    return endingsOf(kind).mid(0, traitsOf(kind).writtenCount);
}

QString filesOf(DocumentKind kind)
{
    return QCoreApplication::translate("Documents", traitsOf(kind).files);
}

template <class Tab>
Tab *cast(DocumentTab *tab, DocumentKind kind)
{
    return tab && tab->document().kind() == kind ? static_cast<Tab *>(tab) : nullptr;
}

} // namespace

const char *nameOf(DocumentKind kind)
{
    return traitsOf(kind).name;
}

QString endingOf(DocumentKind kind)
{
    return endingsOf(kind).constFirst();
}

QString filterOf(DocumentKind kind)
{
    return QStringLiteral("%1 (*.%2)").arg(filesOf(kind), endingsOf(kind).join(QStringLiteral(" *.")));
}

QString saveFilterOf(DocumentKind kind)
{
    const QStringList endings = writtenEndingsOf(kind);
    if (endings.size() == 1)
        return filterOf(kind);
    QStringList filters;
    for (const QString &ending : endings)
        filters << QStringLiteral("%1 (*.%2)").arg(ending.toUpper(), ending);
    return filters.join(QStringLiteral(";;"));
}

bool canSaveTo(DocumentKind kind, const QString &path)
{
    return writtenEndingsOf(kind).contains(QFileInfo(path).suffix(), Qt::CaseInsensitive);
}

std::optional<DocumentKind> kindOfFile(const QString &path)
{
    const QString ending = QFileInfo(path).suffix();
    for (const DocumentKind kind : EveryDocumentKind)
        if (endingsOf(kind).contains(ending, Qt::CaseInsensitive))
            return kind;
    return std::nullopt;
}

DocumentTab *makeTab(DocumentKind kind, bool canDraw)
{
    return traitsOf(kind).makeTab(canDraw);
}

AnimationTab *asAnimation(DocumentTab *tab)
{
    return cast<AnimationTab>(tab, DocumentKind::Animation);
}

TerrainTab *asTerrain(DocumentTab *tab)
{
    return cast<TerrainTab>(tab, DocumentKind::Terrain);
}

MeshTab *asMesh(DocumentTab *tab)
{
    return cast<MeshTab>(tab, DocumentKind::Mesh);
}

} // namespace editor
