// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/base/documentcontext.h"
#include "commands/terrain/historybudget.h"
#include "model/document/meshdocument.h"

namespace commands {

/// The way to change a mesh. Steps keep whole meshes, so the oldest are dropped when they are too much.
class MeshContext final : public DocumentContext<model::MeshDocument>
{
    Q_OBJECT

public:
    explicit MeshContext(model::MeshDocument &document, QObject *parent = nullptr);
    ~MeshContext() override;

    void pushCommand(std::unique_ptr<QUndoCommand> command) override;

    HistoryBudget &history() { return mHistory; }

private:
    HistoryBudget mHistory;
};

} // namespace commands
