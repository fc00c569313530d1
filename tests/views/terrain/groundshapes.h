// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/terraindocument.h"

#include <cmath>
#include <memory>
#include <random>

namespace tests {

/// A document over `domain` with a grid of `side` x `side` vertices, shaken a little, at heights `height(x, y)`.
template <class Height>
std::unique_ptr<model::TerrainDocument> groundDocument(const model::terrain::Rectangle &domain, int side, Height height)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> shake(-0.3, 0.3);
    std::vector<model::terrain::Point3> points;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const bool isInside = i > 0 && j > 0 && i < side - 1 && j < side - 1;
            const double u = (i + (isInside ? shake(random) : 0)) / (side - 1);
            const double v = (j + (isInside ? shake(random) : 0)) / (side - 1);
            const double x = domain.low.x + u * (domain.high.x - domain.low.x);
            const double y = domain.low.y + v * (domain.high.y - domain.low.y);
            points.push_back({x, y, height(x, y)});
        }
    auto built = model::terrain::buildTin(points, domain);
    return std::make_unique<model::TerrainDocument>(model::terrain::Terrain(std::move(built.value().tin)));
}

inline double dunes(double x, double y)
{
    return 0.06 * std::sin(7 * x) * std::cos(5 * y) + 0.03 * std::sin(13 * y + 3 * x);
}

inline constexpr model::terrain::Rectangle UnitSquare{{0, 0}, {1, 1}};

} // namespace tests
