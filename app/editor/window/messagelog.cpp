// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/window/messagelog.h"

#include "views/itemmodels/logmodel.h"

#include <QMutex>
#include <QtGlobal>

namespace editor {

namespace {

// A message handler is a plain function, so its state cannot but be global.
QBasicMutex mutex;
views::LogModel *target = nullptr;
QtMessageHandler previous = nullptr;

views::LogLevel levelOf(QtMsgType type)
{
    switch (type) {
    case QtDebugMsg:
    case QtInfoMsg:
        return views::LogLevel::Info;
    case QtWarningMsg:
        return views::LogLevel::Warning;
    case QtCriticalMsg:
    case QtFatalMsg:
        return views::LogLevel::Error;
    }
    return views::LogLevel::Warning;
}

void handle(QtMsgType type, const QMessageLogContext &context, const QString &text)
{
    {
        const QMutexLocker locker(&mutex);
        if (target && type != QtDebugMsg)
            target->addFromAnyThread(levelOf(type), text);
    }
    if (previous)
        previous(type, context, text);
}

} // namespace

MessageLog::MessageLog(views::LogModel &log)
{
    const QMutexLocker locker(&mutex);
    target = &log;
    previous = qInstallMessageHandler(handle);
}

MessageLog::~MessageLog()
{
    qInstallMessageHandler(previous);
    const QMutexLocker locker(&mutex);
    target = nullptr;
}

} // namespace editor
