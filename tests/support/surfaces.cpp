// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/surfaces.h"

#include "tests/support/meshes.h"

#include <algorithm>
#include <numeric>
#include <random>

using model::Connectivity;
using model::Triangle;

namespace tests {

Connectivity sheet(std::uint32_t columns, std::uint32_t rows, Closing across, Closing along)
{
    const std::uint32_t width = across == Closing::Open ? columns + 1 : columns;
    const std::uint32_t height = along == Closing::Open ? rows + 1 : rows;
    const auto at = [&](std::uint32_t column, std::uint32_t row) {
        if (column >= width) {
            column -= width;
            if (across == Closing::Twisted)
                row = rows - row;
        }
        if (row >= height)
            row -= height;
        return row * width + column;
    };
    Connectivity mesh;
    mesh.vertexCount = width * height;
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t column = 0; column < columns; ++column) {
            mesh.triangles.push_back({at(column, row), at(column + 1, row), at(column + 1, row + 1)});
            mesh.triangles.push_back({at(column, row), at(column + 1, row + 1), at(column, row + 1)});
        }
    return mesh;
}

Connectivity without(const Connectivity &mesh, const std::vector<std::uint32_t> &triangles)
{
    Connectivity result{mesh.vertexCount, {}};
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        if (std::find(triangles.begin(), triangles.end(), t) == triangles.end())
            result.triangles.push_back(mesh.triangles[t]);
    return result;
}

Connectivity withRandomHoles(const Connectivity &mesh, std::uint32_t oneOf, std::uint32_t seed)
{
    std::mt19937 random(seed);
    Connectivity result{mesh.vertexCount, {}};
    for (const Triangle &t : mesh.triangles)
        if (random() % oneOf > 0)
            result.triangles.push_back(t);
    return result;
}

Connectivity together(const Connectivity &a, const Connectivity &b)
{
    Connectivity result = a;
    result.vertexCount += b.vertexCount;
    for (const Triangle &t : b.triangles)
        result.triangles.push_back({t[0] + a.vertexCount, t[1] + a.vertexCount, t[2] + a.vertexCount});
    return result;
}

Connectivity connectedSum(const Connectivity &a, std::uint32_t triangleOfA, const Connectivity &b,
                          std::uint32_t triangleOfB)
{
    Connectivity result = together(without(a, {triangleOfA}), without(b, {triangleOfB}));
    // The triangle of b lies on that of a turned over.
    const Triangle ta = a.triangles[triangleOfA], tb = b.triangles[triangleOfB];
    std::vector<std::uint32_t> names(result.vertexCount);
    std::iota(names.begin(), names.end(), 0u);
    for (unsigned i = 0; i < 3; ++i)
        names[a.vertexCount + tb[i]] = ta[(3 - i) % 3];
    result.triangles = renamed(result.triangles, names);
    return result;
}

Connectivity shuffled(const Connectivity &mesh, std::uint32_t seed)
{
    std::mt19937 random(seed);
    Connectivity result = mesh;
    for (std::size_t i = result.triangles.size(); i > 1; --i)
        std::swap(result.triangles[i - 1], result.triangles[random() % i]);
    for (Triangle &t : result.triangles)
        std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    return result;
}

Connectivity soup(std::uint32_t vertices, std::uint32_t triangles, std::uint32_t seed)
{
    std::mt19937 random(seed);
    Connectivity result{vertices, {}};
    const auto any = [&] { return std::uint32_t(random() % vertices); };
    for (std::uint32_t t = 0; t < triangles; ++t)
        result.triangles.push_back({any(), any(), any()});
    return result;
}

Connectivity spiral(std::uint32_t triangles, std::uint32_t columns)
{
    Connectivity result{triangles + columns + 2, {}};
    for (std::uint32_t i = 0; result.triangles.size() + 1 < triangles; ++i) {
        result.triangles.push_back({i, i + 1, i + columns});
        result.triangles.push_back({i + 1, i + columns + 1, i + columns});
    }
    return result;
}

std::vector<Triangle> canonical(std::vector<Triangle> triangles)
{
    for (Triangle &t : triangles) {
        Triangle best = t;
        for (int i = 0; i < 2; ++i) {
            std::rotate(t.begin(), t.begin() + 1, t.end());
            best = std::min(best, t);
        }
        t = best;
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

std::vector<Triangle> renamed(std::vector<Triangle> triangles, const std::vector<std::uint32_t> &names)
{
    for (Triangle &t : triangles)
        for (std::uint32_t &v : t)
            v = names[v];
    return triangles;
}

const std::vector<NamedSurface> &namedSurfaces()
{
    static const std::vector<NamedSurface> surfaces = [] {
        std::vector<NamedSurface> all;
        for (const NamedMesh &named : namedMeshes())
            all.push_back({named.name, named.mesh.connectivity, {}});
        using Facts = NamedSurface::Facts;
        const auto closedSheet = [](std::uint32_t n) { return sheet(n, n, Closing::Closed, Closing::Closed); };
        const Connectivity ball = tetrahedron().connectivity;
        all.push_back({"sheet", sheet(9, 7), Facts{1, 1, 0}});
        all.push_back({"annulus", sheet(12, 3, Closing::Closed), Facts{1, 2, 0}});
        all.push_back({"annulus in a plane", without(sheet(9, 9), {80, 81, 82, 83, 62, 63}), Facts{1, 2, 0}});
        all.push_back({"closed sheet", closedSheet(7), Facts{1, 0, 1}});
        const Connectivity two = connectedSum(closedSheet(6), 3, closedSheet(7), 40);
        all.push_back({"genus 2", two, Facts{1, 0, 2}});
        Connectivity nine = two;
        for (std::uint32_t i = 0; i < 7; ++i)
            nine = connectedSum(nine, 20 + 11 * i, closedSheet(5 + i), i);
        all.push_back({"genus 9", nine, Facts{1, 0, 9}});
        all.push_back({"genus 9, shuffled", shuffled(nine), Facts{1, 0, 9}});
        all.push_back({"genus 9 with 2 holes", without(nine, {50, 200}), Facts{1, 2, 9}});
        all.push_back({"a hole of two triangles", without(sheet(6, 6), {28, 31}), Facts{1, 2, 0}});
        all.push_back({"many holes", withRandomHoles(sheet(30, 30), 6), {}});
        all.push_back({"many holes and handles", withRandomHoles(nine, 5, 2), {}});
        all.push_back({"mostly holes", withRandomHoles(sheet(30, 30), 2), {}});
        all.push_back({"three parts", together(together(nine, sheet(3, 3)), ball), Facts{3, 1, 9}});
        Connectivity parts = ball;
        for (std::uint32_t i = 0; i < 40; ++i)
            parts = together(parts, i % 3 == 0 ? ball : i % 3 == 1 ? sheet(1, 1) : oneTriangle().connectivity);
        all.push_back({"41 parts", parts, Facts{41, 26, 0}});
        all.push_back({"two triangles back to back", {3, {{0, 1, 2}, {0, 2, 1}}}, Facts{1, 0, 0}});
        all.push_back({"two triangles at two edges", {4, {{0, 1, 2}, {0, 2, 1}, {0, 1, 3}}}, {}});
        all.push_back({"one triangle three times", {3, {{0, 1, 2}, {1, 2, 0}, {0, 1, 2}}}, {}});
        all.push_back({"Moebius strip", sheet(15, 3, Closing::Twisted), {}});
        all.push_back({"Klein bottle", sheet(9, 9, Closing::Twisted, Closing::Closed), {}});
        all.push_back({"projective plane",
                       {6,
                        {{0, 1, 2},
                         {0, 2, 3},
                         {0, 3, 4},
                         {0, 4, 5},
                         {0, 5, 1},
                         {1, 2, 4},
                         {2, 3, 5},
                         {3, 4, 1},
                         {4, 5, 2},
                         {5, 1, 3}}},
                       {}});
        Connectivity turned = closedSheet(8);
        for (std::size_t t = 0; t < turned.triangles.size(); t += 1 + t % 3)
            std::swap(turned.triangles[t][0], turned.triangles[t][2]);
        all.push_back({"closed sheet with turned triangles", turned, {}});
        Connectivity isolated = together(Connectivity{5, {}}, closedSheet(4));
        isolated.vertexCount += 3;
        all.push_back({"isolated vertices", isolated, {}});
        Connectivity wheel{1001, {}};
        for (std::uint32_t i = 1; i <= 1000; ++i)
            wheel.triangles.push_back({0, i, i % 1000 + 1});
        all.push_back({"wheel", wheel, Facts{1, 1, 0}});
        Connectivity book{101, {}};
        for (std::uint32_t i = 2; i < 101; ++i)
            book.triangles.push_back(i % 3 > 0 ? Triangle{0, 1, i} : Triangle{1, 0, i});
        all.push_back({"book", book, {}});
        all.push_back({"spiral", spiral(400, 12), {}});
        for (std::uint32_t seed = 0; seed < 6; ++seed)
            all.push_back({"soup " + std::to_string(seed), soup(5 + 7 * seed, 60 + 20 * seed, seed), {}});
        return all;
    }();
    return surfaces;
}

} // namespace tests
