// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/animationfiles.h"
#include "tests/app/cli/clirun.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QTemporaryDir>

class TestRender : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void drawsTheFrameThatIsAskedFor();
    void drawsEveryFrame();
    void numbersInNames_data();
    void numbersInNames();
    void optionsShow();
    void picturesThatCannotBeWritten();
    void removesOnlyItsOwnPictures();

private:
    QString path(const char *name) const { return mFolder.filePath(QString::fromUtf8(name)); }

    QTemporaryDir mFolder;
};

namespace {

/// Pixels that are not as those at the left border of their row, where only the background is seen.
int drawnPixels(const QImage &image)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            count += image.pixel(x, y) != image.pixel(0, y);
    return count;
}

} // namespace

void TestRender::initTestCase()
{
    tests::writeObjFolder(path("cube"), *tests::rigidRotation(tests::cube(), 12));
}

void TestRender::drawsTheFrameThatIsAskedFor()
{
    SANDREEL_RUN(first, 0, {"render", path("cube"), "-o", path("first.png"), "--size", "120x80"});
    QVERIFY2(first.err.contains("first.png: frame 1") && first.out.isEmpty(), first.err.constData());
    SANDREEL_RUN(third, 0,
                 {"render", path("cube"), "-o", path("third.png"), "--size", "120x80", "--frame", "3", "--json"});
    QCOMPARE(third.json().value("pictures").toInt(), 1);
    QCOMPARE(third.json().value("width").toInt(), 120);
    const QImage a(path("first.png")), b(path("third.png"));
    QCOMPARE(a.size(), QSize(120, 80));
    // A cube fitted into the height covers a good part of the picture, but not its corners.
    QVERIFY(drawnPixels(a) > 120 * 80 / 10 && drawnPixels(a) < 120 * 80 * 7 / 10);
    QVERIFY(a != b);
    // A quarter turn brings the cube onto itself.
    SANDREEL_RUN(fourth, 0, {"render", path("cube"), "-o", path("fourth.png"), "--size", "120x80", "--frame", "4"});
    const int more = drawnPixels(QImage(path("fourth.png"))) - drawnPixels(a);
    QVERIFY2(std::abs(more) < 20, qPrintable(QString::number(more)));
}

void TestRender::drawsEveryFrame()
{
    QDir().mkpath(path("all"));
    SANDREEL_RUN(run, 0, {"render", path("cube"), "-o", path("all/c_%04d.png"), "--size", "60x40", "--json"});
    QCOMPARE(run.json().value("pictures").toInt(), 12);
    QStringList expected;
    for (int i = 1; i <= 12; ++i)
        expected << QStringLiteral("c_%1.png").arg(i, 4, 10, QLatin1Char('0'));
    QCOMPARE(tests::contentsOf(path("all")), expected);
    SANDREEL_RUN(single, 0, {"render", path("cube"), "-o", path("one.png"), "--size", "60x40", "--frame", "7"});
    QCOMPARE(tests::readFile(path("one.png")), tests::readFile(path("all/c_0007.png")));
}

void TestRender::numbersInNames_data()
{
    QTest::addColumn<QString>("pattern");
    QTest::addColumn<QString>("name");
    QTest::newRow("%d") << "a%d.png"
                        << "a1.png";
    QTest::newRow("%03d") << "b%03d_x.png"
                          << "b001_x.png";
    QTest::newRow("%2d") << "c%2d.png"
                         << "c01.png";
    QTest::newRow("a width beyond reason is none") << "d%0999999999d.png"
                                                   << "d%0999999999d.png";
}

void TestRender::numbersInNames()
{
    QFETCH(const QString, pattern);
    QFETCH(const QString, name);
    tests::writeObjFolder(path("one"), *tests::oneFrame(tests::cube()));
    SANDREEL_RUN(run, 0, {"render", path("one"), "-o", mFolder.filePath(pattern), "--size", "20x20"});
    QVERIFY(QFile::exists(mFolder.filePath(name)));
}

void TestRender::optionsShow()
{
    const QStringList base{"render", path("cube"), "--size", "90x90", "-o"};
    SANDREEL_RUN(plain, 0, base + QStringList{path("plain.png")});
    const QByteArray picture = tests::readFile(path("plain.png"));
    for (const QStringList &option :
         {QStringList{"--wireframe"}, QStringList{"--yaw", "-100"}, QStringList{"--pitch", "-45.5"}}) {
        SANDREEL_RUN(other, 0, base + QStringList{path("other.png")} + option);
        QVERIFY2(tests::readFile(path("other.png")) != picture, qPrintable(option.first()));
    }
    SANDREEL_RUN(same, 0, base + QStringList{path("same.png"), "--yaw", "35", "--pitch", "20"});
    QCOMPARE(tests::readFile(path("same.png")), picture);
}

void TestRender::picturesThatCannotBeWritten()
{
    const QStringList before = tests::contentsOf(mFolder.path());
    for (const QString &output : {path("missing/x.png"), path("missing/%d.png"), QStringLiteral("/proc/x.png"),
                                  QStringLiteral("/proc/%d.png")}) {
        SANDREEL_RUN(run, 4, {"render", path("cube"), "-o", output, "--size", "20x20"});
        QVERIFY2(!run.err.isEmpty() && run.out.isEmpty(), run.err.constData());
    }
    QCOMPARE(tests::contentsOf(mFolder.path()), before);
}

void TestRender::removesOnlyItsOwnPictures()
{
    // The fifth picture cannot be written: a folder is in its place.
    QDir().mkpath(path("part/p5.png"));
    tests::writeFile(path("part/p2.png"), "older");
    SANDREEL_RUN(run, 4, {"render", path("cube"), "-o", path("part/p%d.png"), "--size", "20x20"});
    QVERIFY2(run.err.contains("p5.png"), run.err.constData());
    const QStringList expected{"p2.png", "p5.png"};
    QCOMPARE(tests::contentsOf(path("part")), expected);
}

SANDREEL_TEST(TestRender)
#include "tst_render.moc"
