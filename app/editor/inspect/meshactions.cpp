// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/inspect/meshactions.h"

#include "app/editor/actions/actions.h"
#include "app/editor/actions/fileactions.h"
#include "app/editor/documents/meshtab.h"
#include "app/editor/window/workspace.h"
#include "commands/mesh/changemesh.h"
#include "model/mesh/editing/cleaning.h"
#include "model/mesh/editing/cuthandle.h"
#include "model/mesh/editing/decimate.h"
#include "model/mesh/editing/fillholes.h"
#include "model/mesh/editing/subdivide.h"

#include <QAction>
#include <QCoreApplication>
#include <QMenu>

namespace editor {

namespace {

QString translated(const char *text)
{
    return QCoreApplication::translate("Actions", text);
}

} // namespace

MeshActions::Made MeshActions::made(const Task &task, const model::EditedMesh &edited)
{
    return {{edited.vertices.positions(task.mesh->positions), edited.faces}, edited.isUnchanged(task.mesh->faces)};
}

const std::vector<MeshActions::Operation> &MeshActions::operations()
{
    using views::PartKind;
    /// For edits that cannot fail.
    const auto simply = [](auto edit) {
        return [edit](const Task &task, const model::Progress &) -> MakeResult { return made(task, edit(task)); };
    };
    const auto tried = [](auto edit) {
        return [edit](const Task &task, const model::Progress &progress) -> MakeResult {
            const model::EditResult edited = edit(task, progress);
            if (!edited)
                return tl::unexpected(edited.error());
            return made(task, *edited);
        };
    };
    static const std::vector<Operation> all{
        {"mesh.fillHoles", QT_TRANSLATE_NOOP("Actions", "&Fill Holes"),
         QT_TRANSLATE_NOOP("Actions", "Close the holes that are selected in the inspector by smooth lids"),
         QT_TRANSLATE_NOOP("Undo", "Fill Holes"), PartKind::Hole, tried([](const Task &task, const auto &progress) {
             std::vector<model::BorderLoop> loops;
             for (const std::uint32_t hole : task.parts)
                 loops.push_back(task.report->holes[hole].loop);
             return model::fillHoles(task.mesh->faces, task.mesh->positions, loops, {}, progress);
         })},
        {"mesh.cutHandle", QT_TRANSLATE_NOOP("Actions", "&Cut Handle"),
         QT_TRANSLATE_NOOP("Actions", "Cut the selected handle open along its short loop and close both ends"),
         QT_TRANSLATE_NOOP("Undo", "Cut Handle"), PartKind::Handle, tried([](const Task &task, const auto &progress) {
             return model::cutHandle(task.mesh->faces, task.mesh->positions, task.loop, {}, progress);
         })},
        {"mesh.deleteComponents", QT_TRANSLATE_NOOP("Actions", "&Delete Components"),
         QT_TRANSLATE_NOOP("Actions", "Delete the components that are selected in the inspector"),
         QT_TRANSLATE_NOOP("Undo", "Delete Components"), PartKind::Component,
         simply([](const Task &task) { return model::deleteComponents(task.mesh->faces, task.parts); })},
        {nullptr, nullptr, nullptr, nullptr, {}, {}},
        {"mesh.weld",
         QT_TRANSLATE_NOOP("Actions", "&Weld Vertices"),
         QT_TRANSLATE_NOOP("Actions", "Make one of the vertices that are exactly at one place"),
         QT_TRANSLATE_NOOP("Undo", "Weld Vertices"),
         {},
         simply([](const Task &task) {
             const std::span<const model::Vec3f> frame = task.mesh->positions;
             return model::weldVertices(task.mesh->faces, std::span(&frame, 1));
         })},
        {"mesh.orient",
         QT_TRANSLATE_NOOP("Actions", "&Orient Faces"),
         QT_TRANSLATE_NOOP("Actions", "Turn faces until neighbours are wound alike and solids are not inside out"),
         QT_TRANSLATE_NOOP("Undo", "Orient Faces"),
         {},
         simply([](const Task &task) { return model::orientFaces(task.mesh->faces, task.mesh->positions); })},
        {"mesh.removeDegenerate",
         QT_TRANSLATE_NOOP("Actions", "Remove De&generate Faces"),
         QT_TRANSLATE_NOOP("Actions", "Remove faces that have fewer than three different corners"),
         QT_TRANSLATE_NOOP("Undo", "Remove Degenerate Faces"),
         {},
         simply([](const Task &task) { return model::removeDegenerateFaces(task.mesh->faces); })},
        {"mesh.removeDuplicate",
         QT_TRANSLATE_NOOP("Actions", "Remove D&uplicate Faces"),
         QT_TRANSLATE_NOOP("Actions", "Of faces with the same corners keep the first"),
         QT_TRANSLATE_NOOP("Undo", "Remove Duplicate Faces"),
         {},
         simply([](const Task &task) { return model::removeDuplicateFaces(task.mesh->faces); })},
        {"mesh.removeIsolated",
         QT_TRANSLATE_NOOP("Actions", "Remove &Isolated Vertices"),
         QT_TRANSLATE_NOOP("Actions", "Remove vertices that no face uses"),
         QT_TRANSLATE_NOOP("Undo", "Remove Isolated Vertices"),
         {},
         simply([](const Task &task) { return model::removeIsolatedVertices(task.mesh->faces); })},
        {"mesh.split",
         QT_TRANSLATE_NOOP("Actions", "&Split Non-Manifold Parts"),
         QT_TRANSLATE_NOOP("Actions", "Give each sheet and each fan of faces edges and vertices of its own"),
         QT_TRANSLATE_NOOP("Undo", "Split Non-Manifold Parts"),
         {},
         simply([](const Task &task) { return model::splitNonManifold(task.mesh->faces); })},
        {nullptr, nullptr, nullptr, nullptr, {}, {}},
        {"mesh.decimate",
         QT_TRANSLATE_NOOP("Actions", "&Halve the Triangles"),
         QT_TRANSLATE_NOOP("Actions", "Draw edges together until half the triangles are left, where it shows least"),
         QT_TRANSLATE_NOOP("Undo", "Halve the Triangles"),
         {},
         tried([](const Task &task, const auto &progress) {
             const auto count = std::uint32_t(model::fans(task.mesh->faces).triangles.size());
             return model::decimate(task.mesh->faces, task.mesh->positions, count / 2, progress);
         })},
        {"mesh.subdivide",
         QT_TRANSLATE_NOOP("Actions", "Su&bdivide"),
         QT_TRANSLATE_NOOP("Actions", "Put four smooth triangles in place of each"),
         QT_TRANSLATE_NOOP("Undo", "Subdivide"),
         {},
         simply([](const Task &task) { return model::subdivide(task.mesh->faces); })},
        {"mesh.smooth",
         QT_TRANSLATE_NOOP("Actions", "S&mooth"),
         QT_TRANSLATE_NOOP("Actions", "Smooth the surface without shrinking it"),
         QT_TRANSLATE_NOOP("Undo", "Smooth"),
         {},
         [](const Task &task, const model::Progress &) -> MakeResult {
             return Made{{model::smooth(task.mesh->faces, task.mesh->positions), task.mesh->faces}};
         }},
    };
    return all;
}

MeshActions::MeshActions(Actions &actions, FileActions &files, Workspace &workspace, QMenu &menu)
    : mFiles(files)
    , mWorkspace(workspace)
{
    for (const Operation &operation : operations()) {
        QAction *action = menu.addAction(QString());
        mActions.push_back(action);
        if (!operation.key) {
            action->setSeparator(true);
            continue;
        }
        action->setObjectName(QLatin1String(operation.key));
        connect(action, &QAction::triggered, this, [this, &operation] { run(operation); });
        actions.adopt(*action, QT_TRANSLATE_NOOP("Actions", "&Mesh"), DocumentKind::Mesh);
    }
    connect(&workspace, &Workspace::currentChanged, this, &MeshActions::follow);
    connect(&workspace, &Workspace::currentStateChanged, this, &MeshActions::follow);
    connect(&mWork, &views::Job::runningChanged, this, &MeshActions::follow);
    retranslate();
    follow();
}

void MeshActions::retranslate()
{
    for (std::size_t i = 0; i < mActions.size(); ++i)
        if (const Operation &operation = operations()[i]; operation.key) {
            mActions[i]->setText(translated(operation.text));
            mActions[i]->setStatusTip(translated(operation.tip));
        }
}

std::vector<std::uint32_t> MeshActions::selected(const views::Inspection &inspection, views::PartKind kind)
{
    std::vector<std::uint32_t> result;
    for (const views::PartId part : inspection.selection())
        if (part.kind == kind)
            result.push_back(part.index);
    return result;
}

void MeshActions::follow()
{
    MeshTab *tab = mWorkspace.currentMesh();
    views::Inspection *inspection = tab && tab->document().isOpen() ? &tab->document().inspection() : nullptr;
    if (inspection != mFollowed) {
        for (const QMetaObject::Connection &connection : {mSelection, mFound})
            disconnect(connection);
        mFollowed = inspection;
        if (inspection) {
            mSelection = connect(inspection, &views::Inspection::selectionChanged, this, &MeshActions::follow);
            mFound = connect(inspection, &views::Inspection::meshChanged, this, &MeshActions::follow);
        }
    }
    const auto &all = operations();
    for (std::size_t i = 0; i < all.size(); ++i) {
        bool isPossible = inspection && !mWork.isRunning();
        if (isPossible && all[i].needs) {
            const std::size_t count = selected(*inspection, *all[i].needs).size();
            isPossible = *all[i].needs == views::PartKind::Handle ? count == 1 : count > 0;
        }
        mActions[i]->setEnabled(isPossible);
    }
}

void MeshActions::run(const Operation &operation)
{
    MeshTab *tab = mWorkspace.currentMesh();
    const views::Inspection &inspection = tab->document().inspection();
    Task task{tab->document().mesh().mesh(), inspection.report(), {}, {}};
    if (operation.needs) {
        task.parts = selected(inspection, *operation.needs);
        if (*operation.needs == views::PartKind::Handle)
            task.loop = (*inspection.handles())[task.parts.front()].loops[0].vertices;
    }
    const auto before = task.mesh;
    mWork.start([task = std::move(task), make = operation.make](
                    const model::Progress &progress) -> model::Result<MakeResult> { return make(task, progress); },
                [this, tab = QPointer(tab), &operation, before](model::Result<MakeResult> result) {
                    if (!tab)
                        return;
                    if (result)
                        taken(*tab, operation, before, std::move(*result));
                    else
                        mFiles.tell(tr("%1 was left as it is.").arg(tab->document().title()), result.error());
                });
}

void MeshActions::taken(MeshTab &tab, const Operation &operation, const views::Inspection::MeshPtr &before,
                        MakeResult result)
{
    OpenMesh &document = tab.document();
    if (!document.isOpen() || document.mesh().mesh() != before)
        return; // undone, or read anew
    if (!result) {
        QString why;
        switch (result.error().kind) {
        case model::EditError::Kind::NotManifold:
            why = tr("It is no oriented manifold: orient its faces and split its non-manifold parts first.");
            break;
        case model::EditError::Kind::BadLoop:
            why = tr("The loop does not run along edges of two faces.");
            break;
        case model::EditError::Kind::LoopAtBorder:
            why = tr("The loop touches holes on both sides: fill them first.");
            break;
        case model::EditError::Kind::Cancelled:
            return;
        }
        mFiles.say(tr("%1 was left as it is.").arg(document.title()) + QLatin1Char(' ') + why);
        return;
    }
    if (result->isUnchanged) {
        mFiles.say(
            tr("%1: there is nothing to do.").arg(operation.text ? plainTitle(translated(operation.text)) : QString()));
        return;
    }
    document.context()->push<commands::ChangeMesh>(QCoreApplication::translate("Undo", operation.step),
                                                   std::make_shared<const model::PolygonMesh>(std::move(result->mesh)));
}

} // namespace editor
