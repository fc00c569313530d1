// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/objreader.h"
#include "tests/model/io/iotest.h"
#include "tests/support/testmain.h"

#include <random>
#include <sstream>

using namespace model;
using namespace model::io;

namespace {

Result<TriangleMesh> parse(std::string_view text)
{
    ParsedMesh obj;
    const auto parsed = parseObj(text, obj);
    if (!parsed)
        return fail(parsed.error());
    return obj.mesh;
}

/// The same format read slowly and plainly, by other means: the independent answer.
TriangleMesh referenceMesh(const std::string &text)
{
    TriangleMesh mesh;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        words.imbue(std::locale::classic());
        std::string word;
        words >> word;
        if (word == "v") {
            Vec3f p;
            words >> p.x >> p.y >> p.z;
            mesh.positions.push_back(p);
        } else if (word == "f") {
            std::vector<std::uint32_t> polygon;
            while (words >> word) {
                const int index = std::stoi(word);
                polygon.push_back(index < 0 ? std::uint32_t(int(mesh.positions.size()) + index)
                                            : std::uint32_t(index - 1));
            }
            for (std::size_t i = 2; i < polygon.size(); ++i)
                mesh.connectivity.triangles.push_back({polygon[0], polygon[i - 1], polygon[i]});
        }
    }
    mesh.connectivity.vertexCount = std::uint32_t(mesh.positions.size());
    return mesh;
}

std::string randomObj(unsigned seed)
{
    std::mt19937 random(seed);
    const auto below = [&random](unsigned limit) { return unsigned(random() % limit); };
    std::uniform_real_distribution<float> coordinate(-10, 10);
    std::ostringstream text;
    text.precision(int(1 + below(9)));
    text << "# random\nmtllib a.mtl\n";
    unsigned vertexCount = 0;
    for (unsigned block = 0; block < 5; ++block) {
        for (unsigned i = 0; i < 4 + below(20); ++i, ++vertexCount) {
            text << "v " << coordinate(random) << ' ' << coordinate(random) << "\t" << coordinate(random)
                 << (below(3) == 0 ? " 1 0.5 0\n" : "\n");
        }
        text << "vt 0.5 0.5\nvn 0 0 1\ng part" << block << "\ns off\n";
        for (unsigned i = 0; i < below(20); ++i) {
            text << (below(2) ? "f" : "  f");
            for (unsigned corner = 0; corner < 3 + below(4); ++corner) {
                const int index = below(2) ? int(1 + below(vertexCount)) : -int(1 + below(vertexCount));
                static const char *const tails[] = {"", "/1", "//1", "/1/1", "/-1/-1"};
                text << ' ' << index << tails[below(5)];
            }
            text << "\n";
        }
    }
    return text.str();
}

} // namespace

class TestObjReader final : public QObject
{
    Q_OBJECT

private slots:
    void readsLikeTheReference()
    {
        for (unsigned seed = 0; seed < 200; ++seed) {
            const std::string text = randomObj(seed);
            const auto mesh = parse(text);
            QVERIFY(mesh.has_value());
            const TriangleMesh expected = referenceMesh(text);
            QVERIFY(mesh->positions == expected.positions);
            QVERIFY(mesh->connectivity == expected.connectivity);
        }
    }

    void carriageReturnsMakeNoDifference()
    {
        const std::string text = randomObj(3);
        std::string dos;
        for (const char c : text)
            dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
        QVERIFY(parse(dos)->positions == parse(text)->positions);
        QVERIFY(parse(dos)->connectivity == parse(text)->connectivity);
    }

    void polygonsBecomeFans()
    {
        const auto mesh = parse("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 2 2\nf 1 2 3 4 5\n");
        const std::vector<Triangle> fan{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
        QVERIFY(mesh->connectivity.triangles == fan);
    }

    void dirtyFacesStayAsTheyAre()
    {
        const auto mesh = parse("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 9 9 9\nf 1 2 3\nf 1 2 3\nf 3 2 1\nf 1 1 2\nf 2 2 2\n");
        const std::vector<Triangle> same{{0, 1, 2}, {0, 1, 2}, {2, 1, 0}, {0, 0, 1}, {1, 1, 1}};
        QVERIFY(mesh->connectivity.triangles == same);
        QCOMPARE(mesh->connectivity.vertexCount, 4u);
    }

    void oddButLegalForms_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("plain") << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0.5\nf 1 2 3\n");
        QTest::newRow("no newline at the end") << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0.5\nf 1 2 3");
        QTest::newRow("byte order mark") << QByteArray("\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0.5\nf 1 2 3\n");
        QTest::newRow("continuation") << QByteArray("v 0 \\\n0 0\nv 1 0 0\nv 0 1 0.5\nf 1 \\\r\n 2 \\\n\\\n3\n");
        QTest::newRow("joined continuation") << QByteArray("v 0 0\\\n 0\nv 1 0 0\nv 0 1 0.5\nf 1 2\\\n 3\n");
        QTest::newRow("face before its vertices") << QByteArray("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0.5\n");
        QTest::newRow("plus and exponent") << QByteArray("v +0 0e5 -0.0\nv 1e0 0 0\nv 0 10e-1 5E-1\nf 1 2 3\n");
        QTest::newRow("comment after a face") << QByteArray("v 0 0 0 #a\nv 1 0 0\nv 0 1 0.5\nf 1 2 3 # v 5\n");
        QTest::newRow("comment ending in a backslash")
            << QByteArray("# C:\\path\\\nv 0 0 0\nv 1 0 0\nv 0 1 0.5\nf 1 2 3\n");
        QTest::newRow("other statements")
            << QByteArray("o x\nvt 1\nvp 1 2\nv 0 0 0\nvn a b c\nv 1 0 0\nv 0 1 0.5\nfo 9 9 9\nl 1 2\np 1\nf 1 2 3\n");
        QTest::newRow("tabs and blanks") << QByteArray("\t v\t0 0  0 \nv 1 0 0\t\nv 0 1 0.5\n \tf\t1  2 3\t \n\n\n");
        QTest::newRow("a very long line") << QByteArray("v 0 0 0 ") + QByteArray(1 << 20, '7') +
                                                 "\nv 1 0 0\nv 0 1 0.5\nf 1 2" + QByteArray(100'000, ' ') + "3\n#" +
                                                 QByteArray(1 << 20, '#');
    }
    void oddButLegalForms()
    {
        QFETCH(QByteArray, text);
        const auto mesh = parse(std::string_view(text.constData(), std::size_t(text.size())));
        QVERIFY(mesh.has_value());
        const std::vector<Vec3f> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5f}};
        const std::vector<Triangle> triangles{{0, 1, 2}};
        QVERIFY(mesh->positions == positions);
        QVERIFY(mesh->connectivity.triangles == triangles);
        QCOMPARE(mesh->connectivity.vertexCount, 3u);
    }

    void errorsNameTheLine_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("code");
        QTest::addColumn<int>("line");
        QTest::addColumn<QStringList>("args");
        const auto row = [](const char *name, const char *text, ErrorCode code, int line, QStringList args) {
            QTest::newRow(name) << QByteArray(text) << int(code) << line << args;
        };
        const QString coordinate = "a coordinate", index = "a vertex number",
                      corners = "a face with at least 3 corners";
        row("two coordinates", "v 0 0 0\nv 1 2\n", ErrorCode::SyntaxError, 2, {coordinate, "the end of the line"});
        row("two coordinates at the end", "v 1 2", ErrorCode::SyntaxError, 1, {coordinate, "the end of the file"});
        row("decimal comma", "v 0 0 0\n\nv 1,5 2 3\n", ErrorCode::SyntaxError, 3, {coordinate, "\"1,5\""});
        row("a word", "v 0 zero 0\n", ErrorCode::SyntaxError, 1, {coordinate, "\"zero\""});
        row("not printable", "v 0 \x01\xff 0\n", ErrorCode::SyntaxError, 1, {coordinate, "\"??\""});
        row("nan", "v 0 0 0\nv 0 nan 0\n", ErrorCode::NonFinite, 2, {"vertex 2"});
        row("infinite", "v 0 0 0\nv 0 0 1e39\n", ErrorCode::NonFinite, 2, {"vertex 2"});
        row("two corners", "v 0 0 0\nv 0 0 1\nf 1 2\n", ErrorCode::SyntaxError, 3, {corners, "the end of the line"});
        row("no corner", "v 0 0 0\nf \n", ErrorCode::SyntaxError, 2, {corners, "the end of the line"});
        row("after a continuation", "v 0 \\\n 0 0\nv 1 \\\n2 x\n", ErrorCode::SyntaxError, 4, {coordinate, "\"x\""});
        row("index zero", "v 0 0 0\nf 1 1 0\n", ErrorCode::IndexOutOfRange, 2, {"0", "1"});
        row("index too large", "v 0 0 0\nf 1 1 1\nf 1 2 3\nf 1 1 9\n", ErrorCode::IndexOutOfRange, 3, {"2", "1"});
        row("index too large later", "f 1 1 2\nf 1 3 1\nf 1 1 4\nv 0 0 0\nv 0 0 0\n", ErrorCode::IndexOutOfRange, 2,
            {"3", "2"});
        row("index too far back", "v 0 0 0\nf -1 -1 -2\nv 0 0 0\n", ErrorCode::IndexOutOfRange, 2, {"-2", "1"});
        row("index beyond 32 bits", "v 0 0 0\nf 1 1 4294967297\n", ErrorCode::IndexOutOfRange, 2, {"4294967297", "1"});
        row("index beyond 64 bits", "v 0 0 0\nf 1 1 99999999999999999999\n", ErrorCode::SyntaxError, 2,
            {index, "\"99999999999999999999\""});
        row("a word as index", "v 0 0 0\nf 1 1 one\n", ErrorCode::SyntaxError, 2, {index, "\"one\""});
        row("a fraction as index", "v 0 0 0\nf 1 1 1.0\n", ErrorCode::SyntaxError, 2, {index, "\"1.0\""});
    }
    void errorsNameTheLine()
    {
        QFETCH(QByteArray, text);
        QFETCH(int, code);
        QFETCH(int, line);
        QFETCH(QStringList, args);
        const auto mesh = parse(std::string_view(text.constData(), std::size_t(text.size())));
        SANDREEL_COMPARE_ERROR(mesh, code);
        QCOMPARE(mesh.error().line, std::uint64_t(line));
        QCOMPARE(tests::argsOf(mesh.error()), args);
    }

    void withoutVerticesIsAnError()
    {
        for (const char *const text : {"", "\n", "# nothing\n", "hello\n", "\xEF\xBB\xBF"})
            SANDREEL_COMPARE_ERROR(parse(text), ErrorCode::NoVertices);
    }

    void knownFacesAreNotParsed()
    {
        const std::string first = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n";
        ParsedMesh obj;
        QCOMPARE(*parseObj(first, obj), false);
        QVERIFY(obj.facesLast);
        const KnownFaces known{std::string_view(first).substr(obj.facesBegin), 3};
        QVERIFY(known.text == "f 1 2 3\nf 3 2 1\n");

        const std::string moved = "v 5 5 5\nv 6 5 5\nv 5 6 5\nf 1 2 3\nf 3 2 1\n";
        ParsedMesh next;
        QCOMPARE(*parseObj(moved, next, Progress(), known), true);
        QVERIFY(next.mesh.positions == referenceMesh(moved).positions);

        // The same text means something else after another number of vertices.
        const std::string more = "v 5 5 5\nv 6 5 5\nv 5 6 5\nv 0 0 0\nf 1 2 3\nf 3 2 1\n";
        QCOMPARE(*parseObj(more, next, Progress(), known), false);
        QCOMPARE(next.mesh.connectivity.triangles.size(), std::size_t(2));
        const std::string other = "v 5 5 5\nv 6 5 5\nv 5 6 5\nf 1 2 3\nf 3 1 2\n";
        QCOMPARE(*parseObj(other, next, Progress(), known), false);
        QVERIFY(next.mesh.connectivity == referenceMesh(other).connectivity);
    }

    void verticesAfterFacesAreNoticed()
    {
        ParsedMesh obj;
        QVERIFY(parseObj("v 0 0 0\nf 1 1 1\nv 1 1 1\nf 1 2 2\n", obj).has_value());
        QVERIFY(!obj.facesLast);
    }

    void everyPrefixIsAnErrorOrAMesh()
    {
        tests::checkEveryPrefix("\xEF\xBB\xBF# c\nv 0.5 -1e-3 12345678.9\nvt 0 0\nv 1 0 0 \\\n 1\nv 0 1 0\r\n"
                                "f 1/1/1 2//2 \\\n-1\nf 1 2 3 1\n",
                                parse);
    }

    void cancelStops()
    {
        std::string text;
        for (int i = 0; i < 200'000; ++i)
            text += "v 0 0 0\n";
        const Progress progress;
        progress.cancel();
        ParsedMesh obj;
        SANDREEL_COMPARE_ERROR(parseObj(text, obj, progress), ErrorCode::Cancelled);
    }
};

SANDREEL_TEST(TestObjReader)
#include "tst_objreader.moc"
