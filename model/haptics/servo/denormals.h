// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace model::haptics {

/// While it lives, numbers below the normal ones are zero in this thread: computing with them takes a hundred times as
/// long. Every step of the servo has it, so that a replay computes the same.
class FlushDenormals
{
public:
#if defined(__SSE__)
    FlushDenormals()
        : mBefore(_mm_getcsr())
    {
        constexpr unsigned FlushToZero = 0x8000, DenormalsAreZero = 0x0040;
        _mm_setcsr(mBefore | FlushToZero | DenormalsAreZero);
    }
    ~FlushDenormals()
    {
        _mm_setcsr(mBefore);
    }
    FlushDenormals(const FlushDenormals &) = delete;
    FlushDenormals &operator=(const FlushDenormals &) = delete;

private:
    unsigned mBefore;
#else
    FlushDenormals() {} // not trivial, so that it counts as used
#endif
};

} // namespace model::haptics
