// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/documents/meshtab.h"
#include "model/io/animationwriter.h"
#include "tests/app/editor/windowdriver.h"
#include "tests/support/loadedlibraries.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"
#include "views/dialogs/preparedialog.h"
#include "views/inspect/inspectordock.h"
#include "views/inspect/meshview.h"

#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QTabWidget>
#include <QTableView>
#include <QUndoStack>

using editor::ActionId;
using views::PartKind;

/// Meshes in the window: opened, inspected, changed and saved, as a person does it.
class TestMeshes final : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> mFolder;
    std::unique_ptr<tests::WindowDriver> mDriver;

    QString writeMesh(const model::TriangleMesh &mesh, const QString &name,
                      model::io::MeshFormat format = model::io::MeshFormat::Off)
    {
        const QString path = mFolder->filePath(name);
        const auto written =
            model::io::writePolygonMesh(path, {mesh.positions, model::Faces(mesh.connectivity)}, format);
        return written ? path : QString();
    }
    editor::MeshTab *tab() { return mDriver->window.workspace().currentMesh(); }
    editor::OpenMesh &document() { return tab()->document(); }
    views::Inspection &inspection() { return document().inspection(); }
    views::InspectorDock &dock() { return *mDriver->window.findChild<views::InspectorDock *>(); }
    QTableView &list(PartKind kind)
    {
        static constexpr const char *Names[] = {"componentList", "holeList", "handleList", "problemList"};
        return *dock().findChild<QTableView *>(Names[std::size_t(kind)]);
    }
    QAction &action(const char *name) { return *mDriver->window.findChild<QAction *>(name); }
    std::uint32_t faceCount() { return document().mesh().mesh()->faces.faceCount(); }

    bool analysed()
    {
        return QTest::qWaitFor([this] { return tab() && inspection().handles() && !inspection().isBusy(); }, 30'000);
    }
    bool open(const QString &path)
    {
        mDriver->window.open({path});
        return mDriver->settle() && tab() && document().isOpen() && analysed();
    }
    void clickRow(PartKind kind, int row, Qt::KeyboardModifiers modifiers = {})
    {
        dock().findChild<QTabWidget *>("inspectorLists")->setCurrentIndex(int(kind));
        QTableView &rows = list(kind);
        QTest::mouseClick(rows.viewport(), Qt::LeftButton, modifiers,
                          rows.visualRect(rows.model()->index(row, 0)).center());
    }
    /// Triggers an operation and waits for its step.
    bool run(const char *name)
    {
        const int before = document().context()->undoStack().index();
        if (!action(name).isEnabled())
            return false;
        action(name).trigger();
        return QTest::qWaitFor([&] { return document().context()->undoStack().index() == before + 1; }, 30'000) &&
               analysed();
    }

private slots:
    void init()
    {
        mFolder = std::make_unique<QTemporaryDir>();
        mDriver = std::make_unique<tests::WindowDriver>();
    }
    void cleanup() { mDriver.reset(); }

    void opensInATabWithItsLists()
    {
        QVERIFY(!action("mesh.weld").isVisible());
        QVERIFY(open(writeMesh(tests::twoParts(), "two.obj", model::io::MeshFormat::Obj)));
        QVERIFY(tab()->view());
        QVERIFY(dock().isVisible());
        QVERIFY(action("mesh.weld").isVisible());
        QCOMPARE(list(PartKind::Component).model()->rowCount(), 2);
        QCOMPARE(list(PartKind::Hole).model()->rowCount(), 0);
        QVERIFY(!document().isModified());
        clickRow(PartKind::Component, 1);
        QCOMPARE(inspection().selection(), (std::vector<views::PartId>{{PartKind::Component, 1}}));
        clickRow(PartKind::Component, 0, Qt::ControlModifier);
        QCOMPARE(inspection().selection().size(), std::size_t(2));
    }

    void holesAreFilledUndoneSavedAndReopened()
    {
        const QString path = writeMesh(tests::grid(), "grid.off");
        QVERIFY(open(path));
        QVERIFY(!action("mesh.fillHoles").isEnabled());
        clickRow(PartKind::Hole, 0);
        QCOMPARE(inspection().selection(), (std::vector<views::PartId>{{PartKind::Hole, 0}}));
        const std::uint64_t before = document().mesh().fingerprint();
        const std::uint32_t faces = faceCount();
        QVERIFY(run("mesh.fillHoles"));
        QVERIFY(faceCount() > faces);
        QVERIFY(document().isModified());
        QCOMPARE(list(PartKind::Hole).model()->rowCount(), 0);
        const std::uint64_t filled = document().mesh().fingerprint();

        mDriver->action(ActionId::Undo).trigger();
        QVERIFY(analysed());
        QCOMPARE(document().mesh().fingerprint(), before);
        QCOMPARE(list(PartKind::Hole).model()->rowCount(), 1);
        QVERIFY(!document().isModified());
        mDriver->action(ActionId::Redo).trigger();
        QVERIFY(analysed());
        QCOMPARE(document().mesh().fingerprint(), filled);

        mDriver->action(ActionId::Save).trigger();
        QVERIFY(mDriver->settle());
        QVERIFY(!document().isModified());
        mDriver->action(ActionId::CloseTab).trigger();
        QTRY_VERIFY(!tab());
        QVERIFY(open(path));
        QCOMPARE(document().mesh().fingerprint(), filled);
        QCOMPARE(list(PartKind::Hole).model()->rowCount(), 0);
    }

    void everyOperationIsOneStep_data()
    {
        QTest::addColumn<QString>("mesh");
        QTest::addColumn<QByteArray>("operation");
        QTest::addColumn<int>("kind"); // of the list whose first row is clicked before; -1: none
        QTest::newRow("cut handle") << "torus" << QByteArray("mesh.cutHandle") << int(PartKind::Handle);
        QTest::newRow("delete") << "two parts" << QByteArray("mesh.deleteComponents") << int(PartKind::Component);
        QTest::newRow("orient") << "misoriented" << QByteArray("mesh.orient") << -1;
        QTest::newRow("degenerate") << "degenerate" << QByteArray("mesh.removeDegenerate") << -1;
        QTest::newRow("duplicate") << "degenerate" << QByteArray("mesh.removeDuplicate") << -1;
        QTest::newRow("isolated") << "isolated" << QByteArray("mesh.removeIsolated") << -1;
        QTest::newRow("split") << "non-manifold" << QByteArray("mesh.split") << -1;
        QTest::newRow("decimate") << "torus" << QByteArray("mesh.decimate") << -1;
        QTest::newRow("subdivide") << "cube" << QByteArray("mesh.subdivide") << -1;
        QTest::newRow("smooth") << "torus" << QByteArray("mesh.smooth") << -1;
        QTest::newRow("weld") << "cracked" << QByteArray("mesh.weld") << -1;
    }
    void everyOperationIsOneStep()
    {
        QFETCH(QString, mesh);
        QFETCH(QByteArray, operation);
        QFETCH(int, kind);
        model::TriangleMesh cracked = tests::grid(); // every triangle for itself
        model::TriangleMesh soup;
        for (const model::Triangle &triangle : cracked.connectivity.triangles) {
            const auto first = std::uint32_t(soup.positions.size());
            for (const std::uint32_t corner : triangle)
                soup.positions.push_back(cracked.positions[corner]);
            soup.connectivity.triangles.push_back({first, first + 1, first + 2});
        }
        soup.connectivity.vertexCount = std::uint32_t(soup.positions.size());
        const QMap<QString, model::TriangleMesh> meshes{{"torus", tests::torus()},
                                                        {"two parts", tests::twoParts()},
                                                        {"misoriented", tests::misoriented()},
                                                        {"degenerate", tests::degenerate()},
                                                        {"isolated", tests::isolatedVertex()},
                                                        {"non-manifold", tests::nonManifold()},
                                                        {"cube", tests::cube()},
                                                        {"cracked", soup}};
        QVERIFY(open(writeMesh(meshes[mesh], "mesh.off")));
        if (kind >= 0)
            clickRow(PartKind(kind), 0);
        const std::uint64_t before = document().mesh().fingerprint();
        QVERIFY(run(operation.constData()));
        const std::uint64_t after = document().mesh().fingerprint();
        QVERIFY(after != before);
        QVERIFY(!document().context()->undoStack().undoText().isEmpty());
        for (int round = 0; round < 2; ++round) {
            mDriver->action(ActionId::Undo).trigger();
            QCOMPARE(document().mesh().fingerprint(), before);
            mDriver->action(ActionId::Redo).trigger();
            QCOMPARE(document().mesh().fingerprint(), after);
        }
    }

    void whatChangesNothingLeavesNoStep()
    {
        QVERIFY(open(writeMesh(tests::torus(), "torus.off")));
        for (const char *name : {"mesh.weld", "mesh.orient", "mesh.removeDegenerate", "mesh.removeDuplicate",
                                 "mesh.removeIsolated", "mesh.split"}) {
            mDriver->window.workspace().messages().clear();
            action(name).trigger();
            QTRY_VERIFY2(!mDriver->window.workspace().messages().texts().isEmpty(), name);
            QTRY_VERIFY(action(name).isEnabled());
        }
        QCOMPARE(document().context()->undoStack().count(), 0);
    }

    void theReportIsThatOfTheCommandLine()
    {
        QVERIFY(open(writeMesh(tests::torus(), "torus.off")));
        const QString path = mFolder->filePath("report.json");
        tests::withNextDialog([&](QDialog &dialog) {
            dialog.findChild<QLineEdit *>("fileNameEdit")->setText(path);
            dialog.accept();
        });
        action("inspector.save").trigger();
        QTRY_VERIFY(QFile::exists(path));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QJsonObject json = QJsonDocument::fromJson(file.readAll()).object();
        QCOMPARE(json["genus"].toInt(), 1);
        QCOMPARE(json["handles"].toArray().size(), 1);
        QCOMPARE(json["problems"]["self_intersections"]["count"].toInt(-1), 0); // they were looked for
    }

    void numbersOfTheShapeColourIt()
    {
        QVERIFY(open(writeMesh(tests::torus(), "torus.off")));
        const views::FieldId valence{views::FieldKind::Valence};
        auto *coloring = tab()->view()->findChild<QComboBox *>("coloring");
        const int row = coloring->findText(views::fieldTitle(valence));
        QVERIFY(row >= 0);
        coloring->setCurrentIndex(row);
        QTRY_VERIFY(inspection().knownField(valence));
        for (const float value : *inspection().knownField(valence))
            QCOMPARE(value, 6.0f);
    }

    void aFrameOfAnAnimationIsInspected()
    {
        QVERIFY(mDriver->open(tests::makeAnim(*mFolder)));
        mDriver->action(ActionId::InspectFrame).trigger();
        QVERIFY(mDriver->settle());
        QVERIFY(tab() && analysed());
        QVERIFY(document().path().isEmpty());
        QVERIFY(document().title().contains("1"));
        QVERIFY(inspection().fields().size() > 3); // more than the shape alone has
    }

    void meshesNumberedAlikeAreAnAnimation()
    {
        const QStringList frames{writeMesh(tests::cube(), "cube_1.off"), writeMesh(tests::cube(), "cube_2.off")};
        mDriver->window.open(frames);
        views::PrepareDialog *dialog = nullptr;
        QTRY_VERIFY((dialog = mDriver->window.findChild<views::PrepareDialog *>()) && dialog->isVisible());
        QVERIFY(!tab());
        dialog->close();
        // One of them alone is a mesh, and the window says what else it may be.
        QVERIFY(open(frames.constFirst()));
        const QStringList told = mDriver->window.workspace().messages().texts();
        QVERIFY(std::any_of(told.begin(), told.end(), [](const QString &text) { return text.contains("animation"); }));
    }

    void aSecondViewIsDocked()
    {
        QVERIFY(open(writeMesh(tests::torus(), "torus.off")));
        auto *second = mDriver->window.findChild<QDockWidget *>("meshViewDock2");
        QVERIFY(second && !second->isVisible());
        second->toggleViewAction()->trigger();
        auto *view = qobject_cast<views::MeshView *>(second->widget());
        QVERIFY(view);
        QCOMPARE(view->inspection(), &inspection());
        mDriver->action(ActionId::CloseTab).trigger();
        QTRY_VERIFY(!tab());
        QVERIFY(!view->inspection());
    }

    void whatCannotBeReadIsSaid()
    {
        QFile file(mFolder->filePath("broken.off"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("OFF\n3 1 0\n0 0 0\n");
        file.close();
        mDriver->window.open({file.fileName()});
        QVERIFY(mDriver->settle());
        QTRY_VERIFY(!tab());
        const QStringList told = mDriver->window.workspace().messages().texts();
        QVERIFY(!told.isEmpty() && told.constLast().contains("broken.off"));
    }

    void noQt5IsLoaded()
    {
        QVERIFY(open(writeMesh(tests::torus(), "torus.off")));
        QVERIFY(!tests::loadedLibraries().filter("vtk").isEmpty());
        QVERIFY2(tests::loadedQt5Libraries().isEmpty(), qPrintable(tests::loadedQt5Libraries().join('\n')));
    }
};

SANDREEL_TEST(TestMeshes)
#include "tst_meshes.moc"
