// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/animfile.h"
#include "tests/support/busyjobs.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"
#include "tests/views/dialogs/dialogdriver.h"
#include "views/dialogs/framepreview.h"
#include "views/dialogs/numberfield.h"
#include "views/dialogs/pathfield.h"
#include "views/dialogs/preparedialog.h"

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>

using tests::click;
using tests::textOf;
using tests::typeInto;
using views::PrepareDialog;

namespace {

void writeFile(const QString &path, const QByteArray &bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

QByteArray fileBytes(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

/// Drives the dialog as a person does, and looks at the files.
class TestPrepareDialog final : public QObject
{
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> mFolder;

    QString path(const QString &name) const { return mFolder->filePath(name); }
    /// A folder of 12 frames with 35 vertices and 48 triangles.
    QString smallSource(const QString &name = "walk") const
    {
        return tests::writeObjFrames(path(name), *tests::wave(tests::grid(6, 4)));
    }
    /// One that takes long enough to be interrupted.
    QString largeSource() const { return tests::writeObjFrames(path("large"), *tests::noise(tests::grid(60, 60), 60)); }
    static bool isReady(const PrepareDialog &dialog) { return tests::find<QPushButton>(dialog, "encode")->isEnabled(); }
    static int tryCount(const PrepareDialog &dialog) { return tests::find<QTableWidget>(dialog, "tries")->rowCount(); }

private slots:
    void init()
    {
        mFolder = std::make_unique<QTemporaryDir>();
        QSettings().clear();
        QSettings().setValue("prepareDialog/compression", "pca basis=20 resolution=10000");
        QLocale::setDefault(QLocale("en_US"));
    }
    void cleanup() { QLocale::setDefault(QLocale::c()); }

    void typedFolderShowsWhatIsThere()
    {
        const QString source = smallSource();
        PrepareDialog dialog;
        tests::open(dialog);
        QVERIFY(!isReady(dialog));
        typeInto(dialog, "source", source);
        QTRY_COMPARE(textOf(dialog, "factVertices"), QString("35"));
        QCOMPARE(textOf(dialog, "factFormat"), QString("Folder of OBJ frames"));
        QCOMPARE(textOf(dialog, "factFrames"), QString("12 (0.5 s)"));
        QCOMPARE(textOf(dialog, "factTriangles"), QString("48"));
        QCOMPARE(textOf(dialog, "factRawSize"), QString("5.0 kB")); // 35 * 12 * 12 bytes
        QVERIFY(textOf(dialog, "factBox").startsWith("1 × 1 × "));
        QCOMPARE(textOf(dialog, "name"), QString("walk"));
        QCOMPARE(textOf(dialog, "output"), path("walk.anim"));
        QVERIFY(isReady(dialog));
        const auto *preview = dialog.findChild<views::FramePreview *>();
        QTRY_VERIFY(!preview->picture().picture().isNull());
    }

    void whatIsNoSourceIsRefusedWhereTyped()
    {
        writeFile(path("notes.txt"), "hello");
        PrepareDialog dialog;
        tests::open(dialog);
        typeInto(dialog, "source", path("nowhere"));
        QTRY_COMPARE(textOf(dialog, "sourceMessage"), QString("There is no such file or folder."));
        QVERIFY(dialog.findChild<views::PathField *>("source")->input().isRefused());
        QVERIFY(!isReady(dialog));
        typeInto(dialog, "source", path("notes.txt"));
        QTRY_COMPARE(textOf(dialog, "sourceMessage"), QString("Files with the ending “.txt” cannot be read."));
    }

    void valuesOutOfRangeAreRefusedWhereTyped()
    {
        const QString source = smallSource();
        PrepareDialog dialog;
        tests::open(dialog);
        dialog.setSource(source);
        QTRY_VERIFY(isReady(dialog));
        for (const auto &[field, bad, good] : {std::tuple("pca-basis", "0", "5"),
                                               {"pca-basis", "1001", "5"},
                                               {"pca-resolution", "0.5", "1000"},
                                               {"frameRate", "0", "30"}}) {
            typeInto(dialog, field, bad);
            QVERIFY2(dialog.findChild<views::NumberField *>(field)->input().isRefused(), field);
            QVERIFY2(!isReady(dialog), field);
            QCOMPARE(textOf(dialog, "message"), dialog.findChild<views::NumberField *>(field)->problem());
            typeInto(dialog, field, good);
            QVERIFY2(isReady(dialog), field);
        }
    }

    void encodedFileHoldsTheAnimation()
    {
        const QString source = smallSource();
        PrepareDialog dialog;
        tests::open(dialog);
        QSignalSpy opened(&dialog, &PrepareDialog::openRequested);
        typeInto(dialog, "source", source);
        QTRY_VERIFY(isReady(dialog));
        typeInto(dialog, "name", "Waving Flag");
        typeInto(dialog, "frameRate", "29.97");
        typeInto(dialog, "pca-basis", "4");
        typeInto(dialog, "output", path("flag")); // the ending is added
        click(dialog, "encode");
        QTRY_COMPARE(tryCount(dialog), 1);

        const auto anim = model::io::openAnim(path("flag.anim"));
        QVERIFY(anim);
        QCOMPARE((*anim)->frameCount(), 12u);
        QCOMPARE((*anim)->vertexCount(), 35u);
        QCOMPARE((*anim)->connectivity().triangles.size(), std::size_t(48));
        QCOMPARE((*anim)->name(), std::string("Waving Flag"));
        QCOMPARE((*anim)->frameRate(), 29.97);
        QCOMPARE(std::get<model::PcaSettings>((*anim)->settings().method).basisSize, 4u);
        QVERIFY(textOf(dialog, "resultSummary").contains("KG error"));

        click(dialog, "openResult");
        QCOMPARE(opened.size(), 1);
        QCOMPARE(opened.first().first().toString(), path("flag.anim"));
        // What it was made of comes along, so that the error can be shown at once.
        const auto original = opened.first().last().value<views::OriginalPtr>();
        QVERIFY(original != nullptr);
        const auto errors = model::compareAnimations(*original->frames, **anim, original->permutation);
        QVERIFY(errors.has_value());
        QVERIFY(errors->kgErrorPercent < 20);
    }

    void normalisedAnimationFillsTheCube()
    {
        PrepareDialog dialog;
        tests::open(dialog);
        dialog.setSource(smallSource());
        QTRY_VERIFY(isReady(dialog));
        auto *mode = tests::find<QComboBox>(dialog, "normalisation");
        mode->setFocus();
        QTest::keyClick(mode, Qt::Key_End);
        click(dialog, "encode");
        QTRY_COMPARE(tryCount(dialog), 1);
        const auto anim = model::io::openAnim(path("walk.anim"));
        QVERIFY(anim);
        model::Box3f box;
        for (std::uint32_t frame = 0; frame < (*anim)->frameCount(); ++frame)
            box.add(model::boundingBox((*anim)->frame(frame)));
        QVERIFY(std::abs(box.longestSide() - 2) < 0.01);
        QVERIFY(model::length(box.center()) < 0.01);
    }

    void cancelLeavesNothingBehind()
    {
        PrepareDialog dialog;
        tests::open(dialog);
        dialog.setSource(largeSource());
        QTRY_VERIFY(isReady(dialog));
        const QStringList before = QDir(mFolder->path()).entryList();
        click(dialog, "encode");
        QVERIFY(dialog.isEncoding());
        click(dialog, "cancelJob");
        QTRY_VERIFY(!dialog.isEncoding());
        QCOMPARE(textOf(dialog, "message"), QString("Cancelled. Nothing was written."));
        QCOMPARE(QDir(mFolder->path()).entryList(), before);
        QCOMPARE(tryCount(dialog), 0);
        QVERIFY(isReady(dialog)); // and it may be tried again
    }

    void brokenFrameIsNamedWithItsLine()
    {
        const QString source = smallSource();
        writeFile(source + "/frame_0003.obj", "v 0 0 0\nv 1 zero 0\n");
        PrepareDialog dialog;
        tests::open(dialog);
        typeInto(dialog, "source", source);
        QTRY_VERIFY(textOf(dialog, "sourceMessage").contains("frame_0003.obj, line 2"));
        QVERIFY(tests::find<QLabel>(dialog, "sourceMessage")->textInteractionFlags() & Qt::TextSelectableByMouse);
        QVERIFY(!isReady(dialog));
        QCOMPARE(textOf(dialog, "factVertices"), QString("–"));
    }

    void differingVertexCountIsNamed()
    {
        const QString source = smallSource();
        tests::writeObjFrames(path("other"), *tests::oneFrame(tests::cube()));
        QVERIFY(QFile::remove(source + "/frame_0005.obj"));
        QVERIFY(QFile::copy(path("other/frame_0001.obj"), source + "/frame_0005.obj"));
        PrepareDialog dialog;
        tests::open(dialog);
        dialog.setSource(source);
        QTRY_VERIFY(textOf(dialog, "sourceMessage").contains("frame_0005.obj"));
        QVERIFY(textOf(dialog, "sourceMessage").contains("35"));
        QVERIFY(textOf(dialog, "sourceMessage").contains("8"));
    }

    void newerSourceWinsWhileTheOlderIsRead()
    {
        const QString older = largeSource();
        const QString newer = smallSource();
        PrepareDialog dialog;
        tests::open(dialog);
        dialog.setSource(older);
        dialog.setSource(newer);
        QTRY_VERIFY(isReady(dialog));
        QCOMPARE(textOf(dialog, "factVertices"), QString("35"));
        QCOMPARE(textOf(dialog, "output"), path("walk.anim"));
        QTest::qWait(100);
        QCOMPARE(textOf(dialog, "factVertices"), QString("35"));
    }

    void proposalsFollowTheSourceUntilTheyAreChanged()
    {
        const QString first = smallSource("first");
        const QString second = smallSource("second");
        const QString third = smallSource("third");
        PrepareDialog dialog;
        tests::open(dialog);
        dialog.setSource(first);
        QTRY_COMPARE(textOf(dialog, "output"), path("first.anim"));
        dialog.setSource(second);
        QTRY_COMPARE(textOf(dialog, "output"), path("second.anim"));
        typeInto(dialog, "output", path("mine.anim"));
        typeInto(dialog, "name", "Mine");
        dialog.setSource(third);
        QTRY_VERIFY(isReady(dialog));
        QCOMPARE(textOf(dialog, "output"), path("mine.anim"));
        QCOMPARE(textOf(dialog, "name"), QString("Mine"));
    }

    void overwritingIsAsked()
    {
        const QString source = smallSource();
        writeFile(path("walk.anim"), "precious");
        PrepareDialog dialog;
        tests::open(dialog);
        dialog.setSource(source);
        QTRY_VERIFY(isReady(dialog));
        QString question;
        tests::answerMessageBox("Cancel", &question);
        click(dialog, "encode");
        QCOMPARE(question, QString("“walk.anim” exists. Replace it?"));
        QVERIFY(!dialog.isEncoding());
        QCOMPARE(fileBytes(path("walk.anim")), QByteArray("precious"));

        tests::answerMessageBox("Replace");
        click(dialog, "encode");
        QTRY_COMPARE(tryCount(dialog), 1);
        QVERIFY(model::io::openAnim(path("walk.anim")));
    }

    void triesAreKeptForComparison()
    {
        PrepareDialog dialog;
        tests::open(dialog);
        dialog.setSource(smallSource());
        QTRY_VERIFY(isReady(dialog));
        typeInto(dialog, "pca-basis", "1");
        click(dialog, "encode");
        QTRY_COMPARE(tryCount(dialog), 1);
        click(dialog, "encodeAgain");
        QTest::keyClicks(QApplication::focusWidget(), "7"); // the basis size is selected
        click(dialog, "encode");                            // its own file: not asked about
        QTRY_COMPARE(tryCount(dialog), 2);

        auto *table = tests::find<QTableWidget>(dialog, "tries");
        QVERIFY(table->item(0, 0)->text().startsWith("PCA, basis 1, resolution 10,000"));
        QVERIFY(table->item(1, 0)->text().startsWith("PCA, basis 7, resolution 10,000"));
        const auto number = [table](int row, int column) {
            return QLocale().toDouble(table->item(row, column)->text().section(QChar(0xa0), 0, 0));
        };
        constexpr int KgError = 4;
        QVERIFY(number(0, KgError) > number(1, KgError));
        QVERIFY(tests::find<QPushButton>(dialog, "openResult")->isEnabled());
        table->selectRow(0); // the file holds the second try now
        QVERIFY(!tests::find<QPushButton>(dialog, "openResult")->isEnabled());
    }

    void fileOfAnotherSourceIsNotReplacedUnasked()
    {
        const QString other = smallSource("other");
        PrepareDialog dialog;
        tests::open(dialog);
        dialog.setSource(smallSource());
        QTRY_VERIFY(isReady(dialog));
        typeInto(dialog, "output", path("mine.anim"));
        click(dialog, "encode");
        QTRY_COMPARE(tryCount(dialog), 1);
        const QByteArray made = fileBytes(path("mine.anim"));
        dialog.setSource(other);
        QTRY_VERIFY(isReady(dialog));
        QCOMPARE(tryCount(dialog), 0); // tries of another animation compare with nothing
        QString question;
        tests::answerMessageBox("Cancel", &question);
        click(dialog, "encode");
        QCOMPARE(question, QString("“mine.anim” exists. Replace it?"));
        QCOMPARE(fileBytes(path("mine.anim")), made);
    }

    void closingWhileEncodingAsks()
    {
        PrepareDialog dialog;
        tests::open(dialog);
        dialog.setSource(smallSource());
        QTRY_VERIFY(isReady(dialog));
        {
            const tests::BusyJobs busy; // the encoding does not end before the questions are answered
            click(dialog, "encode");
            QString question;
            tests::answerMessageBox("Keep Encoding", &question);
            QTest::keyClick(&dialog, Qt::Key_Escape);
            QCOMPARE(question, QString("The animation is still being encoded."));
            QVERIFY(dialog.isVisible());
            QVERIFY(dialog.isEncoding());
            tests::answerMessageBox("Stop Encoding", &question);
            dialog.close();
            QVERIFY(!dialog.isVisible());
        }
        QTRY_VERIFY(!dialog.isEncoding());
        QVERIFY(!QFile::exists(path("walk.anim")));
        QCOMPARE(tryCount(dialog), 0);
    }

    void whatWasKeptEncodingIsWritten()
    {
        PrepareDialog dialog;
        tests::open(dialog);
        dialog.setSource(smallSource());
        QTRY_VERIFY(isReady(dialog));
        {
            const tests::BusyJobs busy;
            click(dialog, "encode");
            tests::answerMessageBox("Keep Encoding");
            QTest::keyClick(&dialog, Qt::Key_Escape);
        }
        QTRY_COMPARE(tryCount(dialog), 1);
        QVERIFY(model::io::openAnim(path("walk.anim")));
        QTest::keyClick(&dialog, Qt::Key_Escape); // nothing to ask about any more
        QVERIFY(!dialog.isVisible());
    }

    void destroyingWhileEncodingLeavesNothing()
    {
        auto dialog = std::make_unique<PrepareDialog>();
        tests::open(*dialog);
        dialog->setSource(largeSource());
        QTRY_VERIFY(isReady(*dialog));
        click(*dialog, "encode");
        dialog.reset();
        QTest::qWait(500);
        QVERIFY(!QFile::exists(path("large.anim")));
    }

    void droppedFolderIsTheSource()
    {
        const QString source = smallSource();
        PrepareDialog dialog;
        tests::open(dialog);
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(source)});
        QDragEnterEvent enter(QPoint(20, 200), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&dialog, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(20, 200), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&dialog, &drop);
        QCOMPARE(textOf(dialog, "source"), source);
        QTRY_VERIFY(isReady(dialog));
    }

    void settingsAreRemembered()
    {
        {
            PrepareDialog dialog;
            tests::open(dialog);
            typeInto(dialog, "pca-basis", "37");
            typeInto(dialog, "pca-resolution", "2500");
        }
        const PrepareDialog again;
        QCOMPARE(textOf(again, "pca-basis"), QString("37"));
        QCOMPARE(textOf(again, "pca-resolution"), QString("2,500"));
    }

    void spoiltSettingsAreNotTaken()
    {
        QSettings().setValue("prepareDialog/compression", "pca basis=-27 resolution=rubbish");
        QSettings().setValue("prepareDialog/normalisation", 99);
        const PrepareDialog dialog;
        QCOMPARE(textOf(dialog, "pca-basis"), QString("20"));
        QCOMPARE(textOf(dialog, "pca-resolution"), QString("10,000"));
    }

    void everyControlHasAName()
    {
        PrepareDialog dialog;
        const QStringList unnamed = tests::unnamedWidgets(dialog);
        QVERIFY2(unnamed.isEmpty(), qPrintable(unnamed.join(", ")));
    }
};

SANDREEL_TEST(TestPrepareDialog)
#include "tst_preparedialog.moc"
