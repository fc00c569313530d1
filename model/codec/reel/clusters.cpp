// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/reel/clusters.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace model::codec {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr std::uint32_t None = ~0u;

// A coefficient of variance v is taken for log2(1 + share v / step^2) / 2 bits, as a Gaussian value would need of whose
// variance interpolation leaves this share; an entry of a trajectory likewise. Flat: a third or three times of either
// changes the size of files with many parts by 1 - 3 %.
constexpr double CoefficientShare = 0.1;
constexpr double BasisShare = 0.1;
// What two clusters must save at least, in bits.
constexpr double LeastGain = 64;
// More components than this are joined to those that move most alike before pairs are weighed.
constexpr std::size_t MostCandidates = 32;
static_assert(MostCandidates <= MaxClusters);

/// log2 det(1 + scale m).
double logDeterminant(const MatrixXd &m, double scale)
{
    MatrixXd a = scale * m;
    a.diagonal().array() += 1;
    const Eigen::LLT<MatrixXd> factor(a);
    double sum = 0;
    for (Index i = 0; i < a.rows(); ++i)
        sum += std::log2(std::max(factor.matrixLLT()(i, i), 1e-300));
    return 2 * sum;
}

/// Components that share their trajectories.
struct Group
{
    MatrixXd moment; ///< sum of c c^T over the vertices, c their coefficients
    double vertices = 0;
    double bits = 0;
    std::vector<std::uint32_t> components;
};

/// Bits of trajectories of their own and the coefficients on them: sums over the eigenvalues of the moment, which are
/// those of the group's own principal components.
double bitsOf(const MatrixXd &moment, double vertices, double rows, double step)
{
    const double unit = 1 / (step * step);
    return 0.5 * vertices * logDeterminant(moment, CoefficientShare * unit / vertices) +
           0.5 * rows * logDeterminant(moment, BasisShare * unit / rows);
}

/// A group for each of the components that move most; every other one joins the group that moves most alike.
std::vector<Group> candidates(const MatrixXd &coefficients, std::span<const std::uint32_t> components,
                              const Progress &progress)
{
    const std::size_t count = components.empty() ? 0 : 1 + *std::max_element(components.begin(), components.end());
    std::vector<std::vector<Index>> columns(count);
    Eigen::VectorXd energies = Eigen::VectorXd::Zero(Index(count));
    for (std::size_t v = 0; v < components.size(); ++v) {
        columns[components[v]].push_back(Index(v));
        energies[components[v]] += coefficients.col(Index(v)).squaredNorm();
    }
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return energies[a] > energies[b]; });

    std::vector<Group> groups;
    for (const std::uint32_t component : order) {
        if (progress.isCancelled())
            break;
        MatrixXd moment = MatrixXd::Zero(coefficients.rows(), coefficients.rows());
        for (const Index v : columns[component])
            moment.selfadjointView<Eigen::Lower>().rankUpdate(coefficients.col(v));
        moment = MatrixXd(moment.selfadjointView<Eigen::Lower>());
        const auto vertices = double(columns[component].size());
        if (groups.size() < MostCandidates) {
            groups.push_back({std::move(moment), vertices, 0, {component}});
            continue;
        }
        const auto alike = [&](const Group &group) {
            return group.moment.cwiseProduct(moment).sum() / std::max(group.moment.norm(), 1e-300);
        };
        Group &host = *std::max_element(groups.begin(), groups.end(),
                                        [&](const Group &a, const Group &b) { return alike(a) < alike(b); });
        host.moment += moment;
        host.vertices += vertices;
        host.components.push_back(component);
    }
    return groups;
}

/// Joins the two that gain most by it, again and again; a group that was joined to another is left without components.
void joinPairs(std::vector<Group> &groups, double rows, double step, const Progress &progress)
{
    for (Group &group : groups)
        group.bits = bitsOf(group.moment, group.vertices, rows, step);
    const Index count = Index(groups.size());
    MatrixXd gains = MatrixXd::Constant(count, count, -HUGE_VAL);
    const auto weigh = [&](std::size_t i, std::size_t j) {
        if (progress.isCancelled())
            return;
        const Group &a = groups[i], &b = groups[j];
        gains(Index(std::min(i, j)), Index(std::max(i, j))) =
            a.bits + b.bits - bitsOf(a.moment + b.moment, a.vertices + b.vertices, rows, step);
    };
    for (std::size_t i = 0; i < groups.size(); ++i)
        for (std::size_t j = i + 1; j < groups.size(); ++j)
            weigh(i, j);
    Index first = 0, second = 0;
    while (count > 1 && gains.maxCoeff(&first, &second) >= -LeastGain) {
        Group &into = groups[std::size_t(first)], &from = groups[std::size_t(second)];
        into.moment += from.moment;
        into.vertices += from.vertices;
        into.bits = bitsOf(into.moment, into.vertices, rows, step);
        into.components.insert(into.components.end(), from.components.begin(), from.components.end());
        from.components.clear();
        gains.row(second).setConstant(-HUGE_VAL);
        gains.col(second).setConstant(-HUGE_VAL);
        for (std::size_t other = 0; other < groups.size(); ++other)
            if (other != std::size_t(first) && !groups[other].components.empty())
                weigh(std::size_t(first), other);
    }
}

} // namespace

std::vector<std::uint32_t> componentsOf(const CoarseToFine &nodes)
{
    std::vector<std::uint32_t> components(nodes.size(), None);
    std::uint32_t count = 0;
    std::vector<std::uint32_t> queue;
    for (std::uint32_t first = 0; first < nodes.size(); ++first) {
        if (components[first] != None)
            continue;
        components[first] = count;
        queue.assign(1, first);
        while (!queue.empty()) {
            const std::uint32_t node = queue.back();
            queue.pop_back();
            for (const std::uint32_t other : nodes.adjacent[node])
                if (components[other] == None) {
                    components[other] = count;
                    queue.push_back(other);
                }
        }
        ++count;
    }
    return components;
}

std::vector<std::vector<std::uint32_t>> nodesOf(const Clusters &clusters, std::span<const std::uint32_t> components)
{
    std::vector<std::vector<std::uint32_t>> result(clusters.count);
    for (std::uint32_t node = 0; node < components.size(); ++node)
        result[clusters.labels.empty() ? 0 : clusters.labels[components[node]]].push_back(node);
    return result;
}

CoarseToFine restrictedTo(const CoarseToFine &nodes, std::span<const std::uint32_t> members)
{
    std::vector<std::uint32_t> renumbered(nodes.size(), None);
    for (std::uint32_t i = 0; i < members.size(); ++i)
        renumbered[members[i]] = i;
    CoarseToFine result;
    result.finest = nodes.finest;
    std::vector<std::uint32_t> list, lengths;
    const auto keep = [&](std::span<const std::uint32_t> all, std::span<const std::uint32_t> allLengths) {
        list.clear();
        lengths.clear();
        for (std::size_t i = 0; i < all.size(); ++i)
            if (renumbered[all[i]] != None) {
                list.push_back(renumbered[all[i]]);
                if (!allLengths.empty())
                    lengths.push_back(allLengths[i]);
            }
    };
    for (const std::uint32_t node : members) {
        result.vertices.push_back(nodes.vertices[node]);
        result.levels.push_back(nodes.levels[node]);
        keep(nodes.known[node], nodes.lengths[node]);
        result.known.add(list);
        result.lengths.add(lengths);
        keep(nodes.ring[node], nodes.ringLengths[node]);
        result.ring.add(list);
        result.ringLengths.add(lengths);
        keep(nodes.adjacent[node], {});
        result.adjacent.add(list);
    }
    return result;
}

Result<Clusters> clustersOf(const MatrixXd &coefficients, std::span<const std::uint32_t> components, std::size_t rows,
                            double step, const Progress &progress)
{
    std::vector<Group> groups = candidates(coefficients, components, progress);
    joinPairs(groups, double(rows), step, progress);
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);

    Clusters result{0, {}};
    std::vector<const Group *> groupOf;
    for (const Group &group : groups)
        for (const std::uint32_t component : group.components) {
            groupOf.resize(std::max<std::size_t>(groupOf.size(), component + 1));
            groupOf[component] = &group;
        }
    std::vector<std::uint32_t> numbers(groups.size(), None);
    for (const Group *group : groupOf) {
        std::uint32_t &number = numbers[std::size_t(group - groups.data())];
        if (number == None)
            number = result.count++;
        result.labels.push_back(number);
    }
    return result;
}

} // namespace model::codec
