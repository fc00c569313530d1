// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

#include <functional>
#include <memory>

namespace tests {

/// Registers a test class under the stem of its file: tst_bytes.cpp -> "tst_bytes". One binary holds the tests of an
/// area; ctest runs each class as a test of its own.
struct Registration
{
    Registration(const char *file, std::function<std::unique_ptr<QObject>()> make);
};

} // namespace tests

/// At the end of each tst_x.cpp, before its "tst_x.moc".
#define SANDREEL_TEST(Class)                                                                                           \
    static const tests::Registration registration(__FILE__, [] { return std::make_unique<Class>(); });
