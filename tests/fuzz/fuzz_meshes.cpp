// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh files that we read ourselves. Input: a byte that says which format, the file; what follows a byte 0xff 0xfe
// 0xfd is a second frame.
#include "model/io/meshfile.h"
#include "tests/fuzz/require.h"
#include "tests/support/scarcity.h"

#include <cmath>

using namespace model;
using namespace model::io;

namespace {

void requireSound(const TriangleMesh &mesh)
{
    SANDREEL_REQUIRE(mesh.positions.size() == mesh.connectivity.vertexCount && !mesh.positions.empty());
    for (const Vec3f &p : mesh.positions)
        SANDREEL_REQUIRE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    for (const Triangle &t : mesh.connectivity.triangles)
        for (const std::uint32_t v : t)
            SANDREEL_REQUIRE(v < mesh.connectivity.vertexCount);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    if (size < 1)
        return 0;
    constexpr std::string_view Separator = "\xff\xfe\xfd";
    const MeshKind kind = MeshKind(data[0] % 4);
    const std::string_view text(reinterpret_cast<const char *>(data + 1), size - 1);
    const std::size_t end = text.find(Separator);
    const std::string_view first = text.substr(0, end);
    const std::string_view second = end == text.npos ? first : text.substr(end + Separator.size());

    tests::AllocationMeter meter;
    const auto mesh = parseMesh(kind, first);
    // A triangle of twelve bytes may come of the two of " 1", a corner of STL makes a vertex and a place in a table.
    SANDREEL_REQUIRE(meter.peak() <= (std::uint64_t(64) << 20) + 64 * size);
    if (!mesh)
        return 0;
    requireSound(*mesh);

    const auto frame = FirstFrame::parse(kind, first, "first");
    SANDREEL_REQUIRE(frame.has_value() && frame->connectivity() == mesh->connectivity);
    std::vector<Vec3f> positions(mesh->positions.size());
    FirstFrame::Scratch scratch;
    const auto next = frame->parseNext(second, positions, scratch);
    SANDREEL_REQUIRE(next.has_value() || end != text.npos);
    if (next)
        for (const Vec3f &p : positions)
            SANDREEL_REQUIRE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    return 0;
}
