// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/model/codec/plain/plainbands.h"

namespace tests::plain {

// 13.6, each operation as it stands there
inline Place plus(const Place &a, const Place &b)
{
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Place minus(const Place &a, const Place &b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Place times(const Place &a, double s)
{
    return {a[0] * s, a[1] * s, a[2] * s};
}
inline double dot(const Place &a, const Place &b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Place leastDirection(double m[3][3])
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

} // namespace tests::plain
