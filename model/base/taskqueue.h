// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace model {

/// Runs tasks one after another, in the order in which they are given, beside the thread that gives them: the second
/// half of a pipeline. Where threadCount() is 1, or no thread can be had, each runs when it is given: what comes out is
/// the same.
class TaskQueue
{
public:
    /// \param most  tasks that wait at a time: who gives more waits for one to end; at least 1
    explicit TaskQueue(std::size_t most);
    /// Waits for the task that runs; those that were not begun are dropped.
    ~TaskQueue();
    TaskQueue(const TaskQueue &) = delete;
    TaskQueue &operator=(const TaskQueue &) = delete;

    void run(std::function<void()> task);
    /// Waits until all are done. What a task throws (std::bad_alloc, as we throw nothing ourselves) ends the queue and
    /// is thrown here again.
    void finish();

private:
    struct Shared;
    std::unique_ptr<Shared> mShared; ///< none: without a thread
};

} // namespace model
