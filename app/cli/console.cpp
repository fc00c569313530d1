// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/console.h"

#include <QJsonDocument>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <unistd.h>

namespace cli {

namespace {

/// The running work, for the signal handler; a store to an atomic is all that it does with it. Null while the next one
/// is put in place: the flag remembers a signal that comes then.
std::atomic<const model::Progress *> interruptible = nullptr;
std::atomic<bool> interrupted = false;

/// Signals of which the second ends the process at once, should the work not heed the first.
constexpr int Interrupts[] = {SIGINT, SIGTERM};

void interrupt(int)
{
    for (const int number : Interrupts)
        std::signal(number, SIG_DFL);
    interrupted = true;
    if (const model::Progress *work = interruptible)
        work->cancel();
}

/// Names come from files of others: they must not steer the terminal.
QString printable(QString text)
{
    for (QChar &c : text)
        if (c.category() == QChar::Other_Control && c != QLatin1Char('\n'))
            c = QChar::ReplacementCharacter;
    return text;
}

} // namespace

ExitCode exitCodeOf(const model::Error &error)
{
    switch (model::categoryOf(error.code)) {
    case model::ErrorCategory::Usage:
        return ExitCode::Usage;
    case model::ErrorCategory::BadInput:
        return ExitCode::BadInput;
    case model::ErrorCategory::InputOutput:
        return ExitCode::InputOutput;
    case model::ErrorCategory::Limit:
        return ExitCode::Limit;
    case model::ErrorCategory::Cancelled:
        return ExitCode::Interrupted;
    }
    return ExitCode::BadInput;
}

Console::Console()
    : mHasTerminal(isatty(STDERR_FILENO) != 0)
{
    for (const int number : Interrupts)
        if (std::signal(number, interrupt) == SIG_IGN) // what nohup and a shell's "&" ask for
            std::signal(number, SIG_IGN);
    // A reader that goes away is a failed write, not a death that leaves files behind.
    std::signal(SIGPIPE, SIG_IGN);
}

model::Progress Console::progress(const std::string &label)
{
    endProgress();
    model::Progress::Callback draw;
    if (mHasTerminal && !mQuiet)
        draw = [this, label, drawn = -1](double fraction) mutable {
            constexpr int Width = 30;
            constexpr int QuickWork = 200; // milliseconds; a bar that only flashes up is no help
            const int percent = int(fraction * 100);
            if (percent == drawn || mSinceStart.elapsed() < QuickWork)
                return;
            drawn = percent;
            const int filled = int(fraction * Width);
            std::fprintf(stderr, "\r%-10s [%s%s] %3d %%", label.c_str(), std::string(filled, '#').c_str(),
                         std::string(Width - filled, '.').c_str(), percent);
            mBarDrawn = true;
        };
    mSinceStart.start();
    interruptible = nullptr;
    mWork = model::Progress(std::move(draw));
    interruptible = &mWork;
    if (interrupted)
        mWork.cancel();
    return mWork;
}

bool Console::isInterrupted() const
{
    return interrupted;
}

void Console::endProgress()
{
    if (mBarDrawn)
        std::fprintf(stderr, "\r%60s\r", "");
    mBarDrawn = false;
}

void Console::note(const QString &text)
{
    if (!mQuiet)
        error(text);
}

void Console::error(const QString &text)
{
    endProgress();
    std::fprintf(stderr, "%s\n", qUtf8Printable(printable(text)));
}

void Console::line(const QString &text)
{
    endProgress();
    std::fprintf(stdout, "%s\n", qUtf8Printable(printable(text)));
}

void Console::json(const QJsonObject &object)
{
    endProgress();
    std::fputs(QJsonDocument(object).toJson(QJsonDocument::Indented).constData(), stdout);
}

void Console::data(const QJsonObject &object, const QStringList &lines)
{
    if (mJson)
        return json(object);
    for (const QString &text : lines)
        line(text);
}

void Console::outcome(const QJsonObject &object, const QString &text)
{
    if (mJson)
        return json(object);
    note(text);
}

bool Console::flush()
{
    return std::fflush(stdout) == 0 && !std::ferror(stdout);
}

} // namespace cli
