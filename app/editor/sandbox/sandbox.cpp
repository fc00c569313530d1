// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/sandbox/sandbox.h"

#include "app/editor/actions/actions.h"
#include "app/editor/documents/terraintab.h"
#include "app/editor/window/workspace.h"
#include "views/dialogs/measuretext.h"
#include "views/docks/terrain/erosiondock.h"
#include "views/docks/terrain/materialdock.h"
#include "views/docks/terrain/profiledock.h"
#include "views/docks/terrain/toolsdock.h"
#include "views/terrain/terrainviewport.h"
#include "views/widgets/icons.h"

#include <QAction>
#include <QMainWindow>

#include <utility>

namespace editor {

namespace {

QAction *makeMode(const char *name, const char *iconName, const char *shortcut, QObject *parent)
{
    auto *action = new QAction(views::icon(QLatin1String(iconName)), QString(), parent);
    action->setObjectName(QLatin1String(name));
    action->setCheckable(true);
    action->setShortcut(QKeySequence(QLatin1String(shortcut)));
    return action;
}

} // namespace

Sandbox::Sandbox(Actions &actions, Workspace &workspace, QMainWindow &window)
    : mActions(actions)
    , mWorkspace(workspace)
    , mTools(new views::ToolsDock(mSettings, &window))
    , mErosion(new views::ErosionDock(mSettings, &window))
    , mMaterials(new views::MaterialDock(&window))
    , mPick(makeMode("terrain.pickProfile", "profile", "Shift+P", this))
    , mPaint(makeMode("terrain.paintMask", "mask", "M", this))
    , mFeeling(new Feeling(mSettings, window, this))
    , mProfile(new views::ProfileDock(*mPick, &window))
{
    actions[ActionId::Sculpt].setChecked(true);
    connect(&actions[ActionId::Sculpt], &QAction::toggled, this, [this](bool isOn) {
        for (auto &[tab, work] : mWork)
            if (work.strokes)
                work.strokes->setActive(isOn);
    });
    connect(mTools, &views::ToolsDock::referenceRequested, this, &Sandbox::takeReference);
    // One of them at most has the left button.
    for (QAction *action : modes())
        connect(action, &QAction::toggled, this, [this, action](bool isOn) {
            for (QAction *other : modes())
                if (isOn && other != action)
                    other->setChecked(false);
            if (isOn && action == &mFeeling->modeAction())
                mActions[ActionId::Sculpt].setChecked(true); // the hand draws
            shareGround();
        });
    connect(&mSettings, &views::ToolSettings::toolChanged, this, [this, kind = mSettings.tool().index()]() mutable {
        if (std::exchange(kind, mSettings.tool().index()) != kind)
            for (QAction *mode : {mPick, mPaint})
                mode->setChecked(false); // another tool: to draw with it. The hand draws with tools too
    });
    connect(mProfile, &QDockWidget::visibilityChanged, this, [this] {
        if (mProfile->isHidden())
            mPick->setChecked(false);
        shareGround();
    });
    connect(&workspace, &Workspace::currentChanged, this, &Sandbox::follow);
    connect(&workspace, &Workspace::currentStateChanged, this, &Sandbox::follow);
    follow();
}

QList<QAction *> Sandbox::modes() const
{
    return {mPick, mPaint, &mFeeling->modeAction()};
}

Sandbox::~Sandbox()
{
    disconnect(mProfile, nullptr, this, nullptr);
    for (auto &[tab, work] : mWork)
        forget(work);
}

Sandbox::Work *Sandbox::present()
{
    const auto found = mWork.find(mWorkspace.currentTerrain());
    return found == mWork.end() || !found->second.strokes ? nullptr : &found->second;
}

void Sandbox::follow()
{
    TerrainTab *tab = mWorkspace.currentTerrain();
    if (tab && !mWork.contains(tab)) {
        mWork.emplace(tab, Work());
        connect(tab, &TerrainTab::groundChanged, this, [this, tab] { changeGround(*tab); });
        connect(tab, &QObject::destroyed, this, [this, tab] { mWork.erase(tab); });
        connect(&tab->document(), &OpenTerrain::terrainSaved, this,
                [this, tab](const views::GroundReference::TerrainPtr &terrain) {
                    if (const Work &work = mWork[tab]; work.strokes)
                        work.strokes->reference().noteSaved(terrain);
                });
        changeGround(*tab);
        return;
    }
    Work *work = present();
    commands::TerrainContext *context = work ? tab->document().context() : nullptr;
    mActions[ActionId::Sculpt].setEnabled(work);
    mFeeling->setTerrain(work ? &tab->document().terrain() : nullptr, work ? work->strokes.get() : nullptr);
    mErosion->setTerrain(context, work ? &work->strokes->flow() : nullptr);
    mMaterials->setContext(context);
    mProfile->setTerrain(work ? &tab->document().terrain() : nullptr, work ? work->profile.get() : nullptr,
                         work ? &work->strokes->reference() : nullptr);
    shareGround();
    emit readingChanged({});
    emit stateChanged();
    if (!work)
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
    if (tab.ground() && tab.document().context())
        begin(tab, work);
    follow();
}

void Sandbox::begin(TerrainTab &tab, Work &work)
{
    work.ground = tab.ground();
    work.strokes = std::make_unique<views::StrokeController>(*tab.document().context(), mSettings, work.ground);
    work.strokes->setActive(mActions[ActionId::Sculpt].isChecked());
    work.profile = std::make_unique<views::ProfileLine>(work.ground);
    work.strokes->setMask(tab.document().mask());
    work.mask =
        std::make_unique<views::MaskPainter>(*tab.document().context(), tab.document().mask(), mSettings, work.ground);
    work.hand = std::make_unique<views::HandOnGround>(mFeeling->session());
    if (tab.viewport())
        work.arrow = new views::ForceArrow(mFeeling->session(), *tab.viewport());
    work.shared = std::make_unique<views::SharedGround>(
        *work.ground, std::vector<views::GroundInteraction *>{work.strokes.get(), work.profile.get(), work.mask.get(),
                                                              work.hand.get()});
    connect(work.strokes.get(), &views::StrokeController::readingChanged, this, &Sandbox::readingChanged);
    connect(work.strokes.get(), &views::StrokeController::strokeRefused, this,
            [this](const QString &reason) { mWorkspace.messages().add(views::MessageBar::Kind::Warning, reason); });
    connect(work.strokes.get(), &views::StrokeController::strokeEnded, this,
            [this](const model::terrain::StrokeReport &report) {
                if (report.removed > 0 && std::holds_alternative<model::terrain::Scoop>(mSettings.tool()))
                    emit strokeTold(tr("Took out %1").arg(views::volumeText(report.removed)));
            });
    connect(&work.strokes->reference(), &views::GroundReference::changed, this, [&tab, &work] {
        if (tab.viewport())
            tab.viewport()->setReference(work.strokes->reference().terrain());
    });
    connect(&work.strokes->flow(), &views::SandFlow::figuresChanged, this,
            [this, &tab, &work] { showActive(tab, work); });
    const auto showMask = [&tab, &work] {
        if (tab.viewport())
            tab.viewport()->setMask(work.mask->shown());
    };
    connect(work.mask.get(), &views::MaskPainter::shownChanged, this, showMask);
    showMask();
    if (tab.viewport())
        connect(tab.viewport(), &views::TerrainViewport::styleChanged, work.strokes.get(),
                [this, &tab, &work] { showActive(tab, work); });
}

void Sandbox::forget(Work &work)
{
    work.shared.reset();
    work.ground = nullptr;
    mFeeling->setTerrain(nullptr, nullptr);
    delete work.arrow;
    work.hand.reset();
    mErosion->setTerrain(nullptr, nullptr);
    mProfile->setTerrain(nullptr, nullptr, nullptr);
    work.mask.reset();
    work.profile.reset();
    work.strokes.reset();
}

/// Who has the left button, on every terrain.
void Sandbox::shareGround()
{
    if (mPick->isChecked())
        mProfile->show();
    for (auto &[tab, work] : mWork) {
        if (!work.shared)
            continue;
        if (work.arrow)
            work.arrow->setActive(tab == mWorkspace.currentTerrain());
        if (mPick->isChecked())
            work.shared->choose(*work.profile);
        else if (mPaint->isChecked())
            work.shared->choose(*work.mask);
        else if (mFeeling->modeAction().isChecked())
            work.shared->choose(*work.hand);
        else
            work.shared->choose(*work.strokes);
        work.profile->setVisible(!mProfile->isHidden());
    }
}

void Sandbox::showActive(TerrainTab &tab, const Work &work)
{
    if (tab.viewport() && tab.viewport()->style().hasActiveTriangles)
        tab.viewport()->setActiveTriangles(work.strokes->flow().activeTriangles());
}

void Sandbox::chooseTool(std::size_t kind)
{
    for (QAction *mode : {mPick, mPaint})
        mode->setChecked(false);
    mActions[ActionId::Sculpt].setChecked(true);
    mSettings.choose(kind);
}

void Sandbox::clearMask()
{
    if (Work *work = present())
        work->mask->clear();
}

void Sandbox::invertMask()
{
    if (Work *work = present())
        work->mask->invert();
}

void Sandbox::takeReference()
{
    if (Work *work = present())
        work->strokes->reference().take();
}

} // namespace editor
