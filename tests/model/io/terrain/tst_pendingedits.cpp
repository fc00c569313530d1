// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/terraindocument.h"
#include "model/io/terrain/pendingedits.h"
#include "tests/model/io/terrain/terrains.h"
#include "tests/support/testmain.h"

#include <QFile>
#include <QTemporaryDir>

using namespace model;
using namespace model::io;
using namespace model::terrain;

/// Edits that are put together into one frame recover to the same terrain as if each had its own.
class TestPendingEdits final : public QObject
{
    Q_OBJECT

private slots:
    void manyEditsInAFrameComeBack_data()
    {
        QTest::addColumn<int>("editsInAFrame");
        QTest::newRow("one") << 1;
        QTest::newRow("three") << 3;
        QTest::newRow("all") << 60;
    }
    void manyEditsInAFrameComeBack()
    {
        QFETCH(int, editsInAFrame);
        for (unsigned seed = 1; seed <= 8; ++seed) {
            const QTemporaryDir folder;
            const QString path = folder.filePath("t.terrain");
            TerrainDocument document(tests::specimenTerrain(tests::Ground::Random, seed, 120));
            tests::PointSource source(tests::Ground::Random, seed + 50);
            QVERIFY(saveTerrain(path, document.terrain(), {}));
            const auto base = recoveryBaseOf(path);
            QVERIFY(base.has_value());
            const QString journalPath = folder.filePath("journal");
            auto journal = RecoveryJournal::begin(journalPath, *base, document.terrain());
            QVERIFY(journal.has_value());
            PendingEdits pending;
            QVERIFY(pending.isEmpty());
            std::vector<Edit> done;
            for (int i = 1; i <= 60; ++i) {
                if (source.below(4) == 0 && !done.empty()) { // vertices come and go, and their slots are used again
                    document.swap(done.back());
                    pending.add(done.back(), document.tin().arrays());
                    done.pop_back();
                } else {
                    done.push_back(document.edit([&](TinEdit &edit) {
                        for (std::uint32_t k = 1 + source.below(5); k > 0; --k)
                            tests::randomStep(edit, source);
                    }));
                    pending.add(done.back(), document.tin().arrays());
                }
                if (i % editsInAFrame == 0 && !pending.isEmpty())
                    QVERIFY((*journal)->add(pending.take(document.tin().arrays())).has_value());
            }
            const auto recovered = recoverTerrain(journalPath);
            QVERIFY(recovered.has_value());
            QCOMPARE(savedFingerprint(recovered->terrain), document.fingerprint());
            const auto readBase = journalBaseOf(journalPath);
            QVERIFY(readBase.has_value());
            QCOMPARE(readBase->path, path);
            QCOMPARE(readBase->crc, base->crc);
        }
    }

    void sameVerticesAreWrittenOnce()
    {
        TerrainDocument document(tests::specimenTerrain(tests::Ground::Random, 3, 120));
        PendingEdits pending;
        for (int i = 0; i < 50; ++i) {
            const Edit edit = document.edit([](TinEdit &open) {
                for (VertexId v = 10; v < 20; ++v)
                    open.setHeight(v, open.tin().arrays().heights[v] + 0.5);
            });
            pending.add(edit, document.tin().arrays());
        }
        QCOMPARE(pending.vertexCount(), std::size_t(10));
        const std::size_t once = pending.take(document.tin().arrays()).payload.size();
        QVERIFY(pending.isEmpty());
        QVERIFY2(once < 1000, qPrintable(QString::number(once)));
    }

    void anotherNumberOfLayersNeedsASnapshot()
    {
        TerrainDocument document(tests::specimenTerrain(tests::Ground::Random, 3, 120));
        PendingEdits pending;
        const Edit edit = document.edit([](TinEdit &open) { open.addLayer(open.tin().arrays().layerCount(), 0); });
        pending.add(edit, document.tin().arrays());
        QVERIFY(pending.needsSnapshot() && !pending.isEmpty());
        pending.clear();
        QVERIFY(!pending.needsSnapshot() && pending.isEmpty());
    }
};

SANDREEL_TEST(TestPendingEdits)
#include "tst_pendingedits.moc"
