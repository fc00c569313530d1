// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/actions/actions.h"

#include <QObject>
#include <QPointer>

namespace commands {
class AnimationContext;
class EditContext;
} // namespace commands

namespace views {
class EditDialog;
}

namespace editor {

class Workspace;

/// The Edit menu: undo and redo in every document, and the commands that change an animation.
class EditActions final : public QObject
{
    Q_OBJECT

public:
    EditActions(Actions &actions, Workspace &workspace, QWidget &window);

private:
    void follow();
    void update();
    static void ask(views::EditDialog *dialog);
    /// Null without an open document.
    commands::EditContext *context() const;
    /// Null without an open animation.
    commands::AnimationContext *animation() const;

    Actions &mActions;
    Workspace &mWorkspace;
    QWidget &mWindow;
    QPointer<commands::EditContext> mFollowed;
};

} // namespace editor
