// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/newterrain.h"
#include "model/terrain/tin/validate.h"
#include "tests/support/testmain.h"

#include <algorithm>
#include <cmath>

using namespace model;
using namespace model::io;

/// What new terrains look like.
class TestNewTerrain final : public QObject
{
    Q_OBJECT

    static NewTerrain described(ReliefShape shape, std::uint32_t seed)
    {
        NewTerrain description;
        description.width = 60;
        description.depth = 40;
        description.spacing = 1;
        description.height = 100;
        description.relief = {shape, 4, 20, seed};
        return description;
    }

private slots:
    void reliefIsAsHighAsItSays_data()
    {
        QTest::addColumn<int>("shape");
        QTest::newRow("dunes") << int(ReliefShape::Dunes);
        QTest::newRow("noise") << int(ReliefShape::Noise);
    }
    void reliefIsAsHighAsItSays()
    {
        QFETCH(int, shape);
        for (std::uint32_t seed = 1; seed <= 5; ++seed) {
            const auto terrain = makeTerrain(described(ReliefShape(shape), seed));
            QVERIFY(terrain.has_value());
            QVERIFY(terrain::validate(*terrain).has_value());
            const auto heights = terrain->tin.arrays().heights.values();
            const auto [least, most] = std::minmax_element(heights.begin(), heights.end());
            QVERIFY(*least >= 100 && *most <= 104);
            QVERIFY2(*most - *least > 1.5, qPrintable(QString::number(*most - *least)));
        }
    }

    void seedTellsThemApart()
    {
        const auto a = makeTerrain(described(ReliefShape::Noise, 1)), b = makeTerrain(described(ReliefShape::Noise, 2));
        const auto again = makeTerrain(described(ReliefShape::Noise, 1));
        QVERIFY(a && b && again);
        QCOMPARE(a->fingerprint(), again->fingerprint());
        QVERIFY(a->fingerprint() != b->fingerprint());
    }

    void reliefHasNoSteps()
    {
        for (const ReliefShape shape : {ReliefShape::Dunes, ReliefShape::Noise}) {
            const Relief relief({shape, 4, 20, 3});
            for (double x = -50; x < 50; x += 0.01) // from one cell of the noise to the next, and over crests
                QVERIFY(std::abs(relief.heightAt({x + 0.01, 7}) - relief.heightAt({x, 7})) < 0.05);
        }
    }

    void layersArePartOfTheHeight()
    {
        NewTerrain description = described(ReliefShape::Flat, 1);
        description.layers = {{terrain::material(terrain::MaterialPreset::Mud), 2},
                              {terrain::material(terrain::MaterialPreset::DrySand), 0.5}};
        const auto terrain = makeTerrain(description);
        QVERIFY(terrain.has_value());
        QCOMPARE(terrain->tin.heightAt({10, 10}), 100.0);
        QCOMPARE(terrain->tin.arrays().bedrock(7), 97.5);
        QCOMPARE(QString::fromStdString(terrain->materialOf(1).name), QString("dry sand"));
    }

    void whatMakesNoSenseIsRefused()
    {
        NewTerrain description = described(ReliefShape::Dunes, 1);
        description.relief.wavelength = 0;
        QCOMPARE(int(makeTerrain(description).error().code), int(ErrorCode::BadSetting));
        description = described(ReliefShape::Noise, 1);
        description.relief.height = std::nan("");
        QCOMPARE(int(makeTerrain(description).error().code), int(ErrorCode::BadSetting));
        description = described(ReliefShape::Flat, 1);
        description.spacing = 1e-6;
        QCOMPARE(int(makeTerrain(description).error().code), int(ErrorCode::LimitExceeded));
        const Progress cancelled;
        cancelled.cancel();
        QCOMPARE(int(makeTerrain(described(ReliefShape::Dunes, 1), cancelled).error().code), int(ErrorCode::Cancelled));
    }
};

SANDREEL_TEST(TestNewTerrain)
#include "tst_newterrain.moc"
