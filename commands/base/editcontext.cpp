// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/base/editcontext.h"

namespace commands {

EditContext::EditContext(model::AnimationDocument &document, QObject *parent)
    : QObject(parent)
    , mDocument(document)
{}

void EditContext::pushCommand(std::unique_ptr<QUndoCommand> command)
{
    // The stack would drop it too, but only after throwing away what could be redone.
    if (!command->isObsolete())
        mUndoStack.push(command.release());
}

} // namespace commands
