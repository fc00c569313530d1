// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/terrain/terraincontext.h"

#include <utility>

namespace commands {

using model::terrain::Edit;

TerrainContext::TerrainContext(model::TerrainDocument &document, QObject *parent)
    : DocumentContext(document, parent)
    , mHistory(undoStack())
{}

TerrainContext::~TerrainContext() = default;

void TerrainContext::pushCommand(std::unique_ptr<QUndoCommand> command)
{
    if (command->isObsolete())
        return;
    endGesture();
    mHistory.push(std::move(command));
}

void TerrainContext::beginGesture(const QString &text)
{
    endGesture();
    mHasGesture = true;
    mText = text;
}

const Edit *TerrainContext::keep(Edit edit)
{
    Q_ASSERT(mHasGesture);
    if (edit.isEmpty())
        return nullptr;
    if (mStep && undoStack().isClean()) {
        // It was saved as it is.
        mStep->mOnUndo = nullptr;
        mStep.reset();
    }
    if (mStep) {
        joinLast();
        mStep->mEdits.push_back(std::move(edit));
        return &mStep->mEdits.back();
    }
    mJoiner.reset();
    std::vector<Edit> edits;
    edits.push_back(std::move(edit));
    mStep.reset(new EditSurface(mDocument, mText, std::move(edits)));
    mStep->mOnUndo = [this] {
        // The stack undoes this very step.
        mStep.reset();
        endGesture();
    };
    const std::shared_ptr<EditSurface> step = mStep;
    mHistory.push(step);
    return &step->mEdits.back();
}

/// Joins the last edit of the step to the one before it. The very last one stays as it is until the next one comes:
/// keep() has given it away.
void TerrainContext::joinLast()
{
    std::vector<Edit> &edits = mStep->mEdits;
    if (edits.size() < 2)
        return;
    Edit &before = edits[edits.size() - 2];
    if (!mJoiner)
        mJoiner.emplace(before);
    if (mJoiner->join(before, edits.back()))
        edits.pop_back();
    else
        mJoiner.reset();
}

void TerrainContext::endGesture()
{
    if (!std::exchange(mHasGesture, false))
        return;
    if (const auto step = std::exchange(mStep, nullptr)) {
        step->mOnUndo = nullptr;
        mHistory.enforce();
    }
    emit gestureEnded();
}

void TerrainContext::cancelGesture()
{
    if (!mHasGesture)
        return;
    const std::shared_ptr<EditSurface> step = mStep;
    endGesture();
    if (!step)
        return;
    step->setObsolete(true); // the stack drops it
    undoStack().undo();
}

} // namespace commands
