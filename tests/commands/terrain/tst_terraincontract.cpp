// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/terrain/changematerials.h"
#include "commands/terrain/layers.h"
#include "commands/terrain/terraincontext.h"
#include "model/terrain/tools/stroke.h"
#include "tests/commands/terrain/sandbox.h"
#include "tests/support/testmain.h"

#include <QUndoStack>

using namespace commands;
using namespace model::terrain;
using model::TerrainDocument;

Q_DECLARE_METATYPE(std::function<void(commands::TerrainContext &)>)

namespace {

using Push = std::function<void(TerrainContext &)>;

Material mud()
{
    return material(MaterialPreset::Mud);
}

} // namespace

class TestTerrainContract final : public QObject
{
    Q_OBJECT

private slots:
    void everyCommandKeepsTheContract_data()
    {
        QTest::addColumn<Push>("push");
        QTest::newRow("stroke") << Push([](TerrainContext &context) {
            context.push<EditSurface>(QStringLiteral("Imprint"), [](TinEdit &edit) {
                Imprint tool;
                tool.radius = 0.1;
                ToolMemory memory;
                [&] { QVERIFY(draw(edit, {tool, {{{0.5, 0.5}, 1, 0}}, {}}, 1, memory)); }();
            });
        });
        QTest::newRow("stroke made on a copy") << Push([](TerrainContext &context) {
            Terrain copy = context.document().copier()();
            TinEdit edit(copy.tin);
            ToolMemory memory;
            Raise tool;
            tool.brush.radius = 0.2;
            [&] { QVERIFY(draw(edit, {tool, {{{0.5, 0.5}, 1, 0}}, {}}, 1, memory)); }();
            Edit done = edit.commit();
            copy.tin.swap(done);
            context.push<EditSurface>(QStringLiteral("Raise"), std::move(done));
        });
        QTest::newRow("add layer") << Push([](TerrainContext &context) {
            context.push<EditSurface>(QStringLiteral("Add Layer"), addLayer(1, 1, {0.05, 0.5f}));
        });
        QTest::newRow("remove layer") << Push(
            [](TerrainContext &context) { context.push<EditSurface>(QStringLiteral("Remove Layer"), removeLayer(0)); });
        QTest::newRow("fill layer") << Push([](TerrainContext &context) {
            context.push<EditSurface>(QStringLiteral("Fill Layer"), fillLayer(0, {0.25, 1}));
        });
        QTest::newRow("layer's material") << Push([](TerrainContext &context) {
            context.push<EditSurface>(QStringLiteral("Layer of Gravel"), setLayerMaterial(0, 1));
        });
        QTest::newRow("add material") << Push([](TerrainContext &context) { context.push<AddMaterial>(mud()); });
        QTest::newRow("remove material") << Push(
            [](TerrainContext &context) { context.push<RemoveMaterial>(std::uint8_t(1)); });
        QTest::newRow("edit material") << Push(
            [](TerrainContext &context) { context.push<EditMaterial>(std::uint8_t(0), mud()); });
    }
    void everyCommandKeepsTheContract()
    {
        QFETCH(Push, push);
        TerrainDocument document(tests::sandbox());
        TerrainContext context(document);
        int notices = 0;
        connect(&document, &TerrainDocument::changed, &document, [&] {
            ++notices;
            QVERIFY(tests::isValid(document)); // sent only while the state is whole
        });
        const tests::State before(document);
        push(context);
        QUndoStack &stack = context.undoStack();
        QCOMPARE(stack.count(), 1);
        QVERIFY(notices >= 1);
        QVERIFY(!stack.text(0).isEmpty());
        QVERIFY(!stack.text(0).contains(QLatin1Char('%')));
        QVERIFY(context.history().used() > 0);
        const tests::State after(document);
        QVERIFY(after.saved != before.saved);
        for (int round = 0; round < 2; ++round) {
            notices = 0;
            stack.undo();
            QVERIFY(notices >= 1);
            QVERIFY(tests::State(document) == before);
            notices = 0;
            stack.redo();
            QVERIFY(notices >= 1);
            QVERIFY(tests::State(document) == after);
        }
    }
    void whatChangesNothingLeavesNoStep_data()
    {
        QTest::addColumn<Push>("push");
        QTest::newRow("stroke beside the terrain") << Push([](TerrainContext &context) {
            context.push<EditSurface>(QStringLiteral("Raise"), [](TinEdit &edit) {
                ToolMemory memory;
                Raise tool;
                tool.brush.radius = 0.1;
                [&] { QVERIFY(draw(edit, {tool, {{{5, 5}, 1, 0}}, {}}, 1, memory)); }();
            });
        });
        QTest::newRow("fill layer") << Push([](TerrainContext &context) {
            context.push<EditSurface>(QStringLiteral("Fill Layer"), fillLayer(0, {0.5, 0.1f}));
        });
        QTest::newRow("material in use") << Push(
            [](TerrainContext &context) { context.push<RemoveMaterial>(std::uint8_t(0)); });
        QTest::newRow("same material") << Push([](TerrainContext &context) {
            context.push<EditMaterial>(std::uint8_t(1), material(MaterialPreset::Gravel));
        });
        QTest::newRow("empty edit") << Push(
            [](TerrainContext &context) { context.push<EditSurface>(QStringLiteral("Settle"), Edit()); });
    }
    void whatChangesNothingLeavesNoStep()
    {
        QFETCH(Push, push);
        TerrainDocument document(tests::sandbox());
        TerrainContext context(document);
        const tests::State before(document);
        push(context);
        QCOMPARE(context.undoStack().count(), 0);
        QVERIFY(tests::State(document) == before);
    }
    void removingAMaterialMovesTheLayersBehindIt()
    {
        Terrain terrain = tests::sandbox();
        TerrainDocument document(std::move(terrain));
        TerrainContext context(document);
        context.push<AddMaterial>(mud());
        context.push<EditSurface>(QStringLiteral("Layer of Mud"), setLayerMaterial(0, 2));
        context.push<RemoveMaterial>(std::uint8_t(0));
        QCOMPARE(document.terrain().materials.size(), std::size_t(2));
        QCOMPARE(document.terrain().materialOf(0).name, mud().name);
        context.push<RemoveMaterial>(std::uint8_t(0));
        QCOMPARE(document.terrain().materials.size(), std::size_t(1));
        QCOMPARE(document.terrain().materialOf(0).name, mud().name);
        context.undoStack().setIndex(0);
        QCOMPARE(document.terrain().materials.size(), std::size_t(2));
        context.undoStack().setIndex(context.undoStack().count());
        QCOMPARE(document.terrain().materialOf(0).name, mud().name);
    }
    void oneGestureOfAMaterialIsOneStep()
    {
        TerrainDocument document(tests::sandbox());
        TerrainContext context(document);
        const tests::State before(document);
        const GestureId gesture = context.newGesture();
        Material sand = document.terrain().materials[0];
        for (const double density : {1500.0, 1400.0, 1300.0}) {
            sand.bulkDensity = density;
            context.push<EditMaterial>(std::uint8_t(0), sand, gesture);
        }
        QCOMPARE(context.undoStack().count(), 1);
        sand.bulkDensity = 1250;
        context.push<EditMaterial>(std::uint8_t(0), sand, context.newGesture());
        QCOMPARE(context.undoStack().count(), 2);
        context.undoStack().undo();
        QCOMPARE(document.terrain().materials[0].bulkDensity, 1300.0);
        context.undoStack().undo();
        QVERIFY(tests::State(document) == before);
        // There and back again is no step.
        const GestureId second = context.newGesture();
        const double original = document.terrain().materials[0].bulkDensity;
        for (const double density : {1500.0, original}) {
            sand = document.terrain().materials[0];
            sand.bulkDensity = density;
            context.push<EditMaterial>(std::uint8_t(0), sand, second);
        }
        QCOMPARE(context.undoStack().count(), 0);
    }
};

SANDREEL_TEST(TestTerrainContract)
#include "tst_terraincontract.moc"
