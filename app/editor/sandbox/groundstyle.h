// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/start/settings.h"
#include "views/terrain/terrainstyle.h"

#include <QObject>

#include <vector>

class QAction;
class QMenu;

namespace editor {

class Actions;
class Workspace;

/// How terrains are drawn, as a menu: what colours tell, lines on the ground, and how much work goes into the picture.
/// All terrains are drawn alike.
class GroundStyle final : public QObject
{
    Q_OBJECT

public:
    GroundStyle(Actions &actions, Workspace &workspace, QMenu &menu);

    void retranslate();
    /// Colours by the mask, for as long as it is painted; then as before.
    void showMask(bool isShown);

private:
    struct Row;
    static const std::vector<Row> &rows();

    void follow();

    Workspace &mWorkspace;
    views::TerrainStyle mStyle;
    std::vector<QAction *> mActions; ///< of the rows
    QAction *mBeforeMask = nullptr;
};

} // namespace editor
