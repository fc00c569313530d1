// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"

#include <QElapsedTimer>
#include <QJsonObject>
#include <QString>
#include <QStringList>

#include <string>

namespace cli {

/// What the program returns to its caller.
enum class ExitCode : int { Ok = 0, Usage = 2, BadInput = 3, InputOutput = 4, Limit = 5, Interrupted = 130 };

ExitCode exitCodeOf(const model::Error &error);

/// The program's two streams: data go to standard output, everything meant for a person's eyes while waiting to
/// standard error. SIGINT and SIGTERM cancel the work through progress(). One per program run.
class Console
{
public:
    Console();

    void setJson(bool json) { mJson = json; }
    bool isJson() const { return mJson; }
    void setQuiet(bool quiet) { mQuiet = quiet; }

    /// For the work that `label` names ("Encoding"): draws a bar while it runs, on a terminal only.
    model::Progress progress(const std::string &label);
    /// A signal has come. Asked before the last step of a sub-command, which is not interrupted.
    bool isInterrupted() const;
    /// Wipes the bar.
    void endProgress();

    /// A line on standard error, unless quiet.
    void note(const QString &text);
    /// A line on standard error, always.
    void error(const QString &text);
    /// A line of data on standard output.
    void line(const QString &text);
    void json(const QJsonObject &object);
    /// Data: the object with --json, else the lines.
    void data(const QJsonObject &object, const QStringList &lines);
    /// What was written where: the object as data with --json, else a note.
    void outcome(const QJsonObject &object, const QString &text);

    /// Writes out what is buffered. \returns false if standard output could not take it all (a full disk, a closed
    /// pipe)
    bool flush();

private:
    bool mJson = false;
    bool mQuiet = false;
    bool mHasTerminal;
    bool mBarDrawn = false;
    QElapsedTimer mSinceStart; ///< of the work in progress
    model::Progress mWork;
};

} // namespace cli
