// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/parallel.h"

#include <algorithm>
#include <atomic>
#ifndef __wasm__
#include <exception>
#include <thread>
#include <vector>
#endif

namespace model {

namespace {
std::atomic<unsigned> wantedThreads = 0;
}

void setThreadCount(unsigned count)
{
    wantedThreads = count;
}

#ifdef __wasm__

unsigned threadCount()
{
    return 1;
}

void parallelFor(std::size_t count, const std::function<void(std::size_t)> &body)
{
    for (std::size_t i = 0; i < count; ++i)
        body(i);
}

#else

unsigned threadCount()
{
    const unsigned wanted = wantedThreads;
    return wanted ? wanted : std::max(1u, std::thread::hardware_concurrency());
}

void parallelFor(std::size_t count, const std::function<void(std::size_t)> &body)
{
    std::atomic<std::size_t> next = 0;
    std::atomic_flag hasThrown = ATOMIC_FLAG_INIT;
    std::exception_ptr thrown;
    const auto work = [&] {
        try {
            for (std::size_t i = next++; i < count; i = next++)
                body(i);
        } catch (...) {
            next = count;
            if (!hasThrown.test_and_set())
                thrown = std::current_exception();
        }
    };
    {
        const std::size_t helpers = std::min<std::size_t>(threadCount(), std::max<std::size_t>(count, 1)) - 1;
        std::vector<std::jthread> threads;
        threads.reserve(helpers);
        try {
            for (std::size_t i = 0; i < helpers; ++i)
                threads.emplace_back(work);
        } catch (const std::exception &) {
            // No more threads, or no memory for one: those that are there do all of the work.
        }
        work();
    }
    if (thrown)
        std::rethrow_exception(thrown);
}

#endif

void parallelRanges(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)> &body)
{
    const std::size_t step = std::max<std::size_t>(grain, 1);
    parallelFor((count + step - 1) / step, [&](std::size_t i) { body(i * step, std::min(count, (i + 1) * step)); });
}

} // namespace model
