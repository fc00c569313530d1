// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/animationfiles.h"
#include "tests/app/cli/clirun.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"

#include <QElapsedTimer>
#include <QProcess>
#include <QTemporaryDir>

#include <csignal>
#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

/// A person who watches the progress bar and presses Ctrl+C.
class TestInterrupt : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void interruptedWorkLeavesNothing_data();
    void interruptedWorkLeavesNothing();
    void quietDrawsNoBar();
    void readerThatGoesAwayIsAnError();

private:
    QString path(const char *name) const { return mFolder.filePath(QString::fromUtf8(name)); }

    QTemporaryDir mFolder;
};

namespace {

/// A terminal for the program's standard error.
class Terminal
{
public:
    Terminal()
        : mMaster(posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK))
    {
        grantpt(mMaster);
        unlockpt(mMaster);
        mSlave = open(ptsname(mMaster), O_RDWR | O_NOCTTY);
    }
    Terminal(const Terminal &) = delete;
    Terminal &operator=(const Terminal &) = delete;
    ~Terminal()
    {
        close(mSlave);
        close(mMaster);
    }

    void start(QProcess &process, const QStringList &arguments) const
    {
        process.setChildProcessModifier([slave = mSlave] {
            dup2(slave, STDERR_FILENO);
            std::signal(SIGINT, SIG_DFL); // the tests may run where it is ignored
            std::signal(SIGTERM, SIG_DFL);
        });
        process.start(QStringLiteral(SANDREEL_CLI), arguments);
    }

    /// All that was shown so far.
    const QByteArray &text()
    {
        char buffer[4096];
        for (ssize_t count = read(mMaster, buffer, sizeof buffer); count > 0;
             count = read(mMaster, buffer, sizeof buffer))
            mText.append(buffer, count);
        return mText;
    }

private:
    int mMaster, mSlave;
    QByteArray mText;
};

} // namespace

void TestInterrupt::initTestCase()
{
    // Noise has full rank: much work for the encoder.
    tests::writeObjFolder(path("long"), *tests::noise(tests::grid(40, 40), 250));
    tests::writeObjFolder(path("short"), *tests::noise(tests::grid(), 3));
}

void TestInterrupt::interruptedWorkLeavesNothing_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("stage");
    QTest::addColumn<int>("signal");
    const QString in = path("long");
    const QStringList encode{"encode", in,        "-o",   path("x.anim"), "--permutation", path("x.txt"), "--codec",
                             "pca",    "--basis", "1000", "--resolution", "1e6",           "--measure"};
    const QStringList render{"render", in, "-o", path("p%d.png"), "--size", "1920x1080"};
    QTest::newRow("encode, while reading") << encode << "" << SIGINT;
    QTest::newRow("encode") << encode << "Encoding" << SIGINT;
    QTest::newRow("encode, SIGTERM") << encode << "Encoding" << SIGTERM;
    QTest::newRow("render") << render << "Drawing" << SIGINT;
}

void TestInterrupt::interruptedWorkLeavesNothing()
{
    QFETCH(const QStringList, arguments);
    QFETCH(const QString, stage);
    QFETCH(const int, signal);
    const QStringList before = tests::contentsOf(mFolder.path());
    Terminal terminal;
    QProcess process;
    terminal.start(process, arguments);
    QVERIFY(process.waitForStarted());
    QElapsedTimer clock;
    clock.start();
    const auto isReady = [&] {
        if (!stage.isEmpty())
            return terminal.text().contains(stage.toUtf8());
        // Handlers are in place.
        const QByteArray status = tests::readFile(QStringLiteral("/proc/%1/status").arg(process.processId()));
        const qsizetype caught = status.indexOf("SigCgt:");
        return caught >= 0 && (status.mid(caught + 7, 17).trimmed().toULongLong(nullptr, 16) & (1u << (SIGINT - 1)));
    };
    while (!isReady() && clock.elapsed() < 120'000 && !process.waitForFinished(2))
        ;
    QVERIFY2(isReady(), terminal.text().constData());
    QCOMPARE(process.state(), QProcess::Running);
    kill(pid_t(process.processId()), signal);
    QVERIFY(process.waitForFinished(120'000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QVERIFY2(process.exitCode() == 130, terminal.text().constData());
    QCOMPARE(process.readAllStandardOutput(), QByteArray());
    QVERIFY2(terminal.text().endsWith("Cancelled.\r\n"), terminal.text().constData());
    QCOMPARE(tests::contentsOf(mFolder.path()), before);
}

void TestInterrupt::quietDrawsNoBar()
{
    Terminal terminal;
    QProcess process;
    terminal.start(process, {"--quiet", "render", path("long"), "-o", path("q.png"), "--size", "800x600"});
    QVERIFY(process.waitForFinished(120'000));
    QCOMPARE(process.exitCode(), 0);
    QCOMPARE(terminal.text(), QByteArray());
}

void TestInterrupt::readerThatGoesAwayIsAnError()
{
    int ends[2];
    QCOMPARE(pipe2(ends, O_CLOEXEC), 0);
    QProcess process;
    process.setChildProcessModifier([writer = ends[1]] { dup2(writer, STDOUT_FILENO); });
    close(ends[0]);
    process.start(QStringLiteral(SANDREEL_CLI), {"info", path("short")});
    QVERIFY(process.waitForFinished());
    close(ends[1]);
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 4);
    QVERIFY(process.readAllStandardError().contains("standard output"));
}

SANDREEL_TEST(TestInterrupt)
#include "tst_interrupt.moc"
