// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QUndoCommand>

#include <cstddef>
#include <memory>

class QUndoStack;

namespace commands {

/// A command that keeps much: it says how much.
class WeightedCommand : public QUndoCommand
{
public:
    using QUndoCommand::QUndoCommand;
    /// Memory that undo and redo need, in bytes.
    virtual std::size_t byteSize() const = 0;
};

/// Keeps what can be undone within a number of bytes: the oldest steps are dropped, and are then no longer shown
/// either. The newest step always stays, however large it is. Steps that can be redone count as well; they are dropped,
/// the last one first, only when all that can be undone is gone but one.
///
/// QUndoStack drops nothing but its end. So its commands are thin shells around those that do the work: to drop the
/// oldest ones, the stack is emptied and filled again with new shells around the others.
class HistoryBudget final : public QObject
{
    Q_OBJECT

public:
    static constexpr std::size_t DefaultLimit = std::size_t(512) << 20;

    explicit HistoryBudget(QUndoStack &stack, QObject *parent = nullptr);

    std::size_t limit() const { return mLimit; }
    void setLimit(std::size_t bytes);
    /// Of all steps on the stack.
    std::size_t used() const;
    /// Steps that were dropped since the document was opened.
    int droppedCount() const { return mDropped; }

    /// Puts a command on the stack, which carries it out.
    void push(std::shared_ptr<QUndoCommand> command);
    /// Drops what is too much. For whoever let a command on the stack grow.
    void enforce();

signals:
    /// What is used, the limit, or how many were dropped.
    void changed();

private:
    void keep(int from, int to);

    QUndoStack &mStack;
    std::size_t mLimit = DefaultLimit;
    int mDropped = 0;
};

} // namespace commands
