// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/force/granularlaw.h"
#include "model/haptics/force/law2009.h"
#include "tests/model/haptics/grounds.h"
#include "tests/support/testmain.h"

#include <numbers>

using namespace model;
using namespace model::haptics;

namespace {

Contact levelContact(double depth, Vec3d velocity = {})
{
    Contact contact;
    contact.isKnown = true;
    contact.centreDepth = depth;
    contact.ringDepth.fill(depth);
    contact.velocity = velocity;
    contact.dt = 0.001;
    return contact;
}

Feel plainFeel()
{
    Feel feel;
    feel.graininess = 0;
    return feel;
}

Feel feelOfPreset(terrain::MaterialPreset preset)
{
    const terrain::Material material = terrain::material(preset);
    return feelOf(material, material.humidity);
}

/// Moves a tool over level ground at height 0 along `path`, a step each millisecond, and calls `visit(position,
/// force)`.
template <class Path, class Visit>
void move(const ForceLaw &law, const Feel &feel, double duration, Path path, Visit visit)
{
    LawMemory memory;
    Vec3d before = path(0.0);
    for (int i = 0; i <= int(duration * 1000); ++i) {
        const Vec3d position = path(i * 0.001);
        Contact contact = levelContact(-position.z, (position - before) * 1000);
        contact.position = position;
        visit(position, law.force(contact, feel, memory));
        before = position;
    }
}

constexpr auto Nothing = Law2009::Sideways::None;

} // namespace

class TestForceLaws final : public QObject
{
    Q_OBJECT

private slots:
    void contactMeasuresInTheHandsMetres()
    {
        TerrainPatch patch;
        tests::tiltedPatch(patch, {0, 2, 2, 0}, {}); // rises by x
        Workspace workspace;
        workspace.origin = {0.1, 0, 1};
        workspace.scale = 10;
        workspace.toolRadius = 0.2;
        const Contact contact = contactAt(patch, workspace, {0.01, 0, 0.005}, {});
        QVERIFY(contact.isKnown);
        // At x = 0.2 the ground is 1.2 high; the tool is at 1.05.
        QVERIFY(std::abs(contact.centreDepth - 0.015) < 1e-7);
        for (std::uint32_t i = 0; i < RingPoints; ++i)
            QVERIFY(std::abs(contact.ringDepth[i] - (0.015 + 0.02 * std::cos(i * std::numbers::pi / 6))) < 1e-7);
        QVERIFY(!contactAt(patch, workspace, {0.5, 0, 0}, {}).isKnown);
    }

    void law2009PushesByDepth()
    {
        LawMemory memory;
        const Law2009 law({.sideways = Nothing});
        // 0.05 above the ground, in units of 0.2 m, it begins; at the ground it is 0.5 N, a unit deeper 10 N more.
        QCOMPARE(law.force(levelContact(-0.0101), {}, memory), Vec3d());
        QVERIFY(std::abs(law.force(levelContact(-0.005), {}, memory).z - 0.25) < 1e-12);
        QVERIFY(std::abs(law.force(levelContact(0), {}, memory).z - 0.5) < 1e-12);
        QVERIFY(std::abs(law.force(levelContact(0.02), {}, memory).z - 1.5) < 1e-12);
        const Law2009 late({.early = false, .sideways = Nothing});
        QCOMPARE(late.force(levelContact(-0.001), {}, memory), Vec3d());
        QVERIFY(std::abs(late.force(levelContact(0.02), {}, memory).z - 1) < 1e-12);
        Contact nowhere = levelContact(0.02);
        nowhere.isKnown = false;
        QCOMPARE(law.force(nowhere, {}, memory), Vec3d());
    }

    void law2009RaisesSmallForcesToAGel()
    {
        LawMemory memory;
        const Law2009 law({.early = false, .sideways = Nothing});
        const Vec3d force = law.force(levelContact(0.001, {0.3, 0.4, 0}), {}, memory);
        QVERIFY(std::abs(force.x + 0.12) < 1e-12 && std::abs(force.y + 0.16) < 1e-12 && force.z == 0);
        QVERIFY(std::abs(law.force(levelContact(0.001), {}, memory).z - 0.05) < 1e-12); // at rest it has no direction
        const Law2009 without({.early = false, .gel = false, .sideways = Nothing});
        QVERIFY(std::abs(without.force(levelContact(0.001, {0.3, 0.4, 0}), {}, memory).z - 0.05) < 1e-12);
    }

    void law2009AveragesOverTheControlPoints()
    {
        LawMemory memory;
        const Law2009 law;
        Contact contact = levelContact(0.02);
        QVERIFY(std::hypot(law.force(contact, {}, memory).x, law.force(contact, {}, memory).y) < 1e-12);
        // Half of the ring is heaped by 4 cm: the mean of the pushes against those six directions.
        double expected = 0;
        for (std::uint32_t i = 0; i < RingPoints; ++i)
            if (RingDirections[i].x > 1e-9) {
                contact.ringDepth[i] += 0.04;
                expected -= RingDirections[i].x * 10 * 0.04 / 0.2 / 12;
            }
        QVERIFY(std::abs(law.force(contact, {}, memory).x - expected) < 1e-12);
        QVERIFY(std::abs(law.force(contact, {}, memory).y) < 1e-12);
        // Control points in the air do not pull.
        contact.ringDepth.fill(-0.03);
        QVERIFY(std::hypot(law.force(contact, {}, memory).x, law.force(contact, {}, memory).y) < 1e-12);
    }

    /// Where the ray leaves the polygon: between two control points linear in the place on their edge.
    void law2009LooksAlongTheMotion()
    {
        LawMemory memory;
        const Law2009 law({.gel = false, .sideways = Law2009::Sideways::AlongMotion});
        Contact contact = levelContact(0);
        contact.ringDepth[0] = 0.02;
        contact.ringDepth[1] = 0.06;
        contact.velocity = {0.1, 0, 0};
        QVERIFY(std::abs(law.force(contact, {}, memory).x + 1) < 1e-12);
        for (const double share : {0.25, 0.5, 0.9}) {
            const double x = RingDirections[0].x * (1 - share) + RingDirections[1].x * share;
            const double y = RingDirections[0].y * (1 - share) + RingDirections[1].y * share;
            contact.velocity = {x, y, 0};
            const Vec3d force = law.force(contact, {}, memory);
            QVERIFY(std::abs(std::hypot(force.x, force.y) - (1 + 2 * share)) < 1e-9);
        }
        // This is what trembles: the slightest motion to and fro turns the force round.
        contact.ringDepth.fill(0.02);
        contact.velocity = {1e-5, 0, 0};
        QVERIFY(law.force(contact, {}, memory).x < -0.9);
        contact.velocity = {-1e-5, 0, 0};
        QVERIFY(law.force(contact, {}, memory).x > 0.9);
    }

    void resistanceGrowsWithDepthAndYields()
    {
        const GranularLaw law;
        const Feel feel = plainFeel();
        double last = -1;
        int steps = 0;
        move(
            law, feel, 3.0, [](double t) { return Vec3d(0, 0, 0.01 - 0.0133 * t); },
            [&](Vec3d position, Vec3d force) {
                const double depth = -position.z;
                if (depth < 0.004)
                    return;
                QVERIFY(force.z > last);
                last = force.z;
                // It has yielded all the way: the force is that of the yield, plus damping.
                const double expected = feel.crust + feel.resistance * depth + feel.damping * 0.0133;
                QVERIFY2(std::abs(force.z - expected) < 1e-3, qPrintable(QString("%1 %2").arg(force.z).arg(expected)));
                ++steps;
            });
        QVERIFY(steps > 1000);
    }

    /// Pressed in and held by a hand of 1 um tremor: the force stands still. Further in and back by 1 mm: it springs.
    void doesNotTrembleAtRest()
    {
        const GranularLaw law;
        double least = 1e9, most = -1e9, held = 0;
        move(
            law, feelOfPreset(terrain::MaterialPreset::DrySand), 3.0,
            [](double t) {
                const double tremor = int(t * 1000) % 2 ? 1e-6 : -1e-6;
                return Vec3d(t < 1 ? 0 : tremor, 0, t < 1 ? -0.03 * t : -0.03);
            },
            [&](Vec3d, Vec3d force) {
                if (++held < 1200)
                    return;
                least = std::min(least, force.z);
                most = std::max(most, force.z);
                QVERIFY(std::abs(force.x) < 0.01);
            });
        QVERIFY(least > 3);
        QVERIFY2(most - least < 0.005, qPrintable(QString::number(most - least)));
    }

    void wetSandHoldsDrySandDoesNot()
    {
        const GranularLaw law;
        const auto leastOnTheWayOut = [&](terrain::MaterialPreset preset) {
            double least = 0;
            move(
                law, feelOfPreset(preset), 2.0, [](double t) { return Vec3d(0, 0, -0.03 * (1 - std::abs(1 - t))); },
                [&](Vec3d, Vec3d force) { least = std::min(least, force.z); });
            return least;
        };
        const double dry = leastOnTheWayOut(terrain::MaterialPreset::DrySand);
        const double wet = leastOnTheWayOut(terrain::MaterialPreset::MoistSand);
        QVERIFY2(dry > -0.3 && wet < -1.5, qPrintable(QString("%1 %2").arg(dry).arg(wet)));
    }

    void whatIsHeapedAheadResists()
    {
        const GranularLaw law;
        const auto sideways = [&](double heap) {
            LawMemory memory;
            Vec3d force;
            for (int i = 0; i < 500; ++i) {
                Contact contact = levelContact(0.02, {0.05, 0, 0});
                contact.position = {0.00005 * i, 0, -0.02};
                for (std::uint32_t k = 0; k < RingPoints; ++k)
                    contact.ringDepth[k] += RingDirections[k].x > 0.1 ? heap : 0;
                force = law.force(contact, plainFeel(), memory);
            }
            return -force.x;
        };
        QVERIFY(sideways(0) > 0.5);
        QVERIFY(sideways(0.02) > sideways(0) + 0.8);
    }

    /// Around any closed way through level sand, grains and all, it takes energy and never gives.
    void neverGivesEnergy()
    {
        const GranularLaw law;
        for (const terrain::MaterialPreset preset : terrain::EveryMaterialPreset)
            for (unsigned seed = 0; seed < 20; ++seed) {
                std::mt19937 random(seed);
                std::uniform_real_distribution<> any(0, 1);
                const double amplitude = 0.03 * any(random), a = 1 + 4 * any(random), b = 1 + 6 * any(random);
                double work = 0;
                Vec3d before, forceBefore;
                bool isFirst = true;
                move(
                    law, feelOfPreset(preset), 20,
                    [&](double t) {
                        return Vec3d(amplitude * std::sin(a * t), amplitude * std::sin(b * t),
                                     amplitude * (0.3 + std::cos((a + b) * t)));
                    },
                    [&](Vec3d position, Vec3d force) {
                        if (!isFirst)
                            work += dot((force + forceBefore) * 0.5, position - before);
                        isFirst = false;
                        before = position;
                        forceBefore = force;
                    });
                QVERIFY2(work < 0.001,
                         qPrintable(QString("preset %1 seed %2: %3 J").arg(int(preset)).arg(seed).arg(work)));
            }
    }

    void grainsAreFeltInMotionAlone()
    {
        const GranularLaw law;
        Feel feel = plainFeel();
        feel.graininess = 0.2;
        double changes = 0, still = 0;
        Vec3d before;
        move(
            law, feel, 2.0, [](double t) { return Vec3d(t < 1 ? 0.05 * t : 0.05, 0, -0.02); },
            [&, i = 0](Vec3d, Vec3d force) mutable {
                if (i > 100 && i < 990)
                    changes += std::abs(force.x - before.x);
                if (i > 1500)
                    still += std::abs(force.x - before.x);
                before = force;
                ++i;
            });
        QVERIFY2(changes > 5, qPrintable(QString::number(changes)));
        QVERIFY2(still < 1e-6, qPrintable(QString::number(still)));
    }

    void softerWhereTheLoopIsLate()
    {
        const GranularLaw law;
        LawMemory memory;
        Contact contact = levelContact(0.03);
        law.force(contact, plainFeel(), memory);
        contact.position = {0, 0, -0.001};
        contact.stiffnessLimit = 100;
        QVERIFY(std::abs(law.force(contact, plainFeel(), memory).z - 0.1) < 1e-9);
    }

    void materialsFeelDifferent()
    {
        using terrain::MaterialPreset;
        const Feel dry = feelOfPreset(MaterialPreset::DrySand), moist = feelOfPreset(MaterialPreset::MoistSand);
        const Feel snow = feelOfPreset(MaterialPreset::Snow), mud = feelOfPreset(MaterialPreset::Mud);
        QCOMPARE(dry.resistance, 120.0);
        QVERIFY(moist.resistance > 1.3 * dry.resistance && moist.hold > 5 * dry.hold);
        QVERIFY(moist.graininess < dry.graininess);
        QVERIFY(snow.resistance < 0.3 * dry.resistance);
        QVERIFY(mud.damping > 1.5 * dry.damping);
        QVERIFY(rockFeel().resistance > 10 * dry.resistance);
    }

    void namesOfLawsComeBack()
    {
        for (const LawKind kind : EveryLaw)
            QVERIFY(lawNamed(nameOf(kind)) == kind);
        QVERIFY(!lawNamed("2010"));
    }
};

SANDREEL_TEST(TestForceLaws)
#include "tst_forcelaws.moc"
