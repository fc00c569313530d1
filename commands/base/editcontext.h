// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/base/mergeid.h"
#include "model/document/animationdocument.h"

#include <QObject>
#include <QUndoStack>

#include <memory>
#include <utility>

namespace commands {

/// The way to change a document: views hold one, read the document through it, and push commands. Owns the undo stack.
class EditContext final : public QObject
{
    Q_OBJECT

public:
    explicit EditContext(model::AnimationDocument &document, QObject *parent = nullptr);

    const model::AnimationDocument &document() const { return mDocument; }
    const QUndoStack &undoStack() const { return mUndoStack; }
    QUndoStack &undoStack() { return mUndoStack; }

    /// A number for a gesture that starts now; no two gestures of this context have the same.
    GestureId newGesture() { return ++mLastGesture; }

    /// Carries out Command(document, args...) and remembers it: `context.push<TrimAnimation>(first, last)`.
    /// A command that finds in its constructor that it would change nothing marks itself obsolete and is dropped.
    template <class Command, class... Args>
    void push(Args &&...args)
    {
        pushCommand(std::make_unique<Command>(mDocument, std::forward<Args>(args)...));
    }

    /// The same for a command that was made already, for this document as it is now.
    void pushCommand(std::unique_ptr<QUndoCommand> command);

private:
    model::AnimationDocument &mDocument;
    QUndoStack mUndoStack;
    GestureId mLastGesture = NoGesture;
};

} // namespace commands
