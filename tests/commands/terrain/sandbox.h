// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/terrain/terraincontext.h"
#include "model/terrain/tin/validate.h"

#include <QTest>

#include <cmath>
#include <random>

namespace tests {

using namespace model::terrain;

/// How high the sandbox is, where it has a vertex.
inline double sandboxHeight(Point2 p)
{
    return 1 + 0.1 * std::sin(9 * p.x) * std::cos(7 * p.y);
}

/// A wavy square of sand on rock, with a second material that no layer is made of.
inline Terrain sandbox(std::size_t count = 800, unsigned seed = 3)
{
    std::mt19937_64 random(seed);
    const auto unit = [&] { return double(random() >> 11) * 0x1p-53; };
    std::vector<Point3> points(count);
    for (Point3 &p : points) {
        p = {unit(), unit(), 0};
        p.z = sandboxHeight({p.x, p.y});
    }
    Terrain terrain(std::move(buildTin(points, {{0, 0}, {1, 1}})->tin));
    terrain.materials = {material(MaterialPreset::DrySand), material(MaterialPreset::Gravel)};
    TinEdit edit(terrain.tin);
    edit.addLayer(0, 0);
    for (VertexId v = 0; v < terrain.tin.vertexCount(); ++v)
        edit.setLayer(v, 0, {0.5, 0.1f});
    edit.commit();
    return terrain;
}

/// Everything that has to be as before after an undo: what is saved, and every byte of the surface.
struct State
{
    std::uint64_t saved = 0, bytes = 0;

    explicit State(const model::TerrainDocument &document)
        : saved(document.fingerprint())
        , bytes(document.terrain().fingerprint())
    {}
    friend bool operator==(const State &, const State &) = default;
};

inline bool isValid(const model::TerrainDocument &document)
{
    const auto valid = validate(document.terrain());
    if (!valid)
        qWarning("%s", valid.error().args.empty() ? "invalid" : valid.error().args[0].c_str());
    return valid.has_value();
}

} // namespace tests
