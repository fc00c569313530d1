// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"

#include <cstdint>
#include <memory>
#include <string_view>

#include <QFile>
#include <QString>

namespace model::io {

/// The largest file that is read into memory as a whole. Keeps every count in it below 2^32.
constexpr std::uint64_t MaxFileBytes = std::uint64_t(4) << 30;

/// Opens an ordinary file for reading, without buffering. Folders, pipes and devices are refused before they are
/// opened: opening a pipe would block. \error NotFound, CannotOpen
Result<void> openFile(QFile &file);

/// Fills `out` from where `file` is, in pieces. \returns the bytes read, fewer only at the end of the file
/// \error CannotRead, Cancelled
Result<std::uint64_t> readInto(QFile &file, char *out, std::uint64_t count, const Progress &progress = Progress());

/// The contents of one file after another, in memory that is reused.
class FileBuffer
{
public:
    /// \returns the whole file, valid until the next call
    /// \error NotFound, CannotOpen, CannotRead, LimitExceeded, OutOfMemory, Cancelled; all name the file
    Result<std::string_view> load(const QString &path, const Progress &progress = Progress());

private:
    std::unique_ptr<char[]> mMemory;
    std::uint64_t mCapacity = 0;
};

} // namespace model::io
