// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/ids.h"

#include <algorithm>
#include <ctime>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace bench {

using model::terrain::Point2;
using model::terrain::Point3;

/// Processor time: what neighbours on the machine take does not count.
class Stopwatch
{
public:
    double seconds() const
    {
        timespec now;
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
        return double(now.tv_sec - mBegin.tv_sec) + 1e-9 * double(now.tv_nsec - mBegin.tv_nsec);
    }

private:
    static timespec begin()
    {
        timespec now;
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
        return now;
    }
    timespec mBegin = begin();
};

/// The smallest of many times.
struct Fastest
{
    double seconds = std::numeric_limits<double>::infinity();
    void add(double s) { seconds = std::min(seconds, s); }
};

/// CGAL's Constrained_Delaunay_triangulation_2 of the same points. Behind a wall, because CGAL wants compiler flags of
/// its own. Each function does a batch, and returns the seconds it took.
class CgalTriangulation
{
public:
    CgalTriangulation();
    ~CgalTriangulation();

    /// All points at once: CGAL sorts them along a Hilbert curve first.
    double build(std::span<const Point3> points);
    /// Finds a vertex near each point, for the others to begin at.
    void findHints(std::span<const Point3> points);
    double insert(std::span<const Point3> points);
    /// What insert() put in, in that order.
    double remove();
    double locate(std::span<const Point3> points) const;

private:
    struct Data;
    std::unique_ptr<Data> mData;
};

/// What 200 strokes, and stamps on TINs of several sizes, take; prints a table.
void benchStamps(std::size_t largest);

/// Random points in the unit square, with heights of waves.
std::vector<Point3> randomPoints(std::size_t count, unsigned seed);

} // namespace bench
