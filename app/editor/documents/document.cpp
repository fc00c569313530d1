// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/documents/document.h"

#include "app/editor/start/samples.h"

#include <QFileInfo>
#include <QUndoStack>

namespace editor {

namespace {

bool isInResources(const QString &path)
{
    return path.startsWith(QLatin1String(":/"));
}

} // namespace

Document::Document(QObject *parent)
    : QObject(parent)
{
    connect(&mOpening, &views::Job::runningChanged, this, &Document::stateChanged);
    connect(&mSaving, &views::Job::runningChanged, this, &Document::stateChanged);
}

void Document::open(const QString &path)
{
    mSource = path;
    mPath = isInResources(path) ? QString() : path;
    read(path);
}

void Document::save(const QString &path)
{
    Q_ASSERT(canSave());
    write(path);
}

void Document::finishOpening(const FileStamp &stamp)
{
    mStamp = stamp;
    updateModified();
    emit opened();
}

void Document::finishSaving(const QString &path, const FileStamp &stamp, int step)
{
    mSource = mPath = path;
    mStamp = stamp;
    // The stack can mark only the step that it stands on.
    QUndoStack &stack = context()->undoStack();
    if (stack.index() == step)
        stack.setClean();
    else
        stack.resetClean();
    updateModified();
    emit saved();
    emit stateChanged();
}

QString Document::title() const
{
    return mPath.isEmpty() ? sampleName(mSource) : QFileInfo(mPath).completeBaseName();
}

QString Document::origin() const
{
    return tr("Sample, not saved to a file yet");
}

void Document::updateModified()
{
    const bool modified = isModified();
    if (std::exchange(mWasModified, modified) != modified)
        emit stateChanged();
}

} // namespace editor
