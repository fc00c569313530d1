// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/basis/principalfields.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"

#include <cmath>
#include <numeric>

using namespace model;
using namespace tests;

class TestPrincipalFields final : public QObject
{
    Q_OBJECT

private slots:
    void aRigidRotationHasFewTrajectoriesThatAreAllOfIt()
    {
        const auto fields = codec::principalFields(*rigidRotation(torus()), 10);
        QVERIFY(fields);
        QVERIFY(fields->energyShares.size() >= 2);
        for (std::size_t k = 1; k < fields->energyShares.size(); ++k)
            QVERIFY(fields->energyShares[k] <= fields->energyShares[k - 1] + 1e-9);
        const double sum = std::accumulate(fields->energyShares.begin(), fields->energyShares.end(), 0.0);
        QVERIFY(std::abs(sum - 1) < 1e-6);
        QCOMPARE(fields->coefficients.size(), fields->energyShares.size());
        for (const auto &coefficients : fields->coefficients)
            QCOMPARE(coefficients.size(), std::size_t(torus().connectivity.vertexCount));
    }

    void sharesAreThoseOfTheSumOfSquares()
    {
        // With all trajectories of noise, the squares of a vertex's coefficients add up to its squared distance from
        // the row means.
        const SequencePtr animation = noise(grid(3, 2), 3);
        const auto fields = codec::principalFields(*animation, 9);
        QVERIFY(fields);
        const std::uint32_t count = animation->vertexCount();
        for (std::uint32_t v = 0; v < count; ++v) {
            double expected = 0, found = 0;
            for (std::uint32_t f = 0; f < 3; ++f) {
                const auto frame = animation->frame(f);
                Vec3f mean;
                for (const Vec3f &p : frame)
                    mean = mean + p * (1.0f / float(count));
                expected += double(dot(frame[v] - mean, frame[v] - mean));
            }
            for (const auto &coefficients : fields->coefficients)
                found += double(coefficients[v]) * double(coefficients[v]);
            QVERIFY(std::abs(expected - found) < 1e-4 * (1 + expected));
        }
    }

    void standingStillHasNoEnergyToShare()
    {
        const auto fields = codec::principalFields(*constant(oneVertex()), 3);
        QVERIFY(fields);
        for (const double share : fields->energyShares)
            QCOMPARE(share, 0.0);
    }

    void aCancelIsAnError()
    {
        const Progress progress;
        progress.cancel();
        QVERIFY(!codec::principalFields(*wave(grid()), 3, progress));
    }
};

SANDREEL_TEST(TestPrincipalFields)
#include "tst_principalfields.moc"
