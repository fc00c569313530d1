// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>
#include <span>

namespace editor {

class AnimationTab;
class DocumentTab;
class MeshTab;
class TerrainTab;

enum class DocumentKind { Animation, Terrain, Mesh };
inline constexpr DocumentKind EveryDocumentKind[] = {DocumentKind::Animation, DocumentKind::Terrain,
                                                     DocumentKind::Mesh};

/// Under which settings know it: "animation".
const char *nameOf(DocumentKind kind);
/// Of the files that it is saved to unless another is asked for, without dot.
QString endingOf(DocumentKind kind);
/// "Animations (*.anim)", as file dialogs take it to open files.
QString filterOf(DocumentKind kind);
/// The same for saving, a filter for each ending: "OBJ (*.obj);;OFF (*.off)".
QString saveFilterOf(DocumentKind kind);
/// It can be saved to a file of this ending; some are only read.
bool canSaveTo(DocumentKind kind, const QString &path);
/// By a file's ending; nothing for files that are no documents.
std::optional<DocumentKind> kindOfFile(const QString &path);

/// An empty tab: its document is to be opened. \param canDraw  false without sufficient OpenGL
DocumentTab *makeTab(DocumentKind kind, bool canDraw);

// The one place that says what is in a tab. Null for null, and for tabs of another kind.
AnimationTab *asAnimation(DocumentTab *tab);
TerrainTab *asTerrain(DocumentTab *tab);
MeshTab *asMesh(DocumentTab *tab);

} // namespace editor
