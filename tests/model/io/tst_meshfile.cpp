// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/meshfile.h"
#include "tests/model/io/iotest.h"
#include "tests/support/testmain.h"

#include <bit>

using namespace model;
using namespace model::io;

Q_DECLARE_METATYPE(MeshKind)

namespace {

std::string_view view(const QByteArray &bytes)
{
    return {bytes.constData(), std::size_t(bytes.size())};
}

Result<TriangleMesh> parse(MeshKind kind, const QByteArray &bytes)
{
    return parseMesh(kind, view(bytes));
}

/// The bytes of a number, in either byte order.
template <class Number>
QByteArray raw(Number value, bool bigEndian = false)
{
    QByteArray bytes(reinterpret_cast<const char *>(&value), sizeof value); // tests run on little-endian machines
    if (bigEndian)
        std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

QByteArray binaryStl(const std::vector<std::array<Vec3f, 3>> &triangles)
{
    QByteArray bytes = QByteArray("solid made by a test").leftJustified(80, ' ') + raw(std::uint32_t(triangles.size()));
    for (const auto &triangle : triangles) {
        bytes += QByteArray(12, '\xff'); // a normal that nobody reads
        for (const Vec3f &p : triangle)
            bytes += raw(p.x) + raw(p.y) + raw(p.z);
        bytes += QByteArray(2, '\0');
    }
    return bytes;
}

QByteArray textStl(const std::vector<std::array<Vec3f, 3>> &triangles)
{
    QByteArray text = "solid made by a test\n";
    for (const auto &triangle : triangles) {
        text += "  facet normal nan 0 1\n    outer loop\n";
        for (const Vec3f &p : triangle)
            text += "      vertex " + QByteArray::number(p.x) + ' ' + QByteArray::number(p.y) + ' ' +
                    QByteArray::number(p.z) + "\n";
        text += "    endloop\n  endfacet\n";
    }
    return text + "endsolid made by a test\n";
}

const std::vector<std::array<Vec3f, 3>> TwoTriangles{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                                                     {{{0, 1, 0}, {1, 0, 0}, {1, 1, 0.5f}}}};

const QByteArray PlyHeaderEnd = "element vertex 3\nproperty uchar flag\nproperty double z\nproperty float x\n"
                                "property list uchar short extra\nproperty short y\nelement odd 2\nproperty int i\n"
                                "element face 2\nproperty list ushort uint names\n"
                                "property list int short vertex_index\nproperty float quality\nend_header\n";

/// Every kind of trouble in one: mixed types, lists before what matters, an element that nobody knows.
QByteArray binaryPly(bool bigEndian)
{
    const auto put = [bigEndian](auto value) { return raw(value, bigEndian); };
    QByteArray bytes = QByteArray("ply\nformat binary_") + (bigEndian ? "big" : "little") +
                       "_endian 1.0\ncomment made by hand\n" + PlyHeaderEnd;
    const std::vector<Vec3f> positions{{0, 0, 0.1f}, {1.5f, 0, 0}, {0, -7, 0}};
    for (const Vec3f &p : positions)
        bytes += put(std::uint8_t(9)) + put(double(p.z)) + put(p.x) + put(std::uint8_t(2)) + put(std::int16_t(5)) +
                 put(std::int16_t(6)) + put(std::int16_t(p.y));
    bytes += put(std::int32_t(1)) + put(std::int32_t(2));
    bytes += put(std::uint16_t(1)) + put(std::uint32_t(77)) + put(std::int32_t(3)) + put(std::int16_t(0)) +
             put(std::int16_t(1)) + put(std::int16_t(2)) + put(0.5f);
    bytes += put(std::uint16_t(0)) + put(std::int32_t(4)) + put(std::int16_t(2)) + put(std::int16_t(1)) +
             put(std::int16_t(0)) + put(std::int16_t(2)) + put(0.5f);
    return bytes;
}

const QByteArray TextPly = "ply\r\nformat ascii 1.0\r\nobj_info x\r\n" + PlyHeaderEnd +
                           "9 0.1 0 2 5 6 0\n9 0 1.5 0 0\n\n9 0 0 1\n3 -7\n1 2\n1 77 3 0 1 2 0.5\n0 4 2 1 0 2 0.5\n";

void checkPly(const Result<TriangleMesh> &mesh)
{
    QVERIFY(mesh.has_value());
    const std::vector<Vec3f> positions{{0, 0, 0.1f}, {1.5f, 0, 0}, {0, -7, 0}};
    const std::vector<Triangle> triangles{{0, 1, 2}, {2, 1, 0}, {2, 0, 2}};
    QVERIFY(mesh->positions == positions);
    QVERIFY(mesh->connectivity.triangles == triangles);
    QCOMPARE(mesh->connectivity.vertexCount, 3u);
}

} // namespace

class TestMeshFile final : public QObject
{
    Q_OBJECT

private slots:
    void offForms_data()
    {
        QTest::addColumn<QByteArray>("text");
        const QByteArray plain = "0 0 0\n1 0 0\n0 1 0.5\n3 0 1 2\n4 2 1 0 2\n";
        QTest::newRow("plain") << "OFF\n3 2 0\n" + plain;
        QTest::newRow("counts behind the word") << "OFF 3 2 0\n" + plain;
        QTest::newRow("without the word") << "3 2 0\n" + plain;
        QTest::newRow("without edges") << "OFF\n3 2\n" + plain;
        QTest::newRow("comments") << "# a\nOFF # b\n# c\n3 2 0 # d\n\n# e\n" + plain + "# f";
        QTest::newRow("CRLF") << QByteArray("OFF\n3 2 0\n" + plain).replace("\n", "\r\n");
        QTest::newRow("byte order mark") << "\xEF\xBB\xBFOFF\n3 2 0\n" + plain;
        QTest::newRow("COFF") << QByteArray(
            "COFF\n3 2 0\n0 0 0 255 0 0 255\n1 0 0 1 1 1 1\n0 1 0.5 9 9 9 9\n3 0 1 2 0.5 "
            "0.5 0.5\n4 2 1 0 2 255 0 0\n");
        QTest::newRow("NOFF") << QByteArray(
            "NOFF\n3 2 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0.5 0 0 1\n3 0 1 2\n4 2 1 0 2\n");
        QTest::newRow("STCNOFF") << QByteArray(
            "STCNOFF\n3 2 0\n0 0 0 0 0 1 9 9 9 9 0 0\n1 0 0 0 0 1 9 9 9 9 0 0\n0 1 0.5 0 "
            "0 1 9 9 9 9 0 0\n3 0 1 2\n4 2 1 0 2\n");
        QTest::newRow("broken lines") << QByteArray("OFF 3\n2 0\n0\n0 0\n1 0\n0\n0 1 0.5\n3 0\n1 2\n4 2 1\n0 2");
    }
    void offForms()
    {
        QFETCH(QByteArray, text);
        const auto mesh = parse(MeshKind::Off, text);
        QVERIFY(mesh.has_value());
        const std::vector<Vec3f> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5f}};
        const std::vector<Triangle> triangles{{0, 1, 2}, {2, 1, 0}, {2, 0, 2}};
        QVERIFY(mesh->positions == positions);
        QVERIFY(mesh->connectivity.triangles == triangles);
    }

    void plyForms()
    {
        checkPly(parse(MeshKind::Ply, TextPly));
        checkPly(parse(MeshKind::Ply, binaryPly(false)));
        checkPly(parse(MeshKind::Ply, binaryPly(true)));
    }

    void plyPointsAreAMesh()
    {
        const auto mesh =
            parse(MeshKind::Ply, "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float "
                                 "y\nproperty float z\nelement empty 4000000000\nend_header\n1 2 3");
        QVERIFY(mesh.has_value());
        QCOMPARE(mesh->positions.size(), std::size_t(1));
        QVERIFY(mesh->connectivity.triangles.empty());
    }

    void stlFormsAreWelded()
    {
        for (const QByteArray &bytes :
             {binaryStl(TwoTriangles), textStl(TwoTriangles), textStl(TwoTriangles).toUpper()}) {
            const auto mesh = parse(MeshKind::Stl, bytes);
            QVERIFY(mesh.has_value());
            const std::vector<Vec3f> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.5f}};
            const std::vector<Triangle> triangles{{0, 1, 2}, {2, 1, 3}};
            QVERIFY(mesh->positions == positions);
            QVERIFY(mesh->connectivity.triangles == triangles);
            QCOMPARE(mesh->connectivity.vertexCount, 4u);
        }
    }

    void stlWeldsOnlyEqualPlaces()
    {
        const float next = std::nextafter(1.0f, 2.0f);
        const auto mesh =
            parse(MeshKind::Stl,
                  binaryStl({{{{0, 0, 0}, {1, 0, 0}, {0, -0.0f, 0}}}, {{{next, 0, 0}, {-0.0f, 0, 0}, {1, 0, 0}}}}));
        const std::vector<Triangle> triangles{{0, 1, 0}, {2, 0, 1}};
        QVERIFY(mesh->connectivity.triangles == triangles);
    }

    void errors_data()
    {
        QTest::addColumn<MeshKind>("kind");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<int>("code");
        QTest::addColumn<int>("line");
        QTest::addColumn<int>("offset");
        const auto text = [](const char *name, MeshKind kind, const QByteArray &bytes, ErrorCode code, int line) {
            QTest::newRow(name) << kind << bytes << int(code) << line << -1;
        };
        const auto binary = [](const char *name, MeshKind kind, const QByteArray &bytes, ErrorCode code,
                               qsizetype offset) {
            QTest::newRow(name) << kind << bytes << int(code) << -1 << int(offset);
        };
        const auto off = MeshKind::Off, ply = MeshKind::Ply, stl = MeshKind::Stl;

        text("OFF: empty", off, "", ErrorCode::BadMagic, 1);
        text("OFF: another word", off, "# x\nPOFF\n1 0 0\n0 0 0\n", ErrorCode::BadMagic, 2);
        text("OFF: binary", off, "OFF BINARY\n\1\2\3", ErrorCode::UnsupportedFeature, 1);
        text("OFF: 4 dimensions", off, "4OFF\n1 0 0\n0 0 0 0\n", ErrorCode::UnsupportedFeature, 1);
        text("OFF: n dimensions", off, "CnOFF\n3\n1 0 0\n0 0 0 0\n", ErrorCode::UnsupportedFeature, 1);
        text("OFF: no counts", off, "OFF\n", ErrorCode::SyntaxError, 2);
        text("OFF: negative count", off, "OFF\n-1 0 0\n", ErrorCode::BadValue, 2);
        text("OFF: hostile vertices", off, "OFF\n4000000000 0 0\n0 0 0\n", ErrorCode::Truncated, 2);
        text("OFF: hostile faces", off, "OFF\n1 4000000000 0\n0 0 0\n", ErrorCode::Truncated, 2);
        text("OFF: hostile corners", off, "OFF\n1 1 0\n0 0 0\n4000000000 0 0 0\n", ErrorCode::SyntaxError, 5);
        text("OFF: no vertices", off, "OFF\n0 0 0\n", ErrorCode::NoVertices, -1);
        text("OFF: a vertex missing", off, "OFF\n3 0 0\n0 0 0\n1 1.000000 1\n", ErrorCode::SyntaxError, 5);
        text("OFF: not a number", off, "OFF\n1 0 0\n0 x 0\n", ErrorCode::SyntaxError, 3);
        text("OFF: infinite", off, "OFF\n2 0 0\n0 0 0\n0 -inf 0\n", ErrorCode::NonFinite, 4);
        text("OFF: two corners", off, "OFF\n1 1 0\n0 0 0\n2 0 0 \n", ErrorCode::SyntaxError, 4);
        text("OFF: index too large", off, "OFF\n1 1 0\n0 0 0\n3 0 0 1\n", ErrorCode::IndexOutOfRange, 4);
        text("OFF: negative index", off, "OFF\n1 1 0\n0 0 0\n3 0 -1 0\n", ErrorCode::IndexOutOfRange, 4);
        text("OFF: a face missing", off, "OFF\n1 2 0\n0 0 0\n3 0 0 0 255 255\n", ErrorCode::SyntaxError, 5);

        const QByteArray xyz = "property float x\nproperty float y\nproperty float z\n";
        const QByteArray ascii = "ply\nformat ascii 1.0\n", little = "ply\nformat binary_little_endian 1.0\n";
        text("PLY: empty", ply, "", ErrorCode::BadMagic, 1);
        text("PLY: another word", ply, "plyx\n", ErrorCode::BadMagic, 1);
        text("PLY: no format", ply, "ply\nelement vertex 1\n" + xyz + "end_header\n", ErrorCode::SyntaxError, 6);
        text("PLY: unknown format", ply, "ply\nformat packed 1.0\n", ErrorCode::SyntaxError, 2);
        text("PLY: version", ply, "ply\nformat ascii 2.0\n", ErrorCode::UnsupportedVersion, 2);
        text("PLY: unknown line", ply, ascii + "elements 3\n", ErrorCode::SyntaxError, 3);
        text("PLY: property first", ply, ascii + "property float x\n", ErrorCode::SyntaxError, 3);
        text("PLY: unknown type", ply, ascii + "element vertex 1\nproperty half x\n", ErrorCode::SyntaxError, 4);
        text("PLY: float as length", ply, ascii + "element face 1\nproperty list float int vertex_index\n",
             ErrorCode::SyntaxError, 4);
        text("PLY: float as index", ply, ascii + "element face 1\nproperty list int float vertex_index\n",
             ErrorCode::SyntaxError, 4);
        text("PLY: negative count", ply, ascii + "element vertex -1\n", ErrorCode::BadValue, 3);
        text("PLY: no count", ply, ascii + "element vertex\n", ErrorCode::SyntaxError, 3);
        text("PLY: two vertex elements", ply, ascii + "element vertex 1\n" + xyz + "element vertex 1\n",
             ErrorCode::DuplicateChunk, 7);
        text("PLY: strips", ply, ascii + "element tristrips 1\n", ErrorCode::UnsupportedFeature, 3);
        text("PLY: no z", ply, ascii + "element vertex 1\nproperty float x\nproperty float y\nend_header\n1 2\n",
             ErrorCode::UnsupportedFeature, -1);
        text("PLY: faces without vertices", ply,
             ascii + "element vertex 1\n" + xyz + "element face 1\nproperty int i\nend_header\n1 2 3\n4\n",
             ErrorCode::UnsupportedFeature, -1);
        text("PLY: no vertex element", ply, ascii + "end_header\n", ErrorCode::NoVertices, -1);
        text("PLY: header ends early", ply, ascii + "element vertex 1\n" + xyz, ErrorCode::SyntaxError, 7);
        const QByteArray one = "element vertex 1\n" + xyz,
                         face = "element face 1\nproperty list uchar int vertex_index\n";
        text("PLY: hostile count", ply, ascii + "element vertex 4000000000\n" + xyz + "end_header\n1 2 3\n",
             ErrorCode::Truncated, 8);
        text("PLY: text ends early", ply, ascii + one + "end_header\n1.000 2\n", ErrorCode::SyntaxError, 9);
        text("PLY: not a number", ply, ascii + one + "end_header\n1 2 x3\n", ErrorCode::SyntaxError, 8);
        text("PLY: nan", ply, ascii + one + "end_header\n1 2 nan\n", ErrorCode::NonFinite, 8);
        text("PLY: text two corners", ply, ascii + one + face + "end_header\n1 2 3\n2 0 0\n", ErrorCode::SyntaxError,
             11);
        text("PLY: text index", ply, ascii + one + face + "end_header\n1 2 3\n3 0 0 1\n", ErrorCode::IndexOutOfRange,
             11);
        text("PLY: negative length", ply, ascii + one + face + "end_header\n1 2 3\n-3 0 0 0\n", ErrorCode::BadValue,
             11);
        text("PLY: hostile list", ply,
             ascii + one + "element other 1\nproperty list int int o\nend_header\n1 2 3\n4000000000 1\n",
             ErrorCode::SyntaxError, 12);
        const QByteArray start = little + one + face + "end_header\n", vertex = raw(1.f) + raw(2.f) + raw(3.f);
        const QByteArray corners = raw(std::int32_t(0)) + raw(std::int32_t(0)) + raw(std::int32_t(0));
        binary("PLY: vertex cut", ply, start + vertex.chopped(1), ErrorCode::Truncated, start.size());
        binary("PLY: face cut", ply, start + vertex + raw(std::uint8_t(3)) + corners.chopped(2), ErrorCode::Truncated,
               start.size() + 12 + 1 + 8);
        binary("PLY: too long", ply, start + vertex + raw(std::uint8_t(3)) + corners + "x", ErrorCode::TrailingBytes,
               start.size() + 12 + 1 + 12);
        binary("PLY: binary nan", ply,
               start + raw(1.f) + raw(std::numeric_limits<float>::quiet_NaN()) + raw(3.f) + "abc", ErrorCode::NonFinite,
               start.size() + 8);
        binary("PLY: binary two corners", ply, start + vertex + raw(std::uint8_t(2)) + corners, ErrorCode::SyntaxError,
               start.size() + 13);
        binary("PLY: binary index", ply, start + vertex + raw(std::uint8_t(3)) + raw(std::int32_t(-1)) + corners,
               ErrorCode::IndexOutOfRange, start.size() + 17);

        const QByteArray full = binaryStl(TwoTriangles), solid = textStl(TwoTriangles);
        text("STL: neither", stl, "hello\n", ErrorCode::BadMagic, 1);
        text("STL: empty", stl, "", ErrorCode::BadMagic, 1);
        text("STL: ends in a facet", stl, solid.left(solid.indexOf("endloop")), ErrorCode::SyntaxError, 7);
        text("STL: ends between facets", stl, solid.left(solid.indexOf("endfacet") + 8), ErrorCode::SyntaxError, 8);
        text("STL: four corners", stl, QByteArray(solid).replace("endloop", "vertex 1 1 1\nendloop"),
             ErrorCode::SyntaxError, 7);
        text("STL: nan", stl, QByteArray(solid).replace("0.5", "nan"), ErrorCode::NonFinite, 13);
        text("STL: not a number", stl, QByteArray(solid).replace("0.5", "?"), ErrorCode::SyntaxError, 13);
        text("STL: nothing in it", stl, "solid x\nendsolid\n", ErrorCode::NoVertices, -1);
        binary("STL: header cut", stl, QByteArray(50, '\0'), ErrorCode::Truncated, 50);
        binary("STL: cut", stl, full.chopped(1), ErrorCode::Truncated, full.size() - 1);
        binary("STL: too long", stl, full + "x", ErrorCode::TrailingBytes, full.size());
        binary("STL: hostile count", stl, QByteArray(full).replace(80, 4, "\xff\xff\xff\xff"), ErrorCode::Truncated,
               full.size());
        binary("STL: binary nan", stl,
               QByteArray(full).replace(84 + 12, 4, raw(std::numeric_limits<float>::infinity())), ErrorCode::NonFinite,
               84 + 12);
        binary("STL: no triangles", stl, binaryStl({}), ErrorCode::NoVertices, -1);
    }
    void errors()
    {
        QFETCH(MeshKind, kind);
        QFETCH(QByteArray, bytes);
        QFETCH(int, code);
        QFETCH(int, line);
        QFETCH(int, offset);
        const auto mesh = parse(kind, bytes);
        SANDREEL_COMPARE_ERROR(mesh, code);
        QCOMPARE(int(std::int64_t(mesh.error().line)), line);
        QCOMPARE(int(std::int64_t(mesh.error().offset)), offset);
    }

    void everyPrefixIsAnErrorOrAMesh()
    {
        const auto check = [](MeshKind kind, const QByteArray &bytes) {
            QVERIFY(parse(kind, bytes).has_value());
            tests::checkEveryPrefix(bytes, [kind](std::string_view text) { return parseMesh(kind, text); });
        };
        check(MeshKind::Off, "STOFF # c\n3 1 0\n0.25 -1e-3 0 1 1\n1 0 0 0 0\n0 1 0 0 0\n4 0 1 2 0 255 0 0\n");
        check(MeshKind::Ply, TextPly);
        check(MeshKind::Ply, binaryPly(false));
        check(MeshKind::Ply, binaryPly(true));
        check(MeshKind::Stl, textStl(TwoTriangles));
        check(MeshKind::Stl, binaryStl(TwoTriangles));
    }

    void nextFramesAreCompared_data()
    {
        QTest::addColumn<MeshKind>("kind");
        QTest::addColumn<QByteArray>("first");
        QTest::addColumn<QByteArray>("next");
        QTest::addColumn<int>("code"); // -1: no error
        QTest::addColumn<QStringList>("args");
        const auto row = [](const char *name, MeshKind kind, const QByteArray &first, const QByteArray &next,
                            std::optional<ErrorCode> code, const QStringList &args = {}) {
            QTest::newRow(name) << kind << first << next << (code ? int(*code) : -1) << args;
        };
        const auto obj = MeshKind::Obj, off = MeshKind::Off, stl = MeshKind::Stl;
        const QByteArray mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n", moved = "v 5 0 0\nv 1 5 0\nv 0 1 5\n";
        row("OBJ: the same faces", obj, mesh, moved + "f 1 2 3\nf 3 2 1\n", {});
        row("OBJ: faces written otherwise", obj, mesh, "# x\n" + moved + "f -3 2/7 3\nf 3 2 1", {});
        row("OBJ: a vertex more", obj, mesh, moved + "v 0 0 0\nf 1 2 3\nf 3 2 1\n", ErrorCode::VertexCountDiffers,
            {"4", "3", "first"});
        row("OBJ: a vertex less", obj, mesh, "v 0 0 0\nv 0 0 1\nf 1 2 1\nf 1 2 1\n", ErrorCode::VertexCountDiffers,
            {"2", "3", "first"});
        row("OBJ: a face less", obj, mesh, moved + "f 1 2 3\n", ErrorCode::FaceCountDiffers, {"1", "2", "first"});
        row("OBJ: a face more", obj, mesh, moved + "f 1 2 3\nf 3 2 1\nf 1 1 1\n", ErrorCode::FaceCountDiffers,
            {"3", "2", "first"});
        row("OBJ: a corner differs", obj, mesh, moved + "f 1 2 3\nf 3 1 2\n", ErrorCode::FacesDiffer, {"1", "first"});
        row("OBJ: a vertex behind the faces", obj, mesh + "v 9 9 9\n", "v 1 1 1\n" + mesh, {});
        row("OFF: the same faces", off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
            "OFF\n3 1 0\n5 0 0\n1 5 0\n0 1 5\n3 0 1 2\n", {});
        row("OFF: fewer faces, same text", off, "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0\n",
            "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0\n", ErrorCode::FaceCountDiffers, {"1", "2", "first"});
        auto torn = TwoTriangles, meeting = TwoTriangles;
        torn[1][1].x += 1;
        meeting[1][2] = meeting[0][0];
        row("STL: two vertices meet", stl, binaryStl(TwoTriangles), binaryStl(meeting), {});
        row("STL: a vertex is torn", stl, binaryStl(TwoTriangles), binaryStl(torn), ErrorCode::FacesDiffer,
            {"1", "first"});
        row("STL: a triangle less", stl, binaryStl(TwoTriangles), binaryStl({TwoTriangles[0]}),
            ErrorCode::FaceCountDiffers, {"1", "2", "first"});
        row("STL: text after binary", stl, binaryStl(TwoTriangles), textStl(TwoTriangles), {});
        row("PLY: other byte order", MeshKind::Ply, binaryPly(true), binaryPly(false), {});
    }
    void nextFramesAreCompared()
    {
        QFETCH(MeshKind, kind);
        QFETCH(QByteArray, first);
        QFETCH(QByteArray, next);
        QFETCH(int, code);
        QFETCH(QStringList, args);
        const auto frame = FirstFrame::parse(kind, view(first), "first");
        QVERIFY(frame.has_value());
        FirstFrame::Scratch scratch;
        std::vector<Vec3f> positions(frame->connectivity().vertexCount);
        const auto parsed = frame->parseNext(view(next), positions, scratch);
        if (code >= 0) {
            SANDREEL_COMPARE_ERROR(parsed, code);
            QCOMPARE(tests::argsOf(parsed.error()), args);
        } else {
            QVERIFY(parsed.has_value());
            if (kind != MeshKind::Stl)
                QVERIFY(positions == parse(kind, next)->positions);
        }
    }

    void endingsKnowNoCase()
    {
        QVERIFY(meshKindOf("a/b.OBJ") == MeshKind::Obj);
        QVERIFY(meshKindOf("x.y.Stl") == MeshKind::Stl);
        QVERIFY(!meshKindOf("obj"));
        QVERIFY(!meshKindOf("a.obj/b"));
    }

    void cancelStops()
    {
        const Progress progress;
        progress.cancel();
        const QByteArray off = "OFF\n1 0 0\n0 0 0\n";
        SANDREEL_COMPARE_ERROR(parseMesh(MeshKind::Off, view(off), progress), ErrorCode::Cancelled);
        const QByteArray ply = binaryPly(false), stl = binaryStl(TwoTriangles);
        SANDREEL_COMPARE_ERROR(parseMesh(MeshKind::Ply, view(ply), progress), ErrorCode::Cancelled);
        SANDREEL_COMPARE_ERROR(parseMesh(MeshKind::Stl, view(stl), progress), ErrorCode::Cancelled);
    }
};

SANDREEL_TEST(TestMeshFile)
#include "tst_meshfile.moc"
