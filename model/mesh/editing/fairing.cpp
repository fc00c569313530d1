// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: M. Botsch, L. Kobbelt: An Intuitive Framework for Real-Time Freeform Modeling, 2004
// Differs: uniform weights, which are the same in all frames, instead of cotangents.
#include "model/mesh/editing/fairing.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <map>

namespace model {

namespace {

/// What is left out of a sum: no position would move by more than a millionth of the hole.
constexpr double LeastWeight = 1e-7;

} // namespace

std::vector<std::vector<VertexSources::Share>> fairingWeights(const std::vector<std::vector<std::uint32_t>> &neighbours,
                                                              const std::vector<std::uint32_t> &free)
{
    constexpr std::uint32_t NotFree = ~std::uint32_t(0);
    std::vector<std::uint32_t> place(neighbours.size(), NotFree);
    for (std::uint32_t i = 0; i < free.size(); ++i)
        place[free[i]] = i;
    std::vector<bool> isRow(neighbours.size());
    for (const std::uint32_t v : free) {
        isRow[v] = true;
        for (const std::uint32_t n : neighbours[v])
            isRow[n] = true;
    }
    // The energy is the sum over rows of |x_v - mean of its neighbours|^2 times their number.
    std::vector<Eigen::Triplet<double>> inner;
    std::map<std::uint32_t, std::vector<std::pair<std::uint32_t, double>>> outer; // by the vertex that holds
    for (std::uint32_t v = 0; v < neighbours.size(); ++v) {
        if (!isRow[v])
            continue;
        const double degree = double(neighbours[v].size());
        std::vector<std::pair<std::uint32_t, double>> row{{v, 1.0}};
        for (const std::uint32_t n : neighbours[v])
            row.push_back({n, -1 / degree});
        for (const auto &[a, weightA] : row) {
            if (place[a] == NotFree)
                continue;
            for (const auto &[b, weightB] : row) {
                const double value = degree * weightA * weightB;
                if (place[b] != NotFree)
                    inner.emplace_back(int(place[a]), int(place[b]), value);
                else
                    outer[b].push_back({place[a], -value});
            }
        }
    }
    const auto size = Eigen::Index(free.size());
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(inner.begin(), inner.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    if (solver.info() != Eigen::Success || outer.empty())
        return {};

    std::vector<std::vector<VertexSources::Share>> shares(free.size());
    Eigen::VectorXd column(size);
    for (const auto &[vertex, entries] : outer) {
        column.setZero();
        for (const auto &[row, value] : entries)
            column[row] += value;
        const Eigen::VectorXd weights = solver.solve(column);
        for (Eigen::Index i = 0; i < size; ++i)
            if (std::abs(weights[i]) > LeastWeight)
                shares[std::size_t(i)].push_back({vertex, float(weights[i])});
    }
    for (auto &list : shares) {
        double sum = 0;
        for (const auto &share : list)
            sum += double(share.weight);
        if (!(std::abs(sum - 1) < 1e-2))
            return {};
        for (auto &share : list)
            share.weight = float(double(share.weight) / sum);
    }
    return shares;
}

} // namespace model
