// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bench {

/// The regular grid that terrains on triangles are compared with: N x N heights over the unit square, material that
/// slides along the edges to the four neighbours where they are steeper than the critical angle.
class HeightField
{
public:
    HeightField(std::size_t side, double criticalDegrees);

    std::size_t side() const { return mSide; }
    double spacing() const { return mSpacing; }
    double at(std::size_t column, std::size_t row) const { return mHeights[row * mSide + column]; }
    double &at(std::size_t column, std::size_t row) { return mHeights[row * mSide + column]; }
    /// Bilinear, 0 <= x, y <= 1.
    double heightAt(double x, double y) const;

    /// Presses a ball of `radius` into the ground, `depth` deep, and heaps what it displaced evenly into a rim of
    /// half its radius. Wakes what it touched.
    void press(double x, double y, double radius, double depth);

    /// Moves material until no edge is steeper than the critical angle by more than 0.05 degrees. Returns the number of
    /// transfers. Rows that rest are left out.
    std::uint64_t settle();

    double volume() const;
    std::size_t byteSize() const { return mHeights.capacity() * sizeof(double) + mIsAwake.capacity(); }

private:
    std::uint64_t slide(std::size_t from, std::size_t to);

    std::size_t mSide;
    double mSpacing, mDrop;
    std::vector<double> mHeights;
    std::vector<std::uint8_t> mIsAwake; ///< each row
};

} // namespace bench
