// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace model {

/// Bytes of memory that this machine has; 0 if it does not say.
std::uint64_t physicalMemory();

} // namespace model
