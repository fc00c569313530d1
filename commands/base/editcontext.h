// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/base/mergeid.h"

#include <QObject>
#include <QUndoStack>

#include <memory>

namespace commands {

/// The way to change a document, whatever kind it is: owns the undo stack. AnimationContext and TerrainContext know
/// the document too; what shows the history and undoes needs no more than this.
class EditContext : public QObject
{
    Q_OBJECT

public:
    ~EditContext() override;

    const QUndoStack &undoStack() const { return mUndoStack; }
    QUndoStack &undoStack() { return mUndoStack; }

    /// A number for a gesture that starts now; no two gestures of this context have the same.
    GestureId newGesture() { return ++mLastGesture; }

    /// Carries out a command that was made for this document as it is now, and remembers it.
    /// A command that finds in its constructor that it would change nothing marks itself obsolete and is dropped.
    virtual void pushCommand(std::unique_ptr<QUndoCommand> command);

protected:
    using QObject::QObject;

private:
    QUndoStack mUndoStack;
    GestureId mLastGesture = NoGesture;
};

} // namespace commands
