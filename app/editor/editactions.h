// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/actions.h"

#include <QObject>
#include <QPointer>

namespace commands {
class AnimationContext;
}

namespace views {
class EditDialog;
}

namespace editor {

class Document;
class Workspace;

/// The Edit menu: undo and redo, and the commands that change the animation of the present tab.
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
    Document *document() const;
    commands::AnimationContext *context() const;

    Actions &mActions;
    Workspace &mWorkspace;
    QWidget &mWindow;
    QPointer<commands::AnimationContext> mFollowed;
};

} // namespace editor
