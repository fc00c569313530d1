// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/parallel.h"
#include "model/codec/basis/eigenvectors.h"
#include "model/codec/basis/symmetriceigen.h"
#include "tests/support/testmain.h"

#include <Eigen/Eigenvalues>

#include <atomic>
#include <cmath>
#include <functional>
#include <random>
#include <thread>

using namespace model;
using namespace model::codec;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

MatrixXd symmetric(Index size, unsigned seed)
{
    std::mt19937 random(seed);
    MatrixXd a(size, size);
    for (Index j = 0; j < size; ++j)
        for (Index i = 0; i <= j; ++i)
            a(i, j) = a(j, i) = double(random()) / double(std::mt19937::max()) - 0.5;
    return a;
}

/// Symmetric with these eigenvalues: reflections of a diagonal matrix.
MatrixXd withEigenvalues(const VectorXd &values)
{
    MatrixXd a = values.asDiagonal();
    for (unsigned seed = 1; seed <= 3; ++seed) {
        const VectorXd u = symmetric(values.size(), seed).col(0).normalized();
        a -= 2 * u * (u.transpose() * a);
        a -= 2 * (a * u) * u.transpose();
    }
    return (a + a.transpose()) / 2;
}

VectorXd byRank(Index size, const std::function<double(Index)> &value)
{
    return VectorXd::NullaryExpr(size, value);
}

struct Row
{
    const char *name;
    MatrixXd matrix;
};

std::vector<Row> table()
{
    return {{"1 x 1", MatrixXd::Constant(1, 1, -3)},
            {"2 x 2", symmetric(2, 7)},
            {"3 x 3", symmetric(3, 8)},
            {"zero", MatrixXd::Zero(20, 20)},
            {"one value many times", MatrixXd::Identity(40, 40) * 2.5},
            {"diagonal", MatrixXd(VectorXd::LinSpaced(33, -1, 5).asDiagonal())},
            {"both signs", symmetric(150, 9)},
            {"a panel and a row", symmetric(97, 10)},
            {"falling by 300 powers of ten",
             withEigenvalues(byRank(120, [](Index i) { return std::pow(10, -2.5 * double(i)); }))},
            {"huge", symmetric(30, 11) * 1e300},
            {"tiny", symmetric(30, 12) * 1e-300},
            {"pairs", withEigenvalues(byRank(200, [](Index i) { return std::pow(0.9, double(i / 2)); }))},
            {"low rank", withEigenvalues(byRank(450, [](Index i) { return i < 25 ? 30.0 - double(i) : 0.0; }))},
            {"large", withEigenvalues(byRank(450, [](Index i) { return 1 / (1.0 + double(i)); }))}};
}

/// The columns are orthonormal, and A u = lambda u, to some units in the last place of the largest eigenvalue.
void checkVectors(const MatrixXd &a, const MatrixXd &vectors, const VectorXd &values, double tolerance)
{
    const double orthonormality =
        (vectors.transpose() * vectors - MatrixXd::Identity(vectors.cols(), vectors.cols())).cwiseAbs().maxCoeff();
    QVERIFY2(orthonormality < 1e-13, qPrintable(QString::number(orthonormality)));
    const double scale = std::max(a.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
    const MatrixXd left = (a / scale) * vectors - vectors * (values / scale).asDiagonal();
    const double residual = left.cwiseAbs().maxCoeff();
    QVERIFY2(residual < tolerance * std::sqrt(double(a.rows())), qPrintable(QString::number(residual)));
}

} // namespace

class TestEigenvectors final : public QObject
{
    Q_OBJECT

private:
    static void addTable()
    {
        QTest::addColumn<int>("row");
        const auto rows = table();
        for (std::size_t i = 0; i < rows.size(); ++i)
            QTest::newRow(rows[i].name) << int(i);
    }

private slots:
    void fullDecomposition_data() { addTable(); }
    void fullDecomposition()
    {
        QFETCH(int, row);
        const MatrixXd a = table()[std::size_t(row)].matrix;
        const auto found = symmetricEigen(a, a.rows(), Progress());
        QVERIFY(found.has_value());
        QCOMPARE(found->vectors.cols(), a.cols());
        checkVectors(a, found->vectors, found->values, 1e-14);
        // An independent solver.
        const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(a, Eigen::EigenvaluesOnly);
        const VectorXd expected = solver.eigenvalues().reverse();
        const double scale = std::max(expected.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min());
        const double difference = (expected / scale - found->values / scale).cwiseAbs().maxCoeff();
        QVERIFY2(difference < 1e-13, qPrintable(QString::number(difference)));
    }

    void fewerVectorsAreTheFirstOnes()
    {
        const MatrixXd a = symmetric(60, 3);
        const auto all = symmetricEigen(a, 60, Progress());
        const auto some = symmetricEigen(a, 7, Progress());
        QVERIFY(some->vectors == all->vectors.leftCols(7));
        QVERIFY(some->values == all->values);
        QVERIFY(std::is_sorted(all->values.begin(), all->values.end(), std::greater<>()));
        QCOMPARE(symmetricEigen(MatrixXd(), 0, Progress())->values.size(), Index(0));
    }

    void onlyTheLowerTriangleIsRead()
    {
        const MatrixXd a = symmetric(40, 4);
        MatrixXd lower = a;
        lower.triangularView<Eigen::StrictlyUpper>().setConstant(1e9);
        QVERIFY(symmetricEigen(lower, 40, Progress())->vectors == symmetricEigen(a, 40, Progress())->vectors);
    }

    void strongest_data()
    {
        QTest::addColumn<int>("row");
        QTest::addColumn<int>("count");
        const auto rows = table();
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (rows[i].matrix.trace() > 0)
                for (const int count : {1, 20, 110, 450}) // 450 rows: iteration up to 112
                    if (count == 1 || count <= rows[i].matrix.rows())
                        QTest::addRow("%s, %d", rows[i].name, count) << int(i) << count;
    }
    void strongest()
    {
        QFETCH(int, row);
        QFETCH(int, count);
        const MatrixXd a = table()[std::size_t(row)].matrix;
        const auto found = strongestEigenvectors(a, std::size_t(count), Progress());
        QVERIFY(found.has_value());
        QCOMPARE(found->cols(), Index(count));
        const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(a, Eigen::EigenvaluesOnly);
        checkVectors(a, *found, solver.eigenvalues().reverse().head(count), 2e-9);
    }

    void strongestOfProducts()
    {
        const MatrixXd a = table().back().matrix;
        const MatrixProduct apply = [&](const VectorXd &in, VectorXd &out) { out = a * in; };
        const auto found = strongestEigenvectors(apply, 450, 30, Progress());
        QVERIFY(found.has_value());
        QCOMPARE(found->cols(), Index(30));
        checkVectors(a, *found, byRank(30, [](Index i) { return 1 / (1.0 + double(i)); }), 1e-7);
    }

    void sameWithAnyNumberOfThreads()
    {
        const MatrixXd a = symmetric(1100, 5); // large enough for every pass to use threads
        const MatrixXd positive = withEigenvalues(byRank(1100, [](Index i) { return 1 / (1.0 + double(i)); }));
        MatrixXd all, few;
        for (const unsigned threads : {1u, 2u, 5u}) {
            setThreadCount(threads);
            const auto full = symmetricEigen(a, 50, Progress());
            const auto strongest = strongestEigenvectors(positive, 50, Progress());
            setThreadCount(0);
            if (threads == 1) {
                all = full->vectors;
                few = *strongest;
            }
            QVERIFY(full->vectors == all);
            QVERIFY(*strongest == few);
        }
    }

    // Cancelled from another thread when the work has come so far: it does not come much further.
    void fullDecompositionStops_data()
    {
        QTest::addColumn<double>("fraction");
        QTest::newRow("becoming tridiagonal") << 0.1;
        QTest::newRow("before the product of the reflections") << 0.299;
        QTest::newRow("becoming diagonal") << 0.6;
    }
    void fullDecompositionStops()
    {
        QFETCH(double, fraction);
        const MatrixXd a = symmetric(500, 6);
        std::atomic<bool> wanted = false, cancelled = false;
        double last = 0;
        const Progress progress([&](double reported) {
            last = reported;
            if (reported >= fraction && !wanted.exchange(true))
                cancelled.wait(false);
        });
        std::thread other([&] {
            while (!wanted)
                std::this_thread::yield();
            progress.cancel();
            cancelled = true;
            cancelled.notify_all();
        });
        const auto found = strongestEigenvectors(a + 500 * MatrixXd::Identity(500, 500), 400, progress);
        wanted = true; // also where nothing was reported
        other.join();
        QVERIFY(!found.has_value());
        QVERIFY(found.error().code == ErrorCode::Cancelled);
        QVERIFY2(last >= fraction && last < fraction + 0.05, qPrintable(QString::number(last)));
    }

    void iterationStops()
    {
        const MatrixXd a = table().back().matrix;
        const Progress progress;
        int products = 0;
        const MatrixProduct apply = [&](const VectorXd &in, VectorXd &out) {
            out = a * in;
            if (++products == 15)
                progress.cancel();
        };
        const auto found = strongestEigenvectors(apply, 450, 30, progress);
        QVERIFY(!found.has_value());
        QVERIFY(found.error().code == ErrorCode::Cancelled);
        QCOMPARE(products, 15);
    }
};

SANDREEL_TEST(TestEigenvectors)
#include "tst_eigenvectors.moc"
