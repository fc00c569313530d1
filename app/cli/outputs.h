// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/commands.h"

#include <vector>

namespace cli {

/// A file, or a folder of frames, that a sub-command is asked to write.
struct Output
{
    const char *option;
    std::string path; ///< empty: not asked for
    bool isFolder = false;
};

/// Finds out before the work what would only come to light after it, when the result is lost.
/// \error BadSetting  an output is an input, or two outputs are one file
/// \error CannotOpen  its folder is missing or cannot be written to
/// \error CannotWrite it exists and is no ordinary file: a device would be replaced by a file
model::Result<void> checkOutputs(const std::vector<Output> &outputs, const std::vector<std::string> &inputs);

/// The ending of a path, lower case, without dot; empty for "name" and for "folder.pc2/".
QString endingOf(const std::string &path);

/// Removes what has been written when a later step fails, unless it had been there before.
class RemoveUnlessKept
{
public:
    explicit RemoveUnlessKept(const std::string &path);
    RemoveUnlessKept(const RemoveUnlessKept &) = delete;
    RemoveUnlessKept &operator=(const RemoveUnlessKept &) = delete;
    ~RemoveUnlessKept();

    void keep() { mPath.clear(); }

private:
    QString mPath; ///< empty: nothing to remove
};

} // namespace cli
