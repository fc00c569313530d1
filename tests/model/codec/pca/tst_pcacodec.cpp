// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/sequence.h"
#include "model/base/parallel.h"
#include "model/codec/animationcodec.h"
#include "model/codec/basis/kernels.h"
#include "tests/model/codec/animations.h"
#include "tests/model/codec/filesurgery.h"
#include "tests/support/rows.h"
#include "tests/support/testmain.h"

#include <Eigen/Eigenvalues>

#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>
#include <thread>

using namespace model;
using namespace model::codec;

namespace {

CompressionSettings settingsOf(std::uint32_t basisSize, double resolution)
{
    return {PcaSettings{basisSize, resolution}};
}

/// S minus its row means, in double, straight from the definition.
Eigen::MatrixXd centred(const FrameSource &source)
{
    Eigen::MatrixXd s(3 * source.frameCount(), source.vertexCount());
    for (std::uint32_t f = 0; f < source.frameCount(); ++f) {
        const auto frame = source.frame(f);
        for (std::uint32_t v = 0; v < source.vertexCount(); ++v)
            s.col(v).segment(3 * f, 3) << double(frame[v].x), double(frame[v].y), double(frame[v].z);
    }
    s.colwise() -= s.rowwise().mean().eval();
    return s;
}

ErrorCode encodeError(const FrameSource &source, const CompressionSettings &settings)
{
    const auto encoded = encodeAnimation(source, settings);
    return encoded ? ErrorCode(0xffff) : encoded.error().code;
}

/// Restores the number of threads at the end of a test.
struct Threads
{
    explicit Threads(unsigned count) { setThreadCount(count); }
    ~Threads() { setThreadCount(0); }
};

} // namespace

class TestPcaCodec final : public QObject
{
    Q_OBJECT

private:
    static void addTable() { tests::addRows(tests::animationTable()); }

private slots:
    void roundTrip_data() { addTable(); }
    void roundTrip()
    {
        QFETCH(int, row);
        const auto entry = tests::animationTable()[std::size_t(row)];
        const FrameSource &source = *entry.animation;
        const auto settings = settingsOf(60, 1e5);
        const auto encoded = encodeAnimation(source, settings);
        QVERIFY(encoded.has_value());
        const auto decoded = decodeAnimation(encoded->bytes);
        QVERIFY(decoded.has_value());
        const DecodedAnimation &animation = **decoded;
        QCOMPARE(animation.frameCount(), source.frameCount());
        QVERIFY(animation.connectivity() == source.connectivity());
        QCOMPARE(animation.frameRate(), 24.0);
        QCOMPARE(animation.name(), std::string("plain"));
        QVERIFY(animation.creator().starts_with("Sandreel "));
        QVERIFY(animation.settings() == settings);
        QVERIFY(animation.encoded() == encoded->bytes);
        QCOMPARE(animation.encodedBytes(), std::uint64_t(encoded->bytes.size()));
        for (std::uint32_t v = 0; v < source.vertexCount(); ++v)
            QCOMPARE(encoded->permutation.at(v), v);
        // Half a unit in the last place of the largest coordinate comes on top of the quantisation.
        const double bound = 1e-3 + (entry.name == "far from the origin" ? 0.25 : 0);
        const double error = tests::largestError(source, animation);
        QVERIFY2(error <= bound, qPrintable(QString::number(error)));
    }

    void lowResolutionIsCoarseButWhole_data() { addTable(); }
    void lowResolutionIsCoarseButWhole()
    {
        QFETCH(int, row);
        const auto entry = tests::animationTable()[std::size_t(row)];
        const auto encoded = encodeAnimation(*entry.animation, settingsOf(1000, 1));
        QVERIFY(encoded.has_value());
        const auto decoded = decodeAnimation(encoded->bytes);
        QVERIFY(decoded.has_value());
        for (const Vec3f p : (*decoded)->frame(0))
            QVERIFY(isFinite(p));
    }

    void rankIsNotExceeded()
    {
        const auto kept = [](const FrameSource &source) {
            return (*decodeAnimation(encodeAnimation(source, settingsOf(50, 1e4))->bytes))->basisSize();
        };
        const auto table = tests::animationTable();
        for (const auto &[name, animation] : table) {
            if (name == "all at one point" || name == "all at one moving point")
                QCOMPARE(kept(*animation), 0u);
            if (name == "one vertex") // a trajectory may make up for the rounding of the means
                QVERIFY(kept(*animation) <= 1);
            if (name == "still")
                QVERIFY(kept(*animation) <= 1); // on a line
            if (name == "one frame")
                QVERIFY(kept(*animation) <= 3);
        }
        const auto wave = tests::waves(30, 400, 4);
        QCOMPARE((*decodeAnimation(encodeAnimation(wave, settingsOf(2, 1e4))->bytes))->basisSize(), 2u);
    }

    // The best that K trajectories can do is known: the singular values that are left out (Eckart and Young).
    void errorIsThatOfTheBestBasis_data()
    {
        QTest::addColumn<int>("frames");
        QTest::addColumn<int>("vertices");
        QTest::newRow("more vertices than rows") << 20 << 300;
        QTest::newRow("fewer vertices than rows") << 60 << 100;
        QTest::newRow("large enough for the iterative solver") << 150 << 600;
    }
    void errorIsThatOfTheBestBasis()
    {
        QFETCH(int, frames);
        QFETCH(int, vertices);
        const auto source = tests::waves(std::uint32_t(frames), std::uint32_t(vertices), 30);
        const Eigen::MatrixXd s = centred(source);
        const Eigen::MatrixXd narrow = s.rows() < s.cols() ? s : Eigen::MatrixXd(s.transpose());
        const Eigen::MatrixXd gram = narrow * narrow.transpose();
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(gram, Eigen::EigenvaluesOnly);
        const Eigen::VectorXd singular = solver.eigenvalues().cwiseMax(0).cwiseSqrt().reverse();
        for (const Eigen::Index k : {1, 3, 8, 15}) {
            const double best = 100 * singular.tail(singular.size() - k).norm() / singular.norm();
            const double resolution = 1e6;
            const auto encoded = encodeAnimation(source, settingsOf(std::uint32_t(k), resolution));
            const double error = tests::kgErrorPercent(source, **decodeAnimation(encoded->bytes));
            // Quantisation of the basis by half a step, times the size of the coefficients, and of the rest.
            const double quantisation = 100 * (0.5 / resolution) * std::sqrt(double(k)) *
                                        (std::sqrt(double(s.rows())) + std::sqrt(double(s.cols())) / singular.norm());
            QVERIFY2(error > 0.999 * best && error < 1.002 * best + quantisation,
                     qPrintable(QString("%1 for %2").arg(error).arg(best)));
        }
    }

    void manyFramesAndManyVertices()
    {
        // Both sides above the size for which the Gram matrix is made; 6 modes, x and y: at most 8 trajectories.
        const auto source = tests::waves(1001, 3001, 6);
        const auto encoded = encodeAnimation(source, settingsOf(8, 1e5));
        QVERIFY(encoded.has_value());
        const double error = tests::kgErrorPercent(source, **decodeAnimation(encoded->bytes));
        QVERIFY2(error < 0.05, qPrintable(QString::number(error)));
    }

    void sameBytesWithAnyNumberOfThreads()
    {
        const auto source = tests::waves(90, 5000, 25);
        Bytes first;
        for (const unsigned count : {1u, 2u, 3u, 8u}) {
            const Threads threads(count);
            for (int run = 0; run < 2; ++run) {
                const auto encoded = encodeAnimation(source, settingsOf(25, 1e4));
                if (first.empty())
                    first = encoded->bytes;
                QVERIFY(encoded->bytes == first);
            }
            const auto decoded = decodeAnimation(first);
            QVERIFY((*decoded)->frame(40) == (*decodeAnimation(first))->frame(40));
        }
    }

    void sequenceAndAnyOtherSourceEncodeAlike()
    {
        auto plain = tests::waves(12, 90, 6);
        std::vector<Vec3f> positions;
        for (const auto &frame : plain.frames())
            positions.insert(positions.end(), frame.begin(), frame.end());
        const Sequence sequence(plain.connectivity(), positions, 24, "plain");
        QVERIFY(encodeAnimation(plain, settingsOf(10, 1e4))->bytes ==
                encodeAnimation(sequence, settingsOf(10, 1e4))->bytes);
    }

    void framesComeInAnyOrderFromAnyThread()
    {
        const auto source = tests::waves(40, 1003, 10);
        const auto animation = *decodeAnimation(encodeAnimation(source, settingsOf(10, 1e4))->bytes);
        std::vector<std::vector<Vec3f>> expected;
        for (std::uint32_t f = 0; f < 40; ++f)
            expected.push_back(animation->frame(f));
        std::atomic<int> wrong = 0;
        std::vector<std::thread> threads;
        for (unsigned t = 0; t < 4; ++t)
            threads.emplace_back([&, t] {
                std::mt19937 random(t);
                for (int i = 0; i < 200; ++i) {
                    const std::uint32_t f = random() % 40;
                    wrong += animation->frame(f) != expected[f];
                }
            });
        for (auto &thread : threads)
            thread.join();
        QCOMPARE(wrong.load(), 0);
    }

    void digestTellsContentNotName()
    {
        auto source = tests::waves(6, 40, 3);
        const auto digestOf = [&] {
            return (*decodeAnimation(encodeAnimation(source, settingsOf(5, 1e4))->bytes))->digest();
        };
        const auto before = digestOf();
        source.title = "other";
        source.rate = 50;
        QCOMPARE(digestOf(), before);
        source.frames()[3][7].y += 0.5f;
        QVERIFY(digestOf() != before);
    }

    void memoryIsThatOfBasisAndCoefficients()
    {
        for (const auto &[frames, vertices, k] : {std::tuple{30u, 2000u, 10u}, {200u, 300u, 20u}, {12u, 9000u, 20u}}) {
            const auto animation =
                *decodeAnimation(encodeAnimation(tests::waves(frames, vertices, 30), settingsOf(k, 1e4))->bytes);
            const std::size_t bound = 4 * 3 * ((3 * frames + vertices) * k + 10 * vertices);
            QVERIFY2(animation->memoryBytes() <= bound, qPrintable(QString::number(animation->memoryBytes())));
            // At least what it cannot do without.
            QVERIFY(animation->memoryBytes() >= 4 * (3 * frames + vertices) * animation->basisSize() +
                                                    12 * (vertices - 2) + animation->encodedBytes());
        }
    }

    void memoryLimitIsTheCallers()
    {
        const Bytes file = encodeAnimation(tests::waves(20, 500, 5), settingsOf(5, 1e4))->bytes;
        DecodeLimits limits;
        limits.memoryBytes = 10000;
        const auto refused = decodeAnimation(file, Progress(), limits);
        QCOMPARE(int(refused.error().code), int(ErrorCode::LimitExceeded));
        limits.memoryBytes = 8u << 20;
        QVERIFY(decodeAnimation(file, Progress(), limits).has_value());
    }

    void badSettingsAreRefused_data()
    {
        QTest::addColumn<double>("basis");
        QTest::addColumn<double>("resolution");
        QTest::addColumn<double>("rate");
        QTest::addColumn<QString>("setting");
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QTest::newRow("no basis") << 0.0 << 1e4 << 25.0 << "basis";
        QTest::newRow("large basis") << 1001.0 << 1e4 << 25.0 << "basis";
        QTest::newRow("no resolution") << 5.0 << 0.0 << 25.0 << "resolution";
        QTest::newRow("large resolution") << 5.0 << 1.01e7 << 25.0 << "resolution";
        QTest::newRow("NaN resolution") << 5.0 << nan << 25.0 << "resolution";
        QTest::newRow("no rate") << 5.0 << 1e4 << 0.0 << "frame rate";
        QTest::newRow("NaN rate") << 5.0 << 1e4 << nan << "frame rate";
    }
    void badSettingsAreRefused()
    {
        QFETCH(double, basis);
        QFETCH(double, resolution);
        QFETCH(double, rate);
        QFETCH(QString, setting);
        auto source = tests::waves(3, 9, 1);
        source.rate = rate;
        const auto encoded = encodeAnimation(source, settingsOf(std::uint32_t(basis), resolution));
        QVERIFY(!encoded);
        QCOMPARE(int(encoded.error().code), int(ErrorCode::BadSetting));
        QCOMPARE(QString::fromStdString(encoded.error().args.at(0)), setting);
    }

    void emptyAnimationsAreRefused()
    {
        const tests::PlainAnimation noVertices(3, 0, {}, [](auto, auto) { return Vec3f{}; });
        const tests::PlainAnimation noFrames(0, 3, {}, [](auto, auto) { return Vec3f{}; });
        QCOMPARE(int(encodeError(noVertices, {})), int(ErrorCode::NoVertices));
        QCOMPARE(int(encodeError(noFrames, {})), int(ErrorCode::NoFrames));
    }

    void nonFinitePositionsAreNamed()
    {
        for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
            auto source = tests::waves(5, 30, 2);
            source.frames()[3][17].y = bad;
            const auto encoded = encodeAnimation(source, settingsOf(5, 1e4));
            QVERIFY(!encoded);
            QCOMPARE(int(encoded.error().code), int(ErrorCode::NonFinite));
            QCOMPARE(encoded.error().args.at(0), std::string("vertex 17 of frame 3"));
        }
    }

    void hugePositionsAreRefused()
    {
        for (const float scale : {1e15f, 1e38f}) {
            const tests::PlainAnimation source(3, 8, {}, [&](std::uint32_t f, std::uint32_t v) {
                return Vec3f{scale * float(v % 3), scale * float(f), 0};
            });
            QCOMPARE(int(encodeError(source, settingsOf(3, 1e6))), int(ErrorCode::LimitExceeded));
        }
        // Large means alone are fine: only the differences from them must be moderate.
        const tests::PlainAnimation far(3, 8, {}, [](std::uint32_t f, std::uint32_t v) {
            return Vec3f{1e9f + 1024 * float(v), float(f), 0};
        });
        QCOMPARE(int(encodeError(far, settingsOf(3, 1e4))), 0xffff);
    }

    void progressRises()
    {
        std::vector<double> reports;
        const auto encoded = encodeAnimation(tests::waves(60, 3000, 10), settingsOf(10, 1e4),
                                             Progress([&](double fraction) { reports.push_back(fraction); }));
        QVERIFY(reports.size() > 10);
        QCOMPARE(reports.back(), 1.0);
        QVERIFY(std::is_sorted(reports.begin(), reports.end()));
    }

    void cancelStopsAtEachPoint()
    {
        const auto source = tests::waves(60, 3000, 10);
        for (const double at : {0.0, 0.05, 0.2, 0.5, 0.7, 0.9}) {
            std::shared_ptr<Progress> handle;
            handle = std::make_shared<Progress>([&](double fraction) {
                if (fraction >= at)
                    handle->cancel();
            });
            const auto encoded = encodeAnimation(source, settingsOf(10, 1e4), *handle);
            QVERIFY(!encoded);
            QCOMPARE(int(encoded.error().code), int(ErrorCode::Cancelled));
        }
        const Bytes file = encodeAnimation(source, settingsOf(10, 1e4))->bytes;
        const Progress cancelled;
        cancelled.cancel();
        QCOMPARE(int(decodeAnimation(file, cancelled).error().code), int(ErrorCode::Cancelled));
        QCOMPARE(int(encodeAnimation(source, settingsOf(10, 1e4), cancelled).error().code), int(ErrorCode::Cancelled));
    }

    void corruptedParametersHaveTheirErrors_data()
    {
        QTest::addColumn<QString>("tag");
        QTest::addColumn<int>("at");
        QTest::addColumn<int>("value");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("first");
        const auto bad = [](const char *tag, int at, int value, ErrorCode code, const char *first) {
            QTest::addRow("%s %d = %d", tag, at, value) << tag << at << value << int(code) << first;
        };
        bad("PCAP", 7, 0x00, ErrorCode::BadValue, "resolution");
        bad("PCAP", 7, 0x7f, ErrorCode::BadValue, "resolution");
        bad("PCAP", 7, 0xc0, ErrorCode::BadValue, "resolution");
        bad("PCAP", 8, 0, ErrorCode::BadValue, "wanted basis size");
        bad("PCAP", 9, 4, ErrorCode::BadValue, "basis size"); // more than wanted
        bad("PCAP", 9, 2, ErrorCode::CorruptStream, "basis"); // fewer than the streams hold
        bad("INDX", 0, 0x00, ErrorCode::BadValue, "triangles per stream");
        bad("BASE", 0, 0, ErrorCode::BadValue, "rows per stream");
        bad("COEF", 0, 0, ErrorCode::BadValue, "rows per stream");
    }
    void corruptedParametersHaveTheirErrors()
    {
        QFETCH(QString, tag);
        QFETCH(int, at);
        QFETCH(int, value);
        QFETCH(int, code);
        QFETCH(QString, first);
        const Bytes file = tests::withPayload(tests::smallFile(), tag.toStdString(), [&](Bytes &p) {
            p[std::size_t(at)] = std::uint8_t(value);
            if (tag == "INDX")
                p[1] = p[2] = 0;
        });
        const auto decoded = decodeAnimation(file);
        QVERIFY(!decoded);
        QCOMPARE(int(decoded.error().code), code);
        QCOMPARE(QString::fromStdString(decoded.error().args.at(0)), first);
        QVERIFY(decoded.error().offset != Error::None);
    }

    void damagedPayloadsNeverCrash()
    {
        // With right checksums: what an attacker or another program could write.
        const Bytes good = tests::smallFile();
        for (const auto &[tag, payload] : tests::takeApart(good)) {
            for (std::size_t i = 0; i < payload.size(); ++i)
                for (const std::uint8_t change : {0x01, 0x80, 0xff})
                    tests::errorText(tests::withPayload(good, tag, [&](Bytes &p) { p[i] ^= change; }));
            for (std::size_t length = 0; length < payload.size(); ++length)
                if (tag != "HEAD" || length > 0)
                    QVERIFY(tests::errorText(tests::withPayload(good, tag, [&](Bytes &p) { p.resize(length); })) !=
                            "none");
            QVERIFY(tests::errorText(tests::withPayload(good, tag, [](Bytes &p) { p.push_back(0); })) != "none");
        }
    }

    void kernelsAgree()
    {
        const Kernels &best = kernels();
        const Kernels &plain = portableKernels();
        std::mt19937 random(4);
        const auto numbers = [&](std::size_t count) {
            std::vector<float> result(count);
            for (float &x : result)
                x = float(random()) / 4294967296.0f - 0.5f;
            return result;
        };
        for (const std::size_t vertices : {1u, 15u, 16u, 17u, 1000u})
            for (const std::size_t rank : {0u, 1u, 7u, 50u}) {
                const auto tiles = numbers((vertices + 15) / 16 * 16 * rank);
                const auto basis = numbers(3 * rank);
                const auto mean = numbers(6);
                std::vector<float> a(3 * vertices), b(3 * vertices);
                best.reconstruct(tiles.data(), rank, basis.data(), mean.data(), vertices, a.data());
                plain.reconstruct(tiles.data(), rank, basis.data(), mean.data(), vertices, b.data());
                for (std::size_t i = 0; i < a.size(); ++i) {
                    double expected = double(mean[i % 3]) + double(mean[3 + i % 3]);
                    for (std::size_t k = 0; k < rank; ++k)
                        expected +=
                            double(basis[i % 3 * rank + k]) * double(tiles[(i / 3 / 16 * rank + k) * 16 + i / 3 % 16]);
                    QVERIFY(std::fabs(double(a[i]) - expected) < 1e-5);
                    QVERIFY(std::fabs(double(b[i]) - expected) < 1e-5);
                }
            }
        for (const std::size_t rows : {1u, 5u, 128u})
            for (const std::size_t depth : {1u, 511u, 1300u}) {
                const auto x = numbers(rows * depth);
                std::vector<double> a(rows * rows, 1), b(rows * rows, 1);
                best.gramTile(x.data(), rows, x.data(), rows, depth, depth, a.data(), rows);
                plain.gramTile(x.data(), rows, x.data(), rows, depth, depth, b.data(), rows);
                for (std::size_t i = 0; i < rows; ++i)
                    for (std::size_t j = 0; j < rows; ++j) {
                        double expected = 1;
                        for (std::size_t d = 0; d < depth; ++d)
                            expected += double(x[i * depth + d]) * double(x[j * depth + d]);
                        QVERIFY(std::fabs(a[i * rows + j] - expected) < 1e-4);
                        QVERIFY(std::fabs(b[i * rows + j] - expected) < 1e-4);
                    }
            }
    }
};

SANDREEL_TEST(TestPcaCodec)
#include "tst_pcacodec.moc"
