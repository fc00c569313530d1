// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/editedframes.h"
#include "model/animation/sequence.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"

#include <bit>
#include <thread>

using namespace model;

class TestSequence final : public QObject
{
    Q_OBJECT

private slots:
    void framesLieOneAfterTheOther()
    {
        const std::vector<Vec3f> positions{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}, {12, 13, 14}, {15, 16, 17}};
        const Sequence sequence({2, {}}, positions, 12.5, "three");
        QCOMPARE(sequence.frameCount(), 3u);
        QCOMPARE(sequence.vertexCount(), 2u);
        QCOMPARE(sequence.frameRate(), 12.5);
        QVERIFY(sequence.name() == "three");
        QVERIFY(sequence.frame(1) == std::vector<Vec3f>({{6, 7, 8}, {9, 10, 11}}));
        QVERIFY(sequence.frameView(2).data() == sequence.allPositions().data() + 4);
        QVERIFY(sequence.memoryBytes() >= 6 * sizeof(Vec3f));
    }

    void digestChangesWithEveryBitOfPositions()
    {
        const auto original = tests::wave(tests::oneTriangle(), 2);
        const std::uint64_t digest = original->digest();
        for (std::size_t i = 0; i < original->allPositions().size(); ++i)
            for (int bit = 0; bit < 32; ++bit) {
                std::vector<Vec3f> positions(original->allPositions().begin(), original->allPositions().end());
                positions[i].y = std::bit_cast<float>(std::bit_cast<std::uint32_t>(positions[i].y) ^ (1u << bit));
                QVERIFY(Sequence(original->connectivity(), positions).digest() != digest);
            }
    }

    void digestIsOfContentAlone()
    {
        const TriangleMesh mesh = tests::cube();
        const Sequence sequence(mesh.connectivity, mesh.positions, 25, "a");
        QCOMPARE(Sequence(mesh.connectivity, mesh.positions, 30, "b").digest(), sequence.digest());
        Connectivity other = mesh.connectivity;
        std::swap(other.triangles[3][0], other.triangles[3][1]);
        QVERIFY(Sequence(other, mesh.positions).digest() != sequence.digest());
        other.triangles.clear();
        QVERIFY(Sequence(other, mesh.positions).digest() != sequence.digest());
        // The same positions as one frame of eight vertices or two of four.
        QVERIFY(Sequence({4, {}}, mesh.positions).digest() != Sequence({8, {}}, mesh.positions).digest());
    }

    void toSequenceKeepsASequence()
    {
        const FrameSourcePtr source = tests::wave(tests::cube());
        QVERIFY(toSequence(source) == source);
    }

    void toSequenceMakesEveryFrame()
    {
        const auto edited = std::make_shared<EditedFrames>(tests::noise(tests::torus(), 9), TimeMap({8, 2.5, 0, 0}),
                                                           Similarity{2, {1, 2, 3}}, 7.0, "edited");
        const std::shared_ptr<const Sequence> sequence = toSequence(edited);
        QCOMPARE(sequence->frameCount(), 4u);
        QCOMPARE(sequence->frameRate(), 7.0);
        QVERIFY(sequence->name() == "edited");
        QVERIFY(sequence->connectivity() == edited->connectivity());
        for (std::uint32_t frame = 0; frame < 4; ++frame)
            QVERIFY(sequence->frame(frame) == edited->frame(frame));
    }

    void manyThreadsMayAskAtOnce()
    {
        const auto sequence = tests::noise(tests::torus(), 40);
        const std::uint64_t expected = tests::noise(tests::torus(), 40)->digest();
        std::atomic<int> wrong = 0;
        {
            std::vector<std::jthread> threads;
            for (std::uint32_t t = 0; t < 4; ++t)
                threads.emplace_back([&, t] {
                    const auto view = sequence->frameView(t);
                    wrong += sequence->frame(t) != std::vector<Vec3f>(view.begin(), view.end());
                    wrong += sequence->digest() != expected;
                });
        }
        QCOMPARE(wrong.load(), 0);
    }
};

SANDREEL_TEST(TestSequence)
#include "tst_sequence.moc"
