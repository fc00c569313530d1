// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/reel/coarsetofine.h"
#include "model/codec/reel/residualmodel.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace model::codec {

using Point = std::array<double, 3>;

/// What is expected of a node of the shape: the place, and the axes along which it may deviate.
struct ExpectedPlace
{
    Point place{};
    std::array<Point, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
};

/// Expects places of a surface from coarser ones: the mean of the ring, corrected by differences that tell how the
/// surface bends and how unevenly its vertices lie; what each is worth is learned as nodes pass. FORMAT.md 13.6.
class ShapePredictor
{
public:
    /// Keeps a view of `nodes`.
    explicit ShapePredictor(const CoarseToFine &nodes);

    /// Whether the node has a ring to make a surface of: if so axis 0 is its normal. Depends on connectivity alone.
    bool hasSurface(std::size_t node) const
    {
        return mNodes.ring[node].size() >= 3 && mNodes.known[node].size() > mNodes.ring[node].size();
    }
    /// \param places  of the nodes before
    ExpectedPlace expect(std::size_t node, const std::vector<Point> &places);
    /// Learns from the place of the node that expect() was asked about last.
    void learn(const Point &place);

private:
    static constexpr std::size_t Terms = 5;
    using Row = std::array<double, Terms>;

    Point expectOnSurface(std::size_t node, const std::vector<Point> &places);
    void solve();

    const CoarseToFine &mNodes;
    Row mShares{};
    std::array<Row, Terms> mProducts{};
    Row mTargets{};
    std::uint32_t mLessons = 0;
    // Of the node that was asked about last.
    bool mIsSurface = false;
    Point mMiddle{};
    std::array<Point, Terms> mTerms{};
    double mExtent = 1;
};

/// Codes the places of all nodes in steps of their level. `Residual` as in BandCoder, but with the axis (0 ... 2)
/// instead of the predicted value: what is asked for is the deviation from the expected place along that axis.
class ShapeCoder
{
public:
    static constexpr std::size_t Inputs = 4;
    static constexpr std::size_t Sets = 3;
    using Model = ResidualModel<Inputs, Sets>;

    /// \param levelRatio  as BandSettings
    ShapeCoder(const CoarseToFine &nodes, double levelRatio);

    /// \param residual  std::int32_t (Model &, const Model::Contexts &, std::size_t set, std::uint32_t node,
    ///                  const ExpectedPlace &, std::size_t axis, double step)
    /// \returns         false as soon as `goOn()` says so
    template <class Residual, class GoOn>
    bool codeAll(Residual &&residual, GoOn &&goOn)
    {
        for (std::size_t i = 0; i < mNodes.size(); ++i) {
            if (i % 1024 == 0 && !goOn())
                return false;
            const ExpectedPlace expected = mPredictor.expect(i, mPlaces);
            const double step = mLevelSteps[mNodes.levels[i]];
            Point place = expected.place;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::size_t kind = kindOf(i, axis);
                const std::int32_t q =
                    residual(mModel, contextsOf(i, axis, kind), kind, std::uint32_t(i), expected, axis, step);
                for (std::size_t c = 0; c < 3; ++c)
                    place[c] += expected.axes[axis][c] * (q * step);
                const std::uint32_t magnitude = std::min(std::uint32_t(std::abs(q)), MagnitudeLimit);
                mMagnitudes[i][axis] = std::uint16_t(magnitude);
                mRunning[kind] += (std::int32_t(std::min(magnitude, 1000u) * 256) - mRunning[kind]) >> 5;
            }
            mPlaces[i] = place;
            mPredictor.learn(place);
        }
        return true;
    }

    /// In steps.
    const std::vector<Point> &places() const { return mPlaces; }
    static std::uint64_t neededBytes(std::uint64_t nodes)
    {
        return nodes * (sizeof(Point) + 3 * sizeof(std::uint16_t)) + sizeof(ShapeCoder);
    }

private:
    static constexpr std::uint32_t MagnitudeLimit = 4000;
    static constexpr std::uint32_t Levels = 32;
    static constexpr std::uint32_t Unit = 16;

    /// 0 along the normal, 1 across it, 2 where there is no surface.
    std::size_t kindOf(std::size_t node, std::size_t axis) const
    {
        return !mPredictor.hasSurface(node) ? 2 : axis == 0 ? 0 : 1;
    }

    Model::Contexts contextsOf(std::size_t i, std::size_t axis, std::size_t kind) const
    {
        const auto known = mNodes.known[i];
        std::uint32_t sum = 0, shares = 0;
        for (std::size_t j = 0; j < std::min<std::size_t>(known.size(), 8); ++j) {
            const std::uint32_t share = j < 4 ? 2 : 1;
            const auto &m = mMagnitudes[known[j]];
            // In sixths, so that each kind is a mean of whole numbers.
            sum += share * (kind == 0 ? 6u * m[0] : kind == 1 ? 3u * (m[1] + m[2]) : 2u * (m[0] + m[1] + m[2]));
            shares += 6 * share;
        }
        const std::uint32_t around = cappedClass(shares ? sum * Unit / shares : 100);
        const auto &own = mMagnitudes[i];
        const std::uint32_t other = axis == 0 ? 0 : 1 + std::min(axis == 1 ? own[0] : (own[0] + own[1] + 1) / 2, 14);
        const std::uint32_t level =
            std::min<std::uint32_t>(std::uint32_t(mNodes.finest - mNodes.levels[i]), Levels - 1);
        const std::uint32_t ring =
            std::uint32_t(std::min<std::size_t>(std::max<std::size_t>(mNodes.ring[i].size(), 3) - 3, 7));
        const std::uint32_t k = std::uint32_t(kind);
        return {around * SizeClasses + 8 * k + ring, (k * Levels + level) * 4 + std::min(other, 3u),
                around * SizeClasses + cappedClass(std::uint32_t(mRunning[kind]) / 4), around * 16 + other};
    }

    const CoarseToFine &mNodes;
    const std::vector<double> mLevelSteps;
    ShapePredictor mPredictor;
    Model mModel;
    std::vector<Point> mPlaces;
    std::vector<std::array<std::uint16_t, 3>> mMagnitudes;
    std::array<std::int32_t, Sets> mRunning{64, 64, 64};
};

} // namespace model::codec
