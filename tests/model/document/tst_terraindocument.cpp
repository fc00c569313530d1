// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/terraindocument.h"
#include "model/document/terrainsnapshot.h"
#include "model/terrain/tin/validate.h"
#include "tests/model/terrain/tin/randomedits.h"
#include "tests/support/testmain.h"

#include <QTimer>

using namespace model;
using namespace model::terrain;

namespace {

Terrain specimen(unsigned seed = 1)
{
    tests::PointSource source(tests::Ground::Random, seed);
    Terrain terrain(buildTin(source.points(200), source.domain())->tin);
    terrain.materials = {material(MaterialPreset::DrySand)};
    TinEdit edit(terrain.tin);
    edit.addLayer(0, 0);
    edit.commit();
    return terrain;
}

/// Counts notices by kind.
struct Listener
{
    int surface = 0, materials = 0, place = 0;

    explicit Listener(const TerrainDocument &document)
    {
        QObject::connect(&document, &TerrainDocument::changed, &document, [this](const TerrainChange &change) {
            struct Count
            {
                Listener &to;
                void operator()(const SurfaceChanged &c) const { to.surface += !c.edit->isEmpty(); }
                void operator()(MaterialsChanged) const { ++to.materials; }
                void operator()(GeoReferenceChanged) const { ++to.place; }
            };
            std::visit(Count{*this}, change);
        });
    }
    bool isAll(int s, int m, int p) const { return surface == s && materials == m && place == p; }
};

} // namespace

class TestTerrainDocument final : public QObject
{
    Q_OBJECT

private slots:
    void editsAreUndoneAndRedone()
    {
        TerrainDocument document(specimen());
        const Listener heard(document);
        tests::PointSource source(tests::Ground::Random, 3);
        std::vector<Edit> edits;
        std::vector<std::uint64_t> prints{document.fingerprint()};
        for (int i = 0; i < 20; ++i) {
            edits.push_back(document.edit([&](TinEdit &edit) {
                for (int step = 0; step < 5; ++step)
                    tests::randomStep(edit, source);
            }));
            prints.push_back(document.fingerprint());
            QVERIFY(prints[std::size_t(i)] != prints[std::size_t(i) + 1] || edits.back().isEmpty());
        }
        const int done = heard.surface;
        QVERIFY(done > 15);
        for (std::size_t i = edits.size(); i-- > 0;) {
            document.swap(edits[i]);
            QCOMPARE(document.fingerprint(), prints[i]);
        }
        for (std::size_t i = 0; i < edits.size(); ++i) {
            document.swap(edits[i]);
            QCOMPARE(document.fingerprint(), prints[i + 1]);
        }
        QVERIFY(heard.isAll(3 * done, 0, 0));
        QVERIFY(findDefects(document.tin()).empty());
    }

    void anEditOfNothingIsSilent()
    {
        TerrainDocument document(specimen());
        const Listener heard(document);
        QVERIFY(document.edit([](TinEdit &) {}).isEmpty());
        QVERIFY(heard.isAll(0, 0, 0));
    }

    void settersReturnWhatWas()
    {
        TerrainDocument document(specimen());
        const Listener heard(document);
        const std::uint64_t before = document.fingerprint();
        auto materials = document.terrain().materials;
        materials[0].criticalAngles[0].degrees += 1;
        const auto old = document.setMaterials(materials);
        QVERIFY(document.fingerprint() != before);
        QCOMPARE(document.setMaterials(materials), materials);
        QVERIFY(heard.isAll(0, 1, 0));
        document.setMaterials(old);
        QCOMPARE(document.fingerprint(), before);
        GeoReference place;
        place.crs = "somewhere";
        const GeoReference was = document.setGeoReference(place);
        QVERIFY(document.fingerprint() != before);
        document.setGeoReference(place);
        QVERIFY(heard.isAll(0, 2, 1));
        document.setGeoReference(was);
        QCOMPARE(document.fingerprint(), before);
    }

    /// The print knows nothing of numbers, and everything else.
    void fingerprintIsOfWhatIsSaved()
    {
        const Terrain terrain = specimen();
        const std::uint64_t before = savedFingerprint(terrain);
        Terrain other = specimen();
        QCOMPARE(savedFingerprint(other), before);
        TinEdit edit(other.tin);
        edit.setVoid(std::vector<TriangleId>{7}, true);
        edit.commit();
        QVERIFY(savedFingerprint(other) != before);
        other = specimen();
        TinEdit wet(other.tin);
        wet.setLayer(9, 0, {0, 0.5f});
        wet.commit();
        QVERIFY(savedFingerprint(other) != before);
        // Points in another order have other numbers.
        tests::PointSource source(tests::Ground::Random, 1);
        auto points = source.points(200);
        const std::uint64_t one = savedFingerprint(Terrain(buildTin(points, source.domain())->tin));
        Terrain shifted(buildTin(std::vector<Point3>(points.begin(), points.end() - 1), source.domain())->tin);
        TinEdit last(shifted.tin, VolumeRule::Keep);
        last.insert({points.back().x, points.back().y}, points.back().z);
        last.commit();
        QVERIFY(savedFingerprint(shifted) != one); // the ledger says what was added
    }

    void snapshotStaysAsItWas()
    {
        TerrainDocument document(specimen());
        const auto snapshot = document.snapshot();
        const std::uint64_t before = document.fingerprint();
        document.edit([](TinEdit &edit) { edit.setHeight(10, 99); });
        QCOMPARE(savedFingerprint(*snapshot), before);
        QVERIFY(document.fingerprint() != before);
    }

    void snapshotIsWhatTheDocumentIsWhenItIsGiven_data()
    {
        QTest::addColumn<bool>("isEdited");
        QTest::newRow("at rest") << false;
        QTest::newRow("edited without a pause") << true;
    }
    void snapshotIsWhatTheDocumentIsWhenItIsGiven()
    {
        QFETCH(bool, isEdited);
        TerrainDocument document(specimen());
        TerrainSnapshot snapshot(document);
        std::shared_ptr<const Terrain> taken;
        std::uint64_t print = 0;
        QTimer editing;
        double height = 1;
        editing.callOnTimeout([&] { document.edit([&](TinEdit &edit) { edit.setHeight(20, height += 1); }); });
        if (isEdited)
            editing.start(0);
        snapshot.start([&](std::shared_ptr<const Terrain> terrain) {
            taken = std::move(terrain);
            print = document.fingerprint();
        });
        QVERIFY(snapshot.isRunning());
        QTRY_VERIFY(taken);
        QVERIFY(!snapshot.isRunning());
        QCOMPARE(savedFingerprint(*taken), print);
        QCOMPARE(height > 1, isEdited);
    }

    void snapshotIsGivenToTheLastWhoAsked()
    {
        TerrainDocument document(specimen());
        TerrainSnapshot snapshot(document);
        QStringList given;
        const auto start = [&](const QString &name) {
            snapshot.start([&given, name](const std::shared_ptr<const Terrain> &) { given << name; });
        };
        start("first");
        start("second");
        QTRY_COMPARE(given, QStringList{"second"});
        start("third");
        snapshot.cancel();
        QVERIFY(!snapshot.isRunning());
        // While it is copied: the copy is made in no time, but what follows waits for the event loop.
        start("fourth");
        QTimer::singleShot(0, &snapshot, [&] { snapshot.cancel(); }); // after the turn in which the copy begins
        QTest::qWait(50);
        start("fifth");
        QTRY_VERIFY(given.contains("fifth"));
        QTest::qWait(50);
        QVERIFY(!given.contains("third"));
        QCOMPARE(given.size(), given.contains("fourth") ? 3 : 2);
    }
};

SANDREEL_TEST(TestTerrainDocument)
#include "tst_terraindocument.moc"
