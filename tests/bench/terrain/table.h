// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/ids.h"
#include "model/terrain/tin/tin.h"

#include <algorithm>
#include <chrono>
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

/// Time on the wall, for what several threads do.
class WallClock
{
public:
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - mBegin).count(); }

private:
    std::chrono::steady_clock::time_point mBegin = std::chrono::steady_clock::now();
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

// The parts of the table. Each prints its rows.

/// Build, memory, insert, remove and locate, beside CGAL. Sizes above a million are only built.
void printTriangulation(std::size_t largest);
/// Stamps on TINs of several sizes, undo of one and of 200.
void printStamps(std::size_t largest);
/// Transfers on one thread and on two, the column until it rests, and how soon settling stops when it is cancelled.
void printSliding(std::size_t largest);
/// What is left of the volume after a stroke, and after 10,000 mixed edits with erosion.
void printBooks();
/// A trace along 80 % of the diagonal, on a TIN and on a regular grid.
void printTrace();
/// Saving and opening.
void printFiles(std::size_t largest);

/// Random points in the unit square, with heights of waves.
std::vector<Point3> randomPoints(std::size_t count, unsigned seed);

/// A cylinder of radius 0.1 and height 0.5 in the middle of a unit square of random vertices.
model::terrain::Tin column(std::size_t vertices);

/// Degrees.
double steepestFace(const model::terrain::Tin &tin);

} // namespace bench
