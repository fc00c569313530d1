// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/analysis/handles.h"
#include "tests/support/surfaces.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>

using namespace model;

namespace {

constexpr double Pi = std::numbers::pi;

/// The shortest of some runs, seconds: other work on the machine only ever adds.
double shortest(const std::function<void()> &work, int runs = 5)
{
    double best = 1e9;
    for (int i = 0; i < runs; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        work();
        best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    return best;
}

/// A row of tori, each joined to the next at a triangle: genus `genus`, about `triangles` triangles.
TriangleMesh chain(std::uint32_t genus, std::uint32_t triangles)
{
    const double perTorus = double(triangles) / genus / 2;
    const auto rows = std::uint32_t(std::sqrt(perTorus / 3)), columns = std::uint32_t(perTorus / rows);
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < genus; ++i) {
        const Connectivity torus = tests::sheet(columns, rows, tests::Closing::Closed, tests::Closing::Closed);
        mesh.connectivity =
            i == 0 ? torus
                   : tests::connectedSum(mesh.connectivity, std::uint32_t(mesh.connectivity.triangles.size()) - columns,
                                         torus, 5);
        for (std::uint32_t row = 0; row < rows; ++row)
            for (std::uint32_t column = 0; column < columns; ++column) {
                const double u = 2 * Pi * column / columns, v = 2 * Pi * row / rows, r = 3 + std::cos(v);
                mesh.positions.push_back({float(r * std::cos(u) + 8 * i), float(r * std::sin(u)), float(std::sin(v))});
            }
    }
    return mesh;
}

void analysis(const char *name, const TriangleMesh &mesh)
{
    const Faces faces(mesh.connectivity);
    const double seconds = shortest([&] { (void)analyseMesh(faces, mesh.positions); });
    std::printf("analysis  %-28s %8u triangles  %7.3f s\n", name, faces.faceCount(), seconds);
}

void handles(const char *name, const TriangleMesh &mesh)
{
    const Faces faces(mesh.connectivity);
    const auto report = analyseMesh(faces, mesh.positions);
    std::size_t count = 0;
    const double seconds = shortest([&] { count = findHandles(faces, mesh.positions, *report)->size(); }, 3);
    std::printf("handles   %-28s %8u triangles  %7.3f s  %zu handles\n", name, faces.faceCount(), seconds, count);
}

} // namespace

/// What large meshes take to inspect: at most 0.7 s for a million triangles, 3 s for the loops of 200 000 of genus 10.
int main()
{
    const TriangleMesh million = chain(1, 1'000'000);
    analysis("torus", million);
    TriangleMesh shuffled = million;
    shuffled.connectivity = tests::shuffled(million.connectivity);
    analysis("torus, triangles shuffled", shuffled);
    TriangleMesh holes = million;
    holes.connectivity = tests::withRandomHoles(million.connectivity, 20);
    analysis("torus with random holes", holes);
    handles("chain of 10 tori", chain(10, 200'000));
    handles("chain of 50 tori", chain(50, 200'000));
    handles("torus", million);
    return 0;
}
