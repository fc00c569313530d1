// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/taskqueue.h"

#include "model/base/parallel.h"

#ifndef __wasm__
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#endif

namespace model {

#ifdef __wasm__

struct TaskQueue::Shared
{};
TaskQueue::TaskQueue(std::size_t) {}
TaskQueue::~TaskQueue() = default;
void TaskQueue::run(std::function<void()> task)
{
    task();
}
void TaskQueue::finish() {}

#else

struct TaskQueue::Shared
{
    explicit Shared(std::size_t limit)
        : most(limit)
        , thread([this] { work(); })
    {}

    void work()
    {
        std::unique_lock lock(mutex);
        for (;;) {
            given.wait(lock, [this] { return isEnded || !tasks.empty(); });
            if (isEnded)
                return;
            const std::function<void()> &task = tasks.front(); // stays where it is while others are added behind it
            lock.unlock();
            try {
                task();
                lock.lock();
                tasks.pop_front();
            } catch (...) {
                lock.lock();
                thrown = std::current_exception();
                tasks.clear();
                isEnded = true;
            }
            done.notify_one();
        }
    }

    const std::size_t most;
    std::mutex mutex;
    std::condition_variable given, done;
    std::deque<std::function<void()>> tasks;
    std::exception_ptr thrown;
    bool isEnded = false;
    std::jthread thread; ///< the last: what it uses is there before it
};

TaskQueue::TaskQueue(std::size_t most)
{
    if (threadCount() == 1)
        return;
    try {
        mShared = std::make_unique<Shared>(most);
    } catch (const std::exception &) {
        // No thread, or no memory for one.
    }
}

TaskQueue::~TaskQueue()
{
    if (!mShared)
        return;
    const std::lock_guard lock(mShared->mutex);
    mShared->isEnded = true;
    mShared->given.notify_one();
}

void TaskQueue::run(std::function<void()> task)
{
    if (!mShared)
        return task();
    std::unique_lock lock(mShared->mutex);
    mShared->done.wait(lock, [this] { return mShared->isEnded || mShared->tasks.size() < mShared->most; });
    if (mShared->isEnded)
        return;
    mShared->tasks.push_back(std::move(task));
    mShared->given.notify_one();
}

void TaskQueue::finish()
{
    if (!mShared)
        return;
    std::unique_lock lock(mShared->mutex);
    mShared->done.wait(lock, [this] { return mShared->isEnded || mShared->tasks.empty(); });
    if (mShared->thrown)
        std::rethrow_exception(mShared->thrown);
}

#endif

} // namespace model
