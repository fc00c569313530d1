// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/terrain/tools/paintmask.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace model::terrain {

namespace {

/// Within this part of the radius a brush is at full strength.
constexpr double Core = 0.6;

std::uint32_t cellsAlong(double side, double longer)
{
    return std::uint32_t(
        std::clamp(std::round(PaintMask::UsualCells * side / longer), 1.0, double(PaintMask::UsualCells)));
}

double distanceToSegment(Point2 p, Point2 a, Point2 b)
{
    const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    const double share = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0;
    return std::hypot(p.x - a.x - share * dx, p.y - a.y - share * dy);
}

} // namespace

PaintMask::PaintMask(const Rectangle &domain, std::uint32_t columns, std::uint32_t rows,
                     std::vector<std::uint8_t> values)
    : mDomain(domain)
    , mColumns(columns)
    , mRows(rows)
    , mCellX((domain.high.x - domain.low.x) / columns)
    , mCellY((domain.high.y - domain.low.y) / rows)
    , mValues(std::move(values))
{}

PaintMask::PaintMask(const Rectangle &domain)
    : PaintMask(domain,
                cellsAlong(domain.high.x - domain.low.x,
                           std::max(domain.high.x - domain.low.x, domain.high.y - domain.low.y)),
                cellsAlong(domain.high.y - domain.low.y,
                           std::max(domain.high.x - domain.low.x, domain.high.y - domain.low.y)),
                {})
{
    mValues.resize(std::size_t(mColumns) * mRows);
}

Result<PaintMask> PaintMask::restore(const Rectangle &domain, std::uint32_t columns, std::uint32_t rows,
                                     std::vector<std::uint8_t> values)
{
    for (const std::uint32_t count : {columns, rows})
        if (count < 1 || count > MostCells)
            return fail(ErrorCode::BadValue, "cells of the mask", std::to_string(count),
                        "1 ... " + std::to_string(MostCells));
    if (values.size() != std::size_t(columns) * rows)
        return fail(ErrorCode::BadValue, "values of the mask", std::to_string(values.size()),
                    std::to_string(std::size_t(columns) * rows));
    return PaintMask(domain, columns, rows, std::move(values));
}

bool PaintMask::isEmpty() const
{
    return std::all_of(mValues.begin(), mValues.end(), [](std::uint8_t value) { return value == 0; });
}

double PaintMask::at(Point2 p) const
{
    const double x = std::clamp((p.x - mDomain.low.x) / mCellX - 0.5, 0.0, double(mColumns - 1));
    const double y = std::clamp((p.y - mDomain.low.y) / mCellY - 0.5, 0.0, double(mRows - 1));
    const auto column = std::min(std::uint32_t(x), mColumns - 1), row = std::min(std::uint32_t(y), mRows - 1);
    const std::uint32_t right = std::min(column + 1, mColumns - 1), above = std::min(row + 1, mRows - 1);
    const auto value = [&](std::uint32_t c, std::uint32_t r) { return mValues[std::size_t(r) * mColumns + c] / 255.0; };
    const double u = x - column, v = y - row;
    return (1 - v) * ((1 - u) * value(column, row) + u * value(right, row)) +
           v * ((1 - u) * value(column, above) + u * value(right, above));
}

void PaintMask::paint(Point2 from, Point2 to, double radius, double strength, bool isOpening)
{
    if (!(radius > 0) || !(strength > 0))
        return;
    const auto cellOf = [](double metres, double low, double cell, std::uint32_t count) {
        return std::int64_t(std::clamp(std::floor((metres - low) / cell), -1.0, double(count)));
    };
    const std::int64_t left = cellOf(std::min(from.x, to.x) - radius, mDomain.low.x, mCellX, mColumns),
                       right = cellOf(std::max(from.x, to.x) + radius, mDomain.low.x, mCellX, mColumns),
                       low = cellOf(std::min(from.y, to.y) - radius, mDomain.low.y, mCellY, mRows),
                       high = cellOf(std::max(from.y, to.y) + radius, mDomain.low.y, mCellY, mRows);
    for (std::int64_t row = std::max<std::int64_t>(low, 0); row <= std::min<std::int64_t>(high, mRows - 1); ++row)
        for (std::int64_t column = std::max<std::int64_t>(left, 0);
             column <= std::min<std::int64_t>(right, mColumns - 1); ++column) {
            const Point2 p{mDomain.low.x + (double(column) + 0.5) * mCellX,
                           mDomain.low.y + (double(row) + 0.5) * mCellY};
            const double t = distanceToSegment(p, from, to) / radius;
            if (t >= 1)
                continue;
            const double weight = std::min(strength, 1.0) * std::clamp((1 - t) / (1 - Core), 0.0, 1.0);
            std::uint8_t &value = mValues[std::size_t(row) * mColumns + std::size_t(column)];
            const auto painted = std::uint8_t(std::lround(255 * weight));
            value = isOpening ? std::min<std::uint8_t>(value, std::uint8_t(255 - painted)) : std::max(value, painted);
        }
}

void PaintMask::invert()
{
    for (std::uint8_t &value : mValues)
        value = std::uint8_t(255 - value);
}

} // namespace model::terrain
