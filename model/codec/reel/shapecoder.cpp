// SPDX-License-Identifier: GPL-3.0-or-later
// Based on:
// - I. Guskov, W. Sweldens, P. Schroeder: Multiresolution signal processing for meshes, 1999 (detail in local frames)
// - N. Dyn, D. Levin, J. Gregory: A butterfly subdivision scheme, 1990 (a stencil that knows of curvature)
// Differs: the stencil is learned; places need no parametrisation.
#include "model/codec/reel/shapecoder.h"

#include "model/codec/reel/bandcoder.h"

#include <algorithm>
#include <cmath>

namespace model::codec {

namespace {

// How much an older node still counts after each new one; what holds the shares at zero until much is known; nodes
// between two solutions.
constexpr double Memory = 0.9991;
constexpr double Ridge = 2;
constexpr std::uint32_t LessonsBetween = 48;
// Rounds of Jacobi's method: each squares the error of a 3 x 3 matrix.
constexpr int JacobiRounds = 6;

Point operator+(const Point &a, const Point &b)
{
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Point operator-(const Point &a, const Point &b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Point operator*(const Point &a, double s)
{
    return {a[0] * s, a[1] * s, a[2] * s};
}
double dot(const Point &a, const Point &b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Point cross(const Point &a, const Point &b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The direction in which points vary least: the eigenvector of the smallest eigenvalue of their covariance.
Point leastDirection(std::array<Point, 3> m)
{
    std::array<Point, 3> v{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (int round = 0; round < JacobiRounds; ++round)
        for (std::size_t p = 0; p < 2; ++p)
            for (std::size_t q = p + 1; q < 3; ++q) {
                if (m[p][q] == 0)
                    continue;
                const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
                const double t = (theta >= 0 ? 1 : -1) / (std::fabs(theta) + std::sqrt(theta * theta + 1));
                const double c = 1 / std::sqrt(t * t + 1), s = t * c;
                for (std::size_t k = 0; k < 3; ++k) {
                    const double a = m[k][p], b = m[k][q];
                    m[k][p] = c * a - s * b;
                    m[k][q] = s * a + c * b;
                }
                for (std::size_t k = 0; k < 3; ++k) {
                    const double a = m[p][k], b = m[q][k];
                    m[p][k] = c * a - s * b;
                    m[q][k] = s * a + c * b;
                    const double e = v[k][p], f = v[k][q];
                    v[k][p] = c * e - s * f;
                    v[k][q] = s * e + c * f;
                }
            }
    std::size_t least = 0;
    for (std::size_t k = 1; k < 3; ++k)
        if (m[k][k] < m[least][least])
            least = k;
    return {v[0][least], v[1][least], v[2][least]};
}

/// Axes of which the first is `normal`, of length 1, and the second points towards `side` as far as it can.
std::array<Point, 3> axesOf(const Point &normal, const Point &side)
{
    Point tangent = side - normal * dot(side, normal);
    double length = std::sqrt(dot(tangent, tangent));
    if (!(length > 1e-6 * std::sqrt(dot(side, side)))) { // also where `side` is zero
        // The coordinate axis that is farthest from the normal.
        std::size_t axis = 0;
        for (std::size_t c = 1; c < 3; ++c)
            if (std::fabs(normal[c]) < std::fabs(normal[axis]))
                axis = c;
        Point away{};
        away[axis] = 1;
        tangent = away - normal * dot(away, normal);
        length = std::sqrt(dot(tangent, tangent));
    }
    tangent = tangent * (1 / length);
    return {normal, tangent, cross(normal, tangent)};
}

} // namespace

ShapePredictor::ShapePredictor(const CoarseToFine &nodes)
    : mNodes(nodes)
{}

ExpectedPlace ShapePredictor::expect(std::size_t node, const std::vector<Point> &places)
{
    ExpectedPlace expected;
    mIsSurface = hasSurface(node);
    const auto ring = mNodes.ring[node];
    const auto known = mNodes.known[node];
    if (known.empty())
        return expected;
    mMiddle = {};
    for (const std::uint32_t u : ring)
        mMiddle = mMiddle + places[u];
    mMiddle = ring.empty() ? places[known[0]] : mMiddle * (1 / double(ring.size()));
    expected.place = mMiddle;
    if (!mIsSurface)
        return expected;

    std::array<Point, 3> covariance{};
    for (const std::uint32_t u : ring) {
        const Point d = places[u] - mMiddle;
        for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t c = 0; c < 3; ++c)
                covariance[r][c] += d[r] * d[c];
    }
    mExtent = std::sqrt((covariance[0][0] + covariance[1][1] + covariance[2][2]) / double(ring.size())) + 1;
    expected.place = expectOnSurface(node, places);
    expected.axes = axesOf(leastDirection(covariance), places[ring[0]] - mMiddle);
    return expected;
}

Point ShapePredictor::expectOnSurface(std::size_t node, const std::vector<Point> &places)
{
    const auto ring = mNodes.ring[node];
    const auto ringLengths = mNodes.ringLengths[node];
    const auto known = mNodes.known[node];
    // The ring weighted by lengths, their squares, and the nodes beyond the ring.
    Point near{}, nearest{}, beyond{};
    double nearSum = 0, nearestSum = 0, beyondCount = 0;
    for (std::size_t j = 0; j < ring.size(); ++j) {
        const double share = 1 / double(ringLengths[j]);
        near = near + places[ring[j]] * share;
        nearest = nearest + places[ring[j]] * (share * share);
        nearSum += share;
        nearestSum += share * share;
    }
    for (const std::uint32_t u : known)
        if (std::find(ring.begin(), ring.end(), u) == ring.end()) {
            beyond = beyond + places[u];
            beyondCount += 1;
        }
    // How far the ring's nodes stand out from their own rings.
    Point bulge{};
    double bulges = 0;
    for (const std::uint32_t u : ring) {
        const auto own = mNodes.ring[u];
        if (own.size() < 3)
            continue;
        Point mean{};
        for (const std::uint32_t w : own)
            mean = mean + places[w];
        bulge = bulge + (places[u] - mean * (1 / double(own.size())));
        bulges += 1;
    }
    mTerms = {beyondCount > 0 ? mMiddle - beyond * (1 / beyondCount) : Point{}, near * (1 / nearSum) - mMiddle,
              nearest * (1 / nearestSum) - mMiddle, bulges > 0 ? bulge * (1 / bulges) : Point{},
              places[known[0]] - mMiddle};
    Point place = mMiddle;
    for (std::size_t t = 0; t < Terms; ++t)
        place = place + mTerms[t] * mShares[t];
    return place;
}

void ShapePredictor::learn(const Point &place)
{
    if (!mIsSurface)
        return;
    const double scale = 1 / mExtent;
    const Point target = (place - mMiddle) * scale;
    for (Point &term : mTerms)
        term = term * scale;
    for (std::size_t i = 0; i < Terms; ++i) {
        for (std::size_t j = 0; j < Terms; ++j)
            mProducts[i][j] = Memory * mProducts[i][j] + dot(mTerms[i], mTerms[j]);
        mTargets[i] = Memory * mTargets[i] + dot(mTerms[i], target);
    }
    if (++mLessons % LessonsBetween == 0)
        solve();
}

void ShapePredictor::solve()
{
    std::array<Row, Terms> m = mProducts;
    Row x = mTargets;
    for (std::size_t i = 0; i < Terms; ++i)
        m[i][i] += Ridge;
    // Gauss without pivoting: the matrix is positive definite.
    for (std::size_t i = 0; i < Terms; ++i)
        for (std::size_t r = i + 1; r < Terms; ++r) {
            const double factor = m[r][i] / m[i][i];
            for (std::size_t c = i; c < Terms; ++c)
                m[r][c] -= factor * m[i][c];
            x[r] -= factor * x[i];
        }
    for (std::size_t i = Terms; i-- > 0;) {
        for (std::size_t c = i + 1; c < Terms; ++c)
            x[i] -= m[i][c] * x[c];
        x[i] /= m[i][i];
    }
    mShares = x;
}

ShapeCoder::ShapeCoder(const CoarseToFine &nodes, double levelRatio)
    : mNodes(nodes)
    , mLevelSteps(levelSteps(nodes.finest, levelRatio))
    , mPredictor(nodes)
    , mModel({SizeClasses * SizeClasses, 3 * Levels * 4, SizeClasses * SizeClasses, SizeClasses * 16})
    , mPlaces(nodes.size())
    , mMagnitudes(nodes.size())
{}

} // namespace model::codec
