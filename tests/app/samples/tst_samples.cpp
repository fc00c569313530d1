// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/samples/samples.h"
#include "tests/support/testmain.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

using model::Sequence;
using model::Triangle;
using model::Vec3f;

/// The bundled animations are what their descriptions say.
class TestSamples : public QObject
{
    Q_OBJECT
private slots:
    void positionsAreFinite_data() { addSamples(); }
    void positionsAreFinite();
    void componentsAreWhatTheyShouldBe_data() { addSamples(); }
    void componentsAreWhatTheyShouldBe();
    void sameOnEveryRun_data() { addSamples(); }
    void sameOnEveryRun();
    void loopsCloseSmoothly_data();
    void loopsCloseSmoothly();
    void clothStaysOutsideTheBall();
    void clothHardlyStretches();
    void clothFallsAndComesToRest();

private:
    static void addSamples();
    static const Sequence &sequenceOf(const QString &name);
};

namespace {

constexpr std::uint32_t ClothSide = 76;
constexpr std::uint32_t ClothVertices = ClothSide * ClothSide;
constexpr float BallRadius = 0.55f;

/// The farthest that a vertex of first..last-1 goes from one frame to another.
float largestMove(const Sequence &sequence, std::uint32_t from, std::uint32_t to, std::uint32_t vertexCount)
{
    float largest = 0;
    for (std::uint32_t i = 0; i < vertexCount; ++i)
        largest = std::max(largest, length(sequence.frameView(to)[i] - sequence.frameView(from)[i]));
    return largest;
}

struct Component
{
    int eulerNumber = 0;
    std::size_t boundaryEdges = 0;
    double volume = 0; ///< of the first frame; above zero: faces look outwards
};

/// By shared vertices, in the order of their first vertex; fails the test where an edge has two triangles on one side.
std::vector<Component> componentsOf(const Sequence &sequence)
{
    const auto &triangles = sequence.connectivity().triangles;
    std::vector<std::uint32_t> root(sequence.vertexCount());
    std::iota(root.begin(), root.end(), 0u);
    const auto find = [&root](std::uint32_t v) {
        while (root[v] != v)
            v = root[v] = root[root[v]];
        return v;
    };
    std::set<std::pair<std::uint32_t, std::uint32_t>> halfEdges;
    for (const Triangle &t : triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = find(t[i]), b = find(t[(i + 1) % 3]);
            root[std::max(a, b)] = std::min(a, b);
            if (!halfEdges.emplace(t[i], t[(i + 1) % 3]).second)
                QTest::qFail("an edge has two triangles on one side", __FILE__, __LINE__);
        }
    std::map<std::uint32_t, Component> components;
    for (std::uint32_t v = 0; v < sequence.vertexCount(); ++v)
        ++components[find(v)].eulerNumber;
    for (const auto &[a, b] : halfEdges) {
        const bool isBoundary = !halfEdges.contains({b, a});
        if (isBoundary || a < b)
            --components[find(a)].eulerNumber;
        components[find(a)].boundaryEdges += isBoundary;
    }
    const auto first = sequence.frameView(0);
    for (const Triangle &t : triangles) {
        Component &component = components[find(t[0])];
        ++component.eulerNumber;
        component.volume += double(dot(first[t[0]], cross(first[t[1]], first[t[2]]))) / 6;
    }
    std::vector<Component> result;
    for (const auto &[vertex, component] : components)
        result.push_back(component);
    return result;
}

} // namespace

void TestSamples::addSamples()
{
    QTest::addColumn<int>("components");
    QTest::newRow("cloth") << 2;
    QTest::newRow("walker") << 4 + 2 * 2 + 4 * 3 + 1; // body and head; eyes and ears; legs; tail
    QTest::newRow("jellyfish") << 1 + 4 + 10;         // bell; arms; tentacles
}

const Sequence &TestSamples::sequenceOf(const QString &name)
{
    static const std::map<QString, model::Sequence (*)()> makers{
        {"cloth", samples::makeCloth}, {"walker", samples::makeWalker}, {"jellyfish", samples::makeJellyfish}};
    static std::map<QString, std::unique_ptr<const Sequence>> made;
    auto &sequence = made[name];
    if (!sequence)
        sequence.reset(new Sequence(makers.at(name)()));
    return *sequence;
}

void TestSamples::positionsAreFinite()
{
    const Sequence &sequence = sequenceOf(QTest::currentDataTag());
    QVERIFY(sequence.frameCount() >= 100);
    QVERIFY(sequence.frameRate() == 30);
    QVERIFY(!sequence.name().empty());
    QVERIFY(std::ranges::all_of(sequence.allPositions(), [](Vec3f p) { return isFinite(p) && length(p) < 10; }));
}

void TestSamples::componentsAreWhatTheyShouldBe()
{
    QFETCH(const int, components);
    const std::vector<Component> found = componentsOf(sequenceOf(QTest::currentDataTag()));
    QCOMPARE(int(found.size()), components);
    const bool isCloth = QByteArray(QTest::currentDataTag()) == "cloth";
    for (std::size_t i = 0; i < found.size(); ++i) {
        const bool isDisc = isCloth && i == 0;
        QCOMPARE(found[i].eulerNumber, isDisc ? 1 : 2);
        QCOMPARE(found[i].boundaryEdges, std::size_t(isDisc ? 4 * (ClothSide - 1) : 0));
        QVERIFY2(isDisc || found[i].volume > 0, qPrintable(QStringLiteral("component %1 is inside out").arg(i)));
    }
}

void TestSamples::sameOnEveryRun()
{
    const QString name = QTest::currentDataTag();
    const Sequence again = name == "cloth"    ? samples::makeCloth()
                           : name == "walker" ? samples::makeWalker()
                                              : samples::makeJellyfish();
    QVERIFY(std::ranges::equal(again.allPositions(), sequenceOf(name).allPositions()));
    QVERIFY(again.connectivity().triangles == sequenceOf(name).connectivity().triangles);
}

void TestSamples::loopsCloseSmoothly_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("walker") << "walker";
    QTest::newRow("jellyfish") << "jellyfish";
}

/// From the last frame back to the first is a step as any other.
void TestSamples::loopsCloseSmoothly()
{
    QFETCH(const QString, name);
    const Sequence &sequence = sequenceOf(name);
    const std::uint32_t last = sequence.frameCount() - 1;
    float largest = 0;
    for (std::uint32_t frame = 0; frame < last; ++frame)
        largest = std::max(largest, largestMove(sequence, frame, frame + 1, sequence.vertexCount()));
    const float closing = largestMove(sequence, last, 0, sequence.vertexCount());
    QVERIFY2(closing > 0 && closing <= 1.01f * largest,
             qPrintable(QStringLiteral("%1, largest step %2").arg(double(closing)).arg(double(largest))));
    QVERIFY(largest < 0.15f); // no jump in between either
}

void TestSamples::clothStaysOutsideTheBall()
{
    const Sequence &cloth = sequenceOf("cloth");
    for (std::uint32_t frame = 0; frame < cloth.frameCount(); ++frame) {
        const auto positions = cloth.frameView(frame);
        for (std::uint32_t i = 0; i < ClothVertices; ++i)
            QVERIFY2(length(positions[i]) >= BallRadius,
                     qPrintable(QStringLiteral("vertex %1 in frame %2").arg(i).arg(frame)));
        // The ball itself does not move.
        for (std::uint32_t i = ClothVertices; i < cloth.vertexCount(); ++i)
            QVERIFY(std::abs(length(positions[i]) - BallRadius) < 1e-5f);
    }
}

void TestSamples::clothHardlyStretches()
{
    const Sequence &cloth = sequenceOf("cloth");
    const auto lengthOf = [&cloth](std::uint32_t frame, std::uint32_t a, std::uint32_t b) {
        return length(cloth.frameView(frame)[a] - cloth.frameView(frame)[b]);
    };
    // While it swings and touches itself single edges give way for a moment; at rest hardly any does.
    for (std::uint32_t frame = 0; frame < cloth.frameCount(); ++frame) {
        std::size_t within = 0;
        std::vector<float> ratios;
        for (std::uint32_t i = 0; i < ClothVertices; ++i)
            for (const std::uint32_t next : {i + 1, i + ClothSide}) {
                if (next >= ClothVertices || (next == i + 1 && next % ClothSide == 0))
                    continue;
                ratios.push_back(lengthOf(frame, i, next) / lengthOf(0, i, next));
                within += std::abs(ratios.back() - 1) < 0.15f;
            }
        std::ranges::nth_element(ratios, ratios.begin() + std::ptrdiff_t(ratios.size() / 2));
        const float median = ratios[ratios.size() / 2];
        const double share = double(within) / double(ratios.size());
        QVERIFY2(std::abs(median - 1) < 0.03f && share > (frame < 100 ? 0.85 : 0.99),
                 qPrintable(QStringLiteral("frame %1: %2, %3").arg(frame).arg(double(median)).arg(share)));
    }
}

void TestSamples::clothFallsAndComesToRest()
{
    const Sequence &cloth = sequenceOf("cloth");
    float fastest = 0;
    for (std::uint32_t frame = 0; frame + 1 < cloth.frameCount(); ++frame)
        fastest = std::max(fastest, largestMove(cloth, frame, frame + 1, ClothVertices));
    QVERIFY(fastest > 0.03f);
    const std::uint32_t last = cloth.frameCount() - 1;
    const float end = largestMove(cloth, last - 1, last, ClothVertices);
    QVERIFY2(end < 0.1f * fastest, qPrintable(QStringLiteral("%1 of %2").arg(double(end)).arg(double(fastest))));
    // It hangs over the ball: the middle on top, corners below the ball's middle.
    const auto positions = cloth.frameView(last);
    QVERIFY(positions[ClothVertices / 2 + ClothSide / 2].y > 0.8f * BallRadius);
    for (const std::uint32_t corner : {0u, ClothSide - 1, ClothVertices - ClothSide, ClothVertices - 1})
        QVERIFY(positions[corner].y < 0);
}

SANDREEL_TEST(TestSamples)
#include "tst_samples.moc"
