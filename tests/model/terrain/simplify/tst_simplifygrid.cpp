// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/simplify/simplifygrid.h"
#include "model/terrain/tin/validate.h"
#include "tests/support/testmain.h"

#include <cmath>
#include <random>

using namespace model;
using namespace model::terrain;

namespace {

HeightGrid flat(std::uint32_t columns, std::uint32_t rows)
{
    return {columns, rows, 10, 5, std::vector<double>(std::size_t(columns) * rows, 100.0)};
}

/// Hills with steps and noise: errors of every size.
HeightGrid hills(std::uint32_t columns, std::uint32_t rows, unsigned seed)
{
    HeightGrid grid = flat(columns, rows);
    std::mt19937 random(seed);
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i)
            grid.heights[grid.index(i, j)] = 50 * std::sin(i * 0.2) * std::cos(j * 0.15) + (i > columns / 2 ? 20 : 0) +
                                             double(random() % 1000) * 0.002;
    return grid;
}

/// What no step of the simplification knows: the triangle under each node, found from scratch.
struct Scan
{
    double worst = 0;
    std::size_t groundNodes = 0;
    std::size_t wrongVoids = 0; ///< squares whose centre is void where the grid is not, or the other way round
};

Scan scanOf(const Tin &tin, const HeightGrid &grid)
{
    Scan scan;
    std::vector<bool> isGroundNode(grid.heights.size());
    for (std::uint32_t j = 0; j + 1 < grid.rows; ++j)
        for (std::uint32_t i = 0; i + 1 < grid.columns; ++i) {
            const bool isGround = grid.isGround(i, j);
            for (const std::size_t n :
                 {grid.index(i, j), grid.index(i + 1, j), grid.index(i, j + 1), grid.index(i + 1, j + 1)})
                isGroundNode[n] = isGroundNode[n] || isGround;
            const Point2 low = grid.point(i, j);
            // Three places in the square, off its diagonals.
            for (const auto &[fx, fy] : {std::pair{0.5, 0.47}, {0.13, 0.91}, {0.87, 0.06}}) {
                const TriangleId t = tin.triangleAt({low.x + fx * grid.stepX, low.y + fy * grid.stepY});
                scan.wrongVoids += tin.arrays().isVoid(t) == isGround;
            }
        }
    for (std::uint32_t j = 0; j < grid.rows; ++j)
        for (std::uint32_t i = 0; i < grid.columns; ++i) {
            if (!isGroundNode[grid.index(i, j)])
                continue;
            ++scan.groundNodes;
            scan.worst = std::max(scan.worst, std::abs(tin.heightAt(grid.point(i, j)) - grid.height(i, j)));
        }
    return scan;
}

} // namespace

class TestSimplifyGrid final : public QObject
{
    Q_OBJECT

private slots:
    void everyNodeIsWithinTheError_data()
    {
        QTest::addColumn<double>("maxError");
        QTest::addColumn<double>("quantum");
        QTest::addColumn<int>("holes");
        for (const double maxError : {0.0, 0.05, 1.0, 7.0, 1000.0})
            for (const int holes : {0, 1, 40, 700}) {
                QTest::newRow(qPrintable(QStringLiteral("%1 m, %2 void nodes").arg(maxError).arg(holes)))
                    << maxError << 0.0 << holes;
                if (maxError > 0)
                    QTest::newRow(qPrintable(QStringLiteral("%1 m, %2 void nodes, rounded").arg(maxError).arg(holes)))
                        << maxError << heightQuantumFor(maxError) << holes;
            }
    }
    void everyNodeIsWithinTheError()
    {
        QFETCH(double, maxError);
        QFETCH(double, quantum);
        QFETCH(int, holes);
        HeightGrid grid = hills(70, 41, 3);
        std::mt19937 random(17);
        for (int hole = 0; hole < holes; ++hole)
            grid.heights[random() % grid.heights.size()] = NAN;
        const auto tin = simplifyGrid(grid, {maxError, quantum});
        QVERIFY(tin.has_value());
        const auto defects = findDefects(*tin);
        QVERIFY2(defects.empty(), defects.empty() ? "" : nameOf(defects[0].rule));
        const Scan scan = scanOf(*tin, grid);
        QVERIFY(scan.groundNodes > 0);
        QVERIFY2(scan.worst <= (maxError > 0 ? maxError : 1e-12), qPrintable(QString::number(scan.worst)));
        QCOMPARE(scan.wrongVoids, std::size_t(0));
        if (quantum > 0)
            for (VertexId v = 0; v < tin->arrays().vertexSlots(); ++v)
                QCOMPARE(std::fmod(tin->arrays().heights[v], quantum), 0.0);
        QCOMPARE(tin->ledger().expected(), tin->volume());
    }

    void fewerVerticesForLargerErrors()
    {
        const HeightGrid grid = hills(100, 100, 5);
        std::uint32_t before = ~0u;
        for (const double maxError : {0.1, 0.5, 1.0, 2.0, 5.0, 20.0}) {
            const auto tin = simplifyGrid(grid, {maxError});
            QVERIFY(tin.has_value());
            QVERIFY(tin->vertexCount() < before);
            before = tin->vertexCount();
        }
        QVERIFY(before < 300);
    }

    void aPlaneIsTwoTriangles()
    {
        HeightGrid grid = flat(50, 30);
        for (std::uint32_t j = 0; j < grid.rows; ++j)
            for (std::uint32_t i = 0; i < grid.columns; ++i)
                grid.heights[grid.index(i, j)] = 3 + 0.5 * i - 0.25 * j;
        const auto tin = simplifyGrid(grid, {0.001});
        QVERIFY(tin.has_value());
        QCOMPARE(tin->vertexCount(), 4u);
        QCOMPARE(tin->volume(), 49 * 10 * 29 * 5 * (3 + 0.5 * 24.5 - 0.25 * 14.5));
    }

    /// The border of a void runs where the squares end; nothing is taken from the ground or given to it.
    void aVoidKeepsItsArea()
    {
        HeightGrid grid = flat(20, 20);
        for (std::uint32_t j = 5; j < 9; ++j)
            for (std::uint32_t i = 7; i < 15; ++i)
                grid.heights[grid.index(i, j)] = NAN;
        const auto tin = simplifyGrid(grid, {0.5});
        QVERIFY(tin.has_value());
        // Squares from column 6 to 15, from row 4 to 9.
        QCOMPARE(tin->volume(), 100.0 * 50 * (19 * 19 - 9 * 5));
        QCOMPARE(tin->vertexCount(), 8u);
    }

    void sameInputSameTerrain()
    {
        const HeightGrid grid = hills(60, 60, 9);
        QCOMPARE(simplifyGrid(grid, {1.0})->fingerprint(), simplifyGrid(grid, {1.0})->fingerprint());
    }

    void errors()
    {
        HeightGrid grid = flat(1, 9);
        QCOMPARE(simplifyGrid(grid, {1.0}).error().code, ErrorCode::BadValue);
        grid = flat(9, 1);
        QCOMPARE(simplifyGrid(grid, {1.0}).error().code, ErrorCode::BadValue);
        grid = flat(4, 4);
        grid.heights[6] = INFINITY;
        QCOMPARE(simplifyGrid(grid, {1.0}).error().code, ErrorCode::NonFinite);
        QCOMPARE(simplifyGrid(grid, {1.0}).error().args[0], std::string("column 2 of row 1"));
        grid = flat(4, 4);
        for (double &height : grid.heights)
            height = NAN;
        QCOMPARE(simplifyGrid(grid, {1.0}).error().code, ErrorCode::NoSurface);
        // Nodes with a height, but no square of them.
        grid.heights[5] = 3;
        grid.heights[6] = 3;
        QCOMPARE(simplifyGrid(grid, {1.0}).error().code, ErrorCode::NoSurface);
        const Progress progress;
        progress.cancel();
        QCOMPARE(simplifyGrid(hills(30, 30, 1), {0.0}, progress).error().code, ErrorCode::Cancelled);
    }
};

SANDREEL_TEST(TestSimplifyGrid)
#include "tst_simplifygrid.moc"
