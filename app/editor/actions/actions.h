// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/documents/documentkind.h"

#include <QAction>
#include <QKeySequence>
#include <QObject>

#include <map>
#include <vector>

namespace editor {

enum class ActionId {
    Prepare,
    NewTerrain,
    ImportTerrain,
    Open,
    Save,
    SaveAs,
    ExportFrames,
    ExportPointCache,
    ExportScreenshot,
    ExportPictures,
    ExportTerrain,
    TerrainScreenshot,
    Turntable,
    Reload,
    CloseTab,
    Quit,
    Undo,
    Redo,
    Trim,
    Reverse,
    Resample,
    FrameRate,
    Normalise,
    Rename,
    Sculpt,
    Record,
    Shaded,
    ShadedWireframe,
    Wireframe,
    Points,
    Statistics,
    Compare,
    StopComparing,
    ErrorColors,
    ErrorRange,
    InspectFrame,
    Fit,
    NextTab,
    PreviousTab,
    FullScreen,
    ConfigureShortcuts,
    ShortcutList,
    About,
    Licences,
};

/// All actions of the window, in one place: the menus are filled from here, and the shortcut editor and the list of
/// shortcuts show what is here. Texts follow the interface's language.
class Actions final : public QObject
{
    Q_OBJECT

public:
    /// An action with what the shortcut editor needs to know of it.
    struct Entry
    {
        QAction *action;
        const char *menu; ///< the menu it belongs to, in the translation context "Actions"
        QList<QKeySequence> defaultShortcuts;
        std::optional<DocumentKind> kind;                    ///< of the documents that it is for; nothing: any, or none
        QString key() const { return action->objectName(); } ///< under which its shortcuts are stored
        /// Its text as in a list: no mnemonic, no ellipsis.
        QString title() const;
    };

    explicit Actions(QWidget &window);

    QAction &operator[](ActionId id) const { return *mById.at(id); }

    /// Takes an action that somebody else made (and translates) into the lists; it must have an object name.
    void adopt(QAction &action, const char *menu, std::optional<DocumentKind> kind = {});

    /// Hides the actions that are for documents of another kind; their keys are then free for those that are seen.
    void showFor(DocumentKind kind);

    const std::vector<Entry> &entries() const { return mEntries; }
    void retranslate();

    /// Another step is undone and redone next: "Undo Trim to Frames 3–8".
    void setUndoTexts(const QString &undo, const QString &redo);

private:
    QWidget &mWindow;
    std::map<ActionId, QAction *> mById;
    std::vector<Entry> mEntries;
    QString mUndoText;
    QString mRedoText;
};

/// "&Open…" -> "Open"
QString plainTitle(QString text);

} // namespace editor
