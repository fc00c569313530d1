// SPDX-License-Identifier: GPL-3.0-or-later
// Our own importers of terrains: points, RAW, and meshes as surfaces. Input: a byte that says which, the file.
#include "model/io/meshfile.h"
#include "model/io/terrain/meshes/pointsreader.h"
#include "model/io/terrain/meshes/surfacemesh.h"
#include "model/io/terrain/rasters/rawraster.h"
#include "model/terrain/simplify/simplifygrid.h"
#include "model/terrain/simplify/simplifytin.h"
#include "model/terrain/tin/validate.h"
#include "tests/fuzz/require.h"

#include <cmath>

using namespace model;
using namespace model::io;
using namespace model::terrain;

namespace {

void checkPoints(std::string_view text)
{
    const auto points = parsePoints(text);
    if (!points)
        return;
    SANDREEL_REQUIRE(!points->empty());
    for (const Point3 &p : *points)
        SANDREEL_REQUIRE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    const auto built = buildTin(*points, boundsOf(*points));
    if (built)
        SANDREEL_REQUIRE(findDefects(built->tin).empty());
}

void checkRaw(std::span<const std::uint8_t> bytes)
{
    if (bytes.size() < 4)
        return;
    const RawLayout layout{bytes[0], bytes[1], RawType(bytes[2] % 6), bytes[3] % 2 == 1};
    RasterOptions options;
    options.noData = 0;
    const auto raster = parseRaw(bytes.subspan(4), layout, options);
    if (!raster)
        return;
    const double maxError = std::ldexp(1.0, bytes[3] / 8 - 8);
    const auto tin = simplifyGrid(raster->grid, {maxError, 0});
    if (!tin)
        return;
    SANDREEL_REQUIRE(findDefects(*tin).empty());
}

void checkSurface(MeshKind kind, std::string_view text)
{
    const auto mesh = parseMesh(kind, text);
    if (!mesh)
        return;
    std::vector<Point3> positions;
    for (const Vec3f &p : mesh->positions)
        positions.push_back({p.x, p.y, p.z});
    const auto tin = tinOfSurface(positions, mesh->connectivity.triangles);
    if (!tin)
        return;
    SANDREEL_REQUIRE(findDefects(*tin).empty());
    const auto simple = simplifyTin(*tin, 0.5, SurfaceOwner);
    if (simple)
        SANDREEL_REQUIRE(findDefects(*simple).empty());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    if (size < 1)
        return 0;
    const std::string_view text(reinterpret_cast<const char *>(data + 1), size - 1);
    switch (data[0] % 5) {
    case 0:
        checkPoints(text);
        break;
    case 1:
        checkRaw({data + 1, size - 1});
        break;
    case 2:
        checkSurface(MeshKind::Obj, text);
        break;
    case 3:
        checkSurface(MeshKind::Ply, text);
        break;
    default:
        checkSurface(MeshKind::Stl, text);
    }
    return 0;
}
