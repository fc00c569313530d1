// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/documents/filestamp.h"

#include <QFileInfo>

namespace editor {

FileStamp FileStamp::of(const QString &path)
{
    const QFileInfo info(path);
    return info.exists() ? FileStamp{info.size(), info.lastModified()} : FileStamp{};
}

} // namespace editor
