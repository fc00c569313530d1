// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli/clirun.h"
#include "tests/support/testmain.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>

#include <cmath>

/// `sandreel-cli haptics`; what speaks to devices runs under a libhidapi that plays them.
class TestHaptics final : public QObject
{
    Q_OBJECT

    QTemporaryDir mFolder;
    QString path(const char *name) const { return mFolder.filePath(QString::fromUtf8(name)); }

    QByteArray contentOf(const char *name) const
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    /// The environment in which the program finds the devices of `script`.
    QProcessEnvironment faked(const QByteArray &script) const
    {
        QFile file(path("devices"));
        if (file.open(QIODevice::WriteOnly))
            file.write(script);
        QFile::remove(path("sent"));
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("LD_LIBRARY_PATH", QFileInfo(QStringLiteral(SANDREEL_CLI)).dir().filePath("../fakehidapi"));
        environment.insert("SANDREEL_FAKE_HID", path("devices"));
        environment.insert("SANDREEL_FAKE_HID_SENT", path("sent"));
        return environment;
    }

    /// The lines of `haptics monitor --json`.
    static QList<QJsonObject> linesOf(const QByteArray &out)
    {
        QList<QJsonObject> lines;
        for (const QByteArray &line : out.split('\n'))
            if (!line.isEmpty())
                lines << QJsonDocument::fromJson(line).object();
        return lines;
    }

private slots:
    void withoutDevicesThereIsTheSimulatedOne()
    {
        SANDREEL_RUN(run, 0, {"haptics", "list", "--json"}, {}, faked(""));
        const QJsonArray devices = run.json()["devices"].toArray();
        QCOMPARE(devices.size(), 1);
        QCOMPARE(devices[0].toObject()["id"].toString(), "simulated");
    }

    void listsWhatTheLibraryFinds()
    {
        SANDREEL_RUN(run, 0, {"haptics", "list", "--json"}, {},
                     faked("device 046d c077 1 2 Mouse\n"
                           "device 046d c626 1 8 SpaceNavigator\n"
                           "device 256f c652 1 6 Universal Receiver\n"
                           "device 256f c652 1 8 Universal Receiver\n"));
        const QJsonArray devices = run.json()["devices"].toArray();
        QCOMPARE(devices.size(), 3);
        QCOMPARE(devices[1].toObject()["id"].toString(), "spacemouse:/fake/1");
        QCOMPARE(devices[1].toObject()["name"].toString(), "SpaceNavigator");
        QVERIFY(!devices[1].toObject()["force"].toBool());
        QCOMPARE(devices[2].toObject()["id"].toString(), "spacemouse:/fake/3");
    }

    void theShippedAdapterReadsReports()
    {
        QByteArray script = "device 046d c626 1 8 SpaceNavigator\nreport 03 02 00\nreport 17 5a 00\nreport\n";
        script.replace("report\n", "report ff\n"); // garbage
        for (int i = 0; i < 60; ++i)
            script += "report 01 5e 01 00 00 00 00\nreport 02 00 00 e2 ff 00 00\n";
        script += "report 01 00 00 00 00 00 00\n";
        SANDREEL_RUN(run, 0,
                     {"haptics", "monitor", "--device", "spacemouse:/fake/0", "--light", "--seconds", "3", "--json"},
                     {}, faked(script));
        const QList<QJsonObject> lines = linesOf(run.out);
        QVERIFY(lines.size() > 2);
        const QJsonObject last = lines.last();
        QVERIFY(last["connected"].toBool());
        QCOMPARE(last["buttons"].toInt(), 2);
        QCOMPARE(last["battery"].toInt(), 90);
        QVERIFY(last["position"].toArray()[0].toDouble() > 0.01);
        QCOMPARE(last["position"].toArray()[2].toDouble(), 0.0);
        QVERIFY(contentOf("sent").endsWith("04 01 \n04 00 \n")); // on, and off at the end
    }

    void unplugAndPlugIn()
    {
        SANDREEL_RUN(run, 0, {"haptics", "monitor", "--device", "spacemouse:/fake/0", "--seconds", "3", "--json"}, {},
                     faked("device 256f c635 1 8 SpaceMouse Compact\nreport 03 01 00\ngone\nreport 03 02 00\n"));
        const QList<QJsonObject> lines = linesOf(run.out);
        bool wasGone = false, cameBack = false;
        for (const QJsonObject &line : lines) {
            wasGone |= !line["connected"].toBool();
            cameBack |= wasGone && line["connected"].toBool() && line["buttons"].toInt() == 2;
        }
        QVERIFY(wasGone);
        QVERIFY(cameBack);
    }

    void whatCannotBeOpenedSaysWhy()
    {
        const QProcessEnvironment environment = faked("device 256f c635 1 8 SpaceMouse\nforbidden\n");
        SANDREEL_RUN(run, 4, {"haptics", "monitor", "--device", "spacemouse:/fake/0"}, {}, environment);
        QVERIFY(run.err.contains("/fake/0"));
        QVERIFY(run.err.contains("the fake says no"));
        SANDREEL_RUN(unknown, 2, {"haptics", "monitor", "--device", "spacemouse:/fake/7"}, {}, environment);
        QVERIFY(unknown.err.contains("simulated, spacemouse:/fake/0"));
    }

    void simulatesAndReplays()
    {
        for (const QString &material : {QStringLiteral("dry sand"), QStringLiteral("moist sand")}) {
            SANDREEL_RUN(run, 0, {"haptics", "simulate", "--material", material, "-o", path("press.haptics")});
            SANDREEL_RUN(replayed, 0,
                         {"haptics", "replay", path("press.haptics"), "--csv", path("press.csv"), "--json"});
            QVERIFY(replayed.json()["identical"].toBool());
            QCOMPARE(replayed.json()["steps"].toInt(), 9501);
            QVERIFY(replayed.json()["largest_force_n"].toDouble() > 1);
            QCOMPARE(contentOf("press.csv").count('\n'), 9502);
        }
    }

    void recordsWhatItMonitors()
    {
        SANDREEL_RUN(run, 0,
                     {"haptics", "monitor", "--forces", "--seconds", "4", "--record", path("live.haptics"), "--json"},
                     {}, faked(""));
        SANDREEL_RUN(replayed, 0, {"haptics", "replay", path("live.haptics"), "--json"});
        QVERIFY(replayed.json()["steps"].toInt() > 100);
        QCOMPARE(replayed.json()["lost_steps"].toInt(), 0);
        QVERIFY2(replayed.json()["identical"].toBool(), replayed.out.constData());
    }

    void benchSaysWhatWasAsked()
    {
        SANDREEL_RUN(run, 0, {"haptics", "bench", "--seconds", "1", "--json"}, {}, faked(""));
        const QJsonObject json = run.json();
        QVERIFY(std::abs(json["rate_hz"].toDouble() - 1000) < 1);
        QVERIFY(json["missed_ticks"].isDouble());
        for (const char *what : {"lateness_us", "bare_timer_us"})
            for (const char *share : {"p50", "p99", "p999", "max"})
                QVERIFY(json[QLatin1String(what)].toObject()[QLatin1String(share)].toDouble() > 0);
    }

    void wrongUse_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("code");
        QTest::newRow("law") << QStringList{"simulate", "-o", "x.haptics", "--law", "2010"} << 2;
        QTest::newRow("material") << QStringList{"simulate", "-o", "x.haptics", "--material", "jelly"} << 2;
        QTest::newRow("force") << QStringList{"simulate", "-o", "x.haptics", "--max-force", "11"} << 2;
        QTest::newRow("no ground") << QStringList{"bench", "--ground", "nowhere.terrain"} << 4;
        QTest::newRow("no recording") << QStringList{"replay", "nowhere.haptics"} << 4;
        QTest::newRow("no script") << QStringList{"monitor", "--script", "nowhere.txt"} << 4;
        QTest::newRow("nothing") << QStringList{} << 2;
    }
    void wrongUse()
    {
        QFETCH(QStringList, arguments);
        QFETCH(int, code);
        const tests::CliRun run = tests::runCli(QStringList{"haptics"} + arguments);
        QCOMPARE(run.exitCode, code);
        QVERIFY(!run.err.isEmpty());
    }

    void damagedRecording()
    {
        QFile file(path("bad.haptics"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("SRHAPTIC\x02");
        file.close();
        SANDREEL_RUN(run, 3, {"haptics", "replay", path("bad.haptics")});
        QVERIFY(run.err.contains("bad.haptics"));
    }
};

SANDREEL_TEST(TestHaptics)
#include "tst_haptics.moc"
