// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/error.h"

namespace model {

ErrorCategory categoryOf(ErrorCode code)
{
    switch (code) {
    case ErrorCode::BadSetting:
    case ErrorCode::CrossingConstraints:
        return ErrorCategory::Usage;
    case ErrorCode::CannotOpen:
    case ErrorCode::CannotRead:
    case ErrorCode::CannotWrite:
    case ErrorCode::NotFound:
        return ErrorCategory::InputOutput;
    case ErrorCode::LimitExceeded:
    case ErrorCode::OutOfMemory:
        return ErrorCategory::Limit;
    case ErrorCode::Cancelled:
        return ErrorCategory::Cancelled;
    default:
        return ErrorCategory::BadInput;
    }
}

} // namespace model
