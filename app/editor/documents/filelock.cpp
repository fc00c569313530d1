// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/documents/filelock.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace editor {

void FileLock::hold(const QString &path)
{
    if (path == mPath && mHolder.isEmpty() && (mLock || path.isEmpty()))
        return;
    mLock.reset();
    mHolder.clear();
    mPath = path;
    if (path.isEmpty())
        return;
    const QFileInfo file(path);
    mLock = std::make_unique<QLockFile>(file.absolutePath() + QStringLiteral("/.~lock.") + file.fileName());
    mLock->setStaleLockTime(0); // only a program that is gone has left its lock, however long ago
    if (mLock->tryLock())
        return;
    if (mLock->error() == QLockFile::LockFailedError) {
        qint64 process = 0;
        QString host, program;
        mLock->getLockInfo(&process, &host, &program);
        mHolder = QCoreApplication::translate("Documents", "%1 (process %2 on %3)").arg(program).arg(process).arg(host);
    }
    mLock.reset();
}

} // namespace editor
