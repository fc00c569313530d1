// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/parallel.h"

#include <benchmark/benchmark.h>

#include <atomic>

namespace {

/// What a call of parallelFor costs by itself: the threads that it starts.
void parallelForOverhead(benchmark::State &state)
{
    std::atomic<int> sum = 0;
    for (auto _ : state)
        model::parallelFor(64, [&](std::size_t i) { sum += int(i); });
    benchmark::DoNotOptimize(sum.load());
}
BENCHMARK(parallelForOverhead)->Unit(benchmark::kMicrosecond)->UseRealTime();

} // namespace
