// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/sandbox/groundstyle.h"

#include "app/editor/actions/actions.h"
#include "app/editor/documents/terraintab.h"
#include "app/editor/window/workspace.h"
#include "views/terrain/terrainviewport.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>

#include <algorithm>

namespace editor {

using views::GroundEdges;
using views::GroundLook;
using views::GroundOverlay;
using views::GroundQuality;
using views::TerrainStyle;

/// A choice among those of its group, or a switch of its own (group: null).
struct GroundStyle::Row
{
    const char *key;
    const char *group;
    const char *text; ///< null: a separator
    const char *tip;
    void (*apply)(TerrainStyle &, bool);
};

const std::vector<GroundStyle::Row> &GroundStyle::rows()
{
    static const std::vector<Row> all = {
        {"ground.material", "overlay", QT_TRANSLATE_NOOP("Actions", "Colour by &Material"),
         QT_TRANSLATE_NOOP("Actions", "Draw the ground as what it is made of"),
         [](TerrainStyle &s, bool) { s.overlay = GroundOverlay::None; }},
        {"ground.height", "overlay", QT_TRANSLATE_NOOP("Actions", "Colour by &Height"),
         QT_TRANSLATE_NOOP("Actions", "Colour the ground by its height"),
         [](TerrainStyle &s, bool) { s.overlay = GroundOverlay::Height; }},
        {"ground.slope", "overlay", QT_TRANSLATE_NOOP("Actions", "Colour by &Slope"),
         QT_TRANSLATE_NOOP("Actions", "Colour the ground by how steep it is"),
         [](TerrainStyle &s, bool) { s.overlay = GroundOverlay::Slope; }},
        {"ground.humidity", "overlay", QT_TRANSLATE_NOOP("Actions", "Colour by H&umidity"),
         QT_TRANSLATE_NOOP("Actions", "Colour the ground by how wet the layer on top is"),
         [](TerrainStyle &s, bool) { s.overlay = GroundOverlay::Humidity; }},
        {"ground.thickness", "overlay", QT_TRANSLATE_NOOP("Actions", "Colour by &Thickness"),
         QT_TRANSLATE_NOOP("Actions", "Colour the ground by how much loose material lies on the bedrock"),
         [](TerrainStyle &s, bool) { s.overlay = GroundOverlay::Thickness; }},
        {"ground.cutAndFill", "overlay", QT_TRANSLATE_NOOP("Actions", "Colour by Cut &and Fill"),
         QT_TRANSLATE_NOOP("Actions", "Colour the ground by how much lower or higher it is than the reference: when it "
                                      "was opened or saved, or the moment that was taken"),
         [](TerrainStyle &s, bool) { s.overlay = GroundOverlay::CutAndFill; }},
        {"ground.mask", "overlay", QT_TRANSLATE_NOOP("Actions", "Colour by Mas&k"),
         QT_TRANSLATE_NOOP("Actions", "Colour the ground by how far it is protected from tools"),
         [](TerrainStyle &s, bool) { s.overlay = GroundOverlay::Mask; }},
        {"ground.overlays", nullptr, nullptr, nullptr, nullptr},
        {"ground.contours", nullptr, QT_TRANSLATE_NOOP("Actions", "&Contour Lines"),
         QT_TRANSLATE_NOOP("Actions", "Draw lines of equal height"),
         [](TerrainStyle &s, bool isOn) { s.hasContours = isOn; }},
        {"ground.wireframe", nullptr, QT_TRANSLATE_NOOP("Actions", "&Edges of Triangles"),
         QT_TRANSLATE_NOOP("Actions", "Draw the triangles that the ground is made of"),
         [](TerrainStyle &s, bool isOn) { s.hasWireframe = isOn; }},
        {"ground.constraints", nullptr, QT_TRANSLATE_NOOP("Actions", "Constrained E&dges"),
         QT_TRANSLATE_NOOP("Actions", "Draw the edges that stamps and breaklines hold in place"),
         [](TerrainStyle &s, bool isOn) { s.edges = isOn ? GroundEdges::Constrained : GroundEdges::None; }},
        {"ground.active", nullptr, QT_TRANSLATE_NOOP("Actions", "Acti&ve Triangles"),
         QT_TRANSLATE_NOOP("Actions", "Mark the triangles that may still slide"),
         [](TerrainStyle &s, bool isOn) { s.hasActiveTriangles = isOn; }},
        {"ground.lines", nullptr, nullptr, nullptr, nullptr},
        {"ground.low", "quality", QT_TRANSLATE_NOOP("Actions", "&Low Quality"),
         QT_TRANSLATE_NOOP("Actions", "Plain shading, for computers without a graphics card"),
         [](TerrainStyle &s, bool) { s.quality = GroundQuality::Low; }},
        {"ground.medium", "quality", QT_TRANSLATE_NOOP("Actions", "Medium &Quality"),
         QT_TRANSLATE_NOOP("Actions", "Shadows and grains"),
         [](TerrainStyle &s, bool) { s.quality = GroundQuality::Medium; }},
        {"ground.high", "quality", QT_TRANSLATE_NOOP("Actions", "Hi&gh Quality"),
         QT_TRANSLATE_NOOP("Actions", "Grains on steep walls too, ripples and glints"),
         [](TerrainStyle &s, bool) { s.quality = GroundQuality::High; }},
        {"ground.reference", nullptr, QT_TRANSLATE_NOOP("Actions", "&Plain Recipe of Sand"),
         QT_TRANSLATE_NOOP("Actions", "A bump map with its contrast stretched, instead of sand as it looks outside"),
         [](TerrainStyle &s, bool isOn) { s.look = isOn ? GroundLook::Reference : GroundLook::Sand; }},
    };
    return all;
}

GroundStyle::GroundStyle(Actions &actions, Workspace &workspace, QMenu &menu)
    : mWorkspace(workspace)
{
    QActionGroup *group = nullptr;
    const char *named = nullptr;
    for (const Row &row : rows()) {
        auto *action = menu.addAction(QString());
        mActions.push_back(action);
        if (!row.text) {
            action->setSeparator(true);
            continue;
        }
        action->setObjectName(QLatin1String(row.key));
        action->setCheckable(true);
        if (row.group && row.group != named)
            group = new QActionGroup(this);
        named = row.group;
        if (row.group)
            group->addAction(action);
        TerrainStyle tried = mStyle;
        row.apply(tried, true);
        action->setChecked(tried == mStyle); // what a new style is
        connect(action, &QAction::toggled, this, [this, apply = row.apply, isChoice = row.group != nullptr](bool isOn) {
            if (isOn || !isChoice)
                apply(mStyle, isOn);
            follow();
        });
        actions.adopt(*action, QT_TRANSLATE_NOOP("Actions", "&View"), DocumentKind::Terrain);
    }
    connect(&workspace, &Workspace::currentChanged, this, &GroundStyle::follow);
    connect(&workspace, &Workspace::currentStateChanged, this, &GroundStyle::follow);
    retranslate();
    follow();
}

void GroundStyle::showMask(bool isShown)
{
    const auto named = [this](const char *key) {
        return *std::find_if(mActions.begin(), mActions.end(),
                             [key](const QAction *action) { return action->objectName() == QLatin1String(key); });
    };
    QAction *const mask = named("ground.mask");
    if (isShown == mask->isChecked())
        return;
    if (isShown) {
        for (QAction *action : mask->actionGroup()->actions())
            if (action->isChecked())
                mBeforeMask = action;
        mask->setChecked(true);
    } else {
        (mBeforeMask ? mBeforeMask : named("ground.material"))->setChecked(true);
    }
}

void GroundStyle::follow()
{
    const TerrainTab *tab = mWorkspace.currentTerrain();
    views::TerrainViewport *view = tab ? tab->viewport() : nullptr;
    for (QAction *action : mActions)
        action->setEnabled(view);
    if (!view)
        return;
    TerrainStyle style = mStyle;
    style.isDark = view->style().isDark; // the theme's
    view->setStyle(style);
}

void GroundStyle::retranslate()
{
    for (std::size_t i = 0; i < mActions.size(); ++i)
        if (const Row &row = rows()[i]; row.text) {
            mActions[i]->setText(QCoreApplication::translate("Actions", row.text));
            mActions[i]->setStatusTip(QCoreApplication::translate("Actions", row.tip));
        }
}

} // namespace editor
