// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/sandbox/feeling.h"
#include "views/haptics/forcearrow.h"
#include "views/haptics/handonground.h"
#include "views/sculpt/maskpainter.h"
#include "views/sculpt/profileline.h"
#include "views/sculpt/sharedground.h"
#include "views/sculpt/strokecontroller.h"
#include "views/sculpt/toolsettings.h"

#include <QObject>

#include <map>
#include <memory>

class QAction;
class QMainWindow;

namespace views {
class ErosionDock;
class MaterialDock;
class ProfileDock;
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
    views::ProfileDock &profile() const { return *mProfile; }
    views::ToolSettings &settings() { return mSettings; }
    Feeling &feeling() { return *mFeeling; }

    /// While it is checked, the left button draws the line of the cross-section.
    QAction &pickAction() { return *mPick; }
    /// While it is checked, the left button paints what is protected from tools.
    QAction &maskAction() { return *mPaint; }
    void clearMask();
    void invertMask();
    /// The tool of this kind draws from now on.
    void chooseTool(std::size_t kind);
    /// The present terrain, as it is now, is what it is compared with.
    void takeReference();

signals:
    /// The pointer is over another place of the present terrain; nothing beside it.
    void readingChanged(const std::optional<views::GroundReading> &reading);
    /// A stroke is over, and this is what there is to say of it.
    void strokeTold(const QString &text);
    /// Another terrain is in front, or none.
    void stateChanged();

private:
    /// What works on the ground of one tab.
    struct Work
    {
        views::GroundView *ground = nullptr;
        std::unique_ptr<views::StrokeController> strokes;
        std::unique_ptr<views::ProfileLine> profile;
        std::unique_ptr<views::MaskPainter> mask;
        std::unique_ptr<views::HandOnGround> hand;
        QPointer<views::ForceArrow> arrow;           ///< the viewport's; null without OpenGL
        std::unique_ptr<views::SharedGround> shared; ///< by strokes, profile, mask and hand
    };

    void follow();
    void changeGround(TerrainTab &tab);
    void begin(TerrainTab &tab, Work &work);
    void forget(Work &work);
    void shareGround();
    QList<QAction *> modes() const; ///< one of them at most is checked
    void showActive(TerrainTab &tab, const Work &work);
    Work *present();

    Actions &mActions;
    Workspace &mWorkspace;
    views::ToolSettings mSettings;
    views::ToolsDock *mTools;
    views::ErosionDock *mErosion;
    views::MaterialDock *mMaterials;
    QAction *mPick, *mPaint;
    Feeling *mFeeling;
    views::ProfileDock *mProfile;
    std::map<TerrainTab *, Work> mWork;
};

} // namespace editor
