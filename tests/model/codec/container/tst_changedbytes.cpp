// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/codec/container/hostilefile.h"
#include "tests/model/codec/filesurgery.h"
#include "tests/support/testmain.h"

#include <random>

using namespace model;
using namespace model::codec;

namespace {

/// The values that replace a byte.
std::vector<std::uint8_t> replacements(std::uint8_t byte)
{
    return {std::uint8_t(byte ^ 1), std::uint8_t(byte ^ 0x80), 0, 255};
}

} // namespace

/// Files with a byte changed, by accident or on purpose.
class TestChangedBytes final : public QObject
{
    Q_OBJECT

private slots:
    void everyChangedByteIsRefused_data() { tests::addGoldenRows(); }
    void everyChangedByteIsRefused()
    {
        QFETCH(QString, name);
        const tests::OneThread one;
        const Bytes file = tests::dataFile("anim/" + name);
        for (std::size_t i = 0; i < file.size(); ++i)
            for (const std::uint8_t value : replacements(file[i])) {
                if (value == file[i])
                    continue;
                Bytes damaged = file;
                damaged[i] = value;
                const QString what = QString("byte %1 = %2").arg(i).arg(value);
                QVERIFY2(tests::codeOf(damaged) != tests::NotAnError, qPrintable(what));
                tests::checkHostile(damaged, what);
            }
    }

    // With the checksum of its chunk mended, so that the stage itself meets it.
    void everyChangedByteIsSurvived_data() { tests::addGoldenRows(); }
    void everyChangedByteIsSurvived()
    {
        QFETCH(QString, name);
        const tests::OneThread one;
        const auto chunks = tests::takeApart(tests::dataFile("anim/" + name));
        // Of the long chunks one value for each byte instead of all: chosen by this, the same each time.
        std::minstd_rand random(20261122);
        for (std::size_t c = 0; c < chunks.size(); ++c)
            for (std::size_t i = 0; i < chunks[c].second.size(); ++i) {
                auto values = replacements(chunks[c].second[i]);
                if (chunks[c].second.size() > 64)
                    values = {values[random() % values.size()]};
                for (const std::uint8_t value : values) {
                    auto damaged = chunks;
                    damaged[c].second[i] = value;
                    tests::checkHostile(tests::putTogether(damaged),
                                        QString("byte %1 of %2 = %3").arg(i).arg(chunks[c].first.c_str()).arg(value));
                }
            }
    }

    // What the fuzzers found, see its README.
    void findingsStayMended_data()
    {
        QTest::addColumn<QString>("name");
        for (const QString &name : tests::animFilesIn("hostile"))
            QTest::newRow(qPrintable(name)) << name;
    }
    void findingsStayMended()
    {
        QFETCH(QString, name);
        const Bytes file = tests::dataFile("hostile/" + name);
        QVERIFY(!file.empty());
        tests::checkHostile(file, name);
    }
};

SANDREEL_TEST(TestChangedBytes)
#include "tst_changedbytes.moc"
