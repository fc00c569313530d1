// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/bytes.h"

#include <string>
#include <vector>

namespace model::io {

struct ZipEntry
{
    std::string name; ///< UTF-8, relative, with '/'
    Bytes bytes;
    bool isPacked = false; ///< when writing: deflate it
};

/// The bytes of a ZIP file, ZIP64 where it has to be; the same for the same entries, which carry no dates.
/// \error ImporterFailed  what libzip says
Result<Bytes> writeZip(const std::vector<ZipEntry> &entries);

/// All entries of a ZIP file, in their order. Counts, names and sizes are checked before anything is allocated: folders
/// are left out; names that lead out of a folder are refused.
/// \param memoryLimit  bytes that all entries together may take
/// \error BadMagic, CorruptStream, BadValue (a name), LimitExceeded, ChecksumMismatch,
///        UnsupportedFeature (encryption and other methods)
Result<std::vector<ZipEntry>> readZip(std::span<const std::uint8_t> bytes, std::uint64_t memoryLimit);

} // namespace model::io
