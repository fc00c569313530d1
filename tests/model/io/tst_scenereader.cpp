// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/scenereader.h"

#include "model/base/parallel.h"
#include "model/io/animationreader.h"
#include "model/io/errortext.h"
#include "model/io/weldtrajectories.h"
#include "tests/model/io/iotest.h"
#include "tests/support/realdata.h"
#include "tests/support/testmain.h"

#include <algorithm>

#include <QTextStream>

using namespace model;
using namespace model::io;

namespace {

/// One triangle that a node moves from x = 0 to x = 10 in one second, and a quad that stands still at x = 100, in a
/// file of its own (`buffer`) or within the text.
QByteArray gltf(const QString &buffer)
{
    QByteArray data;
    const auto put = [&data](float value) { data.append(reinterpret_cast<const char *>(&value), 4); };
    for (const float c : {0, 0, 0, 1, 0, 0, 0, 1, 0}) // 0: positions
        put(float(c));
    for (const quint16 i : {0, 1, 2, 0}) // 36: indices and padding
        data.append(reinterpret_cast<const char *>(&i), 2);
    for (const float c : {0.0f, 0.5f, 1.0f}) // 44: times
        put(c);
    for (const float c : {0, 0, 0, 4, 0, 0, 10, 0, 0}) // 56: translations
        put(float(c));
    QByteArray uri = buffer.toUtf8();
    if (uri.isEmpty())
        uri = "data:application/octet-stream;base64," + data.toBase64();
    else
        tests::put(buffer, data);
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],
"nodes":[{"mesh":0,"name":"moving"},{"mesh":0,"name":"still","translation":[100,0,0],"scale":[2,2,2]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}],"samplers":[{"input":2,"output":3}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"},
{"bufferView":2,"componentType":5126,"count":3,"type":"SCALAR","min":[0],"max":[1]},
{"bufferView":3,"componentType":5126,"count":3,"type":"VEC3"}],
"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6},
{"buffer":0,"byteOffset":44,"byteLength":12},{"buffer":0,"byteOffset":56,"byteLength":36}],
"buffers":[{"byteLength":92,"uri":")" +
           uri + "\"}]}";
}

/// Frames of points: what Blender says of the scenes in tests/data/scenes, as they are read (y up).
std::vector<std::vector<Vec3f>> truth(const QString &name, float scale)
{
    QFile file(SANDREEL_SOURCE "/tests/data/scenes/" + name);
    if (!file.open(QIODevice::ReadOnly))
        qFatal("%s is missing", qPrintable(name));
    QTextStream text(&file);
    std::size_t frameCount = 0, vertexCount = 0;
    text >> frameCount >> vertexCount;
    std::vector<std::vector<Vec3f>> frames(frameCount, std::vector<Vec3f>(vertexCount));
    for (auto &frame : frames)
        for (Vec3f &p : frame) {
            float x = 0, y = 0, z = 0;
            text >> x >> y >> z;
            p = Vec3f{x, z, -y} * scale;
        }
    return frames;
}

/// The largest distance from a point of `a` to the nearest of `b`.
float oneSidedDistance(const std::vector<Vec3f> &a, const std::vector<Vec3f> &b)
{
    float worst = 0;
    for (const Vec3f &p : a) {
        float nearest = std::numeric_limits<float>::max();
        for (const Vec3f &q : b)
            nearest = std::min(nearest, dot(p - q, p - q));
        worst = std::max(worst, nearest);
    }
    return std::sqrt(worst);
}

} // namespace

class TestSceneReader final : public tests::FolderTest
{
    Q_OBJECT

private slots:
    void nodesMoveTheirMeshes()
    {
        tests::put(path("a.gltf"), gltf({}));
        const auto read = readAnimation(path("a.gltf"), {{}, 4, 0});
        QVERIFY(read.has_value());
        QCOMPARE((*read)->frameCount(), 5u);
        QCOMPARE((*read)->frameRate(), 4.0);
        QCOMPARE((*read)->name(), std::string("a"));
        const std::vector<Triangle> triangles{{0, 1, 2}, {3, 4, 5}};
        QVERIFY((*read)->connectivity().triangles == triangles);
        const float x[] = {0, 2, 4, 7, 10}; // keys at 0, 0.5 and 1 s
        for (std::uint32_t frame = 0; frame < 5; ++frame) {
            const std::vector<Vec3f> expected{{x[frame], 0, 0}, {x[frame] + 1, 0, 0}, {x[frame], 1, 0},
                                              {100, 0, 0},      {102, 0, 0},          {100, 2, 0}};
            const std::vector<Vec3f> found = (*read)->frame(frame);
            QCOMPARE(found.size(), expected.size());
            for (std::size_t i = 0; i < found.size(); ++i)
                QVERIFY(length(found[i] - expected[i]) < 1e-4f);
        }
    }

    /// A node scales, then turns: with another scale along each axis it matters.
    void nodesTurnWhatTheyScaled()
    {
        QByteArray text = gltf({}).replace("\"name\":\"moving\"",
                                           R"("name":"moving","scale":[3,1,1],"rotation":[0,0,0.7071068,0.7071068])");
        tests::put(path("a.gltf"), text);
        const auto read = readAnimation(path("a.gltf"));
        QVERIFY(read.has_value());
        const std::vector<Vec3f> found = (*read)->frame(0);
        const std::vector<Vec3f> expected{{0, 0, 0}, {0, 3, 0}, {-1, 0, 0}}; // x -> y, y -> -x
        for (std::size_t i = 0; i < expected.size(); ++i)
            QVERIFY(length(found[i] - expected[i]) < 1e-5f);
    }

    void rateIsThatOfTheKeys()
    {
        tests::put(path("a.gltf"), gltf({}));
        const auto read = readAnimation(path("a.gltf"));
        QCOMPARE((*read)->frameRate(), 2.0);
        QCOMPARE((*read)->frameCount(), 3u);
    }

    void onlyItsOwnFolderIsRead()
    {
        tests::put(path("in/a.gltf"), gltf(path("in/data.bin")).replace(path("in/").toUtf8(), ""));
        QVERIFY(readAnimation(path("in/a.gltf")).has_value());
        tests::put(path("in/b.gltf"), gltf(path("out.bin")).replace(folder().path().toUtf8(), ".."));
        SANDREEL_COMPARE_ERROR(readAnimation(path("in/b.gltf")), ErrorCode::ImporterFailed);
        tests::put(path("in/c.gltf"), gltf(path("out.bin")));
        SANDREEL_COMPARE_ERROR(readAnimation(path("in/c.gltf")), ErrorCode::ImporterFailed);
        QVERIFY(QFile::link(path("out.bin"), path("in/link.bin")));
        tests::put(path("in/d.gltf"), gltf(path("in/link.bin")).replace(path("in/").toUtf8(), ""));
        SANDREEL_COMPARE_ERROR(readAnimation(path("in/d.gltf")), ErrorCode::ImporterFailed);
    }

    void badScenesAreErrors()
    {
        tests::put(path("a.gltf"), "{ not json");
        const auto broken = readAnimation(path("a.gltf"));
        SANDREEL_COMPARE_ERROR(broken, ErrorCode::ImporterFailed);
        QCOMPARE(broken.error().file, path("a.gltf").toStdString());
        QVERIFY(!broken.error().args.at(0).empty());
        tests::put(path("a.glb"), "");
        SANDREEL_COMPARE_ERROR(readAnimation(path("a.glb")), ErrorCode::ImporterFailed);
        tests::put(path("empty.gltf"),
                   R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{}]})");
        SANDREEL_COMPARE_ERROR(readAnimation(path("empty.gltf")), ErrorCode::NoAnimation);
        tests::put(path("b.gltf"), gltf({}));
        const auto index = readAnimation(path("b.gltf"), {{}, 0, 1});
        SANDREEL_COMPARE_ERROR(index, ErrorCode::BadSetting);
        QCOMPARE(tests::argsOf(index.error()), QStringList({"The number of the animation", "1", "0..0"}));
        SANDREEL_COMPARE_ERROR(readAnimation(path("b.gltf"), {{}, 0, -1}), ErrorCode::BadSetting);
        SANDREEL_COMPARE_ERROR(readAnimation(path("b.gltf"), {{}, 1e12, 0}), ErrorCode::LimitExceeded);
    }

    void everyPrefixIsAnErrorOrAScene()
    {
        const QByteArray whole = gltf({});
        for (qsizetype length = 0; length < whole.size(); length += 7) {
            tests::put(path("a.gltf"), whole.left(length));
            const auto read = readAnimation(path("a.gltf"));
            QVERIFY(!read.has_value());
        }
    }

    void cancelStops()
    {
        tests::put(path("a.gltf"), gltf({}));
        const Progress progress;
        progress.cancel();
        SANDREEL_COMPARE_ERROR(readAnimation(path("a.gltf"), {}, progress), ErrorCode::Cancelled);
    }

    void weldKeepsWhatEverMovesApart()
    {
        // Vertex 1 goes with 0 in both frames, 2 only in the first; 4 goes with 3 but for the sign of a zero.
        Connectivity connectivity{5, {{0, 1, 2}, {4, 3, 1}}};
        std::vector<Vec3f> positions{{1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {5, 0, 0},     {5, 0, 0},
                                     {2, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, -0.0f, 0}, {0, 0, 0}};
        QVERIFY(weldTrajectories(connectivity, positions).has_value());
        const std::vector<Vec3f> expected{{1, 0, 0}, {1, 0, 0}, {5, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 0, 0}};
        const std::vector<Triangle> triangles{{0, 0, 1}, {2, 2, 0}};
        QCOMPARE(connectivity.vertexCount, 3u);
        QVERIFY(connectivity.triangles == triangles);
        QVERIFY(positions == expected);
    }

    /// Skin, shape key, an object that turns and one that a bone carries, against what the program that wrote the files
    /// says. Vertices may be split or welded: as sets of points.
    void scenesOfBlender_data()
    {
        QTest::addColumn<QString>("ending");
        QTest::addColumn<float>("scale");
        QTest::newRow("FBX, in centimetres") << "fbx" << 100.0f;
        QTest::newRow("Collada") << "dae" << 1.0f;
    }
    void scenesOfBlender()
    {
        QFETCH(QString, ending);
        QFETCH(float, scale);
        const auto read = readAnimation(SANDREEL_SOURCE "/tests/data/scenes/worm." + ending);
        QVERIFY2(read.has_value(), read ? "" : qPrintable(errorText(read.error())));
        const auto expected = truth("worm-" + ending + ".txt", scale);
        QCOMPARE((*read)->frameRate(), 24.0);
        QCOMPARE(std::size_t((*read)->frameCount()), expected.size());
        for (std::uint32_t frame = 0; frame < expected.size(); ++frame) {
            const std::vector<Vec3f> found = (*read)->frame(frame);
            const float there = oneSidedDistance(found, expected[frame]);
            const float back = oneSidedDistance(expected[frame], found);
            QVERIFY2(std::max(there, back) < 1e-4f * scale,
                     qPrintable(QString("frame %1: %2, %3").arg(frame).arg(there).arg(back)));
        }
    }

    /// Against the same animations baked by an independent script (data/README.md): every frame as a set of points.
    void realScenes_data()
    {
        QTest::addColumn<QString>("scene");
        QTest::addColumn<int>("animation");
        QTest::addColumn<QString>("sequence");
        QTest::newRow("skin, 83 frames") << "Fox.glb" << 0 << "fox_survey";
        QTest::newRow("skin, 28 frames") << "Fox.glb" << 2 << "fox_run";
        QTest::newRow("many meshes") << "robot.glb" << 0 << "robot_dance";
        QTest::newRow("morph targets") << "MorphStressTest.gltf" << 0 << "morph_columns";
    }
    void realScenes()
    {
        if (tests::dataFolder().isEmpty())
            QSKIP("SANDREEL_DATA is not set");
        QFETCH(QString, scene);
        QFETCH(int, animation);
        QFETCH(QString, sequence);
        const QString file = tests::dataFolder() + "/scenes/" + scene;
        const auto read = readAnimation(file, {{}, 0, animation});
        const auto expected = readAnimation(tests::sequenceFolder(sequence));
        QVERIFY(read.has_value() && expected.has_value());
        QCOMPARE((*read)->frameRate(), 24.0);
        QCOMPARE((*read)->frameCount(), (*expected)->frameCount());
        // The script drops triangles that welding made degenerate; we keep them.
        const auto &triangles = (*read)->connectivity().triangles;
        const auto proper = std::count_if(triangles.begin(), triangles.end(), [](const Triangle &t) {
            return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
        });
        QCOMPARE(std::size_t(proper), (*expected)->connectivity().triangles.size());
        QCOMPARE((*read)->vertexCount(), (*expected)->vertexCount());
        const float tolerance = 2e-5f * boundingBox((*expected)->frame(0)).diagonal();
        for (std::uint32_t frame = 0; frame < (*read)->frameCount(); frame += frame < 5 ? 1 : 11) {
            const std::vector<Vec3f> a = (*read)->frame(frame), b = (*expected)->frame(frame);
            QVERIFY2(oneSidedDistance(a, b) < tolerance, qPrintable(QString::number(oneSidedDistance(a, b))));
            QVERIFY2(oneSidedDistance(b, a) < tolerance, qPrintable(QString::number(oneSidedDistance(b, a))));
        }
        setThreadCount(5);
        QCOMPARE((*readAnimation(file, {{}, 0, animation}))->digest(), (*read)->digest());
    }
};

SANDREEL_TEST(TestSceneReader)
#include "tst_scenereader.moc"
