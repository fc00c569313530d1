// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/tinedit.h"

#include <random>
#include <vector>

namespace tests {

/// How the points of a test lie: what is hard about each is in makePoints().
enum class Ground { Random, Grid, FineGrid, Lines, Clusters, Circles, Far };
inline constexpr Ground EveryGround[] = {Ground::Random,   Ground::Grid,    Ground::FineGrid, Ground::Lines,
                                         Ground::Clusters, Ground::Circles, Ground::Far};
const char *nameOf(Ground ground);

/// The domain and points of a kind, always the same for the same seed.
class PointSource
{
public:
    PointSource(Ground ground, unsigned seed);
    const model::terrain::Rectangle &domain() const { return mDomain; }
    model::terrain::Point2 point();
    std::vector<model::terrain::Point3> points(std::size_t count);
    double uniform(double low, double high) { return low + (high - low) * unit(); }
    std::uint32_t below(std::uint32_t count) { return std::uint32_t(mRandom() % count); }

private:
    double unit() { return double(mRandom() >> 11) * 0x1p-53; }

    Ground mGround;
    std::mt19937_64 mRandom;
    model::terrain::Rectangle mDomain;
};

/// One random change: a vertex put in or taken out, a line constrained or released, a height set.
void randomStep(model::terrain::TinEdit &edit, PointSource &source);

/// One random change of layers or what lies in them; of the number of layers, if asked, one time in ten.
void randomLayerStep(model::terrain::TinEdit &edit, PointSource &source, bool changesCount);

} // namespace tests
