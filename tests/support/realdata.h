// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/testregistry.h"

#include <QString>
#include <QTest>

namespace tests {

/// The folder that SANDREEL_DATA names, empty if it is not set.
QString dataFolder();

/// The folder of one unpacked sequence, e.g. "dance"; unpacks all of them the first time. Precondition: dataFolder()
/// is not empty.
QString sequenceFolder(const QString &name);

} // namespace tests

/// In initTestCase() of a class that needs the real data: skips the whole class, and says so, where there are none.
#define SANDREEL_REQUIRE_DATA()                                                                                        \
    do {                                                                                                               \
        if (tests::dataFolder().isEmpty()) {                                                                           \
            tests::wholeClassSkipped() = true;                                                                         \
            QSKIP("SANDREEL_DATA is not set: tests on real data are skipped");                                         \
        }                                                                                                              \
    } while (false)
