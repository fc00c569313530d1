// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/container/memorylimit.h"

namespace model::codec {

Result<void> requireMemory(const Chunk &header, std::uint64_t needed, std::uint64_t limit)
{
    needed += WorkingMemory;
    if (needed <= limit)
        return {};
    return fail(Error{ErrorCode::LimitExceeded,
                      {"memory", std::to_string(needed), std::to_string(limit)},
                      {},
                      Error::None,
                      header.offset});
}

} // namespace model::codec
