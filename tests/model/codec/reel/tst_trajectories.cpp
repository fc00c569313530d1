// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/basis/gram.h"
#include "model/codec/reel/trajectories.h"
#include "tests/model/codec/animations.h"
#include "tests/support/testmain.h"

#include <cmath>
#include <numbers>

using namespace model;
using namespace model::codec;

namespace {

constexpr double Pi = std::numbers::pi;

/// Entry of cosine k >= 1 of `n`, which are orthogonal to each other and to constants, and have a mean square of 1.
double cosine(std::uint32_t k, std::uint32_t i, std::uint32_t n)
{
    return std::numbers::sqrt2 * std::cos(Pi * k * (i + 0.5) / n);
}

/// How strong trajectory k is; it moves along axis k % 3.
constexpr std::array<double, 7> Strengths{9, 5, 3, 1, 0.3, 0.05, 0.004};

} // namespace

class TestTrajectories final : public QObject
{
    Q_OBJECT

private slots:
    // The trajectories of an animation that is put together from known ones.
    void knownTrajectoriesAreFound_data()
    {
        QTest::addColumn<quint32>("frames");
        QTest::addColumn<quint32>("vertices");
        QTest::newRow("few frames") << 20u << 300u;
        QTest::newRow("few vertices") << 200u << 50u;
        static_assert(3 * 1001 > MaxGramRows);
        QTest::newRow("many of both") << 1001u << 3001u;
    }
    void knownTrajectoriesAreFound()
    {
        QFETCH(quint32, frames);
        QFETCH(quint32, vertices);
        std::vector<double> inTime, overMesh;
        for (std::uint32_t k = 0; k < Strengths.size(); ++k) {
            for (std::uint32_t f = 0; f < frames; ++f)
                inTime.push_back(Strengths[k] * cosine(k + 1, f, frames) / std::sqrt(double(frames)));
            for (std::uint32_t v = 0; v < vertices; ++v)
                overMesh.push_back(cosine(k + 2, v, vertices));
        }
        const tests::PlainAnimation animation(frames, vertices, {}, [&](std::uint32_t f, std::uint32_t v) {
            std::array<double, 3> p{double(v % 10), double(f), 2}; // a rest shape, and means
            for (std::size_t k = 0; k < Strengths.size(); ++k)
                p[k % 3] += inTime[k * frames + f] * overMesh[k * vertices + v];
            return Vec3f{float(p[0]), float(p[1]), float(p[2])};
        });
        const auto stack = FrameStack::gather(animation, Progress());
        QVERIFY(stack.has_value());
        auto found = Trajectories::of(*stack, stack->rowMeans(), Progress());
        QVERIFY(found.has_value());
        QVERIFY(found->find(2, Progress()).has_value());
        QCOMPARE(found->basis().cols(), Eigen::Index(2));
        // More, on top of what is known already.
        QVERIFY(found->find(Strengths.size(), Progress()).has_value());
        QCOMPARE(found->basis().cols(), Eigen::Index(Strengths.size()));
        for (std::uint32_t k = 0; k < Strengths.size(); ++k) {
            QVERIFY2(std::fabs(found->strengths()[k] - Strengths[k]) < 1e-3 * Strengths[k],
                     qPrintable(QString("%1: %2").arg(k).arg(found->strengths()[k])));
            double product = 0;
            for (std::uint32_t f = 0; f < frames; ++f)
                product += found->basis()(3 * f + k % 3, k) * cosine(k + 1, f, frames) / std::sqrt(double(frames));
            // Rounding to floats of positions of about 1000 is all that differs.
            QVERIFY2(std::fabs(std::fabs(product) - 1) < 1e-3, qPrintable(QString("%1: %2").arg(k).arg(product)));
        }
    }

    void aSearchIsCancelled()
    {
        const tests::PlainAnimation animation = tests::waves(1001, 3001, 5);
        const auto stack = FrameStack::gather(animation, Progress());
        auto found = Trajectories::of(*stack, stack->rowMeans(), Progress());
        std::shared_ptr<Progress> handle;
        handle = std::make_shared<Progress>([&](double fraction) {
            if (fraction > 0.2)
                handle->cancel();
        });
        const auto outcome = found->find(20, *handle);
        QVERIFY(!outcome);
        QCOMPARE(int(outcome.error().code), int(ErrorCode::Cancelled));
    }
};

SANDREEL_TEST(TestTrajectories)
#include "tst_trajectories.moc"
