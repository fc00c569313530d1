// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/model/codec/plain/plainmixing.h"
#include "tests/model/codec/plain/plainnodes.h"
#include "tests/model/codec/plain/plainreader.h"

#include <cmath>
#include <map>

namespace tests::plain {

// FORMAT.md 13.3 to 13.5 and 13.7.

using Place = std::array<double, 3>;

// 13.3
inline std::uint64_t classOf(std::uint64_t x)
{
    if (x < 4)
        return x;
    const unsigned t = bits(x) - 1;
    return 2 * t + (x >> (t - 1)) % 2;
}
inline std::uint64_t capped(std::uint64_t x)
{
    return classOf(std::min<std::uint64_t>(x, 2000));
}
inline std::uint64_t sizeOfResidual(std::int64_t r)
{
    return std::min<std::uint64_t>(std::uint64_t(r < 0 ? -r : r), 4000);
}

struct Residuals
{
    Residuals(std::size_t inputs, std::size_t sets)
        : digits(inputs)
        , weights(3, std::vector<WeightSet>(sets, WeightSet(inputs)))
    {}

    std::int64_t decode(Range &in, const std::vector<std::uint64_t> &contexts, std::uint64_t set)
    {
        const auto digit = [&](std::uint64_t d) {
            std::vector<CountedModel *> models;
            for (std::size_t i = 0; i < digits.size(); ++i)
                models.push_back(&digits[i][contexts[i] * 17 + d]);
            return mixed(in, models, weights[std::min<std::uint64_t>(d, 2)][set], 250);
        };
        std::int64_t m = 0;
        bool negative = false;
        while (m < 17 && digit(std::uint64_t(m))) {
            ++m;
            if (m == 1)
                negative = in.direct(1);
        }
        if (m == 17) {
            unsigned b = 0;
            while (b < 29 && in.bit(tail[b]))
                ++b;
            std::int64_t r = 1;
            while (b > 0) {
                const unsigned c = std::min(b, 12u);
                r = (r << c) + in.direct(c);
                b -= c;
            }
            m += r - 1;
        }
        return negative ? -m : m;
    }

    std::vector<CountedModels> digits;
    std::vector<std::vector<WeightSet>> weights; ///< [mixer][set]
    Model tail[29];
};

// 13.4
inline std::vector<double> stepsOf(const std::vector<Node> &nodes, double ratio)
{
    unsigned finest = 0;
    for (const Node &node : nodes)
        finest = std::max(finest, node.level);
    std::vector<double> steps(finest + 1, 1);
    for (unsigned level = finest; level-- > 0;)
        steps[level] = std::max(0.05, steps[level + 1] * ratio);
    return steps;
}

/// Solves a system of equations by elimination with pivots.
inline std::vector<long double> solved(std::vector<std::vector<long double>> m, std::vector<long double> x)
{
    const std::size_t count = x.size();
    for (std::size_t i = 0; i < count; ++i) {
        std::size_t best = i;
        for (std::size_t r = i + 1; r < count; ++r)
            if (std::fabs(m[r][i]) > std::fabs(m[best][i]))
                best = r;
        std::swap(m[i], m[best]);
        std::swap(x[i], x[best]);
        for (std::size_t r = i + 1; r < count; ++r) {
            const long double factor = m[r][i] / m[i][i];
            for (std::size_t c = i; c < count; ++c)
                m[r][c] -= factor * m[i][c];
            x[r] -= factor * x[i];
        }
    }
    for (std::size_t i = count; i-- > 0;) {
        for (std::size_t c = i + 1; c < count; ++c)
            x[i] -= m[i][c] * x[c];
        x[i] /= m[i][i];
    }
    return x;
}

// 13.5
inline std::vector<double> priorWeights(const Node &node, const Place &at, const std::vector<Place> &places)
{
    const std::size_t n = node.known.size();
    std::vector<double> w(n, 0);
    if (n < 3) {
        if (n > 0)
            w[0] = 1;
        return w;
    }
    std::vector<Place> p;
    double h = 0;
    for (const std::size_t u : node.known) {
        Place d;
        for (std::size_t a = 0; a < 3; ++a)
            d[a] = places[u][a] - at[a];
        h += std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) / double(n);
        p.push_back(d);
    }
    for (Place &d : p)
        for (double &x : d)
            x = h > 0 ? x / h : 0;
    const auto k = [](const Place &a, const Place &b) {
        double product = 0, squared = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            product += a[i] * b[i];
            squared += (a[i] - b[i]) * (a[i] - b[i]);
        }
        return 100 + 30 * product + 10 / (1 + squared / 9);
    };
    std::vector<std::vector<long double>> m(n, std::vector<long double>(n));
    std::vector<long double> right;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j)
            m[i][j] = k(p[i], p[j]) + (i == j ? 0.02 : 0);
        right.push_back(k(p[i], Place{}));
    }
    const auto solution = solved(m, right);
    for (std::size_t j = 0; j < n; ++j)
        w[j] = double(solution[j]);
    return w;
}

/// 13.4 and 13.5: bands over one set of nodes.
class Bands
{
public:
    /// \param steps  of the levels
    Bands(std::vector<Node> nodes, const std::vector<Place> &places, std::vector<double> steps, double ridge,
          Residuals &residuals)
        : mNodes(std::move(nodes))
        , mSteps(std::move(steps))
        , mRidge(ridge)
        , mActivity(mNodes.size(), 0)
        , mNearby(mNodes.size(), 0)
        , mResiduals(residuals)
    {
        for (std::size_t i = 0; i < mNodes.size(); ++i)
            mPrior.push_back(priorWeights(mNodes[i], places[i], places));
        mWeights = mPrior;
    }

    const std::vector<double> &next(Range &in)
    {
        const std::size_t band = mValues.size();
        if (band == mNextLesson)
            learn();
        mValues.emplace_back(mNodes.size());
        mMagnitudes.emplace_back(mNodes.size());
        for (std::size_t i = 0; i < mNodes.size(); ++i) {
            const Node &node = mNodes[i];
            double predicted = 0;
            for (std::size_t j = 0; j < node.known.size(); ++j)
                predicted += mWeights[i][j] * mValues[band][node.known[j]];
            const std::int64_t residual = decode(in, i, band);
            mValues[band][i] = predicted + double(residual) * mSteps[node.level];
            mMagnitudes[band][i] = sizeOfResidual(residual);
            mAll += (256 * std::int64_t(mMagnitudes[band][i]) - mAll) >> 6;
        }
        for (std::size_t i = 0; i < mNodes.size(); ++i) {
            const std::uint64_t now = 16 * mMagnitudes[band][i];
            mActivity[i] = band == 0 ? now : (5 * mActivity[i] + 3 * now) / 8;
        }
        for (std::size_t i = 0; i < mNodes.size(); ++i) {
            std::uint64_t sum = 0, count = 0;
            for (; count < mNodes[i].adjacent.size() && count < 32; ++count)
                sum += mActivity[mNodes[i].adjacent[count]];
            mNearby[i] = count ? sum / count : 0;
        }
        return mValues[band];
    }

private:
    std::int64_t decode(Range &in, std::size_t i, std::size_t band)
    {
        static constexpr std::uint64_t Shares[8] = {4, 4, 3, 3, 2, 2, 2, 2};
        const Node &node = mNodes[i];
        std::uint64_t sum = 0, shares = 0;
        for (std::size_t j = 0; j < node.known.size() && j < 8; ++j) {
            sum += Shares[j] * mMagnitudes[band][node.known[j]];
            shares += Shares[j];
        }
        const std::uint64_t around = shares ? sum * 16 / shares : 24;
        const std::uint64_t before = mActivity[i], nearby = mNearby[i], all = std::uint64_t(mAll);
        const std::uint64_t expected =
            (35 * around + 25 * before + 25 * nearby + 15 * std::min<std::uint64_t>(all, 1000)) / 100;
        const std::uint64_t last = band > 0 ? mMagnitudes[band - 1][i] : 1;
        const std::uint64_t second = band > 1 ? mMagnitudes[band - 2][i] : last;
        const std::uint64_t set = std::min<std::uint64_t>(19, classOf(std::min<std::uint64_t>(expected, 1000)));
        return mResiduals.decode(
            in,
            {capped(around) * 24 + capped(before),
             classOf(std::min<std::uint64_t>(2 * expected, 3000)) * 24 + std::min(node.level, 23u),
             std::min<std::uint64_t>(band, 63) * 24 + capped(expected), capped(before) * 24 + capped(nearby),
             24 * capped(around) + 4 * std::min<std::uint64_t>(last, 5) + std::min<std::uint64_t>(second, 3),
             capped(around) * 24 + capped(all / 2)},
            set);
    }

    void learn()
    {
        const std::size_t b = mValues.size();
        for (std::size_t i = 0; i < mNodes.size(); ++i) {
            const auto &known = mNodes[i].known;
            const std::size_t n = known.size();
            if (n < 2)
                continue;
            // With a multiplier for the sum: an unknown more.
            std::vector<std::vector<long double>> m(n + 1, std::vector<long double>(n + 1, 0));
            std::vector<long double> right(n + 1, 0);
            for (std::size_t j = 0; j < n; ++j) {
                for (std::size_t l = 0; l < n; ++l)
                    for (std::size_t k = 0; k < b; ++k)
                        m[j][l] += (long double)mValues[k][known[j]] * mValues[k][known[l]];
                for (std::size_t k = 0; k < b; ++k)
                    right[j] += (long double)mValues[k][known[j]] * mValues[k][i];
                m[j][j] += double(b) * mRidge;
                right[j] += double(b) * mRidge * (long double)mPrior[i][j];
                m[j][n] = m[n][j] = 1;
                right[n] += mPrior[i][j];
            }
            const auto w = solved(m, right);
            for (std::size_t j = 0; j < n; ++j)
                mWeights[i][j] = double(w[j]);
        }
        mNextLesson = b + std::max<std::size_t>(2, b / 2);
    }

    const std::vector<Node> mNodes;
    const std::vector<double> mSteps;
    const double mRidge;
    std::vector<std::vector<double>> mPrior, mWeights;
    std::vector<std::vector<double>> mValues;            ///< [band][node]
    std::vector<std::vector<std::uint64_t>> mMagnitudes; ///< [band][node]
    std::vector<std::uint64_t> mActivity, mNearby;
    std::int64_t mAll = 64;
    std::size_t mNextLesson = 3;
    Residuals &mResiduals;
};

/// 13.7: numbers of clusters.
struct Labels
{
    explicit Labels(std::uint64_t clusters)
        : count(clusters)
    {
        while ((std::uint64_t(1) << bits) < clusters)
            ++bits;
        tree.resize(std::size_t(1) << bits);
    }
    std::uint64_t decode(Range &in)
    {
        std::size_t n = 1;
        for (unsigned i = 0; i < bits; ++i)
            n = 2 * n + in.bit(tree[n]);
        const std::uint64_t label = n - (std::size_t(1) << bits);
        if (label >= count)
            throw std::string("label");
        return label;
    }

    std::uint64_t count;
    unsigned bits = 0;
    std::vector<Model> tree;
};

/// The component of each node, numbered by their first nodes.
inline std::vector<std::size_t> componentsOf(const std::vector<Node> &nodes)
{
    std::vector<std::size_t> least(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
        least[i] = i;
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            for (const std::size_t other : nodes[i].adjacent)
                if (least[other] < least[i]) {
                    least[i] = least[other];
                    changed = true;
                }
    }
    std::map<std::size_t, std::size_t> numbers;
    for (std::size_t &component : least)
        component = numbers.emplace(component, numbers.size()).first->second;
    return least;
}

inline std::vector<Node> only(const std::vector<Node> &nodes, const std::vector<std::size_t> &members)
{
    std::map<std::size_t, std::size_t> numbers;
    for (const std::size_t node : members)
        numbers.emplace(node, numbers.size());
    std::vector<Node> result;
    for (const std::size_t member : members) {
        Node node = nodes[member];
        for (auto *list : {&node.known, &node.ring, &node.adjacent}) {
            std::vector<std::size_t> kept;
            for (const std::size_t other : *list)
                if (numbers.contains(other))
                    kept.push_back(numbers[other]);
            *list = kept;
        }
        result.push_back(node);
    }
    return result;
}

} // namespace tests::plain
