// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/filebuffer.h"

#include "model/io/animationreader.h"
#include "model/io/animationwriter.h"
#include "model/io/animfile.h"
#include "model/io/positionmemory.h"
#include "tests/model/io/iotest.h"
#include "tests/support/scarcity.h"
#include "tests/support/testmain.h"

#include <cstring>

using namespace model;
using namespace model::io;
using tests::WavyFrames;

/// Files that cannot be read to their end, and memory that is not there for them.
class TestFileBuffer final : public tests::FolderTest
{
    Q_OBJECT

private slots:
    void filesComeOneAfterAnother()
    {
        tests::put(path("long"), QByteArray(1000, 'a'));
        tests::put(path("short"), "bc");
        FileBuffer buffer;
        QCOMPARE(buffer.load(path("long"))->size(), std::size_t(1000));
        QCOMPARE(*buffer.load(path("short")), std::string_view("bc"));
        QCOMPARE(*buffer.load(path("long")), std::string_view(std::string(1000, 'a')));
    }

    /// The kernel lets anybody open his own process's memory as an ordinary file, and refuses to read its first page.
    void unreadableFileIsAnError()
    {
        const QString reason = QString::fromLocal8Bit(std::strerror(EIO));
        QFile file(QStringLiteral("/proc/self/mem"));
        QVERIFY(openFile(file).has_value());
        char byte = 0;
        const auto got = readInto(file, &byte, 1);
        SANDREEL_COMPARE_ERROR(got, ErrorCode::CannotRead);
        QCOMPARE(tests::argsOf(got.error()), QStringList(reason));
        QCOMPARE(got.error().file, std::string("/proc/self/mem"));
        for (const QString &name : {path("a.pc2"), path("a.mdd")}) {
            QVERIFY(QFile::link("/proc/self/mem", name));
            const auto read = readAnimation(name);
            SANDREEL_COMPARE_ERROR(read, ErrorCode::CannotRead);
            QCOMPARE(read.error().file, name.toStdString());
        }
    }

    void fileLargerThanTheMemoryIsAnError()
    {
        constexpr std::size_t Size = 1'000'000;
        tests::put(path("large"), QByteArray(Size, 'x'));
        FileBuffer buffer;
        {
            const tests::AllocationLimit limit(Size);
            const auto loaded = buffer.load(path("large"));
            SANDREEL_COMPARE_ERROR(loaded, ErrorCode::OutOfMemory);
            QCOMPARE(loaded.error().file, path("large").toStdString());
            QVERIFY(std::stoul(loaded.error().args.at(0)) >= Size);
        }
        QCOMPARE(buffer.load(path("large"))->size(), Size); // it goes on as before
    }

    /// An animation of each kind, with memory for its files but not for its positions.
    void positionsThatDoNotFitAreAnError_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *const name : {"frames", "wavy.pc2"})
            QTest::newRow(name) << name;
    }
    void positionsThatDoNotFitAreAnError()
    {
        QFETCH(QString, name);
        const WavyFrames frames(2000, 50); // 24 kB a frame, 1.2 MB altogether
        QVERIFY(writeFrames(path("frames"), frames, MeshFormat::Obj).has_value());
        QVERIFY(writePc2(path("wavy.pc2"), frames).has_value());
        QVERIFY(writeMesh(path("wavy.obj"), frames.frame(0), frames.connectivity(), MeshFormat::Obj).has_value());
        const tests::AllocationLimit limit(2000 * 50 * sizeof(Vec3f));
        const auto read = readAnimation(path(name));
        SANDREEL_COMPARE_ERROR(read, ErrorCode::OutOfMemory);
        QCOMPARE(tests::argsOf(read.error()), QStringList("1200000"));
    }

    void countsThatNoMachineHoldsAreRefused()
    {
        // Twelve times the product of the last does not fit into 64 bits.
        for (const std::uint64_t frames : {MaxPositionBytes / 12 / 1000 + 1, std::uint64_t(1) << 62}) {
            const auto memory = positionMemory(1000, frames);
            SANDREEL_COMPARE_ERROR(memory, ErrorCode::LimitExceeded);
            QCOMPARE(tests::argsOf(memory.error())[1], QString("1000 x %1").arg(frames));
        }
        QCOMPARE(positionMemory(1000, 20)->size(), std::size_t(20000));
        QVERIFY(positionMemory(1000, 0)->empty());
    }

    /// Every size of allocation fails once, in whichever thread and function it is made: always this error, never a
    /// crash, and nothing lost (which the address sanitizer tells).
    void anyAllocationMayFail_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *const name : {"obj", "off", "ply", "wavy.pc2", "wavy.anim"})
            QTest::newRow(name) << name;
    }
    void anyAllocationMayFail()
    {
        QFETCH(QString, name);
        const WavyFrames frames(3000, 12);
        QVERIFY(writeFrames(path("obj"), frames, MeshFormat::Obj).has_value());
        QVERIFY(writeFrames(path("off"), frames, MeshFormat::Off).has_value());
        QVERIFY(writeFrames(path("ply"), frames, MeshFormat::Ply).has_value());
        QVERIFY(writePc2(path("wavy.pc2"), frames).has_value());
        QVERIFY(writeMesh(path("wavy.obj"), frames.frame(0), frames.connectivity(), MeshFormat::Obj).has_value());
        QVERIFY(saveBytes(path("wavy.anim"), codec::encodeAnimation(frames, {PcaSettings()})->bytes).has_value());
        std::size_t limitBytes = 1 << 24;
        int failures = 0;
        for (; limitBytes > 4096; limitBytes -= limitBytes / 5) {
            const tests::AllocationLimit limit(limitBytes);
            const auto read = readAnimation(path(name));
            if (read.has_value())
                QCOMPARE(failures, 0);
            else
                SANDREEL_COMPARE_ERROR(read, ErrorCode::OutOfMemory);
            failures += !read.has_value();
        }
        QVERIFY(failures > 3);
    }

    void encodingMayRunOutOfMemory()
    {
        const WavyFrames frames(3000, 12);
        int failures = 0;
        for (std::size_t limitBytes = 1 << 25; limitBytes > 4096; limitBytes -= limitBytes / 5) {
            const tests::AllocationLimit limit(limitBytes);
            try {
                QVERIFY(codec::encodeAnimation(frames, {PcaSettings()}).has_value());
                QCOMPARE(failures, 0);
            } catch (const std::bad_alloc &) {
                ++failures;
            }
        }
        QVERIFY(failures > 3);
    }
};

SANDREEL_TEST(TestFileBuffer)
#include "tst_filebuffer.moc"
