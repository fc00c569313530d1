// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/material/material.h"
#include "tests/support/testmain.h"

#include <cmath>
#include <functional>
#include <set>

using namespace model;
using namespace model::terrain;

class TestMaterial final : public QObject
{
    Q_OBJECT

private slots:
    void everyPresetIsSoundAndFoundAgain()
    {
        std::set<std::string> names;
        for (const MaterialPreset preset : EveryMaterialPreset) {
            Material m = material(preset);
            QVERIFY2(check(m), m.name.c_str());
            QCOMPARE(m.name, std::string(nameOf(preset)));
            names.insert(m.name);
            m.name = "of another name";
            QCOMPARE(presetOf(m), preset);
            m.bulkDensity += 1;
            QCOMPARE(presetOf(m), MaterialPreset::Custom);
        }
        QCOMPARE(names.size(), std::size(EveryMaterialPreset));
    }

    void presetsStandAsTheirMaterialsDo()
    {
        const Material sand = material(MaterialPreset::DrySand), moist = material(MaterialPreset::MoistSand);
        QCOMPARE(criticalAngleAt(sand, sand.humidity), 30.0);
        QCOMPARE(criticalAngleAt(moist, moist.humidity), 45.0);
        QCOMPARE(criticalAngleAt(sand, 1), 15.0); // saturated sand flows
        double highest = 0, at = 0;
        for (int i = 0; i <= 100; ++i)
            if (criticalAngleAt(sand, i / 100.0) > highest) {
                highest = criticalAngleAt(sand, i / 100.0);
                at = i / 100.0;
            }
        QVERIFY(highest == 45 && at > 0.05 && at < 0.5);
        QVERIFY(material(MaterialPreset::Snow).compressibility > 0.5);
        QVERIFY(material(MaterialPreset::Mud).compressibility > 0);
        QCOMPARE(material(MaterialPreset::Gravel).compressibility, 0.0);
    }

    void theCurveIsLinearBetweenItsPoints()
    {
        Material m;
        m.criticalAngles = {{0.25, 20}, {0.5, 40}, {1, 10}};
        QCOMPARE(criticalAngleAt(m, 0.25), 20.0);
        QCOMPARE(criticalAngleAt(m, 0.375), 30.0);
        QCOMPARE(criticalAngleAt(m, 0.5), 40.0);
        QCOMPARE(criticalAngleAt(m, 0.75), 25.0);
        QCOMPARE(criticalAngleAt(m, 1), 10.0);
        // What no humidity is counts as the nearest.
        QCOMPARE(criticalAngleAt(m, 0), 20.0);
        QCOMPARE(criticalAngleAt(m, -3), 20.0);
        QCOMPARE(criticalAngleAt(m, 7), 10.0);
        QCOMPARE(criticalAngleAt(m, NAN), 20.0);
        m.criticalAngles = {{0.5, 33}};
        QCOMPARE(criticalAngleAt(m, 0.9), 33.0);
    }

    void whatMakesNoSenseIsNamed_data()
    {
        QTest::addColumn<int>("row");
        for (std::size_t i = 0; i < mistakes().size(); ++i)
            QTest::newRow(mistakes()[i].name) << int(i);
    }
    void whatMakesNoSenseIsNamed()
    {
        QFETCH(int, row);
        Material m = material(MaterialPreset::Mud);
        mistakes()[std::size_t(row)].make(m);
        const auto checked = check(m);
        QVERIFY(!checked);
        QCOMPARE(checked.error().code, ErrorCode::BadSetting);
        QCOMPARE(checked.error().args.size(), std::size_t(3));
        QCOMPARE(checked.error().args[0],
                 std::string(mistakes()[std::size_t(row)].name).substr(0, checked.error().args[0].size()));
    }

private:
    struct Mistake
    {
        const char *name;
        std::function<void(Material &)> make;
    };
    static const std::vector<Mistake> &mistakes()
    {
        static const std::vector<Mistake> list{
            {"criticalAngles: none", [](Material &m) { m.criticalAngles.clear(); }},
            {"criticalAngles: too many",
             [](Material &m) {
                 m.criticalAngles.assign(65, {0.5, 30});
             }},
            {"criticalAngles[1].humidity goes back",
             [](Material &m) {
                 m.criticalAngles = {{0.5, 30}, {0.25, 30}};
             }},
            {"criticalAngles[1].humidity twice",
             [](Material &m) {
                 m.criticalAngles = {{0.5, 30}, {0.5, 20}};
             }},
            {"criticalAngles[0].humidity below 0", [](Material &m) { m.criticalAngles[0].humidity = -0.1; }},
            {"criticalAngles[3].humidity above 1", [](Material &m) { m.criticalAngles[3].humidity = 1.1; }},
            {"criticalAngles[2].humidity no number", [](Material &m) { m.criticalAngles[2].humidity = NAN; }},
            {"criticalAngles[0].degrees 0", [](Material &m) { m.criticalAngles[0].degrees = 0; }},
            {"criticalAngles[0].degrees 90", [](Material &m) { m.criticalAngles[0].degrees = 90; }},
            {"criticalAngles[0].degrees no number", [](Material &m) { m.criticalAngles[0].degrees = NAN; }},
            {"humidity below 0", [](Material &m) { m.humidity = -0.01; }},
            {"humidity above 1", [](Material &m) { m.humidity = 1.01; }},
            {"bulkDensity 0", [](Material &m) { m.bulkDensity = 0; }},
            {"bulkDensity without end", [](Material &m) { m.bulkDensity = INFINITY; }},
            {"compressibility 1", [](Material &m) { m.compressibility = 1; }},
            {"insideSlope above 90", [](Material &m) { m.insideSlope = 91; }},
            {"outsideSlope below 0", [](Material &m) { m.outsideSlope = -1; }},
            {"roughness above 1", [](Material &m) { m.roughness = 2; }},
            {"liquidity 0", [](Material &m) { m.liquidity = 0; }},
            {"compression no number", [](Material &m) { m.compression = NAN; }},
        };
        return list;
    }
};

SANDREEL_TEST(TestMaterial)
#include "tst_material.moc"
