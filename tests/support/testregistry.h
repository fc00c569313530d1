// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include <QObject>

namespace tests {

std::map<std::string, std::function<std::unique_ptr<QObject>()>> &registry();

/// Set by a class that skips all its tests in initTestCase().
bool &wholeClassSkipped();

/// Runs the test class that the first argument names (all without one), the rest going to QTest.
/// \returns 0 passed, 77 all skipped, else the number of failures
int runTests(int argc, char **argv);

} // namespace tests
