// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/container/container.h"

namespace model::codec {

/// Models of probabilities, and what else the stages hold that does not grow with the counts; the most there was is
/// 4.2 MB.
inline constexpr std::uint64_t WorkingMemory = 6 << 20;

/// Refuses a file before anything is allocated for what it announces.
/// \param header  the file's first chunk: where the counts are
/// \param needed  bytes, by the counts; WorkingMemory is added
/// \error LimitExceeded, at the header
Result<void> requireMemory(const Chunk &header, std::uint64_t needed, std::uint64_t limit);

} // namespace model::codec
