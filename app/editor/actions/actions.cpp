// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/actions/actions.h"

#include "views/widgets/icons.h"

#include <QCoreApplication>
#include <QWidget>

namespace editor {

namespace {

struct Spec
{
    ActionId id;
    const char *key;
    const char *menu;
    const char *text;
    const char *icon;
    const char *shortcuts; ///< separated by "; ", portable text
    const char *tip;       ///< for the status bar
    bool checkable = false;
    std::optional<DocumentKind> kind = {};
};

constexpr std::optional<DocumentKind> Animation = DocumentKind::Animation;
constexpr std::optional<DocumentKind> Terrain = DocumentKind::Terrain;

constexpr const char *File = QT_TRANSLATE_NOOP("Actions", "&File");
constexpr const char *Edit = QT_TRANSLATE_NOOP("Actions", "&Edit");
constexpr const char *TerrainMenu = QT_TRANSLATE_NOOP("Actions", "&Terrain");
constexpr const char *View = QT_TRANSLATE_NOOP("Actions", "&View");
constexpr const char *Settings = QT_TRANSLATE_NOOP("Actions", "&Settings");
constexpr const char *Help = QT_TRANSLATE_NOOP("Actions", "&Help");

// clang-format off
constexpr Spec Specs[] = {
    {ActionId::Prepare, "file.prepare", File, QT_TRANSLATE_NOOP("Actions", "&Prepare Animation…"), "prepare", "Ctrl+N",
     QT_TRANSLATE_NOOP("Actions", "Turn a folder of meshes, a point cache or a scene into an .anim file")},
    {ActionId::NewTerrain, "file.newTerrain", File, QT_TRANSLATE_NOOP("Actions", "&New Terrain…"), "new-terrain",
     "Ctrl+Shift+N", QT_TRANSLATE_NOOP("Actions", "Make a terrain: flat, dunes or hills")},
    {ActionId::ImportTerrain, "file.importTerrain", File, QT_TRANSLATE_NOOP("Actions", "&Import Terrain…"),
     "import-terrain", "Ctrl+I",
     QT_TRANSLATE_NOOP("Actions", "Make a terrain of an elevation model, of points or of a mesh")},
    {ActionId::Open, "file.open", File, QT_TRANSLATE_NOOP("Actions", "&Open…"), "open", "Ctrl+O",
     QT_TRANSLATE_NOOP("Actions", "Open an animation, a terrain or a mesh")},
    {ActionId::Save, "file.save", File, QT_TRANSLATE_NOOP("Actions", "&Save"), "save", "Ctrl+S",
     QT_TRANSLATE_NOOP("Actions", "Save the document to its file")},
    {ActionId::SaveAs, "file.saveAs", File, QT_TRANSLATE_NOOP("Actions", "Save &As…"), "save-as", "Ctrl+Shift+S",
     QT_TRANSLATE_NOOP("Actions", "Save the document to another file")},
    {ActionId::ExportFrames, "file.exportFrames", File, QT_TRANSLATE_NOOP("Actions", "&Frames…"), "frames", "",
     QT_TRANSLATE_NOOP("Actions", "Write every frame as an OBJ, OFF or PLY file"), false, Animation},
    {ActionId::ExportPointCache, "file.exportPointCache", File, QT_TRANSLATE_NOOP("Actions", "Point &Cache…"),
     "point-cache", "", QT_TRANSLATE_NOOP("Actions", "Write all positions as one PC2 point cache"), false, Animation},
    {ActionId::ExportScreenshot, "file.exportScreenshot", File, QT_TRANSLATE_NOOP("Actions", "&Screenshot…"),
     "screenshot", "Ctrl+Shift+P", QT_TRANSLATE_NOOP("Actions", "Write a picture of the frame shown"), false, Animation},
    {ActionId::ExportPictures, "file.exportPictures", File, QT_TRANSLATE_NOOP("Actions", "Picture Se&quence…"), "film",
     "", QT_TRANSLATE_NOOP("Actions", "Write the playback as numbered PNG pictures"), false, Animation},
    {ActionId::ExportTerrain, "file.exportTerrain", File, QT_TRANSLATE_NOOP("Actions", "&Terrain…"), "export-terrain",
     "Ctrl+Shift+E", QT_TRANSLATE_NOOP("Actions", "Write the terrain as a mesh, a raster or contours"), false, Terrain},
    {ActionId::TerrainScreenshot, "file.terrainScreenshot", File, QT_TRANSLATE_NOOP("Actions", "&Screenshot…"),
     "screenshot", "Ctrl+Shift+P", QT_TRANSLATE_NOOP("Actions", "Write a picture of the terrain"), false, Terrain},
    {ActionId::Turntable, "file.turntable", File, QT_TRANSLATE_NOOP("Actions", "T&urntable…"), "film", "",
     QT_TRANSLATE_NOOP("Actions", "Write pictures from all around the terrain"), false, Terrain},
    {ActionId::Reload, "file.reload", File, QT_TRANSLATE_NOOP("Actions", "&Reload"), "reload", "F5",
     QT_TRANSLATE_NOOP("Actions", "Read the file again; the camera stays")},
    {ActionId::CloseTab, "file.close", File, QT_TRANSLATE_NOOP("Actions", "&Close"), "close", "Ctrl+W",
     QT_TRANSLATE_NOOP("Actions", "Close the document")},
    {ActionId::Quit, "file.quit", File, QT_TRANSLATE_NOOP("Actions", "&Quit"), "quit", "Ctrl+Q",
     QT_TRANSLATE_NOOP("Actions", "Close all documents and quit")},

    {ActionId::Undo, "edit.undo", Edit, QT_TRANSLATE_NOOP("Actions", "&Undo"), "undo", "Ctrl+Z",
     QT_TRANSLATE_NOOP("Actions", "Take back the last step")},
    {ActionId::Redo, "edit.redo", Edit, QT_TRANSLATE_NOOP("Actions", "&Redo"), "redo", "Ctrl+Shift+Z; Ctrl+Y",
     QT_TRANSLATE_NOOP("Actions", "Carry out the step that was taken back")},
    {ActionId::Trim, "edit.trim", Edit, QT_TRANSLATE_NOOP("Actions", "&Trim to Range…"), "trim", "Ctrl+T",
     QT_TRANSLATE_NOOP("Actions", "Keep only a range of frames"), false, Animation},
    {ActionId::Reverse, "edit.reverse", Edit, QT_TRANSLATE_NOOP("Actions", "Re&verse"), "reverse", "Ctrl+Shift+R",
     QT_TRANSLATE_NOOP("Actions", "Make the last frame the first"), false, Animation},
    {ActionId::Resample, "edit.resample", Edit, QT_TRANSLATE_NOOP("Actions", "Re&sample…"), "resample", "Ctrl+R",
     QT_TRANSLATE_NOOP("Actions", "The same speed with more or fewer frames"), false, Animation},
    {ActionId::FrameRate, "edit.frameRate", Edit, QT_TRANSLATE_NOOP("Actions", "&Frame Rate…"), "frame-rate", "",
     QT_TRANSLATE_NOOP("Actions", "The same frames, played faster or slower"), false, Animation},
    {ActionId::Normalise, "edit.normalise", Edit, QT_TRANSLATE_NOOP("Actions", "&Normalise…"), "normalise", "",
     QT_TRANSLATE_NOOP("Actions", "Move and scale the animation into the unit cube"), false, Animation},
    {ActionId::Rename, "edit.rename", Edit, QT_TRANSLATE_NOOP("Actions", "Re&name…"), "rename", "F2",
     QT_TRANSLATE_NOOP("Actions", "Give the animation another name"), false, Animation},
    {ActionId::Sculpt, "edit.sculpt", TerrainMenu, QT_TRANSLATE_NOOP("Actions", "Scu&lpt"), "sculpt", "D",
     QT_TRANSLATE_NOOP("Actions", "The left button draws with the tool; else it turns the picture"), true, Terrain},

    {ActionId::Record, "terrain.record", TerrainMenu, QT_TRANSLATE_NOOP("Actions", "&Record as Animation"), "film", "Ctrl+Alt+R",
     QT_TRANSLATE_NOOP("Actions", "Record what happens to the terrain; again: stop, and show it as an animation"), true,
     Terrain},

    {ActionId::Shaded, "view.shaded", View, QT_TRANSLATE_NOOP("Actions", "&Shaded"), "shaded", "1",
     QT_TRANSLATE_NOOP("Actions", "Draw smooth surfaces"), true, Animation},
    {ActionId::ShadedWireframe, "view.shadedWireframe", View, QT_TRANSLATE_NOOP("Actions", "Shaded with &Edges"),
     "shaded-wireframe", "2", QT_TRANSLATE_NOOP("Actions", "Draw surfaces and the edges of their triangles"), true, Animation},
    {ActionId::Wireframe, "view.wireframe", View, QT_TRANSLATE_NOOP("Actions", "&Wireframe"), "wireframe", "3",
     QT_TRANSLATE_NOOP("Actions", "Draw only the edges of the triangles"), true, Animation},
    {ActionId::Points, "view.points", View, QT_TRANSLATE_NOOP("Actions", "&Points"), "points", "4",
     QT_TRANSLATE_NOOP("Actions", "Draw only the vertices"), true, Animation},
    {ActionId::Statistics, "view.statistics", View, QT_TRANSLATE_NOOP("Actions", "S&tatistics"), "statistics", "T",
     QT_TRANSLATE_NOOP("Actions", "Show sizes and times over the picture"), true, Animation},
    {ActionId::Compare, "view.compare", View, QT_TRANSLATE_NOOP("Actions", "&Compare with Original…"), "compare",
     "Ctrl+Shift+C", QT_TRANSLATE_NOOP("Actions", "Show what this animation lost of another one"), false, Animation},
    {ActionId::StopComparing, "view.stopComparing", View, QT_TRANSLATE_NOOP("Actions", "St&op Comparing"), "close", "",
     QT_TRANSLATE_NOOP("Actions", "Forget the original"), false, Animation},
    {ActionId::ErrorColors, "view.errorColors", View, QT_TRANSLATE_NOOP("Actions", "Colour by &Error"), "error-colors",
     "C", QT_TRANSLATE_NOOP("Actions", "Colour the mesh by how far each vertex is from the original"), true, Animation},
    {ActionId::ErrorRange, "view.errorRange", View, QT_TRANSLATE_NOOP("Actions", "Colour &Range of This Frame"),
     "error-range", "", QT_TRANSLATE_NOOP("Actions", "Let the colours reach to the frame's largest error instead of "
                                                     "that of all frames"), true, Animation},
    {ActionId::InspectFrame, "view.inspectFrame", View, QT_TRANSLATE_NOOP("Actions", "&Inspect Frame"), "inspector",
     "Ctrl+Shift+I", QT_TRANSLATE_NOOP("Actions", "Open the frame shown as a mesh, to see what it is made of"), false,
     Animation},
    {ActionId::Fit, "view.fit", View, QT_TRANSLATE_NOOP("Actions", "&Fit to Window"), "fit", "F",
     QT_TRANSLATE_NOOP("Actions", "Move the camera so that everything is seen")},
    {ActionId::NextTab, "view.nextTab", View, QT_TRANSLATE_NOOP("Actions", "&Next Document"), "", "Ctrl+Tab; Ctrl+PgDown",
     QT_TRANSLATE_NOOP("Actions", "Show the next tab")},
    {ActionId::PreviousTab, "view.previousTab", View, QT_TRANSLATE_NOOP("Actions", "Pre&vious Document"), "",
     "Ctrl+Shift+Tab; Ctrl+PgUp", QT_TRANSLATE_NOOP("Actions", "Show the previous tab")},
    {ActionId::FullScreen, "view.fullScreen", View, QT_TRANSLATE_NOOP("Actions", "F&ull Screen"), "full-screen", "F11",
     QT_TRANSLATE_NOOP("Actions", "Use the whole screen"), true},

    {ActionId::ConfigureShortcuts, "settings.shortcuts", Settings,
     QT_TRANSLATE_NOOP("Actions", "Configure &Shortcuts…"), "settings", "",
     QT_TRANSLATE_NOOP("Actions", "Choose the keys of every action")},

    {ActionId::ShortcutList, "help.shortcuts", Help, QT_TRANSLATE_NOOP("Actions", "&Keyboard Shortcuts"), "keyboard",
     "Ctrl+?; F1", QT_TRANSLATE_NOOP("Actions", "Show all keys on one page")},
    {ActionId::Licences, "help.licences", Help, QT_TRANSLATE_NOOP("Actions", "&Licences"), "log", "",
     QT_TRANSLATE_NOOP("Actions", "The libraries that Sandreel is made with, and their licences")},
    {ActionId::About, "help.about", Help, QT_TRANSLATE_NOOP("Actions", "&About Sandreel"), "info", "",
     QT_TRANSLATE_NOOP("Actions", "What this program is")},
};
// clang-format on

QString translated(const char *text)
{
    return QCoreApplication::translate("Actions", text);
}

} // namespace

QString plainTitle(QString text)
{
    text.replace(QLatin1String("&&"), QLatin1String("\x01"));
    text.remove(QLatin1Char('&'));
    text.replace(QLatin1Char('\x01'), QLatin1Char('&'));
    if (text.endsWith(QChar(0x2026)))
        text.chop(1);
    return text;
}

QString Actions::Entry::title() const
{
    return plainTitle(action->text());
}

Actions::Actions(QWidget &window)
    : mWindow(window)
{
    for (const Spec &spec : Specs) {
        auto *action = new QAction(&window);
        action->setObjectName(QLatin1String(spec.key));
        if (*spec.icon)
            action->setIcon(views::icon(QLatin1String(spec.icon)));
        action->setCheckable(spec.checkable);
        QList<QKeySequence> shortcuts;
        if (*spec.shortcuts)
            shortcuts = QKeySequence::listFromString(QLatin1String(spec.shortcuts));
        action->setShortcuts(shortcuts);
        window.addAction(action);
        mById.emplace(spec.id, action);
        mEntries.push_back({action, spec.menu, shortcuts, spec.kind});
    }
    retranslate();
}

void Actions::adopt(QAction &action, const char *menu, std::optional<DocumentKind> kind)
{
    mWindow.addAction(&action);
    mEntries.push_back({&action, menu, action.shortcuts(), kind});
}

void Actions::showFor(DocumentKind kind)
{
    for (const Entry &entry : mEntries)
        if (entry.kind)
            entry.action->setVisible(entry.kind == kind);
}

void Actions::retranslate()
{
    for (const Spec &spec : Specs) {
        QAction &action = *mById.at(spec.id);
        action.setText(translated(spec.text));
        action.setStatusTip(translated(spec.tip));
    }
    setUndoTexts(mUndoText, mRedoText);
}

void Actions::setUndoTexts(const QString &undo, const QString &redo)
{
    mUndoText = undo;
    mRedoText = redo;
    mById.at(ActionId::Undo)
        ->setText(undo.isEmpty() ? translated("&Undo") : QCoreApplication::translate("Actions", "&Undo %1").arg(undo));
    mById.at(ActionId::Redo)
        ->setText(redo.isEmpty() ? translated("&Redo") : QCoreApplication::translate("Actions", "&Redo %1").arg(redo));
}

} // namespace editor
