// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/camera.h"
#include "tests/support/loadedlibraries.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"
#include "views/inspect/inspectordock.h"
#include "views/inspect/meshscenery.h"
#include "views/inspect/meshview.h"
#include "views/inspect/partcolors.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLabel>
#include <QMainWindow>
#include <QSlider>
#include <QTabWidget>
#include <QTableView>

using namespace views;

namespace {

Inspection::MeshPtr meshOf(const model::TriangleMesh &mesh)
{
    return std::make_shared<const model::PolygonMesh>(
        model::PolygonMesh{mesh.positions, model::Faces(mesh.connectivity)});
}

int differenceOf(const QImage &a, const QImage &b)
{
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            if (a.pixel(x, y) != b.pixel(x, y))
                ++count;
    return count;
}

int pixelsLike(const QImage &image, const QColor &wanted)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QColor c = image.pixelColor(x, y);
            if (std::abs(c.red() - wanted.red()) + std::abs(c.green() - wanted.green()) +
                    std::abs(c.blue() - wanted.blue()) <
                40)
                ++count;
        }
    return count;
}

} // namespace

/// A mesh, its lists and its views, as a person uses them.
class TestMeshView final : public QObject
{
    Q_OBJECT

    struct Desk
    {
        Inspection inspection;
        QMainWindow window;
        MeshView *view = new MeshView;
        InspectorDock *dock = new InspectorDock(&window);

        explicit Desk(const model::TriangleMesh &mesh)
        {
            window.setCentralWidget(view);
            window.addDockWidget(Qt::RightDockWidgetArea, dock);
            window.resize(900, 600);
            view->setInspection(&inspection);
            dock->setInspection(&inspection);
            inspection.setMesh(meshOf(mesh));
            window.show();
        }
        bool settle()
        {
            return QTest::qWaitForWindowExposed(&window) &&
                   QTest::qWaitFor([this] { return inspection.handles() && !inspection.isBusy(); }, 20'000);
        }
        QTableView &list(const char *name) { return *dock->findChild<QTableView *>(name); }
        /// Clicks a row; its list is opened before.
        void clickRow(PartKind kind, const char *name, int row, Qt::KeyboardModifiers modifiers = {})
        {
            dock->findChild<QTabWidget *>("inspectorLists")->setCurrentIndex(int(kind));
            QTableView &rows = list(name);
            QTest::mouseClick(rows.viewport(), Qt::LeftButton, modifiers,
                              rows.visualRect(rows.model()->index(row, 0)).center());
        }
    };

private slots:
    void rowsSelectFrameAndMark()
    {
        Desk desk(tests::grid());
        QVERIFY(desk.settle());
        QCOMPARE(desk.list("componentList").model()->rowCount(), 1);
        QCOMPARE(desk.list("holeList").model()->rowCount(), 1);
        QCOMPARE(desk.list("handleList").model()->rowCount(), 0);
        const QColor selected = markColors(desk.view->palette()).selected;
        QCOMPARE(pixelsLike(desk.view->picture(), selected), 0);
        desk.clickRow(PartKind::Hole, "holeList", 0);
        QCOMPARE(desk.inspection.selection(), (std::vector<PartId>{{PartKind::Hole, 0}}));
        QVERIFY(pixelsLike(desk.view->picture(), selected) > 200);
    }

    void handlesShowTwoLoops()
    {
        Desk desk(tests::torus());
        QVERIFY(desk.settle());
        QCOMPARE(desk.list("handleList").model()->rowCount(), 1);
        const MarkColors &colors = markColors(desk.view->palette());
        QVERIFY(pixelsLike(desk.view->picture(), colors.handle) + pixelsLike(desk.view->picture(), colors.tunnel) > 50);
        desk.clickRow(PartKind::Handle, "handleList", 0);
        const QImage chosen = desk.view->picture();
        QVERIFY(pixelsLike(chosen, colors.selected) + pixelsLike(chosen, colors.selectedTunnel) > 50);
    }

    void componentsStepBackBesideTheSelectedOne()
    {
        Desk desk(tests::twoParts());
        QVERIFY(desk.settle());
        QCOMPARE(desk.list("componentList").model()->rowCount(), 2);
        const model::OrbitCamera before = desk.view->camera();
        desk.clickRow(PartKind::Component, "componentList", 1);
        QCOMPARE(desk.inspection.selection(), (std::vector<PartId>{{PartKind::Component, 1}}));
        QVERIFY(model::length(desk.view->camera().target - before.target) > 0.1f); // framed
        QVERIFY(desk.view->camera().distance < before.distance);
        desk.clickRow(PartKind::Component, "componentList", 0, Qt::ControlModifier);
        QCOMPARE(desk.inspection.selection().size(), std::size_t(2));
    }

    void problemsAreListedAndMarked()
    {
        Desk desk(tests::nonManifold());
        QVERIFY(desk.settle());
        QVERIFY(desk.list("problemList").model()->rowCount() >= 1);
        QVERIFY(pixelsLike(desk.view->picture(), markColors(desk.view->palette()).problem) > 20);
        desk.clickRow(PartKind::Problem, "problemList", 0);
        QCOMPARE(desk.inspection.selection().front().kind, PartKind::Problem);
    }

    void aClickPicksAndTellsEverything()
    {
        Desk desk(tests::cube());
        QVERIFY(desk.settle());
        auto *mode = desk.view->findChild<QComboBox *>("pickMode");
        auto *report = desk.view->findChild<QLabel *>("pickReport");
        // The corner that is nearest to the eye.
        const model::Vec3f eye = desk.view->camera().position();
        const model::PolygonMesh &mesh = *desk.inspection.mesh();
        std::uint32_t nearest = 0;
        for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
            if (model::length(mesh.positions[v] - eye) < model::length(mesh.positions[nearest] - eye))
                nearest = v;
        const model::Vec3f inside = mesh.positions[nearest] * 0.97f;
        mode->setCurrentIndex(int(PickMode::Vertex));
        QTest::mouseClick(&desk.view->canvas(), Qt::LeftButton, {}, desk.view->placeOf(inside)->toPoint());
        QVERIFY(desk.view->picked());
        QCOMPARE(desk.view->picked()->vertices[0], nearest);
        QVERIFY(report->text().contains("Position"));
        mode->setCurrentIndex(int(PickMode::Face));
        QTest::mouseClick(&desk.view->canvas(), Qt::LeftButton, {}, desk.view->placeOf(inside)->toPoint());
        const auto corners = mesh.faces.face(desk.view->picked()->face);
        QVERIFY(std::find(corners.begin(), corners.end(), nearest) != corners.end());
        QVERIFY(report->text().contains("Area"));
        // Beside the mesh there is nothing.
        QTest::mouseClick(&desk.view->canvas(), Qt::LeftButton, {}, {3, desk.view->canvas().height() - 3});
        QVERIFY(!desk.view->picked());
    }

    void aPlaneCutsAndPickingKnowsIt()
    {
        Desk desk(tests::cube());
        QVERIFY(desk.settle());
        desk.view->findChild<QAction *>("meshClip")->trigger();
        auto *place = desk.view->findChild<QSlider *>("clipPlace");
        place->setValue(place->maximum()); // nothing is cut away
        const QImage whole = desk.view->picture();
        place->setValue(place->maximum() / 2);
        for (int axis = 0; axis < 3; ++axis) {
            desk.view->findChild<QComboBox *>("clipAxis")->setCurrentIndex(axis);
            QVERIFY(differenceOf(whole, desk.view->picture()) > 500);
        }
        // All is cut away.
        place->setValue(0);
        QTest::mouseClick(&desk.view->canvas(), Qt::LeftButton, {}, desk.view->canvas().rect().center());
        QVERIFY(!desk.view->picked());
        desk.view->findChild<QAction *>("clipFlip")->trigger();
        QTest::mouseClick(&desk.view->canvas(), Qt::LeftButton, {}, desk.view->canvas().rect().center());
        QVERIFY(desk.view->picked());
    }

    void fieldsColourWithAScale()
    {
        Desk desk(tests::torus());
        QVERIFY(desk.settle());
        const auto along = [mesh = desk.inspection.mesh()](float model::Vec3f::*axis) {
            return [mesh, axis](const model::Progress &) -> model::Result<std::vector<float>> {
                std::vector<float> values;
                for (const model::Vec3f &p : mesh->positions)
                    values.push_back(p.*axis);
                return values;
            };
        };
        desk.inspection.setOffers({{{FieldKind::Valence}, along(&model::Vec3f::x)},
                                   {{FieldKind::PcaCoefficient, 1}, along(&model::Vec3f::y)}});
        QCOMPARE(desk.inspection.fields().size(), std::size_t(2));
        auto *coloring = desk.view->findChild<QComboBox *>("coloring");
        const QImage plain = desk.view->picture();
        for (const FieldId id : desk.inspection.fields()) {
            coloring->setCurrentIndex(coloring->findText(fieldTitle(id)));
            QTRY_VERIFY(desk.inspection.knownField(id));
            QVERIFY(differenceOf(plain, desk.view->picture()) > 500);
        }
    }

    void outliersDoNotStretchTheScale()
    {
        std::vector<float> values(1000);
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = float(i) / 1000;
        values[3] = 1e9f;
        values[7] = std::numeric_limits<float>::quiet_NaN();
        const auto [low, high] = typicalRange(values);
        QVERIFY(low >= 0 && low < 0.02f && high > 0.98f && high < 1);
        QCOMPARE(typicalRange({}), std::pair(0.0f, 0.0f));
    }

    void aSecondViewSharesTheSelection()
    {
        Desk desk(tests::grid());
        MeshView second;
        second.resize(400, 300);
        second.setInspection(&desk.inspection);
        second.show();
        QVERIFY(QTest::qWaitForWindowExposed(&second));
        QVERIFY(desk.settle());
        desk.clickRow(PartKind::Hole, "holeList", 0);
        QVERIFY(pixelsLike(second.picture(), markColors(second.palette()).selected) > 100);
    }

    void rowsAreCopiedAsATable()
    {
        Desk desk(tests::twoParts());
        QVERIFY(desk.settle());
        desk.dock->findChild<QAction *>("inspector.copy")->trigger();
        const QStringList lines = QGuiApplication::clipboard()->text().split('\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 3);
        QVERIFY2(lines[1].startsWith("0\t8\t18\t12\t2\t0\t0\ttrue\t"), qPrintable(lines[1]));
    }

    void theCoarseMeshKeepsTheShapeWithFewTriangles()
    {
        const model::TriangleMesh fine = tests::grid(300, 300);
        const auto few = clusterTriangles(*meshOf(fine), 60);
        QVERIFY(few.size() > 2000 && few.size() < 8000);
        double area = 0;
        for (const model::Triangle &t : few) {
            const auto side = [&](int i) { return fine.positions[t[std::size_t(i)]] - fine.positions[t[0]]; };
            area += 0.5 * double(model::length(cross(side(1), side(2))));
        }
        QVERIFY(area > 0.9 && area < 1.01); // of the unit square
    }

    void noQt5IsLoaded()
    {
        QVERIFY2(tests::loadedQt5Libraries().isEmpty(), qPrintable(tests::loadedQt5Libraries().join('\n')));
    }
};

SANDREEL_TEST(TestMeshView)
#include "tst_meshview.moc"
