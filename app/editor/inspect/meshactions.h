// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/editing/editerror.h"
#include "views/inspect/inspection.h"

#include <QObject>
#include <QPointer>

#include <functional>
#include <optional>
#include <vector>

class QAction;
class QMenu;

namespace editor {

class Actions;
class FileActions;
class MeshTab;
class Workspace;

/// The Mesh menu: what is done to the mesh of the present tab. Each operation runs in the background on the mesh as it
/// is, and comes back as one step; a mesh that was changed meanwhile is left alone.
class MeshActions final : public QObject
{
    Q_OBJECT

public:
    MeshActions(Actions &actions, FileActions &files, Workspace &workspace, QMenu &menu);

    void retranslate();

private:
    /// What an operation is given.
    struct Task
    {
        views::Inspection::MeshPtr mesh;
        std::shared_ptr<const model::MeshReport> report;
        std::vector<std::uint32_t> parts; ///< selected ones of the list that it needs
        std::vector<std::uint32_t> loop;  ///< of the selected handle
    };
    struct Made
    {
        model::PolygonMesh mesh;
        bool isUnchanged = false;
    };
    using MakeResult = tl::expected<Made, model::EditError>;
    struct Operation
    {
        const char *key;
        const char *text;
        const char *tip;
        const char *step; ///< its undo text
        std::optional<views::PartKind> needs;
        std::function<MakeResult(const Task &, const model::Progress &)> make;
    };
    static const std::vector<Operation> &operations();
    static Made made(const Task &task, const model::EditedMesh &edited);

    void follow();
    void run(const Operation &operation);
    void taken(MeshTab &tab, const Operation &operation, const views::Inspection::MeshPtr &before, MakeResult result);
    static std::vector<std::uint32_t> selected(const views::Inspection &inspection, views::PartKind kind);

    FileActions &mFiles;
    Workspace &mWorkspace;
    std::vector<QAction *> mActions;       ///< of the operations
    QPointer<views::Inspection> mFollowed; ///< a new one may come to be where a closed one was
    QMetaObject::Connection mSelection, mFound;
    views::Job mWork;
};

} // namespace editor
