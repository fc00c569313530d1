// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/bytes.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace tests {

/// The chunks of a well-formed file as (tag, payload).
using RawChunks = std::vector<std::pair<std::string, model::Bytes>>;
RawChunks takeApart(const model::Bytes &file);
/// Puts them together with lengths and checksums (zlib's) that are right.
model::Bytes putTogether(const RawChunks &chunks);
/// The file with the payload of one chunk changed, its checksum being right.
model::Bytes withPayload(const model::Bytes &file, const std::string &tag,
                         const std::function<void(model::Bytes &)> &change);

/// A small animation as a file.
model::Bytes smallFile();
/// An error as "Code @offset args", for comparing.
std::string errorText(const model::Bytes &file);

} // namespace tests
