// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QJsonObject>
#include <QProcessEnvironment>
#include <QString>
#include <QStringList>

namespace tests {

/// What a run of the program left.
struct CliRun
{
    int exitCode = -1; ///< -1: it crashed or did not end
    QByteArray out, err;

    /// Standard output as one JSON object; empty if it is anything else.
    QJsonObject json() const;
};

/// Runs sandreel-cli as a shell would and waits for its end.
/// \param output  where standard output goes; empty: into CliRun::out
CliRun runCli(const QStringList &arguments, const QString &output = QString(),
              const QProcessEnvironment &environment = QProcessEnvironment::systemEnvironment());

} // namespace tests

/// Runs the program into `run` and shows what it said if its exit code is another one.
#define SANDREEL_RUN(run, code, ...)                                                                                   \
    const tests::CliRun run = tests::runCli(__VA_ARGS__);                                                              \
    QVERIFY2(run.exitCode == (code),                                                                                   \
             ("exit code " + QByteArray::number(run.exitCode) + ", " + run.err + run.out).constData())
