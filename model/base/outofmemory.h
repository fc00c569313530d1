// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"

#include <new>

namespace model {

/// `work()`, which returns a Result, with running out of memory as an error; how many bytes were wanted is not known.
template <class Work>
auto catchBadAlloc(const Work &work) -> decltype(work())
{
    try {
        return work();
    } catch (const std::bad_alloc &) {
        return fail(ErrorCode::OutOfMemory);
    }
}

} // namespace model
