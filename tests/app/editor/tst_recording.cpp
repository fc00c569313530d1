// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/start/samples.h"
#include "model/animation/hausdorff.h"
#include "model/io/animfile.h"
#include "tests/app/editor/raiseground.h"
#include "tests/app/editor/windowdriver.h"
#include "tests/support/testmain.h"

#include <QDialog>
#include <QSettings>

using editor::ActionId;

/// What happens to a terrain becomes an animation like any other.
class TestRecording final : public QObject
{
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> mFolder;
    std::unique_ptr<tests::WindowDriver> mDriver;

    editor::Workspace &workspace() { return mDriver->window.workspace(); }
    /// Raises the ground and waits until a frame of that is taken: a beat is 40 ms.
    void raise(double height)
    {
        mDriver->terrain().context()->push<tests::RaiseGround>(height);
        QTest::qWait(120);
    }

private slots:
    void init()
    {
        QSettings().clear();
        mFolder = std::make_unique<QTemporaryDir>();
        mDriver = std::make_unique<tests::WindowDriver>();
        QString sample;
        for (const editor::Sample &one : editor::samples())
            if (one.path.endsWith(".terrain"))
                sample = one.path;
        mDriver->window.open({sample});
        QVERIFY(mDriver->settle());
        QVERIFY(workspace().currentTerrain());
    }
    void cleanup()
    {
        mDriver.reset();
        mFolder.reset();
    }

    void recordingOpensAsAnAnimationThatCanBeSaved()
    {
        QAction &record = mDriver->action(ActionId::Record);
        QVERIFY(record.isEnabled() && !record.isChecked());
        record.trigger();
        QVERIFY(record.isChecked());
        QVERIFY(workspace().messages().texts().constLast().contains("frames"));
        raise(0.1);
        raise(0.2);
        editor::OpenTerrain &terrain = mDriver->terrain();
        record.trigger();
        QVERIFY(workspace().currentAnimation());
        editor::OpenAnimation &document = mDriver->document();
        QVERIFY(document.isOpen() && document.isModified() && document.path().isEmpty());
        QVERIFY(!document.title().isEmpty() && document.title() != terrain.title());
        const auto frames = document.context()->document().frames();
        QCOMPARE(frames->frameCount(), 3u);
        QVERIFY(!record.isChecked());
        // Through a codec, like any other.
        const QString path = mFolder->filePath("recorded.anim");
        document.save(path);
        QVERIFY(mDriver->settle());
        QVERIFY(!document.isModified() && document.path() == path);
        const auto read = model::io::openAnim(path, model::Progress());
        QVERIFY(read);
        QCOMPARE((*read)->frameCount(), 3u);
        QCOMPARE((*read)->vertexCount(), frames->vertexCount());
        const auto lost = model::hausdorffDistance(*frames, **read); // the codec has an order of its own
        QVERIFY(lost);
        const double size = double(model::boundingBox(frames->frame(0)).diagonal());
        QVERIFY2(lost->distance < 0.01 * size, qPrintable(QString::number(lost->distance)));
    }

    void nothingIsOpenedWhereNothingHappened()
    {
        QAction &record = mDriver->action(ActionId::Record);
        record.trigger();
        record.trigger();
        QVERIFY(workspace().currentTerrain());
        QCOMPARE(workspace().tabs().size(), std::size_t(1));
        QVERIFY(workspace().messages().texts().constLast().contains("Nothing happened"));
    }

    void closingTheTerrainKeepsTheRecording()
    {
        mDriver->action(ActionId::Record).trigger();
        raise(0.1);
        tests::withNextDialog([](QDialog &dialog) { tests::clickButton(dialog, "Discard"); });
        mDriver->action(ActionId::CloseTab).trigger();
        QTRY_VERIFY(workspace().currentAnimation());
        QCOMPARE(mDriver->document().context()->document().frameCount(), 2u);
        QTRY_COMPARE(workspace().tabs().size(), std::size_t(1));
        mDriver->document().abandon();
    }

    void windowThatGoesForgetsIt()
    {
        mDriver->action(ActionId::Record).trigger();
        raise(0.1);
        mDriver.reset(); // no tab is made while the window is being taken apart
        QVERIFY(!mDriver);
    }
};

SANDREEL_TEST(TestRecording)
#include "tst_recording.moc"
