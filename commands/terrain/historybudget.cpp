// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/terrain/historybudget.h"

#include <QSignalBlocker>
#include <QUndoStack>

#include <vector>

namespace commands {

namespace {

/// What a command weighs that keeps little: an estimate.
constexpr std::size_t LightCommand = 512;

/// What lies on the stack: forwards everything.
class Shell final : public QUndoCommand
{
public:
    Shell(std::shared_ptr<QUndoCommand> command, bool isSilent)
        : QUndoCommand(command->text())
        , mCommand(std::move(command))
        , mIsSilent(isSilent)
    {}

    void redo() override
    {
        if (mIsSilent)
            return;
        mCommand->redo();
        setObsolete(mCommand->isObsolete());
    }
    void undo() override
    {
        if (mIsSilent)
            return;
        mCommand->undo();
        setObsolete(mCommand->isObsolete());
    }
    int id() const override { return mIsSilent ? -1 : mCommand->id(); }
    bool mergeWith(const QUndoCommand *newer) override
    {
        if (!mCommand->mergeWith(static_cast<const Shell *>(newer)->mCommand.get()))
            return false;
        setText(mCommand->text());
        setObsolete(mCommand->isObsolete());
        return true;
    }

    const std::shared_ptr<QUndoCommand> &command() const { return mCommand; }
    void setSilent(bool isSilent) { mIsSilent = isSilent; }
    std::size_t byteSize() const
    {
        const auto *weighted = dynamic_cast<const WeightedCommand *>(mCommand.get());
        return weighted ? weighted->byteSize() : LightCommand;
    }

private:
    std::shared_ptr<QUndoCommand> mCommand;
    bool mIsSilent; ///< while the stack is filled again: what the command does is done already
};

const Shell &shellAt(const QUndoStack &stack, int i)
{
    return *static_cast<const Shell *>(stack.command(i));
}

} // namespace

HistoryBudget::HistoryBudget(QUndoStack &stack, QObject *parent)
    : QObject(parent)
    , mStack(stack)
{}

void HistoryBudget::setLimit(std::size_t bytes)
{
    if (bytes == mLimit)
        return;
    mLimit = bytes;
    enforce();
}

std::size_t HistoryBudget::used() const
{
    std::size_t sum = 0;
    for (int i = 0; i < mStack.count(); ++i)
        sum += shellAt(mStack, i).byteSize();
    return sum;
}

void HistoryBudget::push(std::shared_ptr<QUndoCommand> command)
{
    mStack.push(new Shell(std::move(command), false));
    enforce();
}

void HistoryBudget::enforce()
{
    int from = 0, to = mStack.count();
    std::size_t sum = used();
    while (sum > mLimit && from < mStack.index() - 1)
        sum -= shellAt(mStack, from++).byteSize();
    while (sum > mLimit && to > mStack.index() && to > from + 1)
        sum -= shellAt(mStack, --to).byteSize();
    if (from > 0 || to < mStack.count())
        keep(from, to);
    emit changed();
}

void HistoryBudget::keep(int from, int to)
{
    const int index = mStack.index() - from, clean = mStack.cleanIndex() - from;
    const bool wasClean = mStack.isClean(), couldUndo = mStack.canUndo(), couldRedo = mStack.canRedo();
    std::vector<std::shared_ptr<QUndoCommand>> kept;
    for (int i = from; i < to; ++i)
        kept.push_back(shellAt(mStack, i).command());
    mDropped += mStack.count() - int(kept.size());
    {
        const QSignalBlocker blocker(mStack);
        mStack.clear();
        if (clean != 0)
            mStack.resetClean();
        std::vector<Shell *> shells;
        for (auto &command : kept) {
            shells.push_back(new Shell(std::move(command), true));
            mStack.push(shells.back());
            if (clean == int(shells.size()))
                mStack.setClean();
        }
        mStack.setIndex(index);
        for (Shell *const shell : shells)
            shell->setSilent(false);
    }
    // Views read all of the stack when its index changes.
    emit mStack.indexChanged(mStack.index());
    if (mStack.isClean() != wasClean)
        emit mStack.cleanChanged(mStack.isClean());
    if (mStack.canUndo() != couldUndo)
        emit mStack.canUndoChanged(mStack.canUndo());
    if (mStack.canRedo() != couldRedo)
        emit mStack.canRedoChanged(mStack.canRedo());
}

} // namespace commands
