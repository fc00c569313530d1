// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/base/editcontext.h"

namespace commands {

EditContext::~EditContext()
{
    // The stack empties itself and would tell so those who then read a document through half a context.
    mUndoStack.blockSignals(true);
}

void EditContext::pushCommand(std::unique_ptr<QUndoCommand> command)
{
    // The stack would drop it too, but only after throwing away what could be redone.
    if (!command->isObsolete())
        mUndoStack.push(command.release());
}

} // namespace commands
