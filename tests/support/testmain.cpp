// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testmain.h"
#include "tests/support/testregistry.h"

#include <filesystem>
#include <iostream>

namespace tests {

std::map<std::string, std::function<std::unique_ptr<QObject>()>> &registry()
{
    static std::map<std::string, std::function<std::unique_ptr<QObject>()>> tests;
    return tests;
}

bool &wholeClassSkipped()
{
    static bool skipped = false;
    return skipped;
}

Registration::Registration(const char *file, std::function<std::unique_ptr<QObject>()> make)
{
    registry().emplace(std::filesystem::path(file).stem().string(), std::move(make));
}

int runTests(int argc, char **argv)
{
    constexpr int Skipped = 77; // what ctest is told to take as "skipped"
    const std::string wanted = argc > 1 && argv[1][0] != '-' ? argv[1] : "";
    if (!wanted.empty() && !registry().contains(wanted)) {
        std::cerr << "no test " << wanted << '\n';
        return 1;
    }
    QStringList arguments;
    for (int i = 0; i < argc; ++i)
        if (i != 1 || wanted.empty())
            arguments << QString::fromLocal8Bit(argv[i]);
    // The handler would attach a debugger and wait for it; a crash should fail at once.
    arguments << QStringLiteral("-nocrashhandler");
    int failures = 0;
    for (const auto &[name, make] : registry())
        if (wanted.empty() || name == wanted)
            failures += QTest::qExec(make().get(), arguments);
    return failures ? failures : !wanted.empty() && wholeClassSkipped() ? Skipped : 0;
}

} // namespace tests
