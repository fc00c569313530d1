// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testmain.h"
#include "views/viewport/glsupport.h"

#include <QCoreApplication>
#include <QProcess>
#include <QSurfaceFormat>

/// The answer is found once in a process: each case asks in a process of its own, this program run again.
class TestGlSupport final : public QObject
{
    Q_OBJECT

private slots:
    void everyMachineGetsAnAnswer_data()
    {
        QTest::addColumn<QString>("platform");
        QTest::addColumn<QString>("simulated");
        QTest::addColumn<QString>("answer");
        QTest::newRow("xcb") << "xcb"
                             << ""
                             << "sufficient";
        QTest::newRow("no OpenGL") << "xcb"
                                   << "none"
                                   << "none";
        QTest::newRow("too old") << "xcb"
                                 << "old"
                                 << "insufficient";
        QTest::newRow("offscreen") << "offscreen"
                                   << ""
                                   << "none"; // where Qt 6.4 crashes if asked for a context
        QTest::newRow("minimal") << "minimal"
                                 << ""
                                 << "none";
    }
    void everyMachineGetsAnAnswer()
    {
        QFETCH(QString, platform);
        QFETCH(QString, simulated);
        QFETCH(QString, answer);
        QProcess child;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("QT_QPA_PLATFORM", platform);
        environment.insert("SANDREEL_OPENGL", simulated);
        environment.insert("SANDREEL_EXPECTED_ANSWER", answer);
        child.setProcessEnvironment(environment);
        child.setProcessChannelMode(QProcess::MergedChannels);
        child.start(QCoreApplication::applicationFilePath(), {"tst_glsupport", "answerOfThisProcess"});
        QVERIFY(child.waitForFinished(60'000));
        const QByteArray output = child.readAll();
        QVERIFY2(child.exitStatus() == QProcess::NormalExit && child.exitCode() == 0, output.constData());
        QVERIFY2(output.contains("1 passed") || output.contains("3 passed"), output.constData());
    }

    void answerOfThisProcess()
    {
        const QString expected = qEnvironmentVariable("SANDREEL_EXPECTED_ANSWER");
        if (expected.isEmpty())
            return; // asked without a parent, see above
        const views::GlSupport &found = views::glSupport();
        QCOMPARE(&found, &views::glSupport());
        QCOMPARE(found.isSufficient, expected == "sufficient");
        QCOMPARE(found.version.isEmpty(), expected == "none");
        QCOMPARE(found.renderer.isEmpty(), expected == "none");
    }

    void formatIsWhatIsNeeded()
    {
        views::setDefaultGlFormat();
        const QSurfaceFormat format = QSurfaceFormat::defaultFormat();
        QCOMPARE(format.majorVersion(), 3);
        QCOMPARE(format.minorVersion(), 3);
        QCOMPARE(format.profile(), QSurfaceFormat::CoreProfile);
        QVERIFY(format.depthBufferSize() >= 24);
    }
};

SANDREEL_TEST(TestGlSupport)
#include "tst_glsupport.moc"
