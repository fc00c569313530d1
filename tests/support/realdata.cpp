// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/realdata.h"

#include <QProcess>

namespace tests {

QString dataFolder()
{
    return qEnvironmentVariable("SANDREEL_DATA");
}

QString sequenceFolder(const QString &name)
{
    static const QString unpacked = [] {
        QProcess unpack;
        unpack.start(dataFolder() + QStringLiteral("/unpack"), QStringList());
        if (!unpack.waitForFinished(600'000) || unpack.exitCode() != 0)
            qFatal("cannot unpack the sequences: %s", unpack.readAllStandardError().constData());
        return QString::fromUtf8(unpack.readAllStandardOutput()).trimmed();
    }();
    return unpacked + QLatin1Char('/') + name;
}

} // namespace tests
