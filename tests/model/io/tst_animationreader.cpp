// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/animationreader.h"

#include "model/base/parallel.h"
#include "model/codec/animationcodec.h"
#include "model/io/animationwriter.h"
#include "model/io/animfile.h"
#include "model/io/framefolder.h"
#include "tests/model/io/iotest.h"
#include "tests/support/testmain.h"

#include <random>

#include <QDir>

using namespace model;
using namespace model::io;
using tests::put;
using tests::WavyFrames;

class TestAnimationReader final : public tests::FolderTest
{
    Q_OBJECT

private slots:
    void naturalOrder()
    {
        const QStringList ordered{"1.obj",       "2.obj",        "10.obj",
                                  "a.obj",       "a1.obj",       "A2.obj",
                                  "a2b1.obj",    "a2b02.obj",    "a2b3.obj",
                                  "a010.obj",    "a10.obj",      "a11.obj",
                                  "b9 x2.obj",   "b9 x10.obj",   "b10 x1.obj",
                                  "frame_9.obj", "frame_10.obj", "frame_99999999999999999999999.obj"};
        for (qsizetype i = 0; i < ordered.size(); ++i) {
            for (qsizetype j = 0; j < ordered.size(); ++j)
                QVERIFY2(isNaturallyLess(ordered[i], ordered[j]) == (i < j), qPrintable(ordered[i] + ' ' + ordered[j]));
        }
    }

    void framesAreThoseOfTheMostFrequentEnding()
    {
        for (const char *const name :
             {"b/10.obj", "b/2.OBJ", "b/1.obj", "b/1.off", "b/2.off", "b/notes.txt", "b/.9.obj"})
            put(path(name), "v 0 0 0\n");
        QVERIFY(QDir(path("b")).mkdir("3.obj")); // a folder is no frame
        const auto files = frameFilesIn(path("b"));
        QVERIFY(files.has_value());
        QCOMPARE(*files, QStringList({path("b/1.obj"), path("b/2.OBJ"), path("b/10.obj")}));
    }

    void foldersThatAreNone()
    {
        SANDREEL_COMPARE_ERROR(frameFilesIn(path("none")), ErrorCode::NotFound);
        put(path("file"), "x");
        SANDREEL_COMPARE_ERROR(frameFilesIn(path("file")), ErrorCode::CannotOpen);
        put(path("empty/readme.md"), "x");
        const auto empty = readAnimation(path("empty"));
        SANDREEL_COMPARE_ERROR(empty, ErrorCode::NoFrames);
        QCOMPARE(tests::argsOf(empty.error()), QStringList("obj, off, ply, stl"));
        QCOMPARE(empty.error().file, path("empty").toStdString());
    }

    void folderIsReadInOrder()
    {
        for (int i = 1; i <= 12; ++i)
            put(path(QString("walk/%1.obj").arg(i)), QString("v %1 0 0\nv 1 %1 0\nv 0 0 1\nf 1 2 3\n").arg(i).toUtf8());
        const auto read = readAnimation(path("walk/"));
        QVERIFY(read.has_value());
        QCOMPARE((*read)->frameCount(), 12u);
        QCOMPARE((*read)->name(), std::string("walk"));
        QCOMPARE((*read)->frameRate(), 25.0);
        for (std::uint32_t frame = 0; frame < 12; ++frame) {
            const float i = float(frame + 1);
            const std::vector<Vec3f> expected{{i, 0, 0}, {1, i, 0}, {0, 0, 1}};
            QVERIFY((*read)->frame(frame) == expected);
        }
        QCOMPARE((*readAnimation(path("walk"), {{}, 60, 0}))->frameRate(), 60.0);
    }

    void singleMeshIsOneFrame()
    {
        put(path("cow.v2.off"), "OFF\n1 0 0\n1 2 3\n");
        const auto read = readAnimation(path("cow.v2.off"));
        QVERIFY(read.has_value());
        QCOMPARE((*read)->frameCount(), 1u);
        QCOMPARE((*read)->name(), std::string("cow.v2"));
    }

    void firstErrorInFrameOrderIsReported()
    {
        for (int i = 0; i < 40; ++i)
            put(path(QString("f/%1.obj").arg(i)), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        put(path("f/17.obj"), "v 0 0 0\nv 1 0 0\nf 1 2 1\n");
        put(path("f/23.obj"), "v 0 0 0\nv 1 x 0\n");
        put(path("f/39.obj"), "");
        for (const unsigned threads : {1u, 2u, 8u}) {
            setThreadCount(threads);
            for (int repeat = 0; repeat < 5; ++repeat) {
                const auto read = readAnimation(path("f"));
                SANDREEL_COMPARE_ERROR(read, ErrorCode::VertexCountDiffers);
                QCOMPARE(read.error().file, path("f/17.obj").toStdString());
                QCOMPARE(tests::argsOf(read.error()), QStringList({"2", "3", path("f/0.obj")}));
            }
        }
    }

    void errorNamesFileAndLine()
    {
        put(path("f/1.obj"), "v 0 0 0\n");
        put(path("f/2.obj"), "v 0 0 0\nv 1 x 0\n");
        const auto read = readAnimation(path("f"));
        SANDREEL_COMPARE_ERROR(read, ErrorCode::SyntaxError);
        QCOMPARE(read.error().file, path("f/2.obj").toStdString());
        QCOMPARE(read.error().line, std::uint64_t(2));
        put(path("f/1.obj"), "v 0 0\n");
        QCOMPARE(readAnimation(path("f")).error().file, path("f/1.obj").toStdString());
    }

    void readingDoesNotDependOnThreads()
    {
        QVERIFY(writeFrames(path("w"), WavyFrames(333, 21), MeshFormat::Off).has_value());
        setThreadCount(1);
        const auto one = readAnimation(path("w"));
        setThreadCount(7);
        const auto seven = readAnimation(path("w"));
        QVERIFY(one.has_value() && seven.has_value());
        QCOMPARE((*one)->digest(), (*seven)->digest());
    }

    void cancelStopsReading()
    {
        QVERIFY(writeFrames(path("w"), WavyFrames(10, 50), MeshFormat::Obj).has_value());
        Progress progress([&](double fraction) {
            if (fraction > 0.5)
                progress.cancel();
        });
        SANDREEL_COMPARE_ERROR(readAnimation(path("w"), {}, progress), ErrorCode::Cancelled);
    }

    void otherFilesAreRefused()
    {
        put(path("a.txt"), "x");
        const auto read = readAnimation(path("a.txt"));
        SANDREEL_COMPARE_ERROR(read, ErrorCode::UnknownFormat);
        QCOMPARE(tests::argsOf(read.error()), QStringList("txt"));
        SANDREEL_COMPARE_ERROR(readMesh(path("a.txt")), ErrorCode::UnknownFormat);
        SANDREEL_COMPARE_ERROR(readAnimation(path("none.obj")), ErrorCode::NotFound);
        SANDREEL_COMPARE_ERROR(readMesh(path("none.obj")), ErrorCode::NotFound);
        SANDREEL_COMPARE_ERROR(readAnimation(path("none.pc2")), ErrorCode::NotFound);
        SANDREEL_COMPARE_ERROR(readAnimation(path("none.glb")), ErrorCode::NotFound);
    }

    void animIsOpened()
    {
        const WavyFrames frames(60, 10);
        const auto encoded = codec::encodeAnimation(frames, {PcaSettings()});
        QVERIFY(encoded.has_value());
        QVERIFY(saveBytes(path("a.anim"), encoded->bytes).has_value());
        const auto read = readAnimation(path("a.anim"));
        QVERIFY(read.has_value());
        QCOMPARE((*read)->frameCount(), 10u);
        QCOMPARE((*read)->frameRate(), 30.0);
        QVERIFY(std::dynamic_pointer_cast<const codec::DecodedAnimation>(*read));
        const auto faster = readAnimation(path("a.anim"), {{}, 50, 0});
        QCOMPARE((*faster)->frameRate(), 50.0);
        QVERIFY((*faster)->frame(7) == (*read)->frame(7));
    }

    void damagedAnimNamesTheFile()
    {
        put(path("a.anim"), "not an animation");
        const auto read = readAnimation(path("a.anim"));
        SANDREEL_COMPARE_ERROR(read, ErrorCode::BadMagic);
        QCOMPARE(read.error().file, path("a.anim").toStdString());
    }

    void endingsForDialogs()
    {
        const QStringList endings = readableEndings();
        for (const char *const ending : {"obj", "off", "ply", "stl", "pc2", "mdd", "gltf", "glb", "fbx", "anim"})
            QVERIFY2(endings.contains(ending), ending);
    }
};

SANDREEL_TEST(TestAnimationReader)
#include "tst_animationreader.moc"
