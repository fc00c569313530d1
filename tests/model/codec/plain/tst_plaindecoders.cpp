// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/animationcodec.h"
#include "model/codec/connectivity/connectivitystage.h"
#include "model/codec/connectivity/vertexorder.h"
#include "tests/model/codec/animations.h"
#include "tests/model/codec/filesurgery.h"
#include "tests/model/codec/plain/plaincoddyac.h"
#include "tests/model/codec/plain/plainconnectivity.h"
#include "tests/model/codec/plain/plainreel.h"
#include "tests/support/surfaces.h"
#include "tests/support/testmain.h"

#include <QDir>
#include <QFile>

#include <cmath>
#include <optional>
#include <random>

using namespace model;
using namespace model::codec;

namespace {

using PlainTriangles = std::vector<std::array<std::int64_t, 3>>;

PlainTriangles widened(const std::vector<Triangle> &triangles)
{
    PlainTriangles result;
    for (const Triangle &t : triangles)
        result.push_back({t[0], t[1], t[2]});
    return result;
}

PlainTriangles widened(const std::vector<VertexNeighbours> &neighbours)
{
    PlainTriangles result;
    const auto number = [](std::uint32_t v) { return v == NoVertex ? -1 : std::int64_t(v); };
    for (const VertexNeighbours &n : neighbours)
        result.push_back({number(n.left), number(n.right), number(n.opposite)});
    return result;
}

Chunk chunkOf(const Bytes &payload)
{
    Chunk chunk;
    chunk.payload = payload;
    return chunk;
}

/// \param limit  the difference allowed of a coordinate
template <class PlainPosition, class Limit>
void comparePositions(const DecodedAnimation &animation, PlainPosition &&plain, Limit &&limit)
{
    for (std::uint32_t f = 0; f < animation.frameCount(); ++f) {
        const auto frame = animation.frame(f);
        for (std::uint32_t v = 0; v < animation.vertexCount(); ++v) {
            const float p[3] = {frame[v].x, frame[v].y, frame[v].z};
            for (unsigned axis = 0; axis < 3; ++axis) {
                const double difference = std::fabs(double(p[axis]) - plain(f, v, axis));
                QVERIFY2(difference <= limit(f, v, axis), qPrintable(QString("frame %1, vertex %2, axis %3: %4 not %5")
                                                                         .arg(f)
                                                                         .arg(v)
                                                                         .arg(axis)
                                                                         .arg(double(p[axis]))
                                                                         .arg(plain(f, v, axis))));
            }
        }
    }
}

void compareCoddyac(const Bytes &file)
{
    const auto product = decodeAnimation(Bytes(file));
    QVERIFY(product.has_value());
    const tests::PlainCoddyac plain = tests::decodeCoddyacPlainly(file);
    QCOMPARE(plain.error, std::string());
    QVERIFY(widened((*product)->connectivity().triangles) == plain.triangles);
    comparePositions(
        **product, [&](auto f, auto v, unsigned axis) { return plain.coordinate(f, v, axis); },
        [&](auto f, auto v, unsigned axis) { return std::ldexp(plain.size(f, v, axis), -20) + 1e-35; });
}

void compareReel(const Bytes &file)
{
    const auto product = decodeAnimation(Bytes(file));
    QVERIFY(product.has_value());
    const tests::PlainReel plain = tests::decodeReelPlainly(file);
    QCOMPARE(plain.error, std::string());
    QVERIFY(widened((*product)->connectivity().triangles) == plain.triangles);
    const double limit = std::ldexp(plain.size, -20) + 1e-5 * plain.step + 1e-35;
    comparePositions(
        **product, [&](auto f, auto v, unsigned axis) { return plain.positions[f][v][axis]; },
        [&](auto &&...) { return limit; });
}

struct Outcome
{
    PlainTriangles triangles, neighbours;

    friend bool operator==(const Outcome &, const Outcome &) = default;
};
using MaybeOutcome = std::optional<Outcome>; ///< nothing: corrupt

MaybeOutcome outcomeOfProduct(const Bytes &stream, std::uint32_t vertices, std::uint32_t triangles)
{
    const auto decoded = decodeConnectivity(chunkOf(stream), vertices, triangles, std::uint64_t(1) << 30, Progress());
    if (!decoded)
        return {};
    return Outcome{widened(decoded->connectivity.triangles), widened(decoded->neighbours)};
}

MaybeOutcome outcomeOfPlain(const Bytes &stream, std::uint32_t vertices, std::uint32_t triangles)
{
    try {
        const auto decoded = tests::decodeConnectivityPlainly(stream, vertices, triangles);
        return Outcome{decoded.triangles, decoded.neighbours};
    } catch (const std::string &) {
        return {};
    }
}

Bytes damaged(Bytes stream, std::minstd_rand &random)
{
    if (!stream.empty())
        stream[random() % stream.size()] ^= std::uint8_t(1u << random() % 8);
    return stream;
}

} // namespace

/// The decoders that were written from FORMAT.md alone find what the product finds: so the document says enough.
class TestPlainDecoders final : public QObject
{
    Q_OBJECT

private slots:
    void connectivity_data()
    {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < tests::namedSurfaces().size(); ++i)
            if (tests::namedSurfaces()[i].mesh.triangles.size() < 3000)
                QTest::newRow(tests::namedSurfaces()[i].name.c_str()) << int(i);
        QTest::newRow("soup") << -1;
    }
    void connectivity()
    {
        QFETCH(int, index);
        const Connectivity mesh =
            index < 0 ? tests::soup(30, 200) : tests::shuffled(tests::namedSurfaces()[std::size_t(index)].mesh);
        const auto encoded = encodeConnectivity(mesh, Progress());
        const std::uint32_t triangles = std::uint32_t(mesh.triangles.size());
        const MaybeOutcome plain = outcomeOfPlain(encoded->bytes, mesh.vertexCount, triangles);
        QVERIFY(plain.has_value());
        QVERIFY(plain == outcomeOfProduct(encoded->bytes, mesh.vertexCount, triangles));

        // Streams that nobody wrote: both refuse them, or both find the same.
        std::minstd_rand random(7);
        for (int i = 0; i < 40 && triangles < 300; ++i) {
            const Bytes bytes = damaged(encoded->bytes, random);
            const MaybeOutcome product = outcomeOfProduct(bytes, mesh.vertexCount, triangles);
            QVERIFY(outcomeOfPlain(bytes, mesh.vertexCount, triangles) == product);
        }
    }

    void order()
    {
        std::minstd_rand random(11);
        for (const auto &surface : tests::namedSurfaces()) {
            if (surface.mesh.vertexCount == 0 || surface.mesh.vertexCount > 500)
                continue;
            const auto encoded = encodeConnectivity(surface.mesh, Progress());
            const auto &neighbours = encoded->coded.neighbours;
            auto shuffledPlaces = encoded->permutation;
            std::shuffle(shuffledPlaces.begin(), shuffledPlaces.end(), random);
            for (const auto &places : {encoded->permutation, shuffledPlaces}) {
                const Bytes stream = encodeVertexOrder(places, neighbours);
                const auto plain = tests::decodeOrderPlainly(stream, widened(neighbours));
                QVERIFY2(std::equal(plain.begin(), plain.end(), places.begin(), places.end()), surface.name.c_str());
            }
        }
    }

    void goldenFiles_data()
    {
        QTest::addColumn<QString>("name");
        for (const QString &name : QDir(SANDREEL_SOURCE "/tests/data/anim").entryList({"*.anim"}))
            if (name.contains("coddyac") || name.contains("reel"))
                QTest::newRow(qPrintable(name)) << name;
    }
    void goldenFiles()
    {
        QFETCH(QString, name);
        QFile file(QStringLiteral(SANDREEL_SOURCE "/tests/data/anim/") + name);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray raw = file.readAll();
        const Bytes bytes(raw.begin(), raw.end());
        if (name.contains("coddyac"))
            compareCoddyac(bytes);
        else
            compareReel(bytes);
    }

    void animations_data()
    {
        QTest::addColumn<int>("row");
        QTest::addColumn<bool>("keepOrder");
        const auto table = tests::animationTable();
        for (std::size_t i = 0; i < table.size(); ++i)
            for (const bool keepOrder : {false, true})
                QTest::addRow("%s%s", table[i].name.c_str(), keepOrder ? ", in order" : "") << int(i) << keepOrder;
    }
    void animations()
    {
        QFETCH(int, row);
        QFETCH(bool, keepOrder);
        const auto source = tests::animationTable()[std::size_t(row)].animation;
        for (const double step : {0.1, 1e-3}) {
            compareCoddyac(encodeAnimation(*source, {CoddyacSettings{9, step, step}, keepOrder})->bytes);
            compareReel(encodeAnimation(*source, {ReelSettings{step, 0}, keepOrder})->bytes);
        }
    }

    // Surfaces with rings enough to predict by, and connectivities that no graph of a good mesh has.
    void surfaces_data()
    {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < tests::namedSurfaces().size(); ++i) {
            const Connectivity &mesh = tests::namedSurfaces()[i].mesh;
            if (mesh.vertexCount > 0 && mesh.vertexCount <= 300)
                QTest::newRow(tests::namedSurfaces()[i].name.c_str()) << int(i);
        }
        QTest::newRow("everything linked") << -1;
        QTest::newRow("sheet") << -2;
    }
    void surfaces()
    {
        QFETCH(int, index);
        Connectivity mesh;
        if (index >= 0) {
            mesh = tests::namedSurfaces()[std::size_t(index)].mesh;
        } else if (index == -1) {
            mesh.vertexCount = 20;
            for (std::uint32_t a = 0; a < mesh.vertexCount; ++a)
                for (std::uint32_t b = 0; b < a; ++b)
                    mesh.triangles.push_back({a, b, (a * b + 7) % mesh.vertexCount});
        } else {
            mesh = tests::sheet(16, 14);
        }
        const tests::PlainAnimation source(10, mesh.vertexCount, mesh.triangles, [](std::uint32_t f, std::uint32_t v) {
            const double angle = 0.7 * v, time = 0.5 * f;
            return Vec3f{float(std::cos(angle) * (1 + 0.1 * time)), float(0.05 * v + 0.2 * std::sin(time + angle)),
                         float(std::sin(angle) + 0.1 * std::cos(2 * time))};
        });
        compareReel(encodeAnimation(source, {ReelSettings{0.002, 8}})->bytes);
        compareCoddyac(encodeAnimation(source, {CoddyacSettings{8, 0.002, 0.002}})->bytes);
    }
};

SANDREEL_TEST(TestPlainDecoders)
#include "tst_plaindecoders.moc"
