// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/animationfiles.h"
#include "tests/app/cli/clirun.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

/// What holds for every sub-command: help, usage errors, streams, locale.
class TestCommandLine : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void helpNamesEveryOption_data();
    void helpNamesEveryOption();
    void versionIsAnswered();
    void usageErrors_data();
    void usageErrors();
    void unknownArgumentsAreNamed();
    void globalFlagsMayFollowTheSubCommand();
    void quietSaysNothing();
    void messagesDoNotMixWithData();
    void fullStandardOutputIsAnError();
    void inputErrors_data();
    void inputErrors();
    void limitIsAnError();
    void decimalCommaOfTheLocaleDoesNotMatter();
    void namesCannotSteerTheTerminal();

private:
    QString path(const char *name) const { return mFolder.filePath(QString::fromUtf8(name)); }

    QTemporaryDir mFolder;
};

void TestCommandLine::initTestCase()
{
    tests::writeObjFolder(path("in"), *tests::wave(tests::grid(), 5));
    SANDREEL_RUN(run, 0, {"encode", path("in"), "-o", path("in.anim")});
}

void TestCommandLine::helpNamesEveryOption_data()
{
    QTest::addColumn<QStringList>("words");
    QTest::newRow("sandreel-cli") << QStringList{"encode", "decode",  "info",      "inspect",    "compare", "render",
                                                 "--json", "--quiet", "--version", "Exit codes", "130"};
    const QStringList input{"--base-mesh", "--animation", "Examples", "sandreel-cli "};
    QTest::newRow("encode") << input + QStringList{"INPUT",       "--output",       "-o",
                                                   "--codec",     "--basis",        "--resolution",
                                                   "--normalize", "none|first|all", "--fps",
                                                   "--name",      "--permutation",  "--measure",
                                                   "--predictor", "none|A|B|C|N",   "--entropy",
                                                   "--quality",   "--max-kg-error", "--max-vertex-error",
                                                   "--max-bytes", "--keep-order",   "direct"};
    QTest::newRow("decode") << input +
                                   QStringList{"INPUT", "--output", "-o", "--format", "obj|off|ply", "--mesh", ".pc2"};
    QTest::newRow("info") << input + QStringList{"INPUT"};
    QTest::newRow("inspect") << input + QStringList{"MESH", "--frame", "--csv", "components|holes|handles|problems",
                                                    "--self-intersections"};
    QTest::newRow("compare") << input + QStringList{"REFERENCE", "TEST", "--permutation", "--normalize", "--csv"};
    QTest::newRow("render") << input + QStringList{"INPUT", "--output", "-o",          "--frame", "--size",
                                                   "--yaw", "--pitch",  "--wireframe", "%04d"};
}

void TestCommandLine::helpNamesEveryOption()
{
    QFETCH(const QStringList, words);
    const QString command = QString::fromUtf8(QTest::currentDataTag());
    SANDREEL_RUN(run, 0, command == "sandreel-cli" ? QStringList{"--help"} : QStringList{command, "--help"});
    QCOMPARE(run.err, QByteArray());
    for (const QString &word : words)
        QVERIFY2(run.out.contains(word.toUtf8()), qPrintable(word));
    for (const QByteArray &line : run.out.split('\n'))
        QVERIFY2(line.size() <= 130, line.constData());
}

void TestCommandLine::versionIsAnswered()
{
    SANDREEL_RUN(run, 0, {"--version"});
    QVERIFY2(run.out.startsWith("sandreel-cli ") && run.out.count('\n') == 1, run.out.constData());
}

void TestCommandLine::usageErrors_data()
{
    QTest::addColumn<QStringList>("arguments");
    const QString in = path("in"), anim = path("x.anim"), png = path("x.png");
    const auto row = [](const char *name, const QStringList &arguments) { QTest::newRow(name) << arguments; };
    row("nothing", {});
    row("unknown option", {"info", in, "--nonsense"});
    row("two sub-commands", {"info", in, "decode", in, "-o", path("x.pc2")});
    row("no input", {"info"});
    row("a second input", {"info", in, in});
    row("encode: no output", {"encode", in});
    row("encode: other ending", {"encode", in, "-o", path("x.obj")});
    row("encode: basis 0", {"encode", in, "-o", anim, "--codec", "pca", "--basis", "0"});
    row("encode: basis too large", {"encode", in, "-o", anim, "--codec", "pca", "--basis", "1001"});
    row("encode: basis no number", {"encode", in, "-o", anim, "--codec", "pca", "--basis", "ten"});
    row("encode: resolution 0", {"encode", in, "-o", anim, "--codec", "pca", "--resolution", "0"});
    row("encode: resolution nan", {"encode", in, "-o", anim, "--codec", "pca", "--resolution", "nan"});
    row("encode: codec", {"encode", in, "-o", anim, "--codec", "zip"});
    row("encode: no such option with pca", {"encode", in, "-o", anim, "--codec", "pca", "--predictor", "A"});
    row("encode: no such option with direct", {"encode", in, "-o", anim, "--codec", "direct", "--basis", "5"});
    row("encode: predictor", {"encode", in, "-o", anim, "--codec", "direct", "--predictor", "D"});
    row("encode: entropy", {"encode", in, "-o", anim, "--codec", "direct", "--entropy", "zip"});
    row("encode: half a cell", {"encode", in, "-o", anim, "--codec", "direct", "--resolution", "1000.5"});
    row("encode: two targets", {"encode", in, "-o", anim, "--quality", "0.5", "--max-bytes", "5000"});
    row("encode: target and setting", {"encode", in, "-o", anim, "--quality", "0.5", "--basis", "5"});
    row("encode: quality", {"encode", in, "-o", anim, "--quality", "1.5"});
    row("encode: KG error nan", {"encode", in, "-o", anim, "--max-kg-error", "nan"});
    row("encode: vertex error", {"encode", in, "-o", anim, "--max-vertex-error", "0"});
    row("encode: too few bytes", {"encode", in, "-o", anim, "--max-bytes", "10"});
    row("encode: normalize", {"encode", in, "-o", anim, "--normalize", "last"});
    row("encode: fps 0", {"encode", in, "-o", anim, "--fps", "0"});
    row("encode: fps nan", {"encode", in, "-o", anim, "--fps", "nan"});
    row("encode: animation 0", {"encode", in, "-o", anim, "--animation", "0"});
    row("encode: output is input", {"encode", path("in.anim"), "-o", path("in/../in.anim")});
    row("encode: two outputs in one", {"encode", in, "-o", anim, "--permutation", anim});
    row("decode: format", {"decode", path("in.anim"), "-o", path("out"), "--format", "stl"});
    row("decode: mesh ending", {"decode", path("in.anim"), "-o", path("x.pc2"), "--mesh", path("x.stl")});
    row("decode: a file that is not written", {"decode", path("in.anim"), "-o", path("x.ply")});
    row("compare: one input", {"compare", in});
    row("compare: CSV over an input", {"compare", in, path("in.anim"), "--csv", path("in.anim")});
    row("render: no size", {"render", in, "-o", png, "--size", "960"});
    row("render: size 0", {"render", in, "-o", png, "--size", "0x10"});
    row("render: size too large", {"render", in, "-o", png, "--size", "16385x10"});
    row("render: size beyond numbers", {"render", in, "-o", png, "--size", "99999999999x10"});
    row("render: negative size", {"render", in, "-o", png, "--size", "-5x10"});
    row("render: frame 0", {"render", in, "-o", png, "--frame", "0"});
    row("render: frame after the last", {"render", in, "-o", png, "--frame", "6"});
    row("render: frame beyond numbers", {"render", in, "-o", png, "--frame", "4294967297"});
    row("render: frame of a pattern", {"render", in, "-o", path("x%d.png"), "--frame", "1"});
    row("render: pitch", {"render", in, "-o", png, "--pitch", "91"});
    row("render: yaw nan", {"render", in, "-o", png, "--yaw", "nan"});
    row("render: other ending", {"render", in, "-o", path("x.jpg")});
}

void TestCommandLine::usageErrors()
{
    QFETCH(const QStringList, arguments);
    const QStringList before = tests::contentsOf(mFolder.path());
    const QByteArray anim = tests::readFile(path("in.anim"));
    SANDREEL_RUN(run, 2, arguments);
    QCOMPARE(run.out, QByteArray());
    QVERIFY2(run.err.startsWith("sandreel-cli: "), run.err.constData());
    QCOMPARE(tests::contentsOf(mFolder.path()), before);
    QCOMPARE(tests::readFile(path("in.anim")), anim);
}

void TestCommandLine::unknownArgumentsAreNamed()
{
    SANDREEL_RUN(run, 2, {"enocde", path("in"), "-o", path("x.anim")});
    QVERIFY2(run.err.contains("\"enocde\"") &&
                 run.err.contains("encode, decode, info, inspect, compare, render, export-player, terrain, haptics."),
             run.err.constData());
    SANDREEL_RUN(extra, 2, {"info", path("in"), "--size", "3"});
    QVERIFY2(extra.err.contains("--size 3\nSee sandreel-cli info --help."), extra.err.constData());
}

void TestCommandLine::globalFlagsMayFollowTheSubCommand()
{
    SANDREEL_RUN(before, 0, {"--json", "info", path("in")});
    SANDREEL_RUN(after, 0, {"info", path("in"), "--json"});
    QCOMPARE(before.json().value("frames").toInt(), 5);
    QCOMPARE(after.out, before.out);
}

void TestCommandLine::quietSaysNothing()
{
    SANDREEL_RUN(loud, 0, {"decode", path("in.anim"), "-o", path("loud.pc2")});
    QVERIFY2(loud.err.contains("5 frames, 35 vertices"), loud.err.constData());
    SANDREEL_RUN(quiet, 0, {"-q", "decode", path("in.anim"), "-o", path("quiet.pc2")});
    QCOMPARE(quiet.err, QByteArray());
    QCOMPARE(quiet.out, QByteArray());
    SANDREEL_RUN(error, 4, {"--quiet", "info", path("missing.anim")});
    QVERIFY(!error.err.isEmpty());
}

void TestCommandLine::messagesDoNotMixWithData()
{
    // Far apart: compare says so, but not among the figures.
    tests::writeObjFolder(path("far"), *tests::constant(tests::noTriangles(), 2));
    tests::writeObjFolder(path("away"), *tests::noise(tests::noTriangles(), 2));
    model::TriangleMesh moved = tests::noTriangles();
    for (model::Vec3f &p : moved.positions)
        p = p + model::Vec3f{50, 0, 0};
    tests::writeObjFolder(path("moved"), *tests::constant(moved, 2));
    SANDREEL_RUN(run, 0, {"compare", path("far"), path("moved"), "--json"});
    QVERIFY2(run.err.contains("--normalize"), run.err.constData());
    QVERIFY(run.json().value("kg_error_percent").toDouble() > 50);
    SANDREEL_RUN(near, 0, {"compare", path("far"), path("away"), "--json"});
    QCOMPARE(near.err, QByteArray());
}

void TestCommandLine::fullStandardOutputIsAnError()
{
    for (const QStringList &arguments : {QStringList{"info", path("in.anim")},
                                         QStringList{"--json", "info", path("in.anim")}, QStringList{"--help"}}) {
        SANDREEL_RUN(run, 4, arguments, "/dev/full");
        Q_UNUSED(run)
    }
}

void TestCommandLine::inputErrors_data()
{
    tests::writeFile(path("empty.anim"), "");
    tests::writeFile(path("text.anim"), "not an animation");
    QByteArray damaged = tests::readFile(path("in.anim"));
    damaged[damaged.size() - 8] = char(damaged[damaged.size() - 8] ^ 0x55);
    tests::writeFile(path("damaged.anim"), damaged);
    tests::writeFile(path("cut.anim"), tests::readFile(path("in.anim")).chopped(3));
    tests::writeFile(path("notes.txt"), "hello");
    QDir().mkpath(path("none"));
    tests::writeObjFolder(path("broken"), *tests::wave(tests::grid(), 3));
    tests::writeFile(path("broken/frame_2.obj"), "v 0 0 zero\n");
    tests::writeObjFolder(path("nan"), *tests::wave(tests::grid(), 2));
    tests::writeFile(path("nan/frame_2.obj"), "v 0 0 nan\n");

    QTest::addColumn<QString>("input");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("words");
    QTest::newRow("missing file") << path("missing.anim") << 4 << "missing.anim";
    QTest::newRow("missing folder") << path("missing/") << 4 << "missing";
    QTest::newRow("a device") << "/dev/null" << 3 << "/dev/null";
    QTest::newRow("no frames") << path("none") << 3 << "obj";
    QTest::newRow("unknown ending") << path("notes.txt") << 3 << "txt";
    QTest::newRow("empty .anim") << path("empty.anim") << 3 << "empty.anim";
    QTest::newRow("text as .anim") << path("text.anim") << 3 << "text.anim";
    QTest::newRow("damaged .anim") << path("damaged.anim") << 3 << "damaged.anim, byte";
    QTest::newRow("cut .anim") << path("cut.anim") << 3 << "cut.anim, byte";
    QTest::newRow("broken frame") << path("broken") << 3 << "frame_2.obj, line 1";
    QTest::newRow("NaN in a frame") << path("nan") << 3 << "frame_2.obj, line 1";
}

void TestCommandLine::inputErrors()
{
    QFETCH(const QString, input);
    QFETCH(const int, code);
    QFETCH(const QString, words);
    const QStringList before = tests::contentsOf(mFolder.path());
    for (const QStringList &arguments :
         {QStringList{"info", input}, QStringList{"encode", input, "-o", path("out.anim")},
          QStringList{"decode", input, "-o", path("out")}, QStringList{"compare", path("in"), input},
          QStringList{"render", input, "-o", path("out%d.png")}}) {
        SANDREEL_RUN(run, code, arguments);
        QCOMPARE(run.out, QByteArray());
        QVERIFY2(run.err.contains(words.toUtf8()), run.err.constData());
        // One that was cut can be decoded in part: a line more says how.
        const bool hasHint = arguments.first() == "decode" && input == path("cut.anim");
        QCOMPARE(run.err.contains("--bytes"), hasHint);
        QCOMPARE(run.err.count('\n'), hasHint ? 2 : 1);
        QCOMPARE(tests::contentsOf(mFolder.path()), before);
    }
}

void TestCommandLine::limitIsAnError()
{
    model::TriangleMesh huge = tests::oneTriangle();
    for (model::Vec3f &p : huge.positions)
        p = p * 1e30f;
    tests::writeObjFolder(path("huge"), *tests::oneFrame(huge));
    SANDREEL_RUN(run, 5, {"encode", path("huge"), "-o", path("huge.anim"), "--codec", "pca", "--resolution", "1e7"});
    QVERIFY(!QFile::exists(path("huge.anim")));
}

void TestCommandLine::decimalCommaOfTheLocaleDoesNotMatter()
{
    // A locale of our own making: those of the machine may all have a point.
    QDir().mkpath(path("locales"));
    QProcess make;
    make.start("localedef", {"-i", "de_DE", "-f", "UTF-8", path("locales/de_DE.UTF-8")});
    if (!make.waitForFinished() || !QFile::exists(path("locales/de_DE.UTF-8/LC_NUMERIC")))
        QSKIP("localedef cannot make a locale with a decimal comma here");
    QProcessEnvironment german = QProcessEnvironment::systemEnvironment();
    german.insert("LOCPATH", path("locales"));
    german.insert("LC_ALL", "de_DE.UTF-8");
    const auto arguments = [this](const char *output) {
        return QStringList{"encode", path("in"), "-o",  path(output),   "--fps",
                           "29.97",  "--codec",  "pca", "--resolution", "1234.5"};
    };
    SANDREEL_RUN(here, 0, arguments("here.anim"));
    SANDREEL_RUN(there, 0, arguments("there.anim"), QString(), german);
    QVERIFY(tests::readFile(path("there.anim")) == tests::readFile(path("here.anim")));
    SANDREEL_RUN(info, 0, {"info", path("there.anim")}, QString(), german);
    QVERIFY2(info.out.contains("at 29.97 per second"), info.out.constData());

    // Qt warns of a locale that is not UTF-8: not on our standard error.
    QProcessEnvironment plain = QProcessEnvironment::systemEnvironment();
    plain.insert("LC_ALL", "C");
    SANDREEL_RUN(ascii, 0, {"info", path("there.anim")}, QString(), plain);
    QCOMPARE(ascii.err, QByteArray());
}

void TestCommandLine::namesCannotSteerTheTerminal()
{
    SANDREEL_RUN(encode, 0, {"encode", path("in"), "-o", path("evil.anim"), "--name", "a\x1b[2Jb"});
    SANDREEL_RUN(info, 0, {"info", path("evil.anim")});
    QVERIFY2(!info.out.contains('\x1b') && info.out.contains("[2Jb"), info.out.constData());
}

SANDREEL_TEST(TestCommandLine)
#include "tst_commandline.moc"
