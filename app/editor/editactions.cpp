// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/editactions.h"

#include "app/editor/documenttab.h"
#include "app/editor/workspace.h"
#include "commands/animation/reverseanimation.h"
#include "views/dialogs/frameratedialog.h"
#include "views/dialogs/normalisedialog.h"
#include "views/dialogs/renamedialog.h"
#include "views/dialogs/resampledialog.h"
#include "views/dialogs/trimdialog.h"

#include <QUndoStack>

namespace editor {

EditActions::EditActions(Actions &actions, Workspace &workspace, QWidget &window)
    : mActions(actions)
    , mWorkspace(workspace)
    , mWindow(window)
{
    connect(&actions[ActionId::Undo], &QAction::triggered, this, [this] { context()->undoStack().undo(); });
    connect(&actions[ActionId::Redo], &QAction::triggered, this, [this] { context()->undoStack().redo(); });
    connect(&actions[ActionId::Reverse], &QAction::triggered, this,
            [this] { context()->push<commands::ReverseAnimation>(); });
    connect(&actions[ActionId::Trim], &QAction::triggered, this, [this] {
        const model::Playback &playback = document()->player().playback();
        ask(new views::TrimDialog(*context(), playback.rangeFirst(), playback.rangeLast(), &mWindow));
    });
    connect(&actions[ActionId::Resample], &QAction::triggered, this,
            [this] { ask(new views::ResampleDialog(*context(), &mWindow)); });
    connect(&actions[ActionId::FrameRate], &QAction::triggered, this,
            [this] { ask(new views::FrameRateDialog(*context(), &mWindow)); });
    connect(&actions[ActionId::Normalise], &QAction::triggered, this,
            [this] { ask(new views::NormaliseDialog(*context(), &mWindow)); });
    connect(&actions[ActionId::Rename], &QAction::triggered, this,
            [this] { ask(new views::RenameDialog(*context(), &mWindow)); });
    connect(&workspace, &Workspace::currentChanged, this, &EditActions::follow);
    connect(&workspace, &Workspace::currentStateChanged, this, &EditActions::follow);
    follow();
}

void EditActions::follow()
{
    commands::AnimationContext *context_ = context();
    if (mFollowed && mFollowed != context_) {
        disconnect(&mFollowed->undoStack(), nullptr, this, nullptr);
        disconnect(&mFollowed->document(), nullptr, this, nullptr);
    }
    if (context_ && mFollowed != context_) {
        connect(&context_->undoStack(), &QUndoStack::indexChanged, this, &EditActions::update);
        connect(&context_->document(), &model::AnimationDocument::changed, this, &EditActions::update);
    }
    mFollowed = context_;
    update();
}

void EditActions::update()
{
    const commands::AnimationContext *context_ = context();
    const QUndoStack *stack = context_ ? &context_->undoStack() : nullptr;
    mActions[ActionId::Undo].setEnabled(stack && stack->canUndo());
    mActions[ActionId::Redo].setEnabled(stack && stack->canRedo());
    mActions.setUndoTexts(stack ? stack->undoText() : QString(), stack ? stack->redoText() : QString());
    const bool severalFrames = context_ && context_->document().frameCount() > 1;
    for (const ActionId id : {ActionId::Trim, ActionId::Reverse, ActionId::Resample})
        mActions[id].setEnabled(severalFrames);
    for (const ActionId id : {ActionId::FrameRate, ActionId::Normalise, ActionId::Rename})
        mActions[id].setEnabled(context_ != nullptr);
}

void EditActions::ask(views::EditDialog *dialog)
{
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

Document *EditActions::document() const
{
    DocumentTab *tab = mWorkspace.current();
    return tab && tab->document().isOpen() ? &tab->document() : nullptr;
}

commands::AnimationContext *EditActions::context() const
{
    Document *open = document();
    return open ? open->context() : nullptr;
}

} // namespace editor
