// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>
#include <span>

namespace editor {

class AnimationTab;
class DocumentTab;
class TerrainTab;

enum class DocumentKind { Animation, Terrain };
inline constexpr DocumentKind EveryDocumentKind[] = {DocumentKind::Animation, DocumentKind::Terrain};

/// Under which settings know it: "animation".
const char *nameOf(DocumentKind kind);
/// Of its files, without dot.
QString endingOf(DocumentKind kind);
/// "Animations (*.anim)", as file dialogs take it.
QString filterOf(DocumentKind kind);
/// By a file's ending; nothing for files that are no documents.
std::optional<DocumentKind> kindOfFile(const QString &path);

/// An empty tab: its document is to be opened. \param canDraw  false without sufficient OpenGL
DocumentTab *makeTab(DocumentKind kind, bool canDraw);

// The one place that says what is in a tab. Null for null, and for tabs of another kind.
AnimationTab *asAnimation(DocumentTab *tab);
TerrainTab *asTerrain(DocumentTab *tab);

} // namespace editor
