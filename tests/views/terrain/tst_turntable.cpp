// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testmain.h"
#include "tests/views/terrain/groundshapes.h"
#include "views/dialogs/numberfield.h"
#include "views/dialogs/turntabledialog.h"
#include "views/terrain/terrainpictures.h"
#include "views/terrain/terrainviewport.h"
#include "views/viewport/glsupport.h"

#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>

#include <numbers>

using namespace views;

/// The dialog that exports pictures from all around a terrain.
class TestTurntable final : public QObject
{
    Q_OBJECT

    std::unique_ptr<model::TerrainDocument> mDocument;
    std::unique_ptr<TerrainViewport> mViewport;
    QTemporaryDir mFolder;

    QStringList filesIn(const QString &name) const
    {
        return QDir(mFolder.filePath(name)).entryList(QDir::Files, QDir::Name);
    }

private slots:
    void initTestCase()
    {
        QVERIFY2(glSupport().isSufficient, "these tests need a display with OpenGL 3.3");
        mDocument =
            tests::groundDocument(tests::UnitSquare, 20, [](double x, double y) { return 0.5 * x * x + 0.1 * y; });
        mViewport = std::make_unique<TerrainViewport>(*mDocument);
        mViewport->resize(160, 200);
        mViewport->show();
        QVERIFY(QTest::qWaitForWindowExposed(mViewport.get()));
    }
    void cleanupTestCase() { mViewport.reset(); }

    void cameraGoesOnceRound()
    {
        const model::OrbitCamera first = mViewport->camera();
        for (const bool isClockwise : {false, true}) {
            const auto at = [&](std::size_t picture) {
                return TurntableDialog::cameraOf(first, picture, 8, isClockwise);
            };
            QCOMPARE(at(0).yaw, first.yaw);
            QCOMPARE(at(2).yaw - first.yaw, float((isClockwise ? -1 : 1) * std::numbers::pi / 2));
            QCOMPARE(at(5).distance, first.distance);
            QVERIFY(model::length(at(8).position() - first.position()) < 1e-3f * first.distance);
        }
    }

    void picturesAreThoseFromAllAround()
    {
        const model::OrbitCamera first = mViewport->camera();
        TurntableDialog dialog(*mViewport, drawingOf(*mViewport), mFolder.filePath("round"));
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        dialog.findChild<NumberField *>("count")->setValue(4);
        // The preview has the proportions of the pictures.
        const auto *preview = dialog.findChild<QLabel *>("preview");
        QTRY_VERIFY_WITH_TIMEOUT(!preview->pixmap(Qt::ReturnByValue).isNull(), 60000);
        const QSize shown = preview->pixmap(Qt::ReturnByValue).size();
        QVERIFY2(std::abs(shown.width() * 200 - shown.height() * 160) <= 200,
                 qPrintable(QString::number(shown.width())));
        QTest::mouseClick(dialog.findChild<QPushButton *>("export"), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(filesIn("round").size(), 4, 60000);
        QTRY_VERIFY_WITH_TIMEOUT(dialog.findChild<QPushButton *>("showInFolder")->isVisible(), 60000);
        const QStringList files = filesIn("round");
        for (int picture = 0; picture < 4; ++picture) {
            const QImage written(mFolder.filePath("round/" + files[picture]));
            QCOMPARE(written.size(), QSize(160, 200));
            const QImage expected =
                mViewport->renderPicture({160, 200}, TurntableDialog::cameraOf(first, std::size_t(picture), 4, true));
            QCOMPARE(written.convertToFormat(QImage::Format_RGB32), expected.convertToFormat(QImage::Format_RGB32));
            for (int other = 0; other < picture; ++other)
                QVERIFY(QImage(mFolder.filePath("round/" + files[other])) != written);
        }
    }

    void wrongCountIsRefused()
    {
        TurntableDialog dialog(*mViewport, drawingOf(*mViewport), mFolder.filePath("none"));
        dialog.show();
        auto *count = dialog.findChild<NumberField *>("count");
        auto *button = dialog.findChild<QPushButton *>("export");
        QVERIFY(button->isEnabled());
        count->setValue(1);
        QVERIFY(!button->isEnabled());
        count->setValue(2);
        QVERIFY(button->isEnabled());
        QVERIFY(!QDir(mFolder.filePath("none")).exists());
    }
};

SANDREEL_TEST(TestTurntable)
#include "tst_turntable.moc"
