// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/codec/container/hostilefile.h"
#include "tests/model/codec/filesurgery.h"
#include "tests/support/testmain.h"

using namespace model;

/// Files and chunks that end too early.
class TestPrefixes final : public QObject
{
    Q_OBJECT

private slots:
    void everyPrefixIsRefused_data() { tests::addGoldenRows(); }
    void everyPrefixIsRefused()
    {
        QFETCH(QString, name);
        const tests::OneThread one;
        const Bytes file = tests::dataFile("anim/" + name);
        QVERIFY(!file.empty());
        for (std::size_t length = 0; length < file.size(); ++length) {
            const Bytes prefix(file.begin(), file.begin() + std::ptrdiff_t(length));
            QVERIFY2(tests::codeOf(prefix) == (length == 0 ? ErrorCode::BadMagic : ErrorCode::Truncated),
                     qPrintable(QString::number(length)));
            tests::checkHostile(prefix, QString::number(length));
        }
    }

    void everyPrefixOfAChunkIsSurvived_data() { tests::addGoldenRows(); }
    void everyPrefixOfAChunkIsSurvived()
    {
        QFETCH(QString, name);
        const tests::OneThread one;
        const auto chunks = tests::takeApart(tests::dataFile("anim/" + name));
        for (std::size_t i = 0; i + 1 < chunks.size(); ++i)
            for (std::size_t length = 0; length < chunks[i].second.size(); ++length) {
                auto damaged = chunks;
                damaged[i].second.resize(length);
                // A shorter stream may happen to be a whole one: the checksum is there to tell.
                tests::checkHostile(tests::putTogether(damaged),
                                    QString("%1 of %2").arg(length).arg(chunks[i].first.c_str()));
            }
    }
};

SANDREEL_TEST(TestPrefixes)
#include "tst_prefixes.moc"
