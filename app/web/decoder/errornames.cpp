// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/decoder/errornames.h"

namespace web {

const char *nameOf(model::ErrorCode code)
{
    using model::ErrorCode;
    switch (code) {
    case ErrorCode::Truncated:
        return "Truncated";
    case ErrorCode::TrailingBytes:
        return "TrailingBytes";
    case ErrorCode::BadMagic:
        return "BadMagic";
    case ErrorCode::UnsupportedVersion:
        return "UnsupportedVersion";
    case ErrorCode::UnsupportedFeature:
        return "UnsupportedFeature";
    case ErrorCode::ChecksumMismatch:
        return "ChecksumMismatch";
    case ErrorCode::MissingChunk:
        return "MissingChunk";
    case ErrorCode::DuplicateChunk:
        return "DuplicateChunk";
    case ErrorCode::BadValue:
        return "BadValue";
    case ErrorCode::UnknownCodec:
        return "UnknownCodec";
    case ErrorCode::CorruptStream:
        return "CorruptStream";
    case ErrorCode::LimitExceeded:
        return "LimitExceeded";
    case ErrorCode::OutOfMemory:
        return "OutOfMemory";
    default:
        return "UnknownError";
    }
}

} // namespace web
