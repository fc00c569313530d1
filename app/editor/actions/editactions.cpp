// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/actions/editactions.h"

#include "app/editor/documents/animationtab.h"
#include "app/editor/window/workspace.h"
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
            [this] { animation()->push<commands::ReverseAnimation>(); });
    connect(&actions[ActionId::Trim], &QAction::triggered, this, [this] {
        const model::Playback &playback = mWorkspace.currentAnimation()->document().player().playback();
        ask(new views::TrimDialog(*animation(), playback.rangeFirst(), playback.rangeLast(), &mWindow));
    });
    connect(&actions[ActionId::Resample], &QAction::triggered, this,
            [this] { ask(new views::ResampleDialog(*animation(), &mWindow)); });
    connect(&actions[ActionId::FrameRate], &QAction::triggered, this,
            [this] { ask(new views::FrameRateDialog(*animation(), &mWindow)); });
    connect(&actions[ActionId::Normalise], &QAction::triggered, this,
            [this] { ask(new views::NormaliseDialog(*animation(), &mWindow)); });
    connect(&actions[ActionId::Rename], &QAction::triggered, this,
            [this] { ask(new views::RenameDialog(*animation(), &mWindow)); });
    connect(&workspace, &Workspace::currentChanged, this, &EditActions::follow);
    connect(&workspace, &Workspace::currentStateChanged, this, &EditActions::follow);
    follow();
}

void EditActions::follow()
{
    commands::EditContext *context_ = context();
    if (mFollowed && mFollowed != context_)
        disconnect(&mFollowed->undoStack(), nullptr, this, nullptr);
    // A step is all that changes a document: the number of frames changes with the stack.
    if (context_ && mFollowed != context_)
        connect(&context_->undoStack(), &QUndoStack::indexChanged, this, &EditActions::update);
    mFollowed = context_;
    update();
}

void EditActions::update()
{
    const commands::EditContext *context_ = context();
    const QUndoStack *stack = context_ ? &context_->undoStack() : nullptr;
    mActions[ActionId::Undo].setEnabled(stack && stack->canUndo());
    mActions[ActionId::Redo].setEnabled(stack && stack->canRedo());
    mActions.setUndoTexts(stack ? stack->undoText() : QString(), stack ? stack->redoText() : QString());
    const commands::AnimationContext *animation_ = animation();
    const bool severalFrames = animation_ && animation_->document().frameCount() > 1;
    for (const ActionId id : {ActionId::Trim, ActionId::Reverse, ActionId::Resample})
        mActions[id].setEnabled(severalFrames);
    for (const ActionId id : {ActionId::FrameRate, ActionId::Normalise, ActionId::Rename})
        mActions[id].setEnabled(animation_ != nullptr);
}

void EditActions::ask(views::EditDialog *dialog)
{
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

commands::EditContext *EditActions::context() const
{
    const DocumentTab *tab = mWorkspace.current();
    return tab ? tab->document().context() : nullptr;
}

commands::AnimationContext *EditActions::animation() const
{
    const AnimationTab *tab = mWorkspace.currentAnimation();
    return tab ? tab->document().context() : nullptr;
}

} // namespace editor
