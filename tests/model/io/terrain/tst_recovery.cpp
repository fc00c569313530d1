// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/terraindocument.h"
#include "model/io/terrain/maskjson.h"
#include "model/io/terrain/recovery.h"
#include "model/terrain/tin/validate.h"
#include "tests/model/io/terrain/terrains.h"
#include "tests/support/scarcity.h"
#include "tests/support/testmain.h"

#include <QFileInfo>
#include <QTemporaryDir>

#include <csignal>
#include <optional>
#include <random>

#include <sys/wait.h>
#include <unistd.h>

using namespace model;
using namespace model::io;
using namespace model::terrain;

namespace {

constexpr std::uint64_t Limit = std::uint64_t(1) << 28;

std::span<const std::uint8_t> span(const QByteArray &bytes)
{
    return {reinterpret_cast<const std::uint8_t *>(bytes.data()), std::size_t(bytes.size())};
}

/// A terrain, edited at random, journalled, with undo and redo in between.
class Session
{
public:
    Session(const QString &path, unsigned seed)
        : mDocument(tests::specimenTerrain(tests::Ground::Random, seed, 120))
        , mSource(tests::Ground::Random, seed + 100)
        , mPath(path)
    {}

    TerrainDocument &document() { return mDocument; }
    QString journalPath() const { return mPath + ".journal"; }

    bool save()
    {
        if (!saveTerrain(mPath, mDocument.terrain(), {}))
            return false;
        const auto base = recoveryBaseOf(mPath);
        auto begun = base ? RecoveryJournal::begin(journalPath(), *base, mDocument.terrain())
                          : Result<std::unique_ptr<RecoveryJournal>>(fail(base.error()));
        if (begun)
            mJournal = std::move(*begun);
        return begun.has_value();
    }
    bool beginUnsaved()
    {
        auto begun = RecoveryJournal::begin(journalPath(), {}, mDocument.terrain());
        if (begun)
            mJournal = std::move(*begun);
        return begun.has_value();
    }

    Result<void> step()
    {
        const std::uint32_t kind = mSource.below(10);
        if (kind == 0 && !mDone.empty()) {
            mDocument.swap(mDone.back());
            const auto added = mJournal->addEdit(mDone.back(), mDocument.terrain());
            mUndone.push_back(std::move(mDone.back()));
            mDone.pop_back();
            return added;
        }
        if (kind == 1 && !mUndone.empty()) {
            mDocument.swap(mUndone.back());
            const auto added = mJournal->addEdit(mUndone.back(), mDocument.terrain());
            mDone.push_back(std::move(mUndone.back()));
            mUndone.pop_back();
            return added;
        }
        if (kind == 2) {
            auto materials = mDocument.terrain().materials;
            materials[1].bulkDensity += 1;
            mDocument.setMaterials(materials);
            GeoReference place = mDocument.terrain().geoReference;
            place.originX += 0.125;
            mDocument.setGeoReference(place);
            return mJournal->addSettings(mDocument.terrain());
        }
        mUndone.clear();
        mDone.push_back(mDocument.edit([&](TinEdit &edit) {
            if (kind == 3 && mSource.below(4) == 0) {
                const std::uint32_t layers = edit.tin().arrays().layerCount();
                if (layers < 3)
                    edit.addLayer(layers, 0);
                else
                    edit.removeLayer(1);
            } else if (kind == 4) {
                std::vector<TriangleId> some;
                const Point2 p = mSource.point();
                some.push_back(edit.tin().triangleAt(p));
                edit.setVoid(some, mSource.below(2) == 0);
            } else {
                for (std::uint32_t i = 1 + mSource.below(6); i > 0; --i)
                    tests::randomStep(edit, mSource);
            }
        }));
        return mJournal->addEdit(mDone.back(), mDocument.terrain());
    }

    RecoveryJournal &journal() { return *mJournal; }

private:
    TerrainDocument mDocument;
    tests::PointSource mSource;
    const QString mPath;
    std::unique_ptr<RecoveryJournal> mJournal;
    std::vector<Edit> mDone, mUndone;
};

} // namespace

class TestRecovery final : public QObject
{
    Q_OBJECT

private slots:
    /// Cut at every frame and between, the journal gives back what was there after the last whole frame.
    void everyFrameComesBack_data()
    {
        QTest::addColumn<bool>("isSaved");
        QTest::addColumn<int>("seed");
        for (const bool isSaved : {true, false})
            for (const int seed : {1, 2})
                QTest::newRow(qPrintable(QStringLiteral("%1, %2").arg(isSaved ? "saved" : "never saved").arg(seed)))
                    << isSaved << seed;
    }
    void everyFrameComesBack()
    {
        QFETCH(bool, isSaved);
        QFETCH(int, seed);
        const QTemporaryDir folder;
        const QString path = folder.filePath("a.terrain");
        Session session(path, unsigned(seed));
        QVERIFY(isSaved ? session.save() : session.beginUnsaved());
        std::vector<std::pair<qint64, QByteArray>> states{
            {qint64(session.journal().byteSize()), tests::describe(session.document().terrain())}};
        for (int i = 0; i < 25; ++i) {
            QVERIFY(session.step().has_value());
            states.emplace_back(session.journal().byteSize(), tests::describe(session.document().terrain()));
        }
        QVERIFY(session.journal().sync().has_value());
        const QByteArray journal = tests::readFile(session.journalPath());
        const QByteArray saved = isSaved ? tests::readFile(path) : QByteArray();
        QCOMPARE(journal.size(), states.back().first);
        std::mt19937 random(static_cast<unsigned>(seed));
        for (std::size_t i = 0; i < states.size(); ++i) {
            const auto whole = replayJournal(span(journal.left(states[i].first)), span(saved), Limit);
            QVERIFY2(whole.has_value(), whole ? "" : whole.error().args[0].c_str());
            QCOMPARE(tests::describe(whole->terrain), states[i].second);
            QVERIFY(findDefects(whole->terrain.tin).empty());
            QCOMPARE(whole->tornBytes, std::uint64_t(0));
            if (i + 1 == states.size())
                break;
            const qint64 room = states[i + 1].first - states[i].first;
            if (room == 0)
                continue;
            for (const qint64 more : {qint64(1), qint64(7), 1 + qint64(random()) % room, room - 1}) {
                if (more <= 0 || more >= room)
                    continue;
                const auto torn = replayJournal(span(journal.left(states[i].first + more)), span(saved), Limit);
                QVERIFY(torn.has_value());
                QCOMPARE(tests::describe(torn->terrain), states[i].second);
                QCOMPARE(torn->tornBytes, std::uint64_t(more));
            }
        }
        // Through the files themselves.
        const auto recovered = recoverTerrain(session.journalPath());
        QVERIFY(recovered.has_value());
        QCOMPARE(tests::describe(recovered->terrain), states.back().second);
        QCOMPARE(recovered->path, isSaved ? path : QString());
    }

    /// The last word on the mask counts, also over a snapshot and over the one in the file; a journal that says nothing
    /// of it, as older ones, leaves that of the file.
    void maskComesBack()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("a.terrain"), journalPath = folder.filePath("journal");
        const Terrain terrain = tests::specimenTerrain(tests::Ground::Random, 4, 60);
        const Rectangle domain = terrain.tin.domain();
        const Point2 middle{(domain.low.x + domain.high.x) / 2, (domain.low.y + domain.high.y) / 2};
        PaintMask first(domain), second(domain);
        first.paint(domain.low, middle, 0.1 * (domain.high.x - domain.low.x), 1, false);
        second.paint(middle, domain.high, 0.2 * (domain.high.x - domain.low.x), 0.5, false);
        TerrainExtras extras;
        extras.tools[MaskKey] = jsonOf(first);
        extras.tools["other"] = 3;
        QVERIFY(saveTerrain(path, terrain, extras).has_value());
        const auto base = recoveryBaseOf(path);
        QVERIFY(base.has_value());
        auto begun = RecoveryJournal::begin(journalPath, *base, terrain);
        QVERIFY(begun.has_value());
        RecoveryJournal &journal = **begun;
        const auto maskNow = [&]() -> std::optional<PaintMask> {
            const auto recovered = recoverTerrain(journalPath);
            if (!recovered || recovered->extras.tools["other"] != QJsonValue(3))
                QTest::qFail("not recovered", __FILE__, __LINE__);
            const auto mask = maskOf(recovered->extras.tools[MaskKey].toObject(), domain);
            return mask ? std::optional(*mask) : std::nullopt;
        };
        QVERIFY(journal.addSettings(terrain).has_value());
        QVERIFY(maskNow() == first);
        QVERIFY(journal.add(frameOfMask(&second)).has_value());
        QVERIFY(maskNow() == second);
        model::TerrainDocument document(terrain);
        const Edit layers = document.edit([](TinEdit &edit) { edit.addLayer(0, 0); });
        QVERIFY(journal.addEdit(layers, document.terrain()).has_value()); // a snapshot
        QVERIFY(maskNow() == second);
        QVERIFY(journal.add(frameOfMask(nullptr)).has_value());
        QVERIFY(!maskNow());
    }

    /// Power that fails while blocks are written leaves any bytes: whatever is there, it is refused or sound.
    void damagedJournals()
    {
        const QTemporaryDir folder;
        Session session(folder.filePath("a.terrain"), 5);
        QVERIFY(session.save());
        for (int i = 0; i < 10; ++i)
            QVERIFY(session.step().has_value());
        const QByteArray journal = tests::readFile(session.journalPath()),
                         saved = tests::readFile(folder.filePath("a.terrain"));
        std::mt19937 random(1);
        for (int i = 0; i < 100; ++i) {
            QByteArray broken = journal;
            broken[qsizetype(random() % std::size_t(broken.size()))] ^= char(1 << random() % 8);
            const auto recovered = replayJournal(span(broken), span(saved), Limit);
            if (recovered)
                QVERIFY(findDefects(recovered->terrain.tin).empty());
        }
        // A bit of the last frame: that frame is lost, and nothing else.
        const auto whole = replayJournal(span(journal), span(saved), Limit);
        QVERIFY(whole && whole->tornBytes == 0);
        QByteArray bent = journal;
        bent[bent.size() - 1] ^= 1;
        const auto shorter = replayJournal(span(bent), span(saved), Limit);
        QVERIFY(shorter && shorter->tornBytes > 0);
        QCOMPARE(shorter->frames, whole->frames - 1);
        // Another file of the same length.
        QByteArray other = saved;
        other[other.size() / 2] ^= 1;
        SANDREEL_COMPARE_ERROR(replayJournal(span(journal), span(other), Limit), ErrorCode::ChecksumMismatch);
        QCOMPARE(replayJournal(span(journal), span(other), Limit).error().args[0], std::string("the saved file"));
        SANDREEL_COMPARE_ERROR(replayJournal({}, span(saved), Limit), ErrorCode::Truncated);
        SANDREEL_COMPARE_ERROR(replayJournal(span("SRJOURN"), span(saved), Limit), ErrorCode::Truncated);
        SANDREEL_COMPARE_ERROR(replayJournal(span("something else"), span(saved), Limit), ErrorCode::BadMagic);
        QByteArray newer = journal;
        newer[7] = 2;
        SANDREEL_COMPARE_ERROR(replayJournal(span(newer), span(saved), Limit), ErrorCode::UnsupportedVersion);
        SANDREEL_COMPARE_ERROR(replayJournal(span(journal.left(30)), span(saved), Limit), ErrorCode::Truncated);
        SANDREEL_COMPARE_ERROR(replayJournal(span(journal), span(saved + 'x'), Limit), ErrorCode::ChecksumMismatch);
        SANDREEL_COMPARE_ERROR(recoverTerrain(folder.filePath("none")), ErrorCode::NotFound);
    }

    /// A full disk takes nothing of what is there, and what comes when there is room again is kept.
    void fullDisk()
    {
        const QTemporaryDir folder;
        Session session(folder.filePath("a.terrain"), 6);
        QVERIFY(session.save());
        const std::uint64_t before = session.journal().byteSize();
        {
            const tests::FileSizeLimit full(before + 20);
            bool hasFailed = false;
            for (int i = 0; i < 20 && !hasFailed; ++i)
                hasFailed = !session.step().has_value();
            QVERIFY(hasFailed);
        }
        QCOMPARE(std::uint64_t(QFileInfo(session.journalPath()).size()), session.journal().byteSize());
        QVERIFY(recoverTerrain(session.journalPath()).has_value());
    }

    /// Killed at any moment of editing and saving: the old file or the new one is there, and the journal continues the
    /// one that is, or belongs to the one before, whose changes the new file has.
    void killedAtAnyMoment()
    {
        std::mt19937 random(99);
        for (int round = 0; round < 12; ++round) {
            const QTemporaryDir folder;
            const QString path = folder.filePath("a.terrain");
            int ready[2];
            QCOMPARE(pipe(ready), 0);
            const pid_t child = fork();
            if (child == 0) {
                Session session(path, unsigned(round));
                bool isGood = session.save();
                (void)!write(ready[1], "r", 1);
                for (int i = 0; isGood; ++i) {
                    isGood = session.step().has_value();
                    if (i % 5 == 4)
                        isGood = isGood && session.save();
                }
                _exit(1);
            }
            char byte;
            QCOMPARE(read(ready[0], &byte, 1), ssize_t(1));
            usleep(random() % 60000);
            kill(child, SIGKILL);
            int status = 0;
            waitpid(child, &status, 0);
            close(ready[0]);
            close(ready[1]);
            QVERIFY(WIFSIGNALED(status));
            const auto file = openTerrain(path);
            QVERIFY2(file.has_value(), file ? "" : file.error().args[0].c_str());
            QVERIFY(findDefects(file->terrain.tin).empty());
            const auto recovered = recoverTerrain(path + ".journal");
            if (recovered)
                QVERIFY(findDefects(recovered->terrain.tin).empty());
            else
                QCOMPARE(int(recovered.error().code), int(ErrorCode::ChecksumMismatch));
        }
    }
};

SANDREEL_TEST(TestRecovery)
#include "tst_recovery.moc"
