// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/parallel.h"
#include "model/codec/connectivity/connectivitystage.h"
#include "model/codec/entropy/countedinteger.h"
#include "tests/support/rows.h"
#include "tests/support/surfaces.h"
#include "tests/support/testmain.h"

#include <numeric>
#include <optional>
#include <random>
#include <set>

using namespace model;
using namespace model::codec;
using namespace tests;

namespace {

constexpr std::uint64_t Plenty = std::uint64_t(1) << 34;

Result<CodedConnectivity> decoded(const Bytes &bytes, std::uint32_t vertexCount, std::size_t triangleCount,
                                  std::uint64_t memory = Plenty)
{
    const Chunk chunk{"CLRS", bytes, 1000, bytes.size(), 0};
    return decodeConnectivity(chunk, vertexCount, std::uint32_t(triangleCount), memory, Progress());
}

Result<CodedConnectivity> decoded(const EncodedConnectivity &encoded, const Connectivity &mesh)
{
    return decoded(encoded.bytes, mesh.vertexCount, mesh.triangles.size());
}

/// Encodes and decodes; compares what comes out with what went in, and both sides with each other.
void roundTrip(const Connectivity &mesh)
{
    const auto encoded = encodeConnectivity(mesh, Progress());
    QVERIFY(encoded.has_value());
    const auto result = decoded(*encoded, mesh);
    QVERIFY2(result.has_value(), "not decoded");

    QCOMPARE(result->connectivity.vertexCount, mesh.vertexCount);
    QCOMPARE(encoded->permutation.size(), std::size_t(mesh.vertexCount));
    QCOMPARE(std::set(encoded->permutation.begin(), encoded->permutation.end()).size(), std::size_t(mesh.vertexCount));
    for (const std::uint32_t v : encoded->permutation)
        QVERIFY(v < mesh.vertexCount);
    QVERIFY(canonical(renamed(result->connectivity.triangles, encoded->permutation)) == canonical(mesh.triangles));

    QVERIFY(result->connectivity == encoded->coded.connectivity);
    QVERIFY(result->neighbours == encoded->coded.neighbours);
    QVERIFY(result->welded == encoded->coded.welded);
    QVERIFY(std::ranges::equal(result->corners.vertices(), encoded->coded.corners.vertices()));
    QVERIFY(std::ranges::equal(result->corners.opposites(), encoded->coded.corners.opposites()));

    // The walked mesh is the same up to the weld.
    const CornerTable &corners = result->corners;
    QCOMPARE(std::size_t(corners.triangleCount()), mesh.triangles.size());
    for (Corner c = 0; c < corners.cornerCount(); ++c) {
        const Triangle &t = result->connectivity.triangles[c / 3];
        QVERIFY(std::find(t.begin(), t.end(), result->weldedVertex(corners.vertex(c))) != t.end());
        if (const Corner o = corners.opposite(c); o != NoCorner) {
            QCOMPARE(corners.opposite(o), c);
            QCOMPARE(corners.vertex(corners.next(c)), corners.vertex(corners.previous(o)));
        }
    }
    QCOMPARE(result->neighbours.size(), std::size_t(mesh.vertexCount));
    for (std::uint32_t v = 0; v < mesh.vertexCount; ++v)
        if (const VertexNeighbours &n = result->neighbours[v]; !n.isNone())
            QVERIFY(n.left < v && n.right < v && n.opposite < v);
}

/// How the first triangle of a mesh touches holes: for each of its edges whether it is border, for each corner the loop
/// that its vertex lies on (numbered in the order of their first appearance, 0 for none).
std::string touchOf(const Connectivity &mesh)
{
    const CornerTable table = CornerTable::of(mesh);
    std::vector<int> loops(mesh.vertexCount, 0);
    int count = 0;
    for (Corner c = 0; c < table.cornerCount(); ++c) {
        if (table.opposite(c) != NoCorner || loops[table.vertex(table.next(c))] != 0)
            continue;
        ++count;
        Corner at = c;
        do {
            loops[table.vertex(table.next(at))] = count;
            at = nextBorder(table, at);
        } while (at != c);
    }
    std::string edges, vertices;
    std::vector<int> seen;
    for (Corner c = 0; c < 3; ++c) {
        edges += table.opposite(c) == NoCorner ? 'b' : '-';
        const int loop = loops[table.vertex(c)];
        if (loop > 0 && std::find(seen.begin(), seen.end(), loop) == seen.end())
            seen.push_back(loop);
        vertices += loop == 0 ? '.' : char('1' + (std::find(seen.begin(), seen.end(), loop) - seen.begin()));
    }
    // Up to rotation and mirroring: the number of border edges and the sorted pattern.
    std::sort(edges.begin(), edges.end());
    std::sort(vertices.begin(), vertices.end());
    return edges + vertices;
}

/// Triangles that touch nothing.
Connectivity apart(std::uint32_t count)
{
    Connectivity mesh{3 * count, {}};
    for (std::uint32_t v = 0; v < mesh.vertexCount; v += 3)
        mesh.triangles.push_back({v, v + 1, v + 2});
    return mesh;
}

/// With each triangle the other way round whose number `isTurned` says it of.
template <class IsTurned>
Connectivity wound(Connectivity mesh, IsTurned isTurned)
{
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (isTurned(t))
            std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    return mesh;
}

} // namespace

class TestConnectivity final : public QObject
{
    Q_OBJECT

private slots:
    void everySurface_data() { tests::addRows(namedSurfaces()); }
    void everySurface()
    {
        QFETCH(int, row);
        roundTrip(namedSurfaces()[std::size_t(row)].mesh);
        roundTrip(shuffled(namedSurfaces()[std::size_t(row)].mesh));
    }

    void randomSoups()
    {
        for (std::uint32_t seed = 0; seed < 300; ++seed)
            roundTrip(soup(3 + seed % 23, 1 + seed % 70, seed));
    }

    void randomSurfaces()
    {
        for (std::uint32_t seed = 0; seed < 40; ++seed) {
            const Connectivity torus = sheet(9, 9, Closing::Closed, Closing::Closed);
            const Connectivity sum = connectedSum(withRandomHoles(torus, 4 + seed % 9, seed), seed, torus, 3 * seed);
            roundTrip(shuffled(sum, seed));
        }
    }

    /// The walk must not care with which triangle a mesh begins: each of a mesh with many holes comes first once, and
    /// among them is every way in which the first one can touch holes.
    void everyFirstTriangle()
    {
        const Connectivity mesh = withRandomHoles(sheet(16, 16), 6, 3);
        std::set<std::string> touches;
        for (std::size_t first = 0; first < mesh.triangles.size(); ++first) {
            Connectivity turned = mesh;
            std::swap(turned.triangles[0], turned.triangles[first]);
            touches.insert(touchOf(turned));
            roundTrip(turned);
        }
        for (const char *way : {"---...", "---..1", "---.11", "---.12", "--b.11", "--b111", "--b112", "-bb111"})
            QVERIFY2(touches.contains(way), way);
        roundTrip(oneTriangle().connectivity); // "bbb111"
    }
    static TriangleMesh oneTriangle() { return {{}, {3, {{0, 1, 2}}}}; }

    /// A prefix may be the whole code of another mesh by chance (the container's framing then refuses it), never of
    /// this.
    void everyPrefixIsRejected_data() { smallSurfaces(); }
    void everyPrefixIsRejected()
    {
        QFETCH(int, index);
        const Connectivity &mesh = namedSurfaces()[std::size_t(index)].mesh;
        const auto encoded = encodeConnectivity(mesh, Progress());
        const Bytes &bytes = encoded->bytes;
        std::size_t accepted = 0;
        for (std::size_t length = 0; length < bytes.size(); ++length) {
            const auto result = decoded(Bytes(bytes.begin(), bytes.begin() + std::ptrdiff_t(length)), mesh.vertexCount,
                                        mesh.triangles.size());
            if (result) {
                ++accepted;
                QVERIFY(result->connectivity != encoded->coded.connectivity);
                continue;
            }
            QCOMPARE(result.error().code, ErrorCode::CorruptStream);
            QCOMPARE(result.error().args, std::vector<std::string>{"connectivity"});
        }
        QVERIFY(accepted <= 1);
        Bytes longer = bytes;
        longer.push_back(0);
        QVERIFY(!decoded(longer, mesh.vertexCount, mesh.triangles.size()));
    }

    /// A flipped byte may give another mesh, but a whole one: every rule that roundTrip() checks of the decoder holds.
    void everyFlippedByteIsHarmless_data() { smallSurfaces(); }
    void everyFlippedByteIsHarmless()
    {
        QFETCH(int, index);
        const Connectivity &mesh = namedSurfaces()[std::size_t(index)].mesh;
        const Bytes bytes = encodeConnectivity(mesh, Progress())->bytes;
        for (std::size_t at = 0; at < bytes.size(); ++at)
            for (const std::uint8_t mask : {0x01, 0x10, 0x80, 0xff}) {
                Bytes damaged = bytes;
                damaged[at] ^= mask;
                const auto result = decoded(damaged, mesh.vertexCount, mesh.triangles.size());
                if (!result) {
                    QCOMPARE(result.error().code, ErrorCode::CorruptStream);
                    continue;
                }
                QCOMPARE(result->connectivity.triangles.size(), mesh.triangles.size());
                for (const Triangle &t : result->connectivity.triangles)
                    for (const std::uint32_t v : t)
                        QVERIFY(v < mesh.vertexCount);
                for (std::uint32_t v = 0; v < mesh.vertexCount; ++v)
                    if (const VertexNeighbours &n = result->neighbours[v]; !n.isNone())
                        QVERIFY(n.left < v && n.right < v && n.opposite < v);
            }
    }
    static void smallSurfaces()
    {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < namedSurfaces().size(); ++i)
            if (namedSurfaces()[i].mesh.triangles.size() < 700)
                QTest::newRow(namedSurfaces()[i].name.c_str()) << int(i);
    }

    void wrongCountsAreRejected()
    {
        const Connectivity mesh = withRandomHoles(sheet(9, 9), 7);
        const Bytes bytes = encodeConnectivity(mesh, Progress())->bytes;
        const std::size_t count = mesh.triangles.size();
        QVERIFY(decoded(bytes, mesh.vertexCount, count));
        QVERIFY(!decoded(bytes, mesh.vertexCount, count - 1));
        QVERIFY(!decoded(bytes, mesh.vertexCount, count + 1));
        QVERIFY(!decoded(bytes, 20, count));
        // More vertices than triangles use are isolated.
        QVERIFY(decoded(bytes, mesh.vertexCount + 10, count));
    }

    void hostileCountsDoNotAllocate()
    {
        const Bytes bytes(40, 0x55);
        const auto result = decoded(bytes, 1u << 30, 1u << 30, std::uint64_t(64) << 20);
        QVERIFY(!result);
        QCOMPARE(result.error().code, ErrorCode::LimitExceeded);
        // A hole of more edges than fit, in a file that says so in a few bytes.
        RangeEncoder coder;
        CountedInteger holes, lengths;
        CountedBit starts;
        holes.codeCount(coder, 1);
        coder.direct(1, 0);
        codeCounted(coder, starts, true);
        lengths.codeCount(coder, 600000);
        const auto other = decoded(coder.finish(), 100000, 700000, std::uint64_t(27) << 20);
        QVERIFY(!other);
        QCOMPARE(other.error().code, ErrorCode::LimitExceeded);
    }

    void cancelled()
    {
        const Connectivity mesh = sheet(100, 100);
        const Progress progress;
        progress.cancel();
        const auto encoded = encodeConnectivity(mesh, progress);
        QVERIFY(!encoded);
        QCOMPARE(encoded.error().code, ErrorCode::Cancelled);
        const Bytes bytes = encodeConnectivity(mesh, Progress())->bytes;
        const Chunk chunk{"CLRS", bytes, 0, 0, 0};
        const auto result =
            decodeConnectivity(chunk, mesh.vertexCount, std::uint32_t(mesh.triangles.size()), Plenty, progress);
        QVERIFY(!result);
        QCOMPARE(result.error().code, ErrorCode::Cancelled);
    }

    void cancelledWhileASecondThreadCodes()
    {
        setThreadCount(2);
        std::optional<Progress> progress;
        progress.emplace([&](double fraction) {
            if (fraction > 0.6)
                progress->cancel();
        });
        const auto encoded = encodeConnectivity(sheet(200, 200), *progress);
        setThreadCount(0);
        QVERIFY(!encoded);
        QCOMPARE(encoded.error().code, ErrorCode::Cancelled);
    }

    void sameInputSameBytes()
    {
        const Connectivity mesh = shuffled(withRandomHoles(sheet(90, 90), 5)); // of several blocks
        setThreadCount(1);
        const Bytes one = encodeConnectivity(mesh, Progress())->bytes;
        setThreadCount(0);
        QVERIFY(encodeConnectivity(mesh, Progress())->bytes == one);
    }

    /// Each S waits on a stack of our own: two million triangles in one spiral, and as many branches as there can be.
    void twoMillionTrianglesNeedNoDeepStack()
    {
        const Connectivity mesh = spiral(2000000, 40);
        const auto encoded = encodeConnectivity(mesh, Progress());
        const auto result = decoded(*encoded, mesh);
        QVERIFY(result.has_value());
        QCOMPARE(result->connectivity.triangles.size(), std::size_t(2000000));
        QVERIFY(encoded->bytes.size() < 20000); // regular: nearly nothing
    }

    /// Places of S in all ways: near on both sides, where the sides meet, beyond those that are asked for, at handles.
    /// Turns: at random, and in a pattern.
    void placesAndTurns()
    {
        for (std::uint32_t seed = 0; seed < 12; ++seed) {
            const Connectivity torus = sheet(6 + seed, 40, Closing::Closed, Closing::Closed);
            const Connectivity holes = withRandomHoles(torus, 3, seed);
            roundTrip(shuffled(connectedSum(holes, seed, holes, 3 * seed), seed));
            std::mt19937 random(seed);
            roundTrip(wound(holes, [&](std::size_t) { return random() & 1; }));
            roundTrip(wound(holes, [&](std::size_t t) { return t % (2 + seed) == 0; }));
        }
        roundTrip(spiral(5000, 3));
        roundTrip(apart(40));
    }

    void theSizeIsWithinItsBudget()
    {
        const auto bitsPerTriangle = [](const Connectivity &mesh) {
            return 8.0 * double(encodeConnectivity(mesh, Progress())->bytes.size()) / double(mesh.triangles.size());
        };
        QVERIFY(bitsPerTriangle(sheet(100, 100)) < 0.05);
        QVERIFY(bitsPerTriangle(withRandomHoles(sheet(60, 60), 12)) < 2.5);
        QVERIFY(bitsPerTriangle(apart(200)) < 0.5); // holes of one length, learned at once
        QVERIFY(bitsPerTriangle(wound(sheet(60, 60), [](std::size_t t) { return t % 5 == 0; })) < 1.0);
        std::mt19937 random(3);
        QVERIFY(bitsPerTriangle(wound(sheet(60, 60), [&](std::size_t) { return random() & 1; })) < 1.1);
        QVERIFY(bitsPerTriangle(sheet(60, 60, Closing::Twisted, Closing::Closed)) < 0.4);
    }
};

SANDREEL_TEST(TestConnectivity)
#include "tst_connectivity.moc"
