// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/animationfiles.h"
#include "tests/app/cli/clirun.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>

/// `sandreel-cli inspect`
class TestInspect : public QObject
{
    Q_OBJECT

    QString write(const char *name, const QByteArray &text)
    {
        const QString path = mFolder.filePath(QString::fromUtf8(name));
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("cannot write %s", name);
        return path;
    }

    /// A cube of squares without its lid, and a triangle on its own.
    QString openBox()
    {
        return write("box.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                                "v 5 0 0\nv 6 0 0\nv 5 1 0\n"
                                "f 4 3 2 1\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nf 9 10 11\n");
    }

    QTemporaryDir mFolder;

private slots:
    void saysEverythingAsJson()
    {
        SANDREEL_RUN(run, 0, {"inspect", openBox(), "--json"});
        const QJsonObject json = run.json();
        QCOMPARE(json["vertices"].toInt(), 11);
        QCOMPARE(json["faces"].toInt(), 6);
        const QJsonArray components = json["components"].toArray();
        QCOMPARE(components.size(), 2);
        const QJsonObject box = components[0].toObject();
        const QMap<QString, int> expected{{"vertices", 8}, {"edges", 12}, {"faces", 5},
                                          {"euler", 1},    {"genus", 0},  {"boundary_loops", 1}};
        for (auto at = expected.begin(); at != expected.end(); ++at)
            QCOMPARE(box[at.key()].toInt(-99), at.value());
        QCOMPARE(box["orientable"].toBool(), true);
        QCOMPARE(box["area"].toDouble(), 5.0);
        QVERIFY(box.contains("volume") && box["volume"].isNull());
        const QJsonArray holes = json["holes"].toArray();
        QCOMPARE(holes.size(), 2);
        QCOMPARE(holes[0].toObject()["area"].toDouble(), 1.0);
        QCOMPARE(holes[0].toObject()["length"].toDouble(), 4.0);
        QVERIFY(json["handles"].isArray());
        const QJsonObject problems = json["problems"].toObject();
        for (const char *kind : {"non_manifold_edges", "non_manifold_vertices", "duplicate_faces", "degenerate_faces",
                                 "isolated_vertices", "inconsistent_edges"}) {
            QCOMPARE(problems[QLatin1String(kind)].toObject()["count"].toInt(-1), 0);
            QVERIFY(problems[QLatin1String(kind)].toObject()["ids"].isArray());
        }
        QVERIFY(problems["self_intersections"].toObject()["count"].isNull());
    }

    void findsCrossingFacesWhenAsked()
    {
        const QString path =
            write("cross.off", "OFF\n6 2 0\n0 0 0\n2 0 0\n0 2 0\n0.5 0.5 -1\n0.5 0.5 1\n3 3 1\n3 0 1 2\n3 3 4 5\n");
        SANDREEL_RUN(run, 0, {"--json", "inspect", path, "--self-intersections"});
        const QJsonObject found = run.json()["problems"].toObject()["self_intersections"].toObject();
        QCOMPARE(found["count"].toInt(-1), 1);
        QVERIFY(found["ids"].toArray()[0].toArray() == (QJsonArray{0, 1}));
    }

    void whatIsWrongIsReportedAsItIs()
    {
        // Three faces at an edge, one of them twice, one with a vertex twice: a repairing reader makes other vertices
        // of it.
        const QString path = write("dirty.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 9 9 9\n"
                                                "f 1 2 3\nf 2 1 4\nf 1 2 5\nf 3 1 2\nf 1 1 3\n");
        SANDREEL_RUN(run, 0, {"inspect", path, "--json"});
        const QJsonObject json = run.json();
        QCOMPARE(json["vertices"].toInt(), 6);
        QCOMPARE(json["faces"].toInt(), 5);
        const auto ids = [&](const char *kind) {
            return json["problems"].toObject()[QLatin1String(kind)].toObject()["ids"].toArray();
        };
        QVERIFY(ids("duplicate_faces") == (QJsonArray{QJsonArray{3, 0}}));
        QVERIFY(ids("degenerate_faces") == QJsonArray{4});
        QVERIFY(ids("isolated_vertices") == QJsonArray{5});
        QVERIFY(ids("non_manifold_edges").contains(QJsonArray{0, 1}));
        QVERIFY(json["genus"].isNull());
    }

    void aFrameOfAnAnimation()
    {
        const auto animation = tests::wave(tests::torus(), 4);
        tests::writeObjFolder(mFolder.filePath("frames"), *animation);
        SANDREEL_RUN(encoded, 0,
                     {"encode", mFolder.filePath("frames"), "-o", mFolder.filePath("wave.anim"), "--codec", "direct"});
        const auto area = [&](const char *frame) {
            const tests::CliRun run =
                tests::runCli({"inspect", mFolder.filePath("wave.anim"), "--frame", frame, "--json"});
            return run.json()["components"].toArray()[0].toObject()["area"].toDouble();
        };
        QVERIFY(area("1") > 0);
        QVERIFY(area("3") > 0 && area("3") != area("1"));
        SANDREEL_RUN(run, 0, {"inspect", mFolder.filePath("wave.anim"), "--json"});
        QCOMPARE(run.json()["handles"].toArray().size(), 1);
        QCOMPARE(run.json()["components"].toArray()[0].toObject()["area"].toDouble(), area("1"));
        SANDREEL_RUN(late, 2, {"inspect", mFolder.filePath("wave.anim"), "--frame", "5"});
        QVERIFY(late.err.contains("1..4"));
    }

    void tablesAndCsv()
    {
        SANDREEL_RUN(text, 0, {"inspect", openBox()});
        for (const char *word : {"Components", "Holes", "Handles", "Problems: none", "EdgeBreaker", "Euler"})
            QVERIFY2(text.out.contains(word), text.out.constData());
        SANDREEL_RUN(csv, 0, {"inspect", openBox(), "--csv", "holes"});
        QCOMPARE(csv.out.split('\n').at(0), QByteArray("hole,component,edges,length,area,closed,vertices"));
        QCOMPARE(csv.out.count('\n'), 3);
        SANDREEL_RUN(bad, 2, {"inspect", openBox(), "--csv", "tunnels"});
    }
};

SANDREEL_TEST(TestInspect)
#include "tst_inspect.moc"
