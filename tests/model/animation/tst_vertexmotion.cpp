// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/remeshedframes.h"
#include "model/animation/vertexmotion.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"

#include <array>
#include <cmath>

using namespace model;
using namespace tests;

class TestVertexMotion final : public QObject
{
    Q_OBJECT

    static Vec3f at(const FrameSource &source, std::uint32_t frame, std::uint32_t vertex)
    {
        return source.frame(frame)[vertex];
    }

private slots:
    void trajectoriesAreAsLongAsTheirSteps()
    {
        const SequencePtr animation = noise(grid(), 7);
        const auto lengths = trajectoryLengths(*animation);
        QVERIFY(lengths);
        for (std::uint32_t v = 0; v < animation->vertexCount(); ++v) {
            double expected = 0;
            for (std::uint32_t f = 1; f < 7; ++f)
                expected += double(length(at(*animation, f, v) - at(*animation, f - 1, v)));
            QVERIFY(std::abs(double((*lengths)[v]) - expected) < 1e-5);
        }
        const auto still = trajectoryLengths(*constant(grid()));
        QVERIFY(still);
        for (const float value : *still)
            QCOMPARE(value, 0.0f);
    }

    void errorsAreRootMeanSquares()
    {
        const SequencePtr a = noise(grid(), 5, 1), b = noise(grid(), 5, 2);
        const auto errors = vertexErrors(*FramePair::of(*a, *b));
        QVERIFY(errors);
        for (std::uint32_t v = 0; v < a->vertexCount(); ++v) {
            double sum = 0;
            for (std::uint32_t f = 0; f < 5; ++f)
                sum += double(dot(at(*a, f, v) - at(*b, f, v), at(*a, f, v) - at(*b, f, v)));
            QVERIFY(std::abs(double((*errors)[v]) - std::sqrt(sum / 5)) < 1e-6);
        }
    }

    void aRemeshedAnimationHasTheEditInEveryFrame()
    {
        // Vertex 1 goes, the last one is the middle of 0 and 2.
        const SequencePtr animation = noise(tetrahedron(), 4);
        EditedMesh edit;
        edit.vertices.addCopy(0);
        edit.vertices.addCopy(2);
        edit.vertices.addMean(std::array{VertexSources::Share{0, 0.5f}, VertexSources::Share{2, 0.5f}});
        edit.faces = Faces(3);
        edit.faces.add(std::array{0u, 1u, 2u});
        const RemeshedFrames remeshed(animation, edit);
        QCOMPARE(remeshed.frameCount(), 4u);
        QCOMPARE(remeshed.vertexCount(), 3u);
        QCOMPARE(remeshed.connectivity().triangles.size(), std::size_t(1));
        for (std::uint32_t f = 0; f < 4; ++f) {
            QVERIFY(at(remeshed, f, 1) == at(*animation, f, 2));
            QVERIFY(length(at(remeshed, f, 2) - (at(*animation, f, 0) + at(*animation, f, 2)) * 0.5f) < 1e-6f);
        }
        QCOMPARE(RemeshedFrames(animation, edit).digest(), remeshed.digest());
        edit.vertices.addCopy(3);
        edit.faces.setVertexCount(4);
        QVERIFY(RemeshedFrames(animation, edit).digest() != remeshed.digest());
        QVERIFY(remeshed.digest() != animation->digest());
        QVERIFY(remeshed.memoryBytes() > animation->memoryBytes());
    }

    void cancelsAreErrors()
    {
        const Progress progress;
        progress.cancel();
        const SequencePtr animation = wave(grid());
        QVERIFY(!trajectoryLengths(*animation, progress));
        QVERIFY(!vertexErrors(*FramePair::of(*animation, *animation), progress));
    }
};

SANDREEL_TEST(TestVertexMotion)
#include "tst_vertexmotion.moc"
