// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/normals.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace {

/// A wavy square of columns x rows vertices, row after row, as meshes of scans and characters mostly come.
void vertexNormals(benchmark::State &state)
{
    const auto columns = std::uint32_t(state.range(0)), rows = std::uint32_t(state.range(1));
    std::vector<model::Vec3f> positions;
    for (std::uint32_t y = 0; y < rows; ++y)
        for (std::uint32_t x = 0; x < columns; ++x)
            positions.push_back({float(x), float(y), std::sin(float(x) * 0.1f) * std::cos(float(y) * 0.07f) * 5});
    std::vector<model::Triangle> triangles;
    for (std::uint32_t y = 0; y + 1 < rows; ++y)
        for (std::uint32_t x = 0; x + 1 < columns; ++x) {
            const std::uint32_t a = y * columns + x;
            triangles.push_back({a, a + 1, a + columns});
            triangles.push_back({a + 1, a + columns + 1, a + columns});
        }
    std::vector<model::Vec3f> normals(positions.size());
    for (auto _ : state) {
        model::computeVertexNormals(positions, triangles, normals);
        benchmark::DoNotOptimize(normals.data());
    }
    state.SetLabel(std::to_string(positions.size()) + " vertices, " + std::to_string(triangles.size()) + " triangles");
}
BENCHMARK(vertexNormals)->Args({140, 250})->Unit(benchmark::kMillisecond); // 35k / 70k: at most 3 ms

} // namespace
