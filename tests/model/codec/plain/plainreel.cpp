// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/codec/plain/plainreel.h"

#include "tests/model/codec/plain/plainconnectivity.h"
#include "tests/model/codec/plain/plainmixing.h"
#include "tests/model/codec/plain/plainnodes.h"

#include <cmath>

namespace tests {

namespace {

using namespace plain;
using Place = std::array<double, 3>;

// 13.3
std::uint64_t classOf(std::uint64_t x)
{
    if (x < 4)
        return x;
    const unsigned t = bits(x) - 1;
    return 2 * t + (x >> (t - 1)) % 2;
}
std::uint64_t capped(std::uint64_t x)
{
    return classOf(std::min<std::uint64_t>(x, 2000));
}
std::uint64_t sizeOfResidual(std::int64_t r)
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
std::vector<double> stepsOf(const std::vector<Node> &nodes, double ratio)
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
std::vector<long double> solved(std::vector<std::vector<long double>> m, std::vector<long double> x)
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
std::vector<double> priorWeights(const Node &node, const Place &at, const std::vector<Place> &places)
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
std::vector<std::size_t> componentsOf(const std::vector<Node> &nodes)
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

std::vector<Node> only(const std::vector<Node> &nodes, const std::vector<std::size_t> &members)
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

// 13.6, each operation as it stands there
Place plus(const Place &a, const Place &b)
{
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Place minus(const Place &a, const Place &b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Place times(const Place &a, double s)
{
    return {a[0] * s, a[1] * s, a[2] * s};
}
double dot(const Place &a, const Place &b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Place leastDirection(double m[3][3])
{
    double v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int round = 0; round < 6; ++round)
        for (const auto &[p, q] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
            if (m[p][q] == 0)
                continue;
            const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
            const double t = (theta >= 0 ? 1 : -1) / (std::fabs(theta) + std::sqrt(theta * theta + 1));
            const double c = 1 / std::sqrt(t * t + 1), s = t * c;
            for (int k = 0; k < 3; ++k) {
                const double a = m[k][p], b = m[k][q];
                m[k][p] = c * a - s * b;
                m[k][q] = s * a + c * b;
            }
            for (int k = 0; k < 3; ++k) {
                const double a = m[p][k], b = m[q][k];
                m[p][k] = c * a - s * b;
                m[q][k] = s * a + c * b;
                const double e = v[k][p], f = v[k][q];
                v[k][p] = c * e - s * f;
                v[k][q] = s * e + c * f;
            }
        }
    int least = 0;
    for (int k = 1; k < 3; ++k)
        if (m[k][k] < m[least][least])
            least = k;
    return {v[0][least], v[1][least], v[2][least]};
}

class Shape
{
public:
    Shape(const std::vector<Node> &nodes, double ratio)
        : mNodes(nodes)
        , mSteps(stepsOf(nodes, ratio))
    {}

    std::vector<Place> decode(Range &in)
    {
        for (std::size_t i = 0; i < mNodes.size(); ++i) {
            expect(i);
            std::array<std::uint64_t, 3> own{};
            Place place = mExpected;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::int64_t residual = residualOf(in, i, axis, own);
                own[axis] = sizeOfResidual(residual);
                for (std::size_t c = 0; c < 3; ++c)
                    place[c] += mAxes[axis][c] * (double(residual) * mSteps[mNodes[i].level]);
            }
            mPlaces.push_back(place);
            mMagnitudes.push_back(own);
            if (hasSurface(i))
                learn(place);
        }
        return mPlaces;
    }

private:
    bool hasSurface(std::size_t i) const
    {
        return mNodes[i].ring.size() >= 3 && mNodes[i].known.size() > mNodes[i].ring.size();
    }

    std::int64_t residualOf(Range &in, std::size_t i, std::size_t axis, const std::array<std::uint64_t, 3> &own)
    {
        const Node &node = mNodes[i];
        const std::uint64_t kind = !hasSurface(i) ? 2 : axis == 0 ? 0 : 1;
        std::uint64_t sum = 0, shares = 0;
        for (std::size_t j = 0; j < node.known.size() && j < 8; ++j) {
            const auto &m = mMagnitudes[node.known[j]];
            const std::uint64_t x = kind == 0 ? 6 * m[0] : kind == 1 ? 3 * (m[1] + m[2]) : 2 * (m[0] + m[1] + m[2]);
            sum += x * (j < 4 ? 2 : 1);
            shares += j < 4 ? 2 : 1;
        }
        const std::uint64_t around = capped(shares ? sum * 16 / (6 * shares) : 100);
        const std::uint64_t fourteen = 14;
        const std::uint64_t other = axis == 0   ? 0
                                    : axis == 1 ? 1 + std::min(own[0], fourteen)
                                                : 1 + std::min((own[0] + own[1] + 1) / 2, fourteen);
        const std::uint64_t ring = std::min<std::uint64_t>(std::max<std::uint64_t>(node.ring.size(), 3) - 3, 7);
        const std::uint64_t level = std::min<std::uint64_t>(mSteps.size() - 1 - node.level, 31);
        const std::int64_t residual = mResiduals.decode(
            in,
            {24 * around + 8 * kind + ring, (32 * kind + level) * 4 + std::min<std::uint64_t>(other, 3),
             24 * around + capped(std::uint64_t(mRunning[kind]) / 4), 16 * around + other},
            kind);
        const std::int64_t m = std::int64_t(std::min<std::uint64_t>(sizeOfResidual(residual), 1000));
        mRunning[kind] += (256 * m - mRunning[kind]) >> 5;
        return residual;
    }

    Place meanOf(const std::vector<std::size_t> &nodes) const
    {
        Place sum{};
        for (const std::size_t u : nodes)
            sum = plus(sum, mPlaces[u]);
        return times(sum, 1 / double(nodes.size()));
    }

    void expect(std::size_t i)
    {
        const Node &node = mNodes[i];
        mExpected = {};
        mAxes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
        if (!node.ring.empty())
            mExpected = meanOf(node.ring);
        else if (!node.known.empty())
            mExpected = mPlaces[node.known[0]];
        if (!hasSurface(i))
            return;
        mMean = mExpected;
        double covariance[3][3] = {};
        for (const std::size_t u : node.ring) {
            const Place d = minus(mPlaces[u], mMean);
            for (std::size_t r = 0; r < 3; ++r)
                for (std::size_t c = 0; c < 3; ++c)
                    covariance[r][c] += d[r] * d[c];
        }
        mExtent = std::sqrt((covariance[0][0] + covariance[1][1] + covariance[2][2]) / double(node.ring.size())) + 1;
        setTerms(node);
        for (std::size_t t = 0; t < 5; ++t)
            mExpected = plus(mExpected, times(mTerms[t], mShares[t]));

        const Place normal = leastDirection(covariance), side = minus(mPlaces[node.ring[0]], mMean);
        Place tangent = minus(side, times(normal, dot(side, normal)));
        double length = std::sqrt(dot(tangent, tangent));
        if (!(length > 1e-6 * std::sqrt(dot(side, side)))) {
            std::size_t least = 0;
            for (std::size_t c = 1; c < 3; ++c)
                if (std::fabs(normal[c]) < std::fabs(normal[least]))
                    least = c;
            Place away{};
            away[least] = 1;
            tangent = minus(away, times(normal, dot(away, normal)));
            length = std::sqrt(dot(tangent, tangent));
        }
        tangent = times(tangent, 1 / length);
        mAxes = {normal, tangent,
                 Place{normal[1] * tangent[2] - normal[2] * tangent[1], normal[2] * tangent[0] - normal[0] * tangent[2],
                       normal[0] * tangent[1] - normal[1] * tangent[0]}};
    }

    void setTerms(const Node &node)
    {
        std::vector<std::size_t> beyond;
        for (const std::size_t u : node.known)
            if (std::find(node.ring.begin(), node.ring.end(), u) == node.ring.end())
                beyond.push_back(u);
        mTerms[0] = beyond.empty() ? Place{} : minus(mMean, meanOf(beyond));
        Place near{}, nearest{};
        double nearSum = 0, nearestSum = 0;
        for (std::size_t j = 0; j < node.ring.size(); ++j) {
            const double share = 1 / double(node.ringLengths[j]);
            near = plus(near, times(mPlaces[node.ring[j]], share));
            nearest = plus(nearest, times(mPlaces[node.ring[j]], share * share));
            nearSum += share;
            nearestSum += share * share;
        }
        mTerms[1] = minus(times(near, 1 / nearSum), mMean);
        mTerms[2] = minus(times(nearest, 1 / nearestSum), mMean);
        Place bulge{};
        double count = 0;
        for (const std::size_t u : node.ring)
            if (mNodes[u].ring.size() >= 3) {
                bulge = plus(bulge, minus(mPlaces[u], meanOf(mNodes[u].ring)));
                count += 1;
            }
        mTerms[3] = count > 0 ? times(bulge, 1 / count) : Place{};
        mTerms[4] = minus(mPlaces[node.known[0]], mMean);
    }

    void learn(const Place &place)
    {
        const Place target = times(minus(place, mMean), 1 / mExtent);
        for (std::size_t i = 0; i < 5; ++i) {
            const Place term = times(mTerms[i], 1 / mExtent);
            for (std::size_t j = 0; j < 5; ++j)
                mProducts[i][j] = 0.9991 * mProducts[i][j] + dot(term, times(mTerms[j], 1 / mExtent));
            mTargets[i] = 0.9991 * mTargets[i] + dot(term, target);
        }
        if (++mLessons % 48 != 0)
            return;
        std::vector<std::vector<long double>> m(5, std::vector<long double>(5));
        for (std::size_t i = 0; i < 5; ++i)
            for (std::size_t j = 0; j < 5; ++j)
                m[i][j] = mProducts[i][j] + (i == j ? 2 : 0);
        const auto shares = solved(m, std::vector<long double>(mTargets, mTargets + 5));
        for (std::size_t i = 0; i < 5; ++i)
            mShares[i] = double(shares[i]);
    }

    const std::vector<Node> &mNodes;
    const std::vector<double> mSteps;
    std::vector<Place> mPlaces;
    std::vector<std::array<std::uint64_t, 3>> mMagnitudes;
    std::int64_t mRunning[3] = {64, 64, 64};
    double mShares[5] = {}, mProducts[5][5] = {}, mTargets[5] = {};
    unsigned mLessons = 0;
    Place mExpected{}, mMean{};
    std::array<Place, 3> mAxes{};
    std::array<Place, 5> mTerms{};
    double mExtent = 1;
    Residuals mResiduals{4, 3};
};

// 13.1
double eighths(std::int64_t n)
{
    return std::pow(2.0L, (long double)n / 8);
}

float f32(Cursor &in)
{
    const std::uint32_t raw = std::uint32_t(in.fixed(4));
    float result;
    std::memcpy(&result, &raw, 4);
    return result;
}

void decode(const Data &file, PlainReel &anim)
{
    std::map<std::string, Data> chunks = chunksOf(file);
    const Head head = headOf(chunks.at("HEAD"), 4);
    const std::size_t vertices = anim.vertices = head.vertices, frames = anim.frames = head.frames;
    Cursor parameters{chunks.at("REEL")};
    parameters.f64();
    parameters.varuint();
    const double D = parameters.f64();
    const double shapeStep = D * (parameters.u8() + 1) / 32;
    const double meanStep = D * eighths(-std::int64_t(parameters.u8()));
    Place origin;
    for (double &x : origin)
        x = double(f32(parameters));
    const auto ratio = [&] { return (parameters.u8() + 1) / 256.0; };
    const double shapeRatio = ratio(), frameRatio = ratio(), vertexRatio = ratio();
    const std::uint64_t rank = anim.rank = parameters.varuint();

    const PlainConnectivity mesh = decodeConnectivityPlainly(chunks.at("CLRS"), head.vertices, head.triangles);
    anim.triangles = mesh.triangles;
    const auto nodes = vertexNodes(mesh.triangles, vertices);
    const auto times = frameNodes(frames);
    std::vector<Place> framePlaces;
    for (const Node &node : times)
        framePlaces.push_back({double(node.vertex), 0, 0});

    Range shapeIn(chunks.at("SHAP"));
    const std::vector<Place> places = Shape(nodes, shapeRatio).decode(shapeIn);
    Residuals meanResiduals{6, 20};
    Bands meanBands(times, framePlaces, stepsOf(times, frameRatio), 3, meanResiduals);
    std::vector<Place> means(frames);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto &values = meanBands.next(shapeIn);
        for (std::size_t i = 0; i < frames; ++i)
            means[times[i].vertex][axis] = origin[axis] + values[i] * meanStep;
    }
    shapeIn.end();

    anim.positions.assign(frames, std::vector<Place>(vertices));
    std::vector<std::vector<Place>> sizes(frames, std::vector<Place>(vertices));
    for (std::size_t f = 0; f < frames; ++f)
        for (std::size_t i = 0; i < vertices; ++i)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double rest = places[i][axis] * shapeStep / std::sqrt(double(frames));
                anim.positions[f][nodes[i].vertex][axis] = means[f][axis] + rest;
                sizes[f][nodes[i].vertex][axis] = std::fabs(means[f][axis]) + std::fabs(rest);
            }
    anim.step = std::max(shapeStep, meanStep);

    // 13.7
    std::vector<std::vector<std::size_t>> clusters(1);
    for (std::size_t i = 0; i < vertices; ++i)
        clusters[0].push_back(i);
    if (chunks.contains("PART")) {
        Range in(chunks.at("PART"));
        const std::uint64_t count = 1 + in.direct(6);
        Labels labels(count);
        std::vector<std::uint64_t> ofComponent;
        const auto components = componentsOf(nodes);
        clusters.assign(count, {});
        for (std::size_t i = 0; i < vertices; ++i)
            if (components[i] == ofComponent.size())
                ofComponent.push_back(labels.decode(in));
        for (std::size_t i = 0; i < vertices; ++i)
            clusters[ofComponent[components[i]]].push_back(i);
        in.end();
    }
    Range bandIn(chunks.at("BAND"));
    Residuals frameResiduals{6, 20}, vertexResiduals{6, 20};
    Bands frameBands(times, framePlaces, stepsOf(times, frameRatio), 3, frameResiduals);
    std::vector<Bands> vertexBands;
    for (const auto &members : clusters) {
        std::vector<Place> own;
        for (const std::size_t node : members)
            own.push_back(places[node]);
        vertexBands.emplace_back(only(nodes, members), own, stepsOf(nodes, vertexRatio), 0.5, vertexResiduals);
    }
    Labels labels(clusters.size());
    Integers exponents(5);
    std::int64_t e = 0;
    for (std::uint64_t k = 0; k < rank; ++k) {
        const std::uint64_t cluster = labels.decode(bandIn);
        e += exponents.decode(bandIn, k == 0 ? 0 : 1, 0);
        e = std::min<std::int64_t>(std::max<std::int64_t>(e, -4000), 4000);
        std::vector<Place> trajectory(frames);
        double largest = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto &values = frameBands.next(bandIn);
            for (std::size_t i = 0; i < frames; ++i) {
                trajectory[times[i].vertex][axis] = values[i] * eighths(e);
                largest = std::max(largest, std::fabs(values[i] * eighths(e)));
            }
        }
        anim.step = std::max(anim.step, largest * D);
        const auto &values = vertexBands[cluster].next(bandIn);
        for (std::size_t f = 0; f < frames; ++f)
            for (std::size_t i = 0; i < values.size(); ++i)
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const double part = trajectory[f][axis] * values[i] * D;
                    const std::size_t vertex = nodes[clusters[cluster][i]].vertex;
                    anim.positions[f][vertex][axis] += part;
                    sizes[f][vertex][axis] += std::fabs(part);
                }
    }
    bandIn.end();
    for (const auto &frame : sizes)
        for (const Place &place : frame)
            anim.size = std::max({anim.size, place[0], place[1], place[2]});
    if (!chunks.contains("ORDR"))
        return;
    const auto order = decodeOrderPlainly(chunks.at("ORDR"), mesh.neighbours);
    for (auto &triangle : anim.triangles)
        for (std::int64_t &v : triangle)
            v = order[std::size_t(v)];
    for (auto &frame : anim.positions) {
        const auto coded = frame;
        for (std::size_t v = 0; v < vertices; ++v)
            frame[std::size_t(order[v])] = coded[v];
    }
}

} // namespace

PlainReel decodeReelPlainly(const std::vector<std::uint8_t> &file)
{
    PlainReel anim;
    try {
        decode(file, anim);
    } catch (const std::string &error) {
        anim.error = error;
    } catch (const std::exception &error) {
        anim.error = error.what();
    }
    return anim;
}

} // namespace tests
