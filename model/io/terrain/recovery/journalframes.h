// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/terrain/recovery.h"

#include <span>
#include <vector>

namespace model::io {

// The frames that a journal consists of. FORMAT.md, 8.

/// What a journal begins with; the last byte is its version.
inline constexpr std::uint8_t JournalMagic[8] = {'S', 'R', 'J', 'O', 'U', 'R', 'N', 1};
enum FrameKind : std::uint8_t { BaseFrame, SnapshotFrame, EditFrame, SettingsFrame, MaskFrame };

/// A frame that was read.
struct Frame
{
    std::uint8_t kind;
    std::uint64_t offset; ///< of the payload in the journal
    std::span<const std::uint8_t> payload;
};

std::uint32_t journalCrcOf(std::span<const std::uint8_t> bytes);

/// Length, checksum, kind and payload.
Bytes frameOf(std::uint8_t kind, std::span<const std::uint8_t> payload);
/// The first frame of a journal.
Bytes frameOfBase(const RecoveryBase &base);
/// Mirrors frameOfBase(). \error Truncated  there is no such frame
Result<RecoveryBase> readBase(const std::vector<Frame> &frames);

/// The frames that are whole, up to the first that is not.
/// \error BadMagic, UnsupportedVersion, Truncated
Result<std::vector<Frame>> readFrames(std::span<const std::uint8_t> journal, std::uint64_t &tornBytes);

/// The triangle that the void mark of an edit is about: at the domain's first corner, along its south border.
bool isFirstVoid(const terrain::TinArrays &tin);

} // namespace model::io
