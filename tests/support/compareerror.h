// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

/// `result` (a Result) failed with `errorCode`.
#define SANDREEL_COMPARE_ERROR(result, errorCode)                                                                      \
    do {                                                                                                               \
        QVERIFY(!(result).has_value());                                                                                \
        QCOMPARE(int((result).error().code), int(errorCode));                                                          \
    } while (false)
