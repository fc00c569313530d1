// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testregistry.h"
#include "views/viewport/glsupport.h"

#include <QApplication>
#include <QStandardPaths>

int main(int argc, char **argv)
{
    // Settings and recent files of a test must not be those of the person who runs it.
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName(QStringLiteral("Sandreel"));
    QCoreApplication::setApplicationName(QStringLiteral("sandreel-tests"));
    views::setDefaultGlFormat();
    const QApplication application(argc, argv);
    return tests::runTests(argc, argv);
}
