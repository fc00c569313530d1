// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/terrain.h"
#include "model/terrain/tin/tinedit.h"
#include "tests/support/testmain.h"

#include <cmath>
#include <functional>

using namespace model;
using namespace model::terrain;

namespace {

/// 2 x 2 m of snow, 1 m deep, on gravel, 0.5 m deep.
Terrain snowField()
{
    Terrain terrain(Tin(Rectangle{{0, 0}, {2, 2}}));
    terrain.materials = {material(MaterialPreset::Gravel), material(MaterialPreset::Snow)};
    TinEdit edit(terrain.tin);
    edit.insert({1, 1});
    edit.addLayer(0, 0);
    edit.addLayer(1, 1);
    for (VertexId v = 0; v < 5; ++v) {
        edit.deposit(v, 0, {0.5, 0});
        edit.deposit(v, 1, {1, 0.1F});
    }
    edit.commit();
    return terrain;
}

bool isNear(double a, double b)
{
    return std::abs(a - b) <= 1e-12 * std::abs(b);
}

} // namespace

class TestTerrain final : public QObject
{
    Q_OBJECT

private slots:
    void layersWeighWhatTheirMaterialDoes()
    {
        const Terrain terrain = snowField();
        QVERIFY(isNear(terrain.mass(0), 2 * terrain.materials[0].bulkDensity));
        QVERIFY(isNear(terrain.mass(1), 4 * terrain.materials[1].bulkDensity));
        QVERIFY(isNear(terrain.bulkDensity(1), terrain.materials[1].bulkDensity));
    }

    void treadingSnowDownMakesItDenserAndNoLighter()
    {
        Terrain terrain = snowField();
        const double mass = terrain.mass(1), gravel = terrain.mass(0), volume = terrain.tin.volume();
        TinEdit edit(terrain.tin);
        const double area = edit.areaOf(4);
        edit.press(4, 0.5);
        edit.transfer(4, 0, 0.1);
        edit.commit();
        QVERIFY(isNear(terrain.mass(1), mass));
        QVERIFY(isNear(terrain.mass(0), gravel));
        QVERIFY(isNear(terrain.tin.volume(), volume - 0.5 * area));
        QVERIFY(isNear(terrain.bulkDensity(1), terrain.materials[1].bulkDensity * 4 / (4 - 0.5 * area)));
        QVERIFY(isNear(terrain.tin.volume(), terrain.tin.ledger().expected()));
    }

    void everythingSavedIsInTheFingerprint()
    {
        const std::uint64_t before = snowField().fingerprint();
        QCOMPARE(snowField().fingerprint(), before);
        const std::function<void(Terrain &)> changes[] = {
            [](Terrain &t) { t.materials[0].name += "x"; },
            [](Terrain &t) { t.materials[1].criticalAngles[0].degrees += 1; },
            [](Terrain &t) { t.materials[1].liquidity = 0.9; },
            [](Terrain &t) { t.materials.pop_back(); },
            [](Terrain &t) { t.geoReference.originX = 1; },
            [](Terrain &t) { t.geoReference.originY = 1; },
            [](Terrain &t) { t.geoReference.crs = "EPSG"; },
            [](Terrain &t) { t.geoReference.unit = "foot"; },
            [](Terrain &t) {
                TinEdit e(t.tin);
                e.setLayer(0, 0, {1, 0});
                e.commit();
            },
            [](Terrain &t) {
                TinEdit e(t.tin);
                e.setLayer(0, 0, {0.5, 0.5F});
                e.commit();
            },
            [](Terrain &t) {
                TinEdit e(t.tin);
                e.setLayerMaterial(0, 1);
                e.commit();
            },
        };
        for (const auto &change : changes) {
            Terrain terrain = snowField();
            change(terrain);
            QVERIFY(terrain.fingerprint() != before);
        }
    }

    void validateNamesWhatIsWrong()
    {
        QVERIFY(validate(snowField()));
        const struct
        {
            std::function<void(Terrain &)> damage;
            ErrorCode code;
            const char *first;
        } rows[] = {
            {[](Terrain &t) { t.materials[1].roughness = 7; }, ErrorCode::BadSetting, "materials[1].roughness"},
            {[](Terrain &t) { t.materials.pop_back(); }, ErrorCode::BadValue, "material of layer 1"},
            {[](Terrain &t) { t.materials.resize(65); }, ErrorCode::LimitExceeded, "number of materials"},
            {[](Terrain &t) { t.geoReference.originY = NAN; }, ErrorCode::NonFinite, "origin"},
            {[](Terrain &t) {
                 TinEdit e(t.tin);
                 e.setLayer(0, 1, {-1, 0});
                 e.commit();
             },
             ErrorCode::BrokenTerrain, "thickness"},
        };
        for (const auto &row : rows) {
            Terrain terrain = snowField();
            row.damage(terrain);
            const auto valid = validate(terrain);
            QVERIFY(!valid);
            QCOMPARE(valid.error().code, row.code);
            QCOMPARE(valid.error().args[0], std::string(row.first));
        }
    }
};

SANDREEL_TEST(TestTerrain)
#include "tst_terrain.moc"
