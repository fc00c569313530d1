// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/sculpt/strokecontroller.h"
#include "views/sculpt/toolsettings.h"

#include <QObject>

#include <map>
#include <memory>

class QMainWindow;

namespace views {
class ErosionDock;
class MaterialDock;
class ToolsDock;
} // namespace views

namespace editor {

class Actions;
class TerrainTab;
class Workspace;

/// What is done to terrains: one set of tools for all tabs, in docks that follow the present one, and for each terrain
/// the strokes drawn on it and the sand that slides.
class Sandbox final : public QObject
{
    Q_OBJECT

public:
    Sandbox(Actions &actions, Workspace &workspace, QMainWindow &window);
    ~Sandbox() override;

    views::ToolsDock &tools() const { return *mTools; }
    views::ErosionDock &erosion() const { return *mErosion; }
    views::MaterialDock &materials() const { return *mMaterials; }

signals:
    /// The pointer is over another place of the present terrain; nothing beside it.
    void readingChanged(const std::optional<views::GroundReading> &reading);

private:
    /// What works on the ground of one tab.
    struct Work
    {
        views::GroundView *ground = nullptr;
        std::unique_ptr<views::StrokeController> strokes;
    };

    void follow();
    void changeGround(TerrainTab &tab);
    void forget(Work &work);
    views::StrokeController *strokes() const;

    Actions &mActions;
    Workspace &mWorkspace;
    views::ToolSettings mSettings;
    views::ToolsDock *mTools;
    views::ErosionDock *mErosion;
    views::MaterialDock *mMaterials;
    std::map<TerrainTab *, Work> mWork;
};

} // namespace editor
