// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/parallel.h"
#include "model/codec/reel/interpolation.h"
#include "tests/model/codec/animations.h"
#include "tests/support/testmain.h"

#include <Eigen/Dense>

#include <cmath>
#include <random>

using namespace model;
using namespace model::codec;

namespace {

/// A sheet of nodes with places that are a little irregular.
struct Sheet
{
    CoarseToFine nodes;
    std::vector<std::array<double, 3>> places;
};

Sheet sheet()
{
    Connectivity mesh{12 * 12, {}};
    for (std::uint32_t y = 0; y < 11; ++y)
        for (std::uint32_t x = 0; x < 11; ++x) {
            const std::uint32_t a = 12 * y + x;
            mesh.triangles.push_back({a, a + 1, a + 12});
            mesh.triangles.push_back({a + 1, a + 13, a + 12});
        }
    Sheet result{*coarseToFine(mesh, Progress()), {}};
    std::mt19937 random(7);
    for (const std::uint32_t v : result.nodes.vertices) {
        const auto jitter = [&] { return double(random() % 1000) / 5000; };
        result.places.push_back({v % 12 + jitter(), v / 12 + jitter(), jitter()});
    }
    return result;
}

double predicted(const Sheet &s, const Weights &weights, std::size_t node, const std::vector<double> &field)
{
    double sum = 0;
    for (std::size_t j = 0; j < s.nodes.known[node].size(); ++j)
        sum += weights[j] * field[s.nodes.known[node][j]];
    return sum;
}

} // namespace

class TestInterpolation final : public QObject
{
    Q_OBJECT

private slots:
    void krigingSolvesItsEquations()
    {
        const Sheet s = sheet();
        const auto weights = krigingWeights(s.nodes, s.places);
        for (std::size_t i = 0; i < s.nodes.size(); ++i) {
            const auto known = s.nodes.known[i];
            const Eigen::Index n = Eigen::Index(known.size());
            if (n < 3)
                continue;
            const auto at = [&](std::size_t node) { return Eigen::Vector3d(s.places[node].data()); };
            double h = 0;
            for (const std::uint32_t u : known)
                h += (at(u) - at(i)).norm() / double(n);
            const auto covariance = [&](const Eigen::Vector3d &p, const Eigen::Vector3d &q) {
                return 100 + 30 * p.dot(q) / (h * h) + 10 / (1 + (p - q).squaredNorm() / (9 * h * h));
            };
            Eigen::MatrixXd k(n, n);
            Eigen::VectorXd right(n);
            for (Eigen::Index a = 0; a < n; ++a) {
                const Eigen::Vector3d p = at(known[std::size_t(a)]) - at(i);
                right(a) = covariance(p, Eigen::Vector3d::Zero());
                for (Eigen::Index b = 0; b < n; ++b)
                    k(a, b) = covariance(p, at(known[std::size_t(b)]) - at(i)) + (a == b ? 0.02 : 0.0);
            }
            const Eigen::VectorXd expected = k.fullPivLu().solve(right);
            for (Eigen::Index a = 0; a < n; ++a)
                QVERIFY(std::fabs(weights[i][std::size_t(a)] - expected(a)) < 1e-7);
            for (std::size_t a = known.size(); a < MaxKnown; ++a)
                QCOMPARE(weights[i][a], 0.0);
        }
    }

    void krigingKeepsAffineFields()
    {
        const Sheet s = sheet();
        const auto weights = krigingWeights(s.nodes, s.places);
        std::vector<double> field;
        for (const auto &p : s.places)
            field.push_back(3 + 2 * p[0] - p[1] + 5 * p[2]);
        double error = 0, spread = 0;
        for (std::size_t i = 0; i < s.nodes.size(); ++i) {
            if (s.nodes.known[i].size() < MaxKnown)
                continue;
            double mean = 0;
            for (const std::uint32_t u : s.nodes.known[i])
                mean += field[u] / double(MaxKnown);
            error += std::pow(predicted(s, weights[i], i, field) - field[i], 2);
            spread += std::pow(mean - field[i], 2);
        }
        QVERIFY2(error < 0.01 * spread, qPrintable(QString("%1 %2").arg(error).arg(spread)));
    }

    void krigingIsScaleFreeAndTakesOnePlace()
    {
        Sheet s = sheet();
        const auto weights = krigingWeights(s.nodes, s.places);
        for (auto &p : s.places)
            for (double &x : p)
                x *= 1e9;
        const auto scaled = krigingWeights(s.nodes, s.places);
        for (std::size_t i = 0; i < s.nodes.size(); ++i)
            for (std::size_t j = 0; j < MaxKnown; ++j)
                QVERIFY(std::fabs(weights[i][j] - scaled[i][j]) < 1e-9);
        for (auto &p : s.places)
            p = {1, 2, 3};
        for (const Weights &w : krigingWeights(s.nodes, s.places)) {
            double sum = 0;
            for (const double x : w)
                sum += x;
            QVERIFY(sum == 0 || std::fabs(sum - 1) < 1e-3); // none at the first node
        }
    }

    void learningSolvesItsProblem_data()
    {
        QTest::addColumn<int>("bands");
        for (const int bands : {1, 3, 4, 7, 13, 40})
            QTest::newRow(qPrintable(QString::number(bands))) << bands;
    }
    void learningSolvesItsProblem()
    {
        QFETCH(int, bands);
        const Sheet s = sheet();
        const auto prior = krigingWeights(s.nodes, s.places);
        const std::size_t stride = 41;
        std::mt19937 random(3);
        std::vector<double> values(s.nodes.size() * stride);
        for (double &v : values)
            v = double(random() % 2001) / 100 - 10;
        const double ridge = 0.7;
        std::vector<Weights> weights = prior;
        learnWeights(s.nodes, prior, values, stride, std::size_t(bands), ridge, weights);
        for (std::size_t i = 0; i < s.nodes.size(); ++i) {
            const auto known = s.nodes.known[i];
            const Eigen::Index n = Eigen::Index(known.size());
            if (n < 2)
                continue;
            // Minimise |D w + (s - 1) c|^2 + ridge bands |w - prior|^2 over w with sum(w) = s = sum(prior), by
            // Lagrange's equations.
            Eigen::MatrixXd d(bands, n);
            Eigen::VectorXd own(bands), w0(n);
            for (Eigen::Index j = 0; j < n; ++j) {
                w0(j) = prior[i][std::size_t(j)];
                for (int k = 0; k < bands; ++k)
                    d(k, j) =
                        values[known[std::size_t(j)] * stride + std::size_t(k)] - values[i * stride + std::size_t(k)];
            }
            for (int k = 0; k < bands; ++k)
                own(k) = values[i * stride + std::size_t(k)];
            const double sum = w0.sum();
            Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + 1, n + 1);
            system.topLeftCorner(n, n) = d.transpose() * d + ridge * bands * Eigen::MatrixXd::Identity(n, n);
            system.col(n).head(n).setOnes();
            system.row(n).head(n).setOnes();
            Eigen::VectorXd right(n + 1);
            right.head(n) = ridge * bands * w0 - d.transpose() * (sum - 1) * own;
            right(n) = sum;
            const Eigen::VectorXd expected = system.fullPivLu().solve(right);
            for (Eigen::Index j = 0; j < n; ++j)
                QVERIFY(std::fabs(weights[i][std::size_t(j)] - expected(j)) < 1e-6);
        }
    }

    void learningFindsTheLawOfTheBands()
    {
        // Every node is the mean of its two nearest, however the sheet lies.
        const Sheet s = sheet();
        const std::size_t bands = 30;
        std::mt19937 random(5);
        std::vector<double> values(s.nodes.size() * bands);
        for (std::size_t i = 0; i < s.nodes.size(); ++i)
            for (std::size_t k = 0; k < bands; ++k) {
                const auto known = s.nodes.known[i];
                values[i * bands + k] = known.size() < 2
                                            ? double(random() % 2001) - 1000
                                            : (values[known[0] * bands + k] + values[known[1] * bands + k]) / 2 +
                                                  double(random() % 100) / 10;
            }
        const auto prior = krigingWeights(s.nodes, s.places);
        std::vector<Weights> weights = prior;
        learnWeights(s.nodes, prior, values, bands, 20, 0.5, weights);
        double before = 0, after = 0;
        for (std::size_t i = 0; i < s.nodes.size(); ++i)
            for (std::size_t k = 20; k < bands; ++k) {
                std::vector<double> field;
                for (std::size_t j = 0; j < s.nodes.size(); ++j)
                    field.push_back(values[j * bands + k]);
                if (s.nodes.known[i].size() < 2)
                    continue;
                before += std::pow(predicted(s, prior[i], i, field) - field[i], 2);
                after += std::pow(predicted(s, weights[i], i, field) - field[i], 2);
            }
        QVERIFY2(after < before / 2, qPrintable(QString("%1 %2").arg(before).arg(after)));
    }

    void threadsDoNotMatter()
    {
        const Sheet s = sheet();
        std::vector<double> values(s.nodes.size() * 8);
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = double(i * i % 97);
        const auto run = [&](unsigned threads) {
            setThreadCount(threads);
            const auto prior = krigingWeights(s.nodes, s.places);
            auto weights = prior;
            learnWeights(s.nodes, prior, values, 8, 8, 0.5, weights);
            setThreadCount(0);
            return weights;
        };
        QVERIFY(run(1) == run(3));
    }
};

SANDREEL_TEST(TestInterpolation)
#include "tst_interpolation.moc"
