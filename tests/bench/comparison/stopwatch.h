// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <chrono>

namespace bench {

/// Seconds that `work` takes; of what is short, the median of three times.
template <class Work>
double secondsOf(Work &&work)
{
    constexpr double Short = 1;
    const auto once = [&] {
        const auto begin = std::chrono::steady_clock::now();
        work();
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    const double first = once();
    if (first > Short)
        return first;
    std::array<double, 3> all{first, once(), once()};
    std::sort(all.begin(), all.end());
    return all[1];
}

} // namespace bench
