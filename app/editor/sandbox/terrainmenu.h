// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <functional>
#include <vector>

class QAction;
class QActionGroup;

namespace editor {

class Actions;
class Menus;
class Sandbox;

/// The menu Terrain: everything that the docks of the sandbox do, for the menu, for keys and for the shortcut editor.
class TerrainMenu final : public QObject
{
    Q_OBJECT

public:
    TerrainMenu(Actions &actions, Menus &menus, Sandbox &sandbox);

    void retranslate();

private:
    /// Of rows() that follow each other in the menu.
    enum RowGroup { ToolRows, MaskRows };
    struct Row;
    static const std::vector<Row> &rows();

    void makeTools(Menus &menus);
    void makeSymmetries(Menus &menus);
    void makeRows(Menus &menus, RowGroup group);
    /// An action of the menu that the shortcut editor knows. \param text  asked in each language
    QAction &add(const QString &name, const QString &iconName, const char *shortcut, std::function<QString()> text,
                 std::function<QString()> tip);
    QAction &named(const char *key) const;
    void follow();

    Actions &mActions;
    Sandbox &mSandbox;
    QActionGroup *mTools, *mSymmetries;
    std::vector<std::function<void()>> mTexts;
};

} // namespace editor
