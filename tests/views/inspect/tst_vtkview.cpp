// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/loadedlibraries.h"
#include "tests/support/testmain.h"
#include "views/inspect/vtkview.h"

#include <QMainWindow>
#include <QSignalSpy>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

using namespace views;

namespace {

/// A red triangle in the plane z = 0.
void addTriangle(vtkRenderer &renderer)
{
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(-1, -1, 0);
    points->InsertNextPoint(1, -1, 0);
    points->InsertNextPoint(0, 1, 0);
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell({0, 1, 2});
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(cells);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetLighting(false);
    actor->GetProperty()->SetColor(1, 0, 0);
    renderer.AddActor(actor);
}

model::Box3f box()
{
    model::Box3f result;
    result.add(model::Vec3f{-1, -1, 0});
    result.add(model::Vec3f{1, 1, 0});
    return result;
}

bool isRed(QColor color)
{
    return color.red() > 200 && color.green() < 60 && color.blue() < 60;
}

} // namespace

class TestVtkView final : public QObject
{
    Q_OBJECT

private slots:
    void drawsWhatIsInTheRendererWithoutQt5()
    {
        VtkView view;
        view.resize(320, 240);
        addTriangle(view.renderer());
        view.setSceneBox(box());
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        const QImage picture = view.grabFramebuffer();
        const std::optional<QPointF> middle = view.placeOf({0, 0, 0});
        QVERIFY(middle);
        QVERIFY(isRed(picture.pixelColor(middle->toPoint())));
        QVERIFY(!isRed(picture.pixelColor(2, 2)));
        // The other loaded ones say that the list is read at all.
        QVERIFY(!tests::loadedLibraries().filter("libvtkRenderingOpenGL2").isEmpty());
        QVERIFY(!tests::loadedLibraries().filter("libQt6Widgets").isEmpty());
        QVERIFY2(tests::loadedQt5Libraries().isEmpty(), qPrintable(tests::loadedQt5Libraries().join('\n')));
    }

    /// Rays, places and what VTK draws have to agree: picking rests on it.
    void placesAndRaysAgree()
    {
        VtkView view;
        view.resize(320, 240);
        view.setSceneBox(box());
        for (const model::Vec3f point : {model::Vec3f{0.5f, 0.25f, 0.1f}, {-1, -1, 0}, {0, 1, 0.4f}}) {
            const std::optional<QPointF> place = view.placeOf(point);
            QVERIFY(place);
            const VtkView::Ray ray = view.rayAt(*place);
            const model::Vec3f way = point - ray.origin;
            QVERIFY(model::length(cross(way, ray.direction)) < 1e-3f * model::length(way));
        }
    }

    void survivesAnotherWindow()
    {
        QMainWindow first, second;
        auto *view = new VtkView;
        addTriangle(view->renderer());
        view->setSceneBox(box());
        first.setCentralWidget(view);
        first.resize(320, 240);
        first.show();
        QVERIFY(QTest::qWaitForWindowExposed(&first));
        QVERIFY(isRed(view->grabFramebuffer().pixelColor(view->placeOf({0, 0, 0})->toPoint())));
        second.setCentralWidget(first.takeCentralWidget()); // another context
        second.resize(280, 200);
        second.show();
        QVERIFY(QTest::qWaitForWindowExposed(&second));
        QVERIFY(isRed(view->grabFramebuffer().pixelColor(view->placeOf({0, 0, 0})->toPoint())));
    }

    void onlyAClickThatMovesNothingIsAClick()
    {
        VtkView view;
        view.resize(320, 240);
        view.setSceneBox(box());
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        QSignalSpy clicked(&view, &VtkView::clicked), moved(&view, &VtkView::cameraMoved);
        QTest::mouseClick(&view, Qt::LeftButton, {}, {100, 100});
        QCOMPARE(clicked.size(), 1);
        QTest::mousePress(&view, Qt::LeftButton, {}, {100, 100});
        QTest::mouseMove(&view, {130, 110});
        QTest::mouseMove(&view, {150, 120});
        QTest::mouseRelease(&view, Qt::LeftButton, {}, {150, 120});
        QCOMPARE(clicked.size(), 1);
        QVERIFY(!moved.isEmpty());
    }
};

SANDREEL_TEST(TestVtkView)
#include "tst_vtkview.moc"
