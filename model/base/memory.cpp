// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/memory.h"

#include <unistd.h>

namespace model {

std::uint64_t physicalMemory()
{
    const long pages = ::sysconf(_SC_PHYS_PAGES), bytes = ::sysconf(_SC_PAGESIZE);
    return pages > 0 && bytes > 0 ? std::uint64_t(pages) * std::uint64_t(bytes) : 0;
}

} // namespace model
