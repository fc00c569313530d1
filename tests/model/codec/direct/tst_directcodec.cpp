// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/parallel.h"
#include "model/codec/animationcodec.h"
#include "model/codec/direct/meshwalk.h"
#include "tests/model/codec/animations.h"
#include "tests/model/codec/filesurgery.h"
#include "tests/model/codec/plain/plaindirect.h"
#include "tests/support/rows.h"
#include "tests/support/testmain.h"

#include <QFile>

#include <cmath>
#include <set>
#include <thread>

using namespace model;
using namespace model::codec;

namespace {

constexpr Predictor Predictors[] = {Predictor::None, Predictor::Still, Predictor::Steady, Predictor::Accelerating,
                                    Predictor::Neighbours};
constexpr Entropy Entropies[] = {Entropy::Deflate, Entropy::Range};

CompressionSettings settingsOf(std::uint32_t resolution, Predictor predictor = Predictor::Neighbours,
                               Entropy entropy = Entropy::Range)
{
    return {DirectSettings{resolution, predictor, entropy}};
}

struct Extent
{
    double longest = 0, largest = 0; ///< side of the box of all frames, magnitude of a coordinate
};
Extent extentOf(const FrameSource &source)
{
    Extent extent;
    for (int axis = 0; axis < 3; ++axis) {
        double least = INFINITY, most = -INFINITY;
        for (std::uint32_t f = 0; f < source.frameCount(); ++f)
            for (const Vec3f p : source.frame(f)) {
                const double x = double(axis == 0 ? p.x : axis == 1 ? p.y : p.z);
                least = std::min(least, x);
                most = std::max(most, x);
                extent.largest = std::max(extent.largest, std::fabs(x));
            }
        extent.longest = std::max(extent.longest, most - least);
    }
    return extent;
}

double largestDistance(const FrameSource &a, const FrameSource &b)
{
    double largest = 0;
    for (std::uint32_t f = 0; f < a.frameCount(); ++f) {
        const auto p = a.frame(f), q = b.frame(f);
        for (std::size_t v = 0; v < p.size(); ++v)
            largest = std::max(largest, std::hypot(double(p[v].x) - double(q[v].x), double(p[v].y) - double(q[v].y),
                                                   double(p[v].z) - double(q[v].z)));
    }
    return largest;
}

Bytes encoded(const FrameSource &source, const CompressionSettings &settings)
{
    const auto result = encodeAnimation(source, settings);
    return result ? result->bytes : Bytes();
}

Bytes smallDirect(Entropy entropy = Entropy::Range)
{
    return encoded(tests::waves(5, 12, 5), settingsOf(100, Predictor::Neighbours, entropy));
}

/// Opens and decodes everything. \returns the error's code, or -1
int outcomeOf(const Bytes &file)
{
    const auto decoded = decodeAnimation(file);
    if (!decoded)
        return int(decoded.error().code);
    for (std::uint32_t f = 0; f < (*decoded)->frameCount() && f < 100; ++f)
        for (const Vec3f p : (*decoded)->frame(f))
            if (!isFinite(p))
                return 1000;
    const auto checked = (*decoded)->check(Progress());
    return checked ? -1 : int(checked.error().code);
}

} // namespace

class TestDirectCodec final : public QObject
{
    Q_OBJECT

private slots:
    void errorIsAtMostHalfACellDiagonal_data() { tests::addRows(tests::animationTable()); }
    void errorIsAtMostHalfACellDiagonal()
    {
        QFETCH(int, row);
        const auto source = tests::animationTable()[std::size_t(row)].animation;
        const Extent extent = extentOf(*source);
        for (const std::uint32_t resolution : {1u, 2u, 100u, 4096u, 1u << 24}) {
            const double bound = std::sqrt(3.0) * extent.longest / resolution / 2;
            for (const Predictor predictor : Predictors)
                for (const Entropy entropy : Entropies) {
                    const Bytes file = encoded(*source, settingsOf(resolution, predictor, entropy));
                    const auto decoded = decodeAnimation(file);
                    QVERIFY(decoded.has_value());
                    QVERIFY((*decoded)->connectivity() == source->connectivity());
                    QCOMPARE((*decoded)->settings().codec(), CodecId::Direct);
                    QVERIFY((*decoded)->settings() == settingsOf(resolution, predictor, entropy));
                    QVERIFY((*decoded)->check(Progress()).has_value());
                    // What comes out is rounded to float once more.
                    const double rounding = 2e-7 * extent.largest;
                    QVERIFY(largestDistance(*source, **decoded) <= bound * (1 + 1e-9) + rounding);
                }
        }
    }

    void plainDecoderAgrees_data() { errorIsAtMostHalfACellDiagonal_data(); }
    void plainDecoderAgrees()
    {
        QFETCH(int, row);
        const auto source = tests::animationTable()[std::size_t(row)].animation;
        for (const Predictor predictor : Predictors)
            for (const Entropy entropy : Entropies)
                compareWithPlainDecoder(encoded(*source, settingsOf(3000, predictor, entropy)));
    }
    void plainDecoderAgreesOnSeveralGroups()
    {
        for (const Predictor predictor : Predictors)
            compareWithPlainDecoder(encoded(tests::waves(70, 300, 9), settingsOf(4096, predictor)));
    }
    void compareWithPlainDecoder(const Bytes &file)
    {
        const auto product = decodeAnimation(file);
        QVERIFY(product.has_value());
        const tests::PlainDirect plain = tests::decodeDirectPlainly(file);
        QCOMPARE(plain.error, std::string());
        QCOMPARE(plain.frames.size(), std::size_t((*product)->frameCount()));
        for (std::uint32_t f = 0; f < (*product)->frameCount(); ++f) {
            const auto frame = (*product)->frame(f);
            for (std::size_t v = 0; v < frame.size(); ++v) {
                const float found[] = {frame[v].x, frame[v].y, frame[v].z};
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const double expected = plain.origin[axis] + double(plain.frames[f][v][axis]) * plain.cell;
                    QVERIFY(found[axis] == float(expected));
                }
            }
        }
    }

    void allWaysGiveTheSamePositions()
    {
        const auto source = tests::waves(40, 200, 6);
        const auto first = *decodeAnimation(encoded(source, settingsOf(500, Predictor::None, Entropy::Deflate)));
        for (const Predictor predictor : Predictors)
            for (const Entropy entropy : Entropies) {
                const auto other = *decodeAnimation(encoded(source, settingsOf(500, predictor, entropy)));
                QCOMPARE(largestDistance(*first, *other), 0.0);
            }
    }

    void neighboursMakeSmallerFiles()
    {
        const auto source = tests::waves(64, 2000, 6);
        const std::size_t neighbours = encoded(source, settingsOf(4096)).size();
        for (const Predictor predictor : {Predictor::Still, Predictor::Steady, Predictor::Accelerating})
            QVERIFY(neighbours < encoded(source, settingsOf(4096, predictor)).size());
    }

    void flatStaysFlat()
    {
        const tests::PlainAnimation flat(3, 9, tests::strip(9), [](std::uint32_t f, std::uint32_t v) {
            return Vec3f{float(v), float(f) / 3, 0.1f};
        });
        const auto decoded = *decodeAnimation(encoded(flat, settingsOf(7)));
        for (const Vec3f p : decoded->frame(2))
            QCOMPARE(p.z, 0.1f);
    }

    void framesComeInAnyOrder()
    {
        const auto source = tests::waves(75, 400, 9);
        const Bytes file = encoded(source, settingsOf(4096));
        const auto forward = *decodeAnimation(file), jumping = *decodeAnimation(file);
        std::vector<std::vector<Vec3f>> frames;
        for (std::uint32_t f = 0; f < 75; ++f)
            frames.push_back(forward->frame(f));
        for (std::uint32_t i = 0; i < 200; ++i) {
            const std::uint32_t f = i * 29 % 75;
            QVERIFY(jumping->frame(f) == frames[f]);
        }
        for (std::uint32_t f = 75; f-- > 0;)
            QVERIFY(jumping->frame(f) == frames[f]);
    }

    void largeGroupsComeInAnyOrder()
    {
        // Too large for all frames of a group to be kept.
        const auto source = tests::waves(10, 180000, 3);
        const Bytes file = encoded(source, settingsOf(64, Predictor::Steady));
        const auto forward = *decodeAnimation(file), jumping = *decodeAnimation(file);
        std::vector<std::vector<Vec3f>> frames;
        for (std::uint32_t f = 0; f < 10; ++f)
            frames.push_back(forward->frame(f));
        for (const std::uint32_t f : {9u, 8u, 2u, 6u, 5u, 0u, 9u})
            QVERIFY(jumping->frame(f) == frames[f]);
    }

    void severalThreadsMayAsk()
    {
        const auto source = tests::waves(100, 300, 9);
        const auto decoded = *decodeAnimation(encoded(source, settingsOf(1000)));
        const auto alone = *decodeAnimation(decoded->encoded());
        std::vector<std::vector<Vec3f>> frames;
        for (std::uint32_t f = 0; f < 100; ++f)
            frames.push_back(alone->frame(f));
        std::atomic<int> wrong = 0;
        std::vector<std::thread> threads;
        for (std::uint32_t t = 0; t < 4; ++t)
            threads.emplace_back([&, t] {
                for (std::uint32_t i = 0; i < 100; ++i)
                    if (const std::uint32_t f = (i * (2 * t + 1) + 31 * t) % 100; decoded->frame(f) != frames[f])
                        ++wrong;
            });
        for (std::thread &thread : threads)
            thread.join();
        QCOMPARE(int(wrong), 0);
    }

    void sameBytesWithAnyNumberOfThreads()
    {
        const auto source = tests::waves(70, 500, 9);
        for (const Entropy entropy : Entropies) {
            setThreadCount(1);
            const Bytes one = encoded(source, settingsOf(4096, Predictor::Neighbours, entropy));
            setThreadCount(5);
            const Bytes five = encoded(source, settingsOf(4096, Predictor::Neighbours, entropy));
            setThreadCount(0);
            QVERIFY(!one.empty() && one == five);
        }
    }

    void everyPrefixIsRejected()
    {
        const Bytes file = smallDirect();
        QCOMPARE(outcomeOf(file), -1);
        for (std::size_t length = 0; length < file.size(); ++length)
            QVERIFY(!decodeAnimation(Bytes(file.begin(), file.begin() + std::ptrdiff_t(length))));
        Bytes longer = file;
        longer.push_back(0);
        QVERIFY(!decodeAnimation(longer));
    }

    void everyFlippedByteIsFound()
    {
        const Bytes file = smallDirect();
        for (std::size_t i = 0; i < file.size(); ++i) {
            Bytes flipped = file;
            flipped[i] ^= 0xff;
            QVERIFY(!decodeAnimation(flipped));
        }
    }

    void damagedPayloadsNeverCrash()
    {
        // With right checksums: what an attacker or another program could write.
        for (const Entropy entropy : Entropies) {
            const Bytes good = smallDirect(entropy);
            for (const auto &[tag, payload] : tests::takeApart(good)) {
                for (std::size_t i = 0; i < payload.size(); ++i)
                    for (const std::uint8_t change : {0x01, 0x80, 0xff})
                        QVERIFY(outcomeOf(tests::withPayload(good, tag, [&](Bytes &p) { p[i] ^= change; })) != 1000);
                for (std::size_t length = 0; length < payload.size(); ++length)
                    if (tag != "HEAD" || length > 0)
                        QVERIFY(outcomeOf(tests::withPayload(good, tag, [&](Bytes &p) { p.resize(length); })) != -1);
                QVERIFY(outcomeOf(tests::withPayload(good, tag, [](Bytes &p) { p.push_back(0); })) != -1);
            }
        }
    }

    void laterCorruptionIsFoundByCheck()
    {
        const Bytes good = encoded(tests::waves(40, 60, 9), settingsOf(4096));
        const Bytes bad = tests::withPayload(good, "FRMS", [](Bytes &p) { p[p.size() - 3] ^= 0x40; });
        const auto decoded = decodeAnimation(bad);
        QVERIFY(decoded.has_value()); // the first frame is whole
        const auto checked = (*decoded)->check(Progress());
        QVERIFY(!checked);
        QCOMPARE(int(checked.error().code), int(ErrorCode::CorruptStream));
        QVERIFY(isFinite((*decoded)->frame(39)[0]));
        const Progress cancelled;
        cancelled.cancel();
        QCOMPARE(int((*decoded)->check(cancelled).error().code), int(ErrorCode::Cancelled));
    }

    void corruptedParametersHaveTheirErrors_data()
    {
        QTest::addColumn<int>("at");
        QTest::addColumn<int>("value");
        QTest::addColumn<QString>("field");
        QTest::newRow("resolution 0") << 0 << 0 << "resolution";
        QTest::newRow("predictor") << 1 << 5 << "predictor";
        QTest::newRow("entropy") << 2 << 2 << "entropy coder";
        QTest::newRow("group 0") << 3 << 0 << "frames per group";
        QTest::newRow("negative cell") << 11 << 0xbf << "cell";
        QTest::newRow("infinite cell") << 11 << 0x7f << "cell";
        QTest::newRow("infinite origin") << 19 << 0x7f << "origin";
    }
    void corruptedParametersHaveTheirErrors()
    {
        QFETCH(int, at);
        QFETCH(int, value);
        QFETCH(QString, field);
        const Bytes file =
            tests::withPayload(smallDirect(), "DIRP", [&](Bytes &p) { p[std::size_t(at)] = std::uint8_t(value); });
        const auto decoded = decodeAnimation(file);
        QVERIFY(!decoded);
        QCOMPARE(int(decoded.error().code), int(ErrorCode::BadValue));
        QCOMPARE(QString::fromStdString(decoded.error().args.at(0)), field);
        QVERIFY(decoded.error().offset != Error::None);
    }

    void hostileCountsDoNotAllocate()
    {
        // 2^30 vertices, triangles, or 2^26 frames in a small file.
        const Bytes good = smallDirect();
        const auto withCounts = [&](std::vector<std::uint8_t> counts) {
            return tests::withPayload(good, "HEAD", [&](Bytes &p) {
                p.erase(p.begin() + 4, p.begin() + 7);
                p.insert(p.begin() + 4, counts.begin(), counts.end());
            });
        };
        const std::vector<std::uint8_t> much{0x80, 0x80, 0x80, 0x80, 0x04};
        std::vector<std::uint8_t> vertices = much, triangles{12}, frames{12, 10};
        vertices.insert(vertices.end(), {10, 5});
        triangles.insert(triangles.end(), much.begin(), much.end());
        triangles.push_back(5);
        frames.insert(frames.end(), {0x80, 0x80, 0x80, 0x20});
        QCOMPARE(outcomeOf(withCounts(vertices)), int(ErrorCode::LimitExceeded));
        QCOMPARE(outcomeOf(withCounts(triangles)), int(ErrorCode::LimitExceeded));
        QCOMPARE(outcomeOf(withCounts(frames)), int(ErrorCode::BadValue)); // more streams than bytes left
    }

    void memoryIsBounded()
    {
        const Bytes file = encoded(tests::waves(20, 500, 5), settingsOf(1000));
        DecodeLimits limits;
        limits.memoryBytes = 100000;
        QCOMPARE(int(decodeAnimation(file, Progress(), limits).error().code), int(ErrorCode::LimitExceeded));
        limits.memoryBytes = 8u << 20;
        const auto decoded = decodeAnimation(file, Progress(), limits);
        QVERIFY(decoded.has_value());
        QVERIFY((*decoded)->memoryBytes() > file.size() && (*decoded)->memoryBytes() < (4u << 20));
    }

    void cancelStops()
    {
        const auto source = tests::waves(64, 3000, 10);
        for (const double at : {0.0, 0.1, 0.5}) {
            std::shared_ptr<Progress> handle;
            handle = std::make_shared<Progress>([&](double fraction) {
                if (fraction >= at)
                    handle->cancel();
            });
            const auto result = encodeAnimation(source, settingsOf(1000), *handle);
            QVERIFY(!result);
            QCOMPARE(int(result.error().code), int(ErrorCode::Cancelled));
        }
    }

    void badSettingsAreRefused()
    {
        const auto source = tests::waves(3, 9, 1);
        const auto settingOf = [&](const CompressionSettings &settings) {
            const auto result = encodeAnimation(source, settings);
            return result || result.error().code != ErrorCode::BadSetting ? "" : result.error().args.at(0);
        };
        QCOMPARE(settingOf(settingsOf(0)), std::string("resolution"));
        QCOMPARE(settingOf(settingsOf((1u << 24) + 1)), std::string("resolution"));
        QCOMPARE(settingOf(settingsOf(10, Predictor(5))), std::string("predictor"));
        QCOMPARE(settingOf(settingsOf(10, Predictor::None, Entropy(2))), std::string("entropy"));
    }

    void walkTakesEachVertexOnce_data() { errorIsAtMostHalfACellDiagonal_data(); }
    void walkTakesEachVertexOnce()
    {
        QFETCH(int, row);
        const auto source = tests::animationTable()[std::size_t(row)].animation;
        const Connectivity &connectivity = source->connectivity();
        std::vector<std::set<std::uint32_t>> neighbours(connectivity.vertexCount);
        for (const Triangle &t : connectivity.triangles)
            for (const std::uint32_t a : t)
                for (const std::uint32_t b : t)
                    if (a != b)
                        neighbours[a].insert(b);
        for (const auto order : {MeshWalk::Order::File, MeshWalk::Order::Growing}) {
            const MeshWalk walk(connectivity, order);
            std::set<std::uint32_t> taken;
            for (std::size_t place = 0; place < walk.vertexCount(); ++place) {
                const std::uint32_t v = walk.vertex(place);
                std::set<std::uint32_t> expected;
                for (const std::uint32_t n : neighbours[v])
                    if (taken.count(n))
                        expected.insert(n);
                if (order == MeshWalk::Order::Growing) {
                    // Nobody waits who has more known neighbours.
                    std::size_t most = 0;
                    for (std::uint32_t u = 0; u < connectivity.vertexCount; ++u) {
                        const auto known = std::ranges::count_if(neighbours[u], [&](auto n) { return taken.count(n); });
                        if (!taken.count(u))
                            most = std::max(most, std::min<std::size_t>(8, std::size_t(known)));
                    }
                    QVERIFY(std::min<std::size_t>(8, expected.size()) == most);
                }
                if (expected.empty() && place > 0)
                    expected.insert(walk.vertex(place - 1));
                const auto known = walk.known(place);
                QVERIFY(std::set<std::uint32_t>(known.begin(), known.end()) == expected);
                QCOMPARE(known.size(), expected.size());
                for (const auto &p : walk.parallelograms(place)) {
                    QVERIFY(taken.count(p.a) && taken.count(p.b) && taken.count(p.opposite));
                    QVERIFY(neighbours[v].count(p.a) && neighbours[v].count(p.b));
                    QVERIFY(neighbours[p.opposite].count(p.a) && neighbours[p.opposite].count(p.b));
                }
                QVERIFY(taken.insert(v).second);
            }
            QCOMPARE(taken.size(), std::size_t(connectivity.vertexCount));
        }
    }
};

SANDREEL_TEST(TestDirectCodec)
#include "tst_directcodec.moc"
