// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testregistry.h"

#include <QApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QTemporaryDir>

/// A QApplication as the editor has it, whose settings begin empty and go with the process.
int main(int argc, char **argv)
{
    QSurfaceFormat format; // what views::setDefaultGlFormat() sets; not every GUI test links the viewport
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format);

    const QTemporaryDir settings;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName(QStringLiteral("SandreelTests"));
    QCoreApplication::setApplicationName(QStringLiteral("SandreelTests"));

    const QApplication application(argc, argv);
    return tests::runTests(argc, argv);
}
