// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"

#include <cstdint>
#include <span>

#include <QSaveFile>
#include <QString>

class QFileDevice;

namespace model::io {

/// A file that takes the place of another one when all of its bytes are on the disk. Until then, and for ever without
/// commit(), the other one stays as it is.
///
/// QSaveFile alone is not enough: on a full disk it cuts small files off without an error, as it does not look at what
/// its buffer says; and it puts an ordinary file in the place of a device.
class SaveFile
{
public:
    explicit SaveFile(const QString &path);

    /// \error CannotOpen  also for folders, devices and pipes
    Result<void> open();
    /// \error CannotWrite
    Result<void> write(std::span<const std::uint8_t> bytes);
    /// \error CannotWrite
    Result<void> commit();

private:
    QSaveFile mFile;
};

/// Writes bytes through a SaveFile: all or nothing. \error CannotOpen, CannotWrite
Result<void> saveBytes(const QString &path, std::span<const std::uint8_t> bytes);

/// All of `bytes` to where an unbuffered file is. \error CannotWrite
Result<void> writeAll(QFileDevice &file, std::span<const std::uint8_t> bytes);

} // namespace model::io
