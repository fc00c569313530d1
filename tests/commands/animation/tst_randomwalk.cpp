// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/animation/animationcontext.h"
#include "commands/animation/normaliseanimation.h"
#include "commands/animation/renameanimation.h"
#include "commands/animation/resampleanimation.h"
#include "commands/animation/reverseanimation.h"
#include "commands/animation/setcompression.h"
#include "commands/animation/setframerate.h"
#include "commands/animation/trimanimation.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"
#include "tests/support/undocheck.h"

#include <algorithm>
#include <cmath>
#include <random>

using namespace commands;
using model::AnimationDocument;
using model::Vec3f;

namespace {

/// A plain simulation of the document: what should be there, by other means than the product's.
struct Simulation
{
    std::vector<long double> moments; ///< of the source, in frames
    double rate = 25;
    model::Similarity placement;
    std::string name = "noise";
    model::CompressionSettings compression;

    void resample(double to)
    {
        const auto steps = (long double)(moments.size() - 1);
        if (moments.size() > 1) {
            const auto newSteps = std::size_t(std::max(1.0L, std::round(steps * to / rate)));
            std::vector<long double> resampled;
            for (std::size_t i = 0; i <= newSteps; ++i) {
                const long double at = steps * i / newSteps;
                const auto left = std::min(std::size_t(at), moments.size() - 2);
                const long double weight = at - left;
                resampled.push_back((1 - weight) * moments[left] + weight * moments[left + 1]);
            }
            moments = resampled;
        }
        rate = to;
    }

    Vec3f position(const model::Sequence &source, std::size_t frame, std::size_t vertex) const
    {
        const long double moment = moments[frame];
        const auto before = std::uint32_t(std::min<long double>(std::floor(moment + 1e-7L), source.frameCount() - 1));
        const std::uint32_t after = std::min(before + 1, source.frameCount() - 1);
        const Vec3f a = source.frameView(before)[vertex], b = source.frameView(after)[vertex];
        const auto weight = std::max(0.0L, moment - before);
        const auto placed = [&](float from, float to, int axis) {
            return float(placement.scale * (from + weight * (to - from)) + placement.offset[axis]);
        };
        return {placed(a.x, b.x, 0), placed(a.y, b.y, 1), placed(a.z, b.z, 2)};
    }
};

struct Step
{
    Simulation simulation;
    std::uint64_t fingerprint;
};

} // namespace

class TestRandomWalk final : public QObject
{
    Q_OBJECT

    static bool agrees(const AnimationDocument &document, const model::Sequence &source, const Simulation &expected)
    {
        const auto frames = document.frames();
        if (frames->frameCount() != expected.moments.size() || frames->frameRate() != expected.rate ||
            frames->name() != expected.name || document.compression() != expected.compression)
            return false;
        const float tolerance = float(1e-5 * std::max(1.0, expected.placement.scale));
        for (std::uint32_t frame = 0; frame < frames->frameCount(); ++frame) {
            const std::vector<Vec3f> positions = frames->frame(frame);
            for (std::size_t vertex = 0; vertex < positions.size(); ++vertex)
                if (length(positions[vertex] - expected.position(source, frame, vertex)) > tolerance)
                    return false;
        }
        return true;
    }

private slots:
    void documentFollowsThePlainSimulation_data()
    {
        QTest::addColumn<quint32>("seed");
        for (quint32 seed = 1; seed <= 8; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void documentFollowsThePlainSimulation()
    {
        QFETCH(quint32, seed);
        std::mt19937 random(seed);
        const auto below = [&random](std::uint32_t limit) { return std::uint32_t(random() % limit); };
        const auto source = tests::noise(tests::tetrahedron(), 40, seed);
        AnimationDocument document(source);
        AnimationContext context(document);
        QUndoStack &stack = context.undoStack();

        Simulation start;
        for (std::uint32_t i = 0; i < source->frameCount(); ++i)
            start.moments.push_back(i);
        std::vector<Step> history{{start, document.fingerprint()}};
        std::size_t present = 0;
        GestureId topGesture = NoGesture; // of the newest step, if it may be merged into
        int pushes = 0, mergings = 0;

        for (int step = 0; step < 300; ++step) {
            Simulation next = history[present].simulation;
            bool merges = false;
            GestureId gesture = NoGesture;
            switch (below(11)) {
            case 0: {
                const auto count = std::uint32_t(next.moments.size());
                if (count < 6)
                    continue;
                const std::uint32_t first = below(3), last = count - 1 - below(3);
                next.moments = {next.moments.begin() + first, next.moments.begin() + last + 1};
                context.push<TrimAnimation>(first, last);
                break;
            }
            case 1:
                std::reverse(next.moments.begin(), next.moments.end());
                context.push<ReverseAnimation>();
                break;
            case 2: {
                const double rate = std::vector<double>{10, 12, 24, 25, 29.97, 50}[below(6)];
                if (double(next.moments.size()) * rate / next.rate > 200)
                    continue;
                next.resample(rate);
                context.push<ResampleAnimation>(rate);
                break;
            }
            case 3:
                next.rate = 20 + below(10);
                context.push<SetFrameRate>(next.rate);
                break;
            case 4:
                next.placement = {0.5 + below(4), {double(below(3)), -1.5, 0}};
                context.push<NormaliseAnimation>(next.placement);
                break;
            case 5:
                next.name = std::string(below(3), 'x');
                context.push<RenameAnimation>(next.name);
                break;
            case 6:
            case 7:
                gesture = topGesture != NoGesture && below(3) ? topGesture : context.newGesture();
                merges = gesture == topGesture;
                next.compression.method = model::PcaSettings{20 + below(3), 10000};
                context.push<SetCompression>(next.compression, gesture);
                break;
            case 8:
            case 9:
                for (std::uint32_t i = below(5); i > 0; --i) {
                    QCOMPARE(stack.canUndo(), present > 0);
                    if (!stack.canUndo())
                        break;
                    stack.undo();
                    QCOMPARE(document.fingerprint(), history[--present].fingerprint);
                }
                topGesture = NoGesture;
                QVERIFY(agrees(document, *source, history[present].simulation));
                continue;
            default:
                for (std::uint32_t i = below(4); i > 0; --i) {
                    QCOMPARE(stack.canRedo(), present + 1 < history.size());
                    if (!stack.canRedo())
                        break;
                    stack.redo();
                    QCOMPARE(document.fingerprint(), history[++present].fingerprint);
                    topGesture = NoGesture;
                }
                QVERIFY(agrees(document, *source, history[present].simulation));
                continue;
            }

            QVERIFY(agrees(document, *source, next));
            QVERIFY(tests::brokenRules(document).empty());
            const std::uint64_t fingerprint = document.fingerprint();
            if (fingerprint != history[present].fingerprint) {
                history.resize(present + 1);
                if (merges)
                    history.pop_back();
                const bool cameBack = merges && history.back().fingerprint == fingerprint;
                if (!cameBack)
                    history.push_back({next, fingerprint});
                topGesture = cameBack ? NoGesture : gesture;
                present = history.size() - 1;
                (merges ? mergings : pushes) += 1;
            }
            QCOMPARE(std::size_t(stack.index()), present);
            QCOMPARE(std::size_t(stack.count()), history.size() - 1);
        }
        QVERIFY(pushes > 50 && mergings > 0); // the walk saw what it is meant to see
        stack.setIndex(0);
        QCOMPARE(document.fingerprint(), history[0].fingerprint);
        QVERIFY(document.frames()->keepsFrames());
    }
};

SANDREEL_TEST(TestRandomWalk)
#include "tst_randomwalk.moc"
