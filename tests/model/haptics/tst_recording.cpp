// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/record/session.h"
#include "tests/model/haptics/grounds.h"
#include "tests/support/testmain.h"

#include <QFile>
#include <QRegularExpression>

#include <zlib.h>

using namespace model;
using namespace model::haptics;
using namespace std::chrono_literals;
using tests::lengthOf;

namespace {

terrain::Terrain levelGround()
{
    return tests::groundOf(0.25, [](double, double) { return 0.0; });
}

SessionPlan plan(terrain::MaterialPreset preset, LawKind law = LawKind::Granular)
{
    SessionPlan session;
    session.settings.law = law;
    session.settings.workspace = tests::plainWorkspace();
    session.settings.limits.userForce = 8;
    session.settings.overridesFeel = true;
    const terrain::Material material = terrain::material(preset);
    session.settings.feel = feelOf(material, material.humidity);
    session.trajectory = pressTrajectory();
    return session;
}

std::vector<ServoSample> samplesOf(const Recording &recording)
{
    std::vector<ServoSample> samples;
    for (const Recording::Event &event : recording.events)
        if (const auto *sample = std::get_if<ServoSample>(&event))
            samples.push_back(*sample);
    return samples;
}

QByteArray dataFile(const char *name)
{
    QFile file(QStringLiteral(SANDREEL_SOURCE "/%1").arg(QLatin1String(name)));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

Bytes bytesOf(const QByteArray &text)
{
    return Bytes(text.begin(), text.end());
}

/// Makes the checksum at the end that of what is there.
void resign(Bytes &bytes)
{
    const std::size_t covered = bytes.size() - 4;
    const std::uint32_t checksum = std::uint32_t(crc32_z(0, bytes.data(), covered));
    for (std::size_t i = 0; i < 4; ++i)
        bytes[covered + i] = std::uint8_t(checksum >> (8 * i));
}

/// A recording with one of everything.
Recording small()
{
    SessionPlan session = plan(terrain::MaterialPreset::Mud);
    session.trajectory = Trajectory({{0, {0, 0, 0.005}, 0}, {0.06, {0, 0, -0.01}, 1}});
    Recording recording = simulateSession(levelGround(), session);
    recording.note = "small";
    return recording;
}

} // namespace

class TestRecording final : public QObject
{
    Q_OBJECT

private slots:
    /// Pressing into dry and wet sand: recorded, written, read, replayed to the last bit; and it feels as it should.
    void sessionsReplayIdentically_data()
    {
        QTest::addColumn<int>("preset");
        QTest::addColumn<int>("law");
        for (const LawKind law : EveryLaw)
            for (const terrain::MaterialPreset preset :
                 {terrain::MaterialPreset::DrySand, terrain::MaterialPreset::MoistSand})
                QTest::addRow("%s, %s", nameOf(law), terrain::nameOf(preset)) << int(preset) << int(law);
    }
    void sessionsReplayIdentically()
    {
        QFETCH(int, preset);
        QFETCH(int, law);
        const Recording recording = simulateSession(levelGround(), plan(terrain::MaterialPreset(preset), LawKind(law)));
        const Bytes bytes = writeRecording(recording);
        const auto read = readRecording(bytes);
        QVERIFY2(read.has_value(), read ? "" : read.error().args[0].c_str());
        QCOMPARE(read->events.size(), recording.events.size());
        QCOMPARE(writeRecording(*read), bytes);
        const auto replayed = replay(*read);
        QVERIFY(replayed.has_value());
        QVERIFY(replayed->steps > 9000);
        QCOMPARE(replayed->different, 0u);
        QVERIFY(replayed->largestForce > 1);
    }

    /// The plot of docs/haptics.md, as numbers: more with depth, it gives way, and does not tremble while it is held.
    void pressingFeelsLikeSand()
    {
        double deepest[2], pull[2];
        for (const int i : {0, 1}) {
            const std::vector<ServoSample> samples = samplesOf(simulateSession(
                levelGround(), plan(i ? terrain::MaterialPreset::MoistSand : terrain::MaterialPreset::DrySand)));
            const auto at = [&](double time) { return samples[std::size_t(time * 1000)]; };
            double before = 0;
            for (const double time : {3.5, 3.8, 4.1, 4.45}) {
                QVERIFY(at(time).force.z > before + 0.2);
                before = at(time).force.z;
            }
            deepest[i] = at(4.5).force.z;
            QVERIFY(at(4.5).depth > 0.01);
            for (const double held : {5.0, 7.6}) {
                double low = 1e9, high = -1e9;
                for (double t = held; t < held + 0.4; t += 0.001) {
                    low = std::min(low, lengthOf(at(t).force));
                    high = std::max(high, lengthOf(at(t).force));
                }
                QVERIFY2(high - low < 0.02, qPrintable(QString("%1 N at %2 s").arg(high - low).arg(held)));
            }
            QVERIFY(at(6.5).force.x < -0.3); // ploughed to the right
            pull[i] = 0;
            for (double t = 8; t < 9; t += 0.001)
                pull[i] = std::min(pull[i], at(t).force.z);
            QCOMPARE(lengthOf(at(9.4).force), 0.0);
        }
        QVERIFY(deepest[1] > 1.05 * deepest[0]);
        QVERIFY2(pull[0] > -0.3 && pull[1] < -0.8, qPrintable(QString("%1 %2").arg(pull[0]).arg(pull[1])));
    }

    void replayFindsADifference()
    {
        Recording recording = simulateSession(levelGround(), plan(terrain::MaterialPreset::DrySand));
        std::uint64_t steps = 0;
        for (Recording::Event &event : recording.events)
            if (auto *sample = std::get_if<ServoSample>(&event); sample && steps++ == 4000)
                sample->force.z = std::nextafter(sample->force.z, 10.0);
        const auto replayed = replay(recording);
        QVERIFY(replayed.has_value());
        QCOMPARE(replayed->different, 1u);
        QCOMPARE(replayed->firstDifferent, 4000u);
        QVERIFY(!replayed->isIdentical());
    }

    void replayNeedsWhatItsStepsName()
    {
        Recording recording = small();
        std::get<ServoSample>(recording.events.back()).settings = 77;
        QCOMPARE(replay(recording).error().code, ErrorCode::BadValue);
        recording = small();
        std::get<ServoSample>(recording.events.back()).patch = 77;
        QCOMPARE(replay(recording).error().code, ErrorCode::BadValue);
    }

    void sameGroundIsKeptOnce()
    {
        Recorder recorder("x");
        auto patch = std::make_unique<TerrainPatch>();
        tests::levelPatch(*patch, 0, {});
        recorder.add(*patch);
        patch->id = 2;
        recorder.add(*patch);
        tests::levelPatch(*patch, 0.1, {});
        recorder.add(*patch);
        const auto &events = recorder.recording().events;
        QVERIFY(!std::get<RecordedPatch>(events[0]).isRefresh);
        QVERIFY(std::get<RecordedPatch>(events[1]).isRefresh);
        QVERIFY(!std::get<RecordedPatch>(events[2]).isRefresh);
    }

    /// The file of the first version. Its forces come from this machine's square roots and cosines: elsewhere they may
    /// differ in the last bits.
    void recordingsOfVersion1AreReadAndReplayed()
    {
        const QByteArray file = dataFile("tests/data/haptics/version1.haptics");
        QVERIFY(!file.isEmpty());
        const auto read = readRecording(bytesOf(file));
        QVERIFY2(read.has_value(), read ? "" : read.error().args[0].c_str());
        QCOMPARE(read->device, std::string("Simulated device"));
        QCOMPARE(read->note, std::string("small"));
        QCOMPARE(samplesOf(*read).size(), 61u);
        const ServoSample last = samplesOf(*read).back();
        QVERIFY(std::abs(last.depth - 0.000656) < 1e-6); // the hand is late behind where it wants to be
        QCOMPARE(last.reading.buttons, 1u);
        const auto replayed = replay(*read);
        QVERIFY(replayed.has_value());
        QCOMPARE(replayed->steps, 61u);
        QVERIFY(replayed->largestDifference < 1e-9);
    }

    void everyPrefixIsRejected()
    {
        const Bytes bytes = writeRecording(small());
        for (std::size_t length = 0; length < bytes.size(); length += length < 400 ? 1 : 97)
            QVERIFY(!readRecording(Bytes(bytes.begin(), bytes.begin() + std::ptrdiff_t(length))));
        Bytes longer = bytes;
        longer.push_back(0);
        QCOMPARE(readRecording(longer).error().code, ErrorCode::TrailingBytes);
    }

    void damageIsNamed_data()
    {
        QTest::addColumn<int>("at");
        QTest::addColumn<int>("byte");
        QTest::addColumn<int>("code");
        const auto row = [](const char *name, int at, int byte, ErrorCode code) {
            QTest::newRow(name) << at << byte << int(code);
        };
        // The device's name is 16 bytes, the note 5: the settings begin at 8 + 2 + 17 + 6 = 33 with their tag.
        row("magic", 0, 'X', ErrorCode::BadMagic);
        row("version", 8, 2, ErrorCode::UnsupportedVersion);
        row("long name", 10, 0xff, ErrorCode::BadValue);
        row("tag", 33, 9, ErrorCode::BadValue);
        row("scale of nothing", 33 + 1 + 8 + 24 + 7, 0xbf, ErrorCode::BadValue); // -1
        row("law", 33 + 1 + 8 + 40, 9, ErrorCode::BadValue);
        row("infinite gain", 33 + 1 + 8 + 41 + 7, 0x7f, ErrorCode::NonFinite);
        row("somewhere", 500, 0x55, ErrorCode::ChecksumMismatch);
    }
    void damageIsNamed()
    {
        QFETCH(int, at);
        QFETCH(int, byte);
        QFETCH(int, code);
        Recording recording = small();
        Bytes bytes = writeRecording(recording);
        if (code == int(ErrorCode::NonFinite))
            bytes[std::size_t(at) - 1] = 0xf0;
        bytes[std::size_t(at)] = std::uint8_t(byte);
        const auto read = readRecording(bytes);
        QVERIFY(!read);
        QCOMPARE(int(read.error().code), code);
    }

    /// Whatever is read can be replayed: with the checksum made right, as an adversary would.
    void anyBytesAreSafe()
    {
        const Recording recording = small();
        std::mt19937 random(4);
        const Bytes whole = writeRecording(recording);
        int replayedCount = 0;
        for (int i = 0; i < 1500; ++i) {
            Bytes bytes = whole;
            for (int k = int(random() % 6); k >= 0; --k)
                bytes[10 + random() % (bytes.size() - 14)] = std::uint8_t(random());
            resign(bytes);
            if (const auto read = readRecording(bytes)) {
                if (const auto replayed = replay(*read)) {
                    ++replayedCount;
                    for (const ServoSample &sample : replayed->samples)
                        QVERIFY(lengthOf(sample.force) <= 10);
                }
            }
        }
        QVERIFY(replayedCount > 50);
    }

    void documentSaysTheVersion()
    {
        const QByteArray document = dataFile("model/haptics/record/FORMAT.md");
        QVERIFY(document.contains(QStringLiteral("Format version: %1\n").arg(RecordingVersion).toUtf8()));
    }

    /// The worked example of the document, taken out of it.
    void workedExampleIsRead()
    {
        static const QRegularExpression block("```hex\n([^`]*)```");
        const QString hex = block.match(QString::fromUtf8(dataFile("model/haptics/record/FORMAT.md"))).captured(1);
        QByteArray digits;
        for (const QString &line : hex.split('\n'))
            digits += line.section('#', 0, 0).toUtf8();
        const auto read = readRecording(bytesOf(QByteArray::fromHex(digits)));
        QVERIFY2(read.has_value(), read ? "" : read.error().args[0].c_str());
        QCOMPARE(read->device, std::string("Stick"));
        QCOMPARE(read->events.size(), 2u);
        const auto &patch = std::get<RecordedPatch>(read->events[0]);
        QCOMPARE(patch.id, 1u);
        QCOMPARE(patch.triangles.size(), 1u);
        QCOMPARE(patch.triangles[0][1], (Vec3f{1, 0, 0}));
        QCOMPARE(patch.feel.resistance, 120.0);
        const auto &sample = std::get<ServoSample>(read->events[1]);
        QCOMPARE(sample.now, Time(1ms));
        QCOMPARE(sample.reading.position.z, 0.5);
        QVERIFY(sample.reading.isConnected);
        QCOMPARE(sample.state, SafetyState::Stopped);
        QCOMPARE(sample.cause, SafetyCause::Stopped);
    }
};

SANDREEL_TEST(TestRecording)
#include "tst_recording.moc"
