// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/terrain/heightfield.h"

#include <algorithm>
#include <cmath>

namespace bench {

HeightField::HeightField(std::size_t side, double criticalDegrees)
    : mSide(side)
    , mSpacing(1.0 / double(side - 1))
    , mDrop(std::tan(criticalDegrees * M_PI / 180) * mSpacing)
    , mHeights(side * side)
    , mIsAwake(side)
{}

double HeightField::heightAt(double x, double y) const
{
    const double u = x / mSpacing, v = y / mSpacing;
    const std::size_t i = std::min(std::size_t(u), mSide - 2), j = std::min(std::size_t(v), mSide - 2);
    const double s = u - double(i), t = v - double(j);
    return (1 - t) * ((1 - s) * at(i, j) + s * at(i + 1, j)) + t * ((1 - s) * at(i, j + 1) + s * at(i + 1, j + 1));
}

void HeightField::press(double x, double y, double radius, double depth)
{
    const double outer = 1.5 * radius;
    const auto low = [&](double at) { return std::size_t(std::max(0.0, std::ceil((at - outer) / mSpacing))); };
    const auto high = [&](double at) { return std::min(mSide - 1, std::size_t((at + outer) / mSpacing)); };
    double dug = 0;
    std::size_t rim = 0;
    for (int pass = 0; pass < 2; ++pass)
        for (std::size_t j = low(y); j <= high(y); ++j)
            for (std::size_t i = low(x); i <= high(x); ++i) {
                const double distance = std::hypot(double(i) * mSpacing - x, double(j) * mSpacing - y);
                if (distance > outer)
                    continue;
                mIsAwake[j] = 1;
                if (pass == 0 && distance < radius) {
                    const double floor = -depth * std::sqrt(1 - distance * distance / (radius * radius));
                    dug += std::max(0.0, at(i, j) - floor);
                    at(i, j) = std::min(at(i, j), floor);
                } else if (pass == 0) {
                    ++rim;
                } else if (distance >= radius) {
                    at(i, j) += dug / double(rim);
                }
            }
}

std::uint64_t HeightField::slide(std::size_t from, std::size_t to)
{
    double &a = mHeights[from], &b = mHeights[to];
    const double difference = a - b;
    if (std::abs(difference) <= mDrop * 1.002)
        return 0;
    const double half = 0.5 * (std::abs(difference) - mDrop);
    a -= difference > 0 ? half : -half;
    b += difference > 0 ? half : -half;
    return 1;
}

std::uint64_t HeightField::settle()
{
    std::uint64_t transfers = 0, last = 1;
    while (last > 0) {
        last = 0;
        for (std::size_t j = 0; j < mSide; ++j) {
            if (!mIsAwake[j])
                continue;
            std::uint64_t inRow = 0;
            for (std::size_t i = 0; i < mSide; ++i) {
                if (i + 1 < mSide)
                    inRow += slide(j * mSide + i, j * mSide + i + 1);
                if (j + 1 < mSide)
                    inRow += slide(j * mSide + i, (j + 1) * mSide + i);
            }
            mIsAwake[j] = inRow > 0;
            if (inRow > 0) {
                if (j > 0)
                    mIsAwake[j - 1] = 1;
                if (j + 1 < mSide)
                    mIsAwake[j + 1] = 1;
            }
            last += inRow;
        }
        transfers += last;
    }
    return transfers;
}

double HeightField::volume() const
{
    double sum = 0;
    for (std::size_t j = 0; j < mSide; ++j)
        for (std::size_t i = 0; i < mSide; ++i)
            sum += at(i, j) * (i == 0 || i + 1 == mSide ? 0.5 : 1) * (j == 0 || j + 1 == mSide ? 0.5 : 1);
    return sum * mSpacing * mSpacing;
}

} // namespace bench
