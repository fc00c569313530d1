// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/mesh/meshcontext.h"

#include <utility>

namespace commands {

MeshContext::MeshContext(model::MeshDocument &document, QObject *parent)
    : DocumentContext(document, parent)
    , mHistory(undoStack())
{}

MeshContext::~MeshContext() = default;

void MeshContext::pushCommand(std::unique_ptr<QUndoCommand> command)
{
    if (!command->isObsolete())
        mHistory.push(std::move(command));
}

} // namespace commands
