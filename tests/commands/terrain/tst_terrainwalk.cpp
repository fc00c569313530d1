// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/terrain/changematerials.h"
#include "commands/terrain/layers.h"
#include "commands/terrain/setmask.h"
#include "commands/terrain/terraincontext.h"
#include "model/terrain/erosion/erosion.h"
#include "model/terrain/tools/livestroke.h"
#include "tests/commands/terrain/sandbox.h"
#include "tests/support/testmain.h"

#include <QUndoStack>

using namespace commands;
using namespace model::terrain;
using model::TerrainDocument;

namespace {

/// Everything that a person can do to a terrain, at random.
class Hand
{
public:
    Hand(TerrainContext &context, unsigned seed)
        : mContext(context)
        , mRandom(seed)
    {}

    std::uint32_t below(std::uint32_t limit) { return std::uint32_t(mRandom() % limit); }
    double unit() { return double(mRandom() >> 11) * 0x1p-53; }

    Tool tool(const model::GroundMask::Value &painted)
    {
        Brush brush;
        brush.mask.paint = painted;
        brush.radius = 0.05 + 0.05 * unit();
        Imprint imprint;
        imprint.radius = 0.05 + 0.03 * unit();
        imprint.depth = 0.04;
        Rake rake;
        rake.width = 0.2;
        rake.depth = 0.02;
        const std::vector<Tool> tools{imprint,
                                      rake,
                                      Raise{brush, 0.02},
                                      Lower{brush, 0.02},
                                      Flatten{brush, 0.5, {}},
                                      Smooth{brush, 0.5},
                                      Noise{brush, 0.02, 0.1, 2, 1},
                                      Ramp{brush, {}, {}},
                                      Restore{brush, 0.5, {[](Point2) { return 1.0; }, nullptr}},
                                      Pour{brush, 1e-4},
                                      Scoop{brush, 0.02},
                                      Breakline{0.05, {}, Crossing::Split},
                                      Moisten{brush, unit(), 0.5}};
        return tools[below(std::uint32_t(tools.size()))];
    }
    Point2 place() { return {-0.05 + 1.1 * unit(), -0.05 + 1.1 * unit()}; }

    /// Stamps and what slides in turns, all within one gesture. False if it was cancelled.
    bool stroke(const model::GroundMask &mask)
    {
        const Tin &tin = mContext.document().tin();
        auto live = LiveStroke::begin(tin, tool(mask.value()), {Symmetry::Kind(below(5)), {0.5, 0.5}, 2}, mOwner);
        auto erosion = Erosion::create({}, mContext.document().terrain().materials);
        mContext.beginGesture(QString::fromLatin1(nameOf(live->tool())));
        const auto draw = [&] {
            while (live->isDue()) {
                const Edit *const drawn =
                    mContext.edit([&](TinEdit &edit) { static_cast<void>(live->draw(edit, mMemory, 2)); });
                if (!drawn)
                    continue;
                live->note(*drawn);
                erosion->activate(tin, *drawn);
                if (const Edit *const slid =
                        mContext.edit([&](TinEdit &edit) { static_cast<void>(erosion->run(edit, 0.05)); }))
                    live->note(*slid);
            }
        };
        const Point2 from = place(), to = place();
        for (int i = 0; i <= 3; ++i) {
            static_cast<void>(live->add(
                {{from.x + i * (to.x - from.x) / 12, from.y + i * (to.y - from.y) / 12}, 0.5 + unit() / 2, 0}));
            draw();
        }
        live->end();
        draw();
        mOwner = live->report().nextOwner;
        if (below(6) == 0) {
            mContext.cancelGesture();
            return false;
        }
        mContext.endGesture();
        return true;
    }
    void settle()
    {
        Terrain copy = mContext.document().copier()();
        auto erosion = Erosion::create({}, copy.materials);
        TinEdit open(copy.tin);
        [&] { QVERIFY(erosion->settle(open)); }();
        Edit edit = open.commit();
        if (!edit.isEmpty())
            copy.tin.swap(edit);
        mContext.push<EditSurface>(QStringLiteral("Settle"), std::move(edit));
    }
    void layers()
    {
        const std::uint32_t count = mContext.document().tin().arrays().layerCount();
        const auto materials = std::uint32_t(mContext.document().terrain().materials.size());
        const auto push = [&](EditSurface::Work work) {
            mContext.push<EditSurface>(QStringLiteral("Layers"), std::move(work));
        };
        switch (below(4)) {
        case 0:
            if (count < 4)
                push(addLayer(below(count + 1), std::uint8_t(below(materials)), {0.02 * unit(), float(unit())}));
            break;
        case 1:
            if (count > 1)
                push(removeLayer(below(count)));
            break;
        case 2:
            push(fillLayer(below(count), {0.3 * unit(), float(unit())}));
            break;
        default:
            push(setLayerMaterial(below(count), std::uint8_t(below(materials))));
        }
    }
    void mask(const std::shared_ptr<model::GroundMask> &of)
    {
        PaintMask painted = of->value() ? *of->value() : PaintMask(mContext.document().tin().domain());
        if (below(4) == 0)
            painted.invert();
        else
            painted.paint(place(), place(), 0.02 + 0.1 * unit(), unit(), below(2) == 0);
        mContext.pushCommand(std::make_unique<SetMask>(of, QStringLiteral("Mask"),
                                                       std::make_shared<const PaintMask>(std::move(painted))));
    }
    void materials()
    {
        const auto count = std::uint32_t(mContext.document().terrain().materials.size());
        const Material any = material(EveryMaterialPreset[below(5)]);
        switch (below(3)) {
        case 0:
            if (count < 6)
                mContext.push<AddMaterial>(any);
            break;
        case 1:
            mContext.push<RemoveMaterial>(std::uint8_t(below(count)));
            break;
        default:
            mContext.push<EditMaterial>(std::uint8_t(below(count)), any);
        }
    }

private:
    TerrainContext &mContext;
    std::mt19937_64 mRandom;
    ToolMemory mMemory;
    OwnerId mOwner = 1;
};

} // namespace

class TestTerrainWalk final : public QObject
{
    Q_OBJECT

private slots:
    void everyStepIsUndoneAndRedoneToTheByte_data()
    {
        QTest::addColumn<unsigned>("seed");
        for (unsigned seed = 1; seed <= 3; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void everyStepIsUndoneAndRedoneToTheByte()
    {
        QFETCH(unsigned, seed);
        TerrainDocument document(tests::sandbox(400, seed));
        TerrainContext context(document);
        context.history().setLimit(std::size_t(1) << 40); // nothing is dropped
        QUndoStack &stack = context.undoStack();
        Hand hand(context, seed);
        const auto mask = std::make_shared<model::GroundMask>();
        using Whole = std::pair<tests::State, model::GroundMask::Value>;
        const auto whole = [&] { return Whole(document, mask->value()); };
        std::vector<Whole> states{whole()};
        // Much longer walks for who has the time.
        const int steps = std::max(60, qEnvironmentVariableIntValue("SANDREEL_WALK_STEPS"));
        int strokes = 0, cancelled = 0, undone = 0;
        for (int step = 0; step < steps; ++step) {
            const auto index = std::size_t(stack.index());
            bool isDone = true;
            switch (hand.below(10)) {
            case 0:
            case 1:
            case 2:
                isDone = hand.stroke(*mask);
                ++(isDone ? strokes : cancelled);
                break;
            case 3:
                hand.settle();
                break;
            case 4:
                hand.layers();
                break;
            case 5:
                hand.materials();
                break;
            case 6:
            case 7:
                stack.setIndex(int(hand.below(std::uint32_t(stack.count() + 1))));
                ++undone;
                QVERIFY(whole() == states[std::size_t(stack.index())]);
                continue;
            case 8:
                hand.mask(mask);
                break;
            default:
                stack.undo();
                stack.redo();
                continue;
            }
            QVERIFY(tests::isValid(document));
            const Tin &tin = document.tin();
            QVERIFY(std::abs(tin.volume() - tin.ledger().expected()) < 1e-11);
            if (!isDone) {
                QVERIFY(whole() == states[index]);
                states.resize(std::size_t(stack.count()) + 1, states[index]);
                continue;
            }
            const bool isPushed = std::size_t(stack.index()) == index + 1;
            QCOMPARE(isPushed, !(whole() == states[index]));
            if (isPushed) {
                states.resize(index + 1, states[index]);
                states.push_back(whole());
            }
            QCOMPARE(std::size_t(stack.count()), states.size() - 1);
        }
        QVERIFY(strokes > 8 && undone > 4); // the walk saw what it is meant to see
        for (int i = stack.count(); i >= 0; --i) {
            stack.setIndex(i);
            QVERIFY(whole() == states[std::size_t(i)]);
        }
        stack.setIndex(stack.count());
        QVERIFY(whole() == states.back());
    }
};

SANDREEL_TEST(TestTerrainWalk)
#include "tst_terrainwalk.moc"
