// SPDX-License-Identifier: GPL-3.0-or-later
// Writes what the fuzzers start from: fuzz_seeds FOLDER makes FOLDER/<fuzzer>/<name>. Golden files come on top.
#include "model/codec/coddyac/lanestage.h"
#include "model/codec/connectivity/connectivitystage.h"
#include "model/codec/connectivity/vertexorder.h"
#include "model/codec/entropy/bandstage.h"
#include "model/codec/entropy/indexstage.h"
#include "tests/fuzz/animbytes.h"
#include "tests/model/codec/animations.h"

#include "model/codec/animationcodec.h"
#include "model/io/terrain/terrainfile.h"
#include "model/io/terrain/tiles/tilecodec.h"
#include "model/terrain/tin/tinedit.h"

#include <filesystem>
#include <fstream>
#include <iostream>

using namespace model;
using namespace model::codec;

namespace {

std::filesystem::path folder;

void write(const std::string &fuzzer, const std::string &name, std::span<const std::uint8_t> bytes)
{
    std::filesystem::create_directories(folder / fuzzer);
    std::ofstream(folder / fuzzer / name, std::ios::binary)
        .write(reinterpret_cast<const char *>(bytes.data()), std::streamsize(bytes.size()));
}

void write(const std::string &fuzzer, const std::string &name, std::string_view text)
{
    write(fuzzer, name, std::span(reinterpret_cast<const std::uint8_t *>(text.data()), text.size()));
}

Bytes operator+(Bytes a, const Bytes &b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// Meshes with all that the connectivity's coder knows, of few triangles.
std::vector<std::pair<std::string, Connectivity>> meshes()
{
    std::vector<std::pair<std::string, Connectivity>> result;
    const auto grid = [](std::uint32_t columns, std::uint32_t rows, bool closed) {
        Connectivity mesh{columns * rows, {}};
        for (std::uint32_t r = 0; r + (closed ? 0 : 1) < rows; ++r)
            for (std::uint32_t c = 0; c + (closed ? 0 : 1) < columns; ++c) {
                const auto at = [&](std::uint32_t dr, std::uint32_t dc) {
                    return (r + dr) % rows * columns + (c + dc) % columns;
                };
                mesh.triangles.push_back({at(0, 0), at(0, 1), at(1, 0)});
                mesh.triangles.push_back({at(0, 1), at(1, 1), at(1, 0)});
            }
        return mesh;
    };
    result.push_back({"sheet", grid(6, 5, false)});
    result.push_back({"torus", grid(5, 6, true)});
    Connectivity holes = grid(8, 7, false);
    for (const std::ptrdiff_t at : {50, 30, 12})
        holes.triangles.erase(holes.triangles.begin() + at);
    result.push_back({"holes", holes});
    Connectivity bent = grid(4, 4, false);
    bent.triangles.insert(bent.triangles.end(), {{0, 1, 9}, {5, 5, 2}, {1, 0, 4}, {1, 0, 4}});
    bent.vertexCount += 2;
    result.push_back({"nonmanifold", bent});
    result.push_back({"tetrahedron", {4, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}}});
    return result;
}

void animations()
{
    const auto add = [](const std::string &fuzzer, const std::string &name, const tests::PlainAnimation &source,
                        const CompressionSettings &settings) {
        if (const auto encoded = encodeAnimation(source, settings))
            write(fuzzer, name, encoded->bytes);
    };
    for (const auto &[name, connectivity] : meshes()) {
        tests::PlainAnimation source(
            8, connectivity.vertexCount, connectivity.triangles, [](std::uint32_t f, std::uint32_t v) {
                return Vec3f{float(v % 7) + 0.1f * float(f * v % 5), float(v / 7), float(f * f % 11) * 0.2f};
            });
        add("direct", name + "-n", source, {DirectSettings{500, Predictor::Neighbours, Entropy::Range}});
        add("direct", name + "-c", source, {DirectSettings{3000, Predictor::Accelerating, Entropy::Deflate}});
        add("pca", name, source, {PcaSettings{4, 300}});
        add("coddyac", name, source, {CoddyacSettings{4, 0.01, 0.01}});
        add("coddyac", name + "-ordered", source, {CoddyacSettings{3, 0.05, 0.01}, true});
        add("reel", name, source, {ReelSettings{0.02, 4}});
        add("reel", name + "-ordered", source, {ReelSettings{0.1, 3}, true});
    }
    add("reel", "long", tests::waves(40, 30, 9), {ReelSettings{0.005, 8}});
    add("direct", "long", tests::waves(40, 30, 9), {DirectSettings{300, Predictor::Steady, Entropy::Range}});
}

void connectivities()
{
    for (const auto &[name, mesh] : meshes()) {
        const auto encoded = encodeConnectivity(mesh, Progress());
        const std::uint32_t vertices = mesh.vertexCount - 1, triangles = std::uint32_t(mesh.triangles.size());
        const Bytes counts{0, std::uint8_t(vertices >> 8), std::uint8_t(vertices), std::uint8_t(triangles >> 8),
                           std::uint8_t(triangles)};
        write("connectivity", name + "-stream", counts + encoded->bytes);
        Bytes corners{1, std::uint8_t(vertices)};
        for (const Triangle &t : mesh.triangles)
            for (const std::uint32_t v : t)
                corners.push_back(std::uint8_t(v));
        write("connectivity", name + "-mesh", corners);
    }
    write("connectivity", "order", Bytes{3, 6, 0, 0, 0, 1, 0, 0, 9, 0, 200});
    write("connectivity", "order-stream", Bytes{2, 6, 0x80, 0x12, 0x34, 0x56, 0x78, 0x9a, 0xbc});
}

void stages()
{
    for (std::uint8_t stage = 0; stage < 8; ++stage)
        for (std::uint8_t isEncoding = 0; isEncoding < 2; ++isEncoding) {
            Bytes bytes{stage, isEncoding, 11};
            for (unsigned i = 0; i < 120; ++i)
                bytes.push_back(std::uint8_t(110 + i * i % 13));
            write("stages", std::to_string(stage) + (isEncoding ? "-there-and-back" : "-stream"), bytes);
        }
    const std::uint32_t columns = 12;
    std::vector<std::int32_t> rows;
    std::vector<std::int64_t> wide;
    for (std::uint32_t i = 0; i < 7 * columns; ++i)
        rows.push_back(std::int32_t(i * i % 100) - 50);
    for (std::uint32_t i = 0; i < 15 * columns; ++i)
        wide.push_back(std::int64_t(i * i % 1000));
    const Bytes start{0, 0, std::uint8_t(columns - 1)};
    write("stages", "rows", Bytes{1, 0, std::uint8_t(columns - 1)} + *encodeBands({7, columns, 3}, rows, Progress()));
    write("stages", "lanes", Bytes{3, 0, std::uint8_t(columns - 1)} + encodeLanes(3 * columns, wide));
    Connectivity mesh{columns, tests::strip(columns)};
    mesh.triangles.resize(3 * columns);
    write("stages", "indices", start + *encodeIndices(mesh, Progress()));
}

void roundTrips()
{
    for (std::uint8_t codec = 0; codec < 4; ++codec)
        for (const std::uint8_t choice : {0x46, 0x93}) {
            Bytes bytes{codec, choice, 11, 9, 20};
            for (unsigned i = 0; i < 500; ++i)
                bytes.push_back(std::uint8_t(i * i % 101));
            write("roundtrip", std::to_string(codec) + "-" + std::to_string(choice), bytes);
        }
}

void files()
{
    using namespace std::string_literals;
    write("meshes", "obj", "\0# a\nv 0 0 0 1\nv 1.5e-3 -2 +.5\nv 1 1 1\nvt 0 1\nf 1/1/1 2//2 \\\n 3\nf -1 -2 -3 1\n"s);
    write("meshes", "off", "\1OFF # x\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n4 0 1 2 0 255 0 0\n"s);
    write("meshes", "coff", "\1COFF\n1 0 0\n0 0 0 1 1 1 1\n"s);
    write("meshes", "ply",
          "\2ply\nformat ascii 1.0\ncomment c\nelement vertex 3\nproperty float x\nproperty double y\nproperty int z\n"
          "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"s);
    for (const std::string order : {"little", "big"})
        write("meshes", "ply-" + order,
              "\2ply\nformat binary_"s + order +
                  "_endian 1.0\nelement vertex 3\nproperty uchar x\nproperty short y\nproperty float z\n"
                  "element face 1\nproperty list uchar uchar vertex_index\nend_header\n"
                  "\1\0\1\0\0\0\0\2\0\2\0\0\0\0\3\0\3\0\0\0\0\3\0\1\2"s);
    write("meshes", "stl",
          "\3solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
          "endloop\nendfacet\nendsolid a\n"s);
    write("meshes", "stl-binary", "\3"s + std::string(80, 'x') + "\1\0\0\0"s + std::string(50, '\1'));
    write("meshes", "two", "\0v 0 0 0\nv 1 0 0\nv 1 1 1\nf 1 2 3\n\xff\xfe\xfdv 0 0 1\nv 1 0 1\nv 1 1 2\nf 1 2 3\n"s);
    const std::string pc2 = "POINTCACHE2\0\1\0\0\0\2\0\0\0\0\0\0\0\0\0\x80\x3f\2\0\0\0"s;
    write("pointcache", "pc2", "\2"s + pc2 + std::string(48, '\1'));
    write("pointcache", "mdd", "\3\0\0\0\2\0\0\0\2\0\0\0\0\x3d\x23\xd7\x0a"s + std::string(48, '\1'));
}

/// A small terrain with a layer, a void and a constraint; as a file, and its surface alone.
void terrains()
{
    using namespace std::string_literals;
    std::vector<terrain::Point3> points;
    for (int i = 0; i < 40; ++i)
        points.push_back({double(i * 7 % 16), double(i * 11 % 13), i % 5 * 0.25});
    terrain::Terrain small(terrain::buildTin(points, {{0, 0}, {16, 16}})->tin);
    small.materials.emplace_back();
    terrain::TinEdit edit(small.tin);
    edit.addLayer(0, 0);
    edit.setLayer(6, 0, {0.5, 0.25f});
    (void)edit.constrain(5, 20, 3, terrain::Crossing::Split);
    edit.setVoid(std::vector<terrain::TriangleId>{10, 11}, true);
    edit.commit();
    write("terrainfile", "file", Bytes{0} + *io::formatTerrain(small, {}));
    write("terrainfile", "surface", Bytes{1} + *io::encodeSurface(small.tin.arrays(), small.tin.domain(), {}));
    write("terrainfile", "two-triangles",
          Bytes{1} + *io::encodeSurface(terrain::Tin({{0, 0}, {1, 1}}).arrays(), {{0, 0}, {1, 1}}, {}));
    write("terrainfile", "edit",
          "\2\2\0\0\1"s + "\0\0\0\0\0\0\x10\x40\0\0\0\0\0\0\x10\x40"s + std::string(8, '\0') + "\0\0\0"s +
              std::string(88, '\0'));
    write("terrainfile", "settings",
          "\2\3{\"materials\":[{\"name\":\"a\"}],\"origin\":[0,0],\"crs\":\"\",\"unit\":\"metre\"}"s);
    write("terrainscript", "strokes",
          "{\"terrain\":{\"new\":{\"layers\":[{\"material\":\"mud\"}]}},\"steps\":[{\"stroke\":{\"tool\":\"imprint\","
          "\"outline\":\"wedge\",\"path\":[[1,1],[5,5,0.5]],"
          "\"mask\":{\"highest_slope\":60}}},{\"material\":{\"index\":0,\"preset\":\"snow\"}},{\"validate\":true}]}"s);
    write("terrainimport", "points", "\0X;Y;Z\n1 2 3\n4,5,6\n7;8;9\n"s);
    write("terrainimport", "raw", "\1\4\4\0\x40"s + "abcdefghijklmnop"s);
    write("terrainimport", "obj", "\2v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 0\nf 1 2 3 4\n"s);
    write(
        "terrainimport", "stl",
        "\4solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n"s);
}

} // namespace

int main(int argc, char **argv)
{
    if (argc != 2) {
        std::cerr << "usage: fuzz_seeds FOLDER\n";
        return 2;
    }
    folder = argv[1];
    animations();
    connectivities();
    stages();
    roundTrips();
    files();
    terrains();
}
