// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/commands/terrain/sandbox.h"
#include "tests/support/testmain.h"
#include "views/dialogs/numberfield.h"
#include "views/docks/historydock.h"
#include "views/docks/terrain/erosiondock.h"
#include "views/docks/terrain/materialdock.h"
#include "views/docks/terrain/toolsdock.h"
#include "views/sculpt/toolvalues.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QMainWindow>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>
#include <QTranslator>
#include <QTreeWidget>

using namespace model::terrain;
using namespace views;

/// Driven as a person does, looking at the document and the settings.
class TestTerrainDocks final : public QObject
{
    Q_OBJECT

    struct Editor
    {
        model::TerrainDocument document{tests::sandbox()};
        commands::TerrainContext context{document};
        ToolSettings settings;
        SandFlow flow{context, settings};
        QMainWindow window;
        ToolsDock *tools = new ToolsDock(settings, &window);
        ErosionDock *erosion = new ErosionDock(settings, &window);
        MaterialDock *materials = new MaterialDock(&window);
        HistoryDock *history = new HistoryDock(&window);
        tests::State start{document};

        Editor()
        {
            settings.fitTo(document.tin().domain());
            window.setCentralWidget(new QWidget);
            window.addDockWidget(Qt::LeftDockWidgetArea, tools);
            window.addDockWidget(Qt::RightDockWidgetArea, erosion);
            window.addDockWidget(Qt::RightDockWidgetArea, materials);
            window.addDockWidget(Qt::LeftDockWidgetArea, history);
            window.splitDockWidget(tools, history, Qt::Horizontal);
            window.splitDockWidget(erosion, materials, Qt::Horizontal);
            erosion->setTerrain(&context, &flow);
            materials->setContext(&context);
            history->setContext(&context);
            window.resize(1500, 950);
            window.show();
        }
        ~Editor()
        {
            history->setContext(nullptr);
            erosion->setTerrain(nullptr, nullptr);
            materials->setContext(nullptr);
        }
    };

    template <class Widget>
    static Widget *find(QWidget *in, const char *name)
    {
        auto *widget = in->findChild<Widget *>(QLatin1String(name));
        if (!widget)
            qFatal("no %s in the dock", name);
        return widget;
    }
    /// The input of the number that is called so.
    static QLineEdit *number(QWidget *in, const QString &name)
    {
        for (QLineEdit *line : in->findChildren<QLineEdit *>())
            if (line->accessibleName() == name)
                return line;
        qFatal("no number %s", qPrintable(name));
    }
    static void type(QLineEdit *line, const QString &text)
    {
        line->setFocus();
        line->selectAll();
        QTest::keyClicks(line, text);
        QTest::keyClick(line, Qt::Key_Return);
    }
    static void choose(QComboBox *box, int row)
    {
        box->setCurrentIndex(row);
        emit box->activated(row); // as a click in its list does
    }

private slots:
    void init() { QLocale::setDefault(QLocale("en_US")); }

    void everyToolHasItsButtonAndFields()
    {
        Editor editor;
        const ToolSettings fresh;
        for (const Tool &tool : fresh.tools()) {
            QTest::mouseClick(find<QToolButton>(editor.tools, (std::string("tool.") + nameOf(tool)).c_str()),
                              Qt::LeftButton);
            QCOMPARE(editor.settings.tool().index(), tool.index());
            for (const ToolField &field : fieldsOf(editor.settings.tool()))
                if (field.kind == ToolField::Kind::Number)
                    QVERIFY(number(editor.tools, field.label));
        }
    }
    void whatIsTypedIsTheTool()
    {
        Editor editor;
        type(number(editor.tools, QStringLiteral("Radius")), QStringLiteral("0.125"));
        QCOMPARE(radiusOf(editor.settings.tool()), 0.125);
        type(number(editor.tools, QStringLiteral("Depth")), QStringLiteral("0.5"));
        QCOMPARE(amountOf(editor.settings.tool()), 0.5);
        type(number(editor.tools, QStringLiteral("Slope to")), QStringLiteral("35"));
        QCOMPARE(maskOf(editor.settings.tool())->highestSlope, 35.0);
        // A key in the view changes what the dock shows.
        Tool tool = editor.settings.tool();
        setRadius(tool, 0.25);
        editor.settings.setTool(tool);
        QCOMPARE(number(editor.tools, QStringLiteral("Radius"))->text(), QStringLiteral("0.25"));
        QVERIFY(check(editor.settings.tool()));
    }
    void aPresetBecomesCustomOnceItIsEdited()
    {
        Editor editor;
        auto *presets = find<QComboBox>(editor.tools, "presets");
        choose(presets, 3);
        QCOMPARE(presets->currentIndex(), 3);
        QVERIFY(std::get<Imprint>(editor.settings.tool()).doesFollowDirection);
        type(number(editor.tools, QStringLiteral("Rim angle")), QStringLiteral("20"));
        QCOMPARE(presets->currentIndex(), 0);
    }
    void symmetryIsTaken()
    {
        Editor editor;
        choose(find<QComboBox>(editor.tools, "symmetry"), int(Symmetry::Kind::Radial));
        type(number(editor.tools, QStringLiteral("Number of copies")), QStringLiteral("5"));
        QCOMPARE(editor.settings.symmetry().count(), 5u);
        QVERIFY((editor.settings.symmetry().centre == Point2{0.5, 0.5}));
    }
    void settingsOfErosionAreTaken()
    {
        Editor editor;
        type(number(editor.erosion, QStringLiteral("Speed")), QStringLiteral("2.5"));
        QCOMPARE(editor.settings.flow().speed, 2.5);
        choose(find<QComboBox>(editor.erosion, "rule"), 1);
        QVERIFY(editor.settings.flow().erosion.rule == ErosionRule::Edge);
        QTest::mouseClick(find<QCheckBox>(editor.erosion, "whileDrawing"), Qt::LeftButton, {}, QPoint(8, 8));
        QVERIFY(!editor.settings.flow().isOn);
    }
    void untilSettledIsOneStep()
    {
        Editor editor;
        editor.context.push<commands::EditSurface>(QStringLiteral("Raise"), [](TinEdit &edit) {
            for (VertexId v = 4; v < 60; ++v)
                edit.setHeight(v, 1.4);
        });
        const tests::State raised(editor.document);
        QTest::mouseClick(find<QPushButton>(editor.erosion, "settle"), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(editor.context.undoStack().count(), 2, 60000);
        QVERIFY(tests::isValid(editor.document));
        // No face is too steep any more: asked of the terrain, not of the erosion.
        const TinArrays &tin = editor.document.tin().arrays();
        double steepest = 0;
        for (TriangleId t = 0; t < tin.triangleSlots(); ++t)
            if (tin.isTriangle(t))
                steepest = std::max(steepest, slopeOf(tin, t) * 180 / M_PI);
        const double critical = criticalAngleAt(editor.document.terrain().materials[0], 0.1);
        QVERIFY2(steepest < critical + 2, qPrintable(QString::number(steepest)));
        editor.context.undoStack().undo();
        QVERIFY(tests::State(editor.document) == raised);
    }
    void layersAreAddedFilledAndRemoved()
    {
        Editor editor;
        auto *layers = find<QTreeWidget>(editor.materials, "layers");
        QCOMPARE(layers->topLevelItemCount(), 1);
        choose(find<QComboBox>(editor.materials, "layerMaterial"), 0);
        type(number(editor.materials, QStringLiteral("Thickness")), QStringLiteral("0.25"));
        QTest::mouseClick(find<QPushButton>(editor.materials, "addLayer"), Qt::LeftButton);
        QTRY_COMPARE(editor.document.tin().arrays().layerCount(), 2u);
        QCOMPARE(editor.document.tin().arrays().sample(9, 1).thickness, 0.25);
        QTRY_COMPARE(layers->topLevelItemCount(), 2);
        QTRY_VERIFY(find<QPushButton>(editor.materials, "removeLayer")->isEnabled());
        QTest::mouseClick(find<QPushButton>(editor.materials, "removeLayer"), Qt::LeftButton);
        QTRY_COMPARE(editor.document.tin().arrays().layerCount(), 1u);
        QCOMPARE(editor.context.undoStack().count(), 2);
        editor.context.undoStack().setIndex(0);
        QVERIFY(tests::State(editor.document) == editor.start);
    }
    void materialsAreEditedAsOneStepAndBecomeCustom()
    {
        Editor editor;
        auto *preset = find<QComboBox>(editor.materials, "materialPreset");
        QCOMPARE(preset->currentIndex(), int(MaterialPreset::DrySand));
        type(number(editor.materials, QStringLiteral("Density")), QStringLiteral("1725"));
        QCOMPARE(editor.document.terrain().materials[0].bulkDensity, 1725.0);
        QCOMPARE(preset->currentIndex(), int(MaterialPreset::Custom));
        QCOMPARE(editor.context.undoStack().count(), 1); // four keys, one step
        choose(preset, int(MaterialPreset::Mud));
        QCOMPARE(presetOf(editor.document.terrain().materials[0]), MaterialPreset::Mud);
        QVERIFY(!find<QPushButton>(editor.materials, "removeMaterial")->isEnabled()); // a layer is made of it
        editor.context.undoStack().setIndex(0);
        QVERIFY(tests::State(editor.document) == editor.start);
        QCOMPARE(preset->currentIndex(), int(MaterialPreset::DrySand));
    }
    void theHistorySaysWhatItKeepsAndDropsWhatIsTooMuch()
    {
        Editor editor;
        for (int i = 0; i < 3; ++i)
            editor.context.push<commands::EditSurface>(QStringLiteral("Fill"), [i](TinEdit &edit) {
                for (VertexId v = 4; v < edit.tin().vertexCount(); ++v)
                    edit.setHeight(v, 1 + 0.1 * i);
            });
        auto *used = find<QLabel>(editor.history, "historyUsed");
        QVERIFY(used->text().contains(QStringLiteral("kB")) || used->text().contains(QStringLiteral("MB")));
        editor.context.history().setLimit(1);
        QCOMPARE(editor.context.undoStack().count(), 1);
        QVERIFY(used->text().contains(QLatin1Char('2')));
        type(find<QWidget>(editor.history, "historyLimit")->findChild<QLineEdit *>(), QStringLiteral("64"));
        QCOMPARE(editor.context.history().limit(), std::size_t(64) << 20);
    }
    void everyControlHasANameAndItsText_data()
    {
        QTest::addColumn<QString>("language");
        QTest::newRow("English") << "en";
        QTest::newRow("Czech") << "cs";
    }
    void everyControlHasANameAndItsText()
    {
        QFETCH(QString, language);
        QTranslator translator;
        QVERIFY(translator.load(QStringLiteral(":/i18n/sandreel_%1.qm").arg(language)));
        QCoreApplication::installTranslator(&translator);
        QLocale::setDefault(QLocale(language));
        Editor editor;
        QTest::qWait(200); // for the layout
        for (QWidget *dock : std::initializer_list<QWidget *>{editor.tools, editor.erosion, editor.materials})
            for (QWidget *widget : dock->findChildren<QWidget *>()) {
                if (!widget->isVisibleTo(dock))
                    continue;
                if (widget->focusPolicy() != Qt::NoFocus && !qobject_cast<QAbstractButton *>(widget) &&
                    !widget->inherits("QAbstractScrollArea") && !widget->inherits("QScrollBar") &&
                    !widget->focusProxy() && !widget->inherits("QLabel") &&
                    widget->objectName() != QLatin1String("qt_scrollarea_viewport"))
                    QVERIFY2(!widget->accessibleName().isEmpty(), widget->metaObject()->className());
                if (const auto *button = qobject_cast<QAbstractButton *>(widget); button && !button->text().isEmpty())
                    QVERIFY2(button->width() >= button->sizeHint().width(), qPrintable(button->text()));
                if (const auto *label = qobject_cast<QLabel *>(widget); label && !label->wordWrap())
                    QVERIFY2(label->width() >= label->sizeHint().width(), qPrintable(label->text()));
            }
        // For whoever wants to see them.
        if (const QString folder = qEnvironmentVariable("SANDREEL_PICTURES"); !folder.isEmpty())
            editor.window.grab().save(QStringLiteral("%1/terraindocks-%2.png").arg(folder, language));
    }
    void docksLetGoOfTheTerrain()
    {
        auto editor = std::make_unique<Editor>();
        editor->erosion->setTerrain(nullptr, nullptr);
        editor->materials->setContext(nullptr);
        QVERIFY(!find<QPushButton>(editor->erosion, "run")->isEnabled());
        QCOMPARE(find<QTreeWidget>(editor->materials, "layers")->topLevelItemCount(), 0);
    }
};

SANDREEL_TEST(TestTerrainDocks)
#include "tst_terraindocks.moc"
