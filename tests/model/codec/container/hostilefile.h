// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/parallel.h"
#include "model/codec/animationcodec.h"

#include <QStringList>

/// What the tests of hostile files share. Golden files are what is damaged: they use all that was ever written. The
/// fuzzers (tests/fuzz) go on where these tests end.
namespace tests {

/// A file of tests/data, such as "anim/reel-1.0.anim"; empty if it cannot be read.
model::Bytes dataFile(const QString &path);
/// The names of the `.anim` files in a folder of tests/data.
QStringList animFilesIn(const QString &folder);
/// A row for each golden file, with its "name".
void addGoldenRows();

/// What any bytes must lead to: a named error with its place, or positions that are finite; and no more memory than
/// the caller allows. \returns what is wrong, or nothing
QString complaintAbout(const model::Bytes &file, const model::codec::DecodeLimits &limits = {});
/// Fails the test if there is a complaint.
void checkHostile(const model::Bytes &file, const QString &what, const model::codec::DecodeLimits &limits = {});

/// The error of decoding; NotAnError if there is none.
model::ErrorCode codeOf(const model::Bytes &file, const model::codec::DecodeLimits &limits = {});
inline constexpr model::ErrorCode NotAnError{0xffff};

/// One thread while it lives: starting threads takes longer than files of this size.
class OneThread
{
public:
    OneThread() { model::setThreadCount(1); }
    ~OneThread() { model::setThreadCount(0); }
    OneThread(const OneThread &) = delete;
    OneThread &operator=(const OneThread &) = delete;
};

} // namespace tests
