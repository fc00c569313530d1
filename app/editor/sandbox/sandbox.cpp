// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/sandbox/sandbox.h"

#include "app/editor/actions/actions.h"
#include "app/editor/documents/terraintab.h"
#include "app/editor/window/workspace.h"
#include "views/docks/terrain/erosiondock.h"
#include "views/docks/terrain/materialdock.h"
#include "views/docks/terrain/toolsdock.h"

#include <QMainWindow>

namespace editor {

Sandbox::Sandbox(Actions &actions, Workspace &workspace, QMainWindow &window)
    : mActions(actions)
    , mWorkspace(workspace)
    , mTools(new views::ToolsDock(mSettings, &window))
    , mErosion(new views::ErosionDock(mSettings, &window))
    , mMaterials(new views::MaterialDock(&window))
{
    actions[ActionId::Sculpt].setChecked(true);
    connect(&actions[ActionId::Sculpt], &QAction::toggled, this, [this](bool isOn) {
        for (auto &[tab, work] : mWork)
            if (work.strokes)
                work.strokes->setActive(isOn);
    });
    connect(mTools, &views::ToolsDock::referenceRequested, this, [this] {
        if (views::StrokeController *present = strokes())
            present->takeReference();
    });
    connect(&workspace, &Workspace::currentChanged, this, &Sandbox::follow);
    connect(&workspace, &Workspace::currentStateChanged, this, &Sandbox::follow);
    follow();
}

Sandbox::~Sandbox()
{
    for (auto &[tab, work] : mWork)
        forget(work);
}

void Sandbox::follow()
{
    TerrainTab *tab = mWorkspace.currentTerrain();
    if (tab && !mWork.contains(tab)) {
        mWork.emplace(tab, Work());
        connect(tab, &TerrainTab::groundChanged, this, [this, tab] { changeGround(*tab); });
        connect(tab, &QObject::destroyed, this, [this, tab] { mWork.erase(tab); });
        changeGround(*tab);
        return;
    }
    views::StrokeController *present = strokes();
    mActions[ActionId::Sculpt].setEnabled(present);
    mErosion->setTerrain(present ? tab->document().context() : nullptr, present ? &present->flow() : nullptr);
    mMaterials->setContext(present ? tab->document().context() : nullptr);
    emit readingChanged({});
    if (!present)
        return;
    // Sizes are kept for as long as terrains are of one size.
    const model::terrain::Rectangle domain = tab->document().terrain().tin().domain();
    if (std::min(domain.high.x - domain.low.x, domain.high.y - domain.low.y) != mSettings.terrainSide())
        mSettings.fitTo(domain);
}

void Sandbox::changeGround(TerrainTab &tab)
{
    Work &work = mWork[&tab];
    if (work.ground == tab.ground())
        return;
    forget(work);
    if (tab.ground() && tab.document().context()) {
        work.ground = tab.ground();
        work.strokes = std::make_unique<views::StrokeController>(*tab.document().context(), mSettings, work.ground);
        work.strokes->setActive(mActions[ActionId::Sculpt].isChecked());
        work.ground->setInteraction(work.strokes.get());
        connect(work.strokes.get(), &views::StrokeController::readingChanged, this, &Sandbox::readingChanged);
        connect(work.strokes.get(), &views::StrokeController::strokeRefused, this,
                [this](const QString &reason) { mWorkspace.messages().add(views::MessageBar::Kind::Warning, reason); });
    }
    follow();
}

void Sandbox::forget(Work &work)
{
    if (work.ground)
        work.ground->setInteraction(nullptr);
    work.ground = nullptr;
    mErosion->setTerrain(nullptr, nullptr);
    work.strokes.reset();
}

views::StrokeController *Sandbox::strokes() const
{
    const auto found = mWork.find(mWorkspace.currentTerrain());
    return found == mWork.end() ? nullptr : found->second.strokes.get();
}

} // namespace editor
