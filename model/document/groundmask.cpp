// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/groundmask.h"

#include <utility>

namespace model {

GroundMask::Value GroundMask::setValue(Value value)
{
    Value before = std::exchange(mValue, std::move(value));
    if (mValue != before)
        emit changed();
    return before;
}

} // namespace model
