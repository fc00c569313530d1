// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/animationwriter.h"

#include "model/base/parallel.h"
#include "model/io/animationreader.h"
#include "model/io/animfile.h"
#include "tests/model/io/iotest.h"
#include "tests/support/scarcity.h"
#include "tests/support/testmain.h"

#include <cstring>

#include <QDir>
#include <QDirIterator>

using namespace model;
using namespace model::io;
using tests::contents;
using tests::WavyFrames;

Q_DECLARE_METATYPE(MeshFormat)

namespace {

void formatRows()
{
    QTest::addColumn<MeshFormat>("format");
    QTest::addColumn<QString>("ending");
    QTest::newRow("OBJ") << MeshFormat::Obj << "obj";
    QTest::newRow("OFF") << MeshFormat::Off << "off";
    QTest::newRow("PLY") << MeshFormat::Ply << "ply";
}

} // namespace

class TestAnimationWriter final : public tests::FolderTest
{
    Q_OBJECT

private slots:
    void objIsWhatItSays()
    {
        const Connectivity connectivity{3, {{0, 1, 2}, {2, 1, 0}}};
        const std::vector<Vec3f> positions{{0, -0.5f, 1e-10f}, {0.1f, 16777216, -3e20f}, {1, 2, 3}};
        QVERIFY(writeMesh(path("a.obj"), positions, connectivity, MeshFormat::Obj).has_value());
        QCOMPARE(contents(path("a.obj")),
                 QByteArray("v 0 -0.5 1e-10\nv 0.1 16777216 -3e+20\nv 1 2 3\nf 1 2 3\nf 3 2 1\n"));
        QVERIFY(writeMesh(path("a.off"), positions, connectivity, MeshFormat::Off).has_value());
        QCOMPARE(contents(path("a.off")),
                 QByteArray("OFF\n3 2 0\n0 -0.5 1e-10\n0.1 16777216 -3e+20\n1 2 3\n3 0 1 2\n3 2 1 0\n"));
    }

    void meshComesBackBitForBit_data() { formatRows(); }
    void meshComesBackBitForBit()
    {
        QFETCH(MeshFormat, format);
        QFETCH(QString, ending);
        const WavyFrames frames(1000, 1);
        std::vector<Vec3f> positions = frames.frame(0);
        positions[0] = {std::numeric_limits<float>::denorm_min(), -0.0f, std::numeric_limits<float>::max()};
        positions[1] = {std::numeric_limits<float>::min(), -std::numeric_limits<float>::max(), 0.1f};
        const QString file = path("mesh." + ending);
        QVERIFY(writeMesh(file, positions, frames.connectivity(), format).has_value());
        const auto mesh = readMesh(file);
        QVERIFY(mesh.has_value());
        QVERIFY(mesh->connectivity == frames.connectivity());
        QCOMPARE(std::memcmp(mesh->positions.data(), positions.data(), positions.size() * sizeof(Vec3f)), 0);
    }

    void framesComeBackBitForBit_data() { formatRows(); }
    void framesComeBackBitForBit()
    {
        QFETCH(MeshFormat, format);
        const WavyFrames frames(50, 12);
        double last = 0;
        QVERIFY(writeFrames(path("new/deep"), frames, format, Progress([&](double f) { last = f; })).has_value());
        QCOMPARE(last, 1.0);
        const auto read = readAnimation(path("new/deep"));
        QVERIFY(read.has_value());
        QCOMPARE((*read)->frameCount(), 12u);
        QVERIFY((*read)->connectivity() == frames.connectivity());
        for (std::uint32_t frame = 0; frame < 12; ++frame)
            QVERIFY((*read)->frame(frame) == frames.frame(frame));
    }

    void namesHaveAsManyDigitsAsNeeded()
    {
        QVERIFY(writeFrames(path("few"), WavyFrames(3, 2), MeshFormat::Obj).has_value());
        QCOMPARE(QDir(path("few")).entryList(QDir::Files), QStringList({"frame_0001.obj", "frame_0002.obj"}));
        QVERIFY(writeFrames(path("many"), WavyFrames(1, 10'000), MeshFormat::Off).has_value());
        QVERIFY(QFile::exists(path("many/frame_00001.off")));
        QVERIFY(QFile::exists(path("many/frame_10000.off")));
    }

    void filesDoNotDependOnThreads()
    {
        for (const unsigned threads : {1u, 5u}) {
            setThreadCount(threads);
            QVERIFY(writeFrames(path(QString::number(threads)), WavyFrames(100, 9), MeshFormat::Ply).has_value());
        }
        for (const QString &name : QDir(path("1")).entryList(QDir::Files))
            QCOMPARE(contents(path("1/" + name)), contents(path("5/" + name)));
    }

    void cancelRemovesWhatWasWritten()
    {
        for (const bool existed : {false, true}) {
            const QString folder = path(existed ? "old" : "new");
            if (existed)
                tests::put(folder + "/notes.txt", "mine");
            const Progress progress;
            WavyFrames frames(10, 100);
            frames.onFrame = [&](std::uint32_t frame) {
                if (frame == 50)
                    progress.cancel();
            };
            SANDREEL_COMPARE_ERROR(writeFrames(folder, frames, MeshFormat::Obj, progress), ErrorCode::Cancelled);
            QCOMPARE(QFile::exists(folder), existed);
            if (existed)
                QCOMPARE(QDir(folder).entryList(QDir::Files), QStringList("notes.txt"));
        }
    }

    /// The disk fills up in the middle: an error that names the file and the reason, and nothing new is left.
    void fullDiskLeavesNothingBehind()
    {
        constexpr std::uint64_t Room = 4000; // for less than one frame, and more than what Qt keeps in memory
        const WavyFrames frames(5000, 3);
        tests::put(path("old/notes.txt"), "mine");
        tests::put(path("a.pc2"), "old");
        tests::put(path("a.obj"), "old");
        const QStringList before = everything();
        const tests::FileSizeLimit limit(Room);
        const auto check = [&](const Result<void> &written, const QString &file) {
            SANDREEL_COMPARE_ERROR(written, ErrorCode::CannotWrite);
            QCOMPARE(tests::argsOf(written.error()), QStringList(QString::fromLocal8Bit(std::strerror(EFBIG))));
            QVERIFY2(written.error().file.starts_with(path(file).toStdString()), written.error().file.c_str());
            QCOMPARE(everything(), before);
        };
        for (const MeshFormat format : {MeshFormat::Obj, MeshFormat::Off, MeshFormat::Ply}) {
            check(writeFrames(path("old"), frames, format), "old/frame_000");
            check(writeFrames(path("new"), frames, format), "new/frame_000");
            check(writeMesh(path("a.obj"), frames.frame(0), frames.connectivity(), format), "a.obj");
        }
        check(writePc2(path("a.pc2"), frames), "a.pc2");
        check(saveBytes(path("new.anim"), Bytes(100'000)), "new.anim");
        check(saveBytes(path("small.anim"), Bytes(Room + 1)), "small.anim"); // known only when Qt writes its buffer
        QCOMPARE(contents(path("a.pc2")), QByteArray("old"));
        QCOMPARE(contents(path("a.obj")), QByteArray("old"));
        QVERIFY(saveBytes(path("small.anim"), Bytes(Room)).has_value());
    }

    void folderWithFramesIsLeftAlone()
    {
        tests::put(path("old/frame_0007.obj"), "v 1 2 3\n");
        const auto written = writeFrames(path("old"), WavyFrames(3, 2), MeshFormat::Obj);
        SANDREEL_COMPARE_ERROR(written, ErrorCode::CannotWrite);
        QCOMPARE(written.error().file, path("old").toStdString());
        QCOMPARE(QDir(path("old")).entryList(QDir::Files), QStringList("frame_0007.obj"));
        QCOMPARE(contents(path("old/frame_0007.obj")), QByteArray("v 1 2 3\n"));
    }

    void fileInPlaceOfTheFolderIsAnError()
    {
        tests::put(path("file"), "x");
        SANDREEL_COMPARE_ERROR(writeFrames(path("file"), WavyFrames(3, 2), MeshFormat::Obj), ErrorCode::CannotOpen);
        SANDREEL_COMPARE_ERROR(writeFrames(path("file/sub"), WavyFrames(3, 2), MeshFormat::Obj), ErrorCode::CannotOpen);
        QCOMPARE(contents(path("file")), QByteArray("x"));
    }

    void meshInMissingFolderIsAnError()
    {
        const WavyFrames frames(3, 1);
        const auto written = writeMesh(path("none/a.obj"), frames.frame(0), frames.connectivity(), MeshFormat::Obj);
        SANDREEL_COMPARE_ERROR(written, ErrorCode::CannotOpen);
        QCOMPARE(written.error().file, path("none/a.obj").toStdString());
        QVERIFY(!written.error().args.at(0).empty());
        SANDREEL_COMPARE_ERROR(writePc2(path("none/a.pc2"), frames), ErrorCode::CannotOpen);
    }

    void pc2IsWhatItSays()
    {
        const WavyFrames frames(2, 3);
        QVERIFY(writePc2(path("a.pc2"), frames).has_value());
        QByteArray expected("POINTCACHE2\0\1\0\0\0\2\0\0\0\0\0\0\0\0\0\x80\x3f\3\0\0\0", 32);
        for (std::uint32_t frame = 0; frame < 3; ++frame)
            for (const Vec3f &p : frames.frame(frame))
                for (const float c : {p.x, p.y, p.z})
                    for (int shift = 0; shift < 32; shift += 8)
                        expected += char(std::bit_cast<std::uint32_t>(c) >> shift);
        QCOMPARE(contents(path("a.pc2")), expected);
    }

    void cancelledPc2LeavesTheOldFile()
    {
        tests::put(path("a.pc2"), "old");
        const Progress progress;
        WavyFrames frames(10, 100);
        frames.onFrame = [&](std::uint32_t frame) {
            if (frame == 50)
                progress.cancel();
        };
        SANDREEL_COMPARE_ERROR(writePc2(path("a.pc2"), frames, progress), ErrorCode::Cancelled);
        QCOMPARE(contents(path("a.pc2")), QByteArray("old"));
        QCOMPARE(QDir(folder().path()).entryList(QDir::Files), QStringList("a.pc2"));
    }

private:
    /// Every file and folder that there is.
    QStringList everything() const
    {
        QStringList result;
        QDirIterator entries(folder().path(), QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot,
                             QDirIterator::Subdirectories);
        while (entries.hasNext())
            result << entries.next();
        result.sort();
        return result;
    }
};

SANDREEL_TEST(TestAnimationWriter)
#include "tst_animationwriter.moc"
