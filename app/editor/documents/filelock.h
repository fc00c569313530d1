// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLockFile>
#include <QString>

#include <memory>

namespace editor {

/// Says to other programs like this one that a file is being edited: a small file beside it, which goes with this
/// object, and is taken over from a program that is gone. Nothing is said where no file can be made: nothing can be
/// saved there either.
class FileLock
{
public:
    /// Gives the one before back. An empty path holds none.
    void hold(const QString &path);

    /// Somebody else has it: "Sandreel (process 1234 on tower)"; empty if nobody does.
    const QString &holder() const { return mHolder; }

private:
    QString mPath;
    QString mHolder;
    std::unique_ptr<QLockFile> mLock;
};

} // namespace editor
