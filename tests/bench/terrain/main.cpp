// SPDX-License-Identifier: GPL-3.0-or-later
// What the terrain's kernel takes, as one table: `sandreel-bench-terrain [largest size] [part ...]`. Without a size, up
// to six million vertices; without parts, all of them.
#include "tests/bench/terrain/table.h"

#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>

namespace bench {

std::vector<Point3> randomPoints(std::size_t count, unsigned seed)
{
    std::mt19937_64 random(seed);
    const auto unit = [&] { return double(random() >> 11) * 0x1p-53; };
    std::vector<Point3> points(count);
    for (Point3 &p : points) {
        p = {unit(), unit(), 0};
        p.z = std::sin(9 * p.x) * std::cos(7 * p.y);
    }
    return points;
}

} // namespace bench

int main(int argc, char **argv)
{
    std::size_t largest = 6000000;
    int first = 1;
    if (argc > 1 && std::isdigit(static_cast<unsigned char>(argv[1][0]))) {
        largest = std::strtoull(argv[1], nullptr, 10);
        first = 2;
    }
    const struct
    {
        std::string name;
        std::function<void()> print;
    } parts[] = {
        {"triangulation", [=] { bench::printTriangulation(largest); }},
        {"stamps", [=] { bench::printStamps(largest); }},
        {"sliding", [=] { bench::printSliding(largest); }},
        {"books", [] { bench::printBooks(); }},
        {"trace", [] { bench::printTrace(); }},
        {"files", [=] { bench::printFiles(largest); }},
    };
    const std::vector<std::string> wanted(argv + first, argv + argc);
    bool isKnown = true;
    for (const std::string &name : wanted)
        isKnown =
            isKnown && std::any_of(std::begin(parts), std::end(parts), [&](const auto &p) { return p.name == name; });
    if (!isKnown || largest < 1000) {
        std::fprintf(
            stderr,
            "usage: sandreel-bench-terrain [largest size] [triangulation|stamps|sliding|books|trace|files ...]\n");
        return 2;
    }
    for (const auto &part : parts)
        if (wanted.empty() || std::find(wanted.begin(), wanted.end(), part.name) != wanted.end())
            part.print();
    return 0;
}
