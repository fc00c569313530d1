// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/animationreader.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"
#include "tests/views/dialogs/dialogdriver.h"
#include "views/dialogs/exportframesdialog.h"
#include "views/dialogs/exportpicturesdialog.h"
#include "views/dialogs/exportpointcachedialog.h"
#include "views/dialogs/screenshotdialog.h"
#include "views/scene/picturefiles.h"
#include "views/viewport/animationviewport.h"

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QPushButton>
#include <QTemporaryDir>

using tests::click;
using tests::textOf;
using tests::typeInto;

/// What is exported is read back and compared.
class TestExportDialogs final : public QObject
{
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> mFolder;
    const model::FrameSourcePtr mFrames = tests::wave(tests::grid(6, 4), 12);

    QString path(const QString &name) const { return mFolder->filePath(name); }
    static bool mayExport(const QDialog &dialog) { return tests::find<QPushButton>(dialog, "export")->isEnabled(); }
    static void exportAndWait(views::ExportDialog &dialog)
    {
        click(dialog, "export");
        QTRY_VERIFY(!dialog.isExporting());
        QVERIFY2(textOf(dialog, "message").startsWith("Written: "), qPrintable(textOf(dialog, "message")));
    }
    /// The frames first..last of mFrames, exactly.
    void compare(const model::FrameSource &read, std::uint32_t first, std::uint32_t last) const
    {
        QCOMPARE(read.frameCount(), last - first + 1);
        QVERIFY(read.connectivity() == mFrames->connectivity());
        for (std::uint32_t frame = first; frame <= last; ++frame)
            QVERIFY(read.frame(frame - first) == mFrames->frame(frame));
    }

private slots:
    void init()
    {
        mFolder = std::make_unique<QTemporaryDir>();
        QLocale::setDefault(QLocale("en_US"));
    }
    void cleanup() { QLocale::setDefault(QLocale::c()); }

    void framesComeBackAsTheyWere_data()
    {
        QTest::addColumn<int>("format");
        QTest::addColumn<QString>("ending");
        QTest::newRow("OBJ") << 0 << "obj";
        QTest::newRow("OFF") << 1 << "off";
        QTest::newRow("PLY") << 2 << "ply";
    }
    void framesComeBackAsTheyWere()
    {
        QFETCH(int, format);
        QFETCH(QString, ending);
        views::ExportFramesDialog dialog(mFrames, path("frames"), 0, 11);
        tests::open(dialog);
        tests::find<QComboBox>(dialog, "format")->setCurrentIndex(format);
        typeInto(dialog, "first", "3");
        typeInto(dialog, "last", "7");
        exportAndWait(dialog);
        QCOMPARE(QDir(path("frames")).entryList({"*." + ending}).size(), 5);
        const auto read = model::io::readAnimation(path("frames"));
        QVERIFY(read);
        compare(**read, 2, 6);
    }

    void folderWithFramesIsNotMixed()
    {
        tests::writeObjFrames(path("frames"), *mFrames);
        views::ExportFramesDialog dialog(mFrames, path("frames"), 0, 11);
        tests::open(dialog);
        QVERIFY(!mayExport(dialog));
        QVERIFY(textOf(dialog, "message").startsWith("The folder holds frames already."));
        typeInto(dialog, "folder", path("new"));
        QVERIFY(mayExport(dialog));
        typeInto(dialog, "folder", path("no/such/place"));
        QVERIFY(!mayExport(dialog));
    }

    void cancelledExportOfFramesLeavesNothing()
    {
        const model::FrameSourcePtr large = tests::noise(tests::grid(60, 60), 300);
        views::ExportFramesDialog dialog(large, path("frames"), 0, 299);
        tests::open(dialog);
        click(dialog, "export");
        click(dialog, "cancelJob");
        QTRY_VERIFY(!dialog.isExporting());
        QCOMPARE(textOf(dialog, "message"), QString("Cancelled. Nothing was left behind."));
        QVERIFY(QDir(mFolder->path()).isEmpty());
    }

    void pointCacheComesBackWithItsBaseMesh()
    {
        views::ExportPointCacheDialog dialog(mFrames, path("walk"), 0, 11);
        tests::open(dialog);
        exportAndWait(dialog);
        const auto mesh = model::io::readMesh(path("walk.obj"));
        QVERIFY(mesh);
        QVERIFY(mesh->connectivity == mFrames->connectivity());
        QVERIFY(mesh->positions == mFrames->frame(0));
        const auto read = model::io::readAnimation(path("walk.pc2"));
        QVERIFY(read);
        compare(**read, 0, 11);
    }

    void pointCacheAsksBeforeItReplaces()
    {
        QFile existing(path("walk.obj"));
        QVERIFY(existing.open(QIODevice::WriteOnly));
        existing.write("precious");
        existing.close();
        views::ExportPointCacheDialog dialog(mFrames, path("walk.pc2"), 0, 11);
        tests::open(dialog);
        QString question;
        tests::answerMessageBox("Cancel", &question);
        click(dialog, "export");
        QCOMPARE(question, QString("Already there: walk.obj. Replace?"));
        QCOMPARE(QFile(path("walk.obj")).size(), qint64(8));
        QVERIFY(!QFile::exists(path("walk.pc2")));
        QTest::keyClick(tests::find<QWidget>(dialog, "baseMesh"), Qt::Key_Space); // not wanted any more: nothing to ask
        exportAndWait(dialog);
        QCOMPARE(QFile(path("walk.obj")).size(), qint64(8));
        QVERIFY(QFile::exists(path("walk.pc2")));
    }

    void screenshotHasTheWantedSize()
    {
        views::Player player;
        views::AnimationViewport viewport(player);
        viewport.resize(320, 200);
        player.setSource(mFrames);
        viewport.show();
        QTRY_VERIFY(player.currentFrame() && !viewport.maximumPictureSize().isEmpty());
        views::ScreenshotDialog dialog(viewport, player.currentFrame(), path("shot"));
        tests::open(dialog);
        QCOMPARE(textOf(dialog, "message"), QString("320 × 200 pixels"));
        tests::find<QComboBox>(dialog, "pictureScale")->setCurrentIndex(1);
        QCOMPARE(textOf(dialog, "message"), QString("640 × 400 pixels"));
        exportAndWait(dialog);
        const QImage picture(path("shot.png"));
        QCOMPARE(picture.size(), QSize(640, 400));
        QVERIFY(picture.pixel(320, 200) != picture.pixel(2, 2)); // the mesh is in the middle
    }

    void picturesFollowThePlayback()
    {
        views::Player player;
        views::AnimationViewport viewport(player);
        viewport.resize(160, 120);
        player.setSource(mFrames);
        viewport.show();
        QTRY_VERIFY(player.currentFrame() && !viewport.maximumPictureSize().isEmpty());
        views::ExportPicturesDialog dialog(viewport, mFrames, path("pictures"), 0, 3);
        dialog.setOrder(views::ExportPicturesDialog::Order::ThereAndBack);
        tests::open(dialog);
        QVERIFY2(textOf(dialog, "message").startsWith("6 picture"), qPrintable(textOf(dialog, "message")));
        exportAndWait(dialog);
        const QDir folder(path("pictures"));
        QCOMPARE(folder.entryList({"*.png"}).size(), 6);
        const auto picture = [&folder](int number) {
            return QImage(folder.filePath(QString("frame_%1.png").arg(number, 4, 10, QChar('0'))));
        };
        QCOMPARE(picture(1).size(), QSize(160, 120));
        QVERIFY(picture(1) != picture(4));
        QVERIFY(picture(3) == picture(5)); // 1 2 3 4 3 2
        QVERIFY(picture(2) == picture(6));
        QVERIFY(!mayExport(dialog)); // the folder holds pictures now
    }

    void failedPictureTakesTheOthersAway()
    {
        QVERIFY(QDir(mFolder->path()).mkpath("there"));
        QFile other(path("there/readme.txt"));
        QVERIFY(other.open(QIODevice::WriteOnly));
        int drawn = 0;
        const auto outcome = views::savePictures(
            path("there"), mFrames, {0, 1, 2, 3},
            [&drawn](const views::FrameDataPtr &, const model::Progress &) -> std::optional<QImage> {
                return ++drawn < 3 ? QImage(4, 4, QImage::Format_RGB32) : QImage();
            },
            model::Progress());
        QVERIFY(!outcome);
        QCOMPARE(int(outcome.error().code), int(model::ErrorCode::OutOfMemory));
        QCOMPARE(QDir(path("there")).entryList(QDir::Files), QStringList("readme.txt"));
    }

    void cancelledPicturesAreTakenAwayWithTheirFolder()
    {
        const model::Progress progress;
        int drawn = 0;
        const auto outcome = views::savePictures(
            path("pictures"), mFrames, {0, 1, 2, 3},
            [&drawn](const views::FrameDataPtr &, const model::Progress &running) -> std::optional<QImage> {
                if (++drawn == 3)
                    running.cancel();
                return QImage(4, 4, QImage::Format_RGB32);
            },
            progress);
        QVERIFY(!outcome);
        QCOMPARE(int(outcome.error().code), int(model::ErrorCode::Cancelled));
        QVERIFY(!QDir(path("pictures")).exists());
    }

    void everyControlHasAName()
    {
        const views::ExportFramesDialog frames(mFrames, path("frames"), 0, 11);
        const views::ExportPointCacheDialog cache(mFrames, path("walk"), 0, 11);
        QCOMPARE(tests::unnamedWidgets(frames), QStringList());
        QCOMPARE(tests::unnamedWidgets(cache), QStringList());
    }
};

SANDREEL_TEST(TestExportDialogs)
#include "tst_exportdialogs.moc"
