// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/documents/documentkind.h"

#include "app/editor/documents/animationtab.h"
#include "app/editor/documents/terraintab.h"

#include <QCoreApplication>
#include <QFileInfo>

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
    const char *ending;
    const char *files; ///< in the translation context "Documents"
    DocumentTab *(*makeTab)(bool canDraw);
};

constexpr Traits Kinds[] = {
    {DocumentKind::Animation, "animation", "anim", QT_TRANSLATE_NOOP("Documents", "Animations"), make<AnimationTab>},
    {DocumentKind::Terrain, "terrain", "terrain", QT_TRANSLATE_NOOP("Documents", "Terrains"), make<TerrainTab>},
};

const Traits &traitsOf(DocumentKind kind)
{
    const Traits &traits = Kinds[std::size_t(kind)];
    Q_ASSERT(traits.kind == kind);
    return traits;
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
    return QLatin1String(traitsOf(kind).ending);
}

QString filterOf(DocumentKind kind)
{
    return QStringLiteral("%1 (*.%2)")
        .arg(QCoreApplication::translate("Documents", traitsOf(kind).files), endingOf(kind));
}

std::optional<DocumentKind> kindOfFile(const QString &path)
{
    const QString ending = QFileInfo(path).suffix();
    for (const DocumentKind kind : EveryDocumentKind)
        if (ending.compare(endingOf(kind), Qt::CaseInsensitive) == 0)
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

} // namespace editor
