// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/start/samples.h"
#include "commands/animation/renameanimation.h"
#include "model/io/animfile.h"
#include "tests/app/editor/windowdriver.h"
#include "tests/support/testmain.h"
#include "views/dialogs/preparedialog.h"
#include "views/docks/timelinedock.h"
#include "views/viewport/animationviewport.h"
#include "views/viewport/noglview.h"

#include <QAbstractButton>
#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QSettings>
#include <QStatusBar>
#include <QTabBar>
#include <QTabWidget>
#include <QToolButton>
#include <QUndoView>
#include <QtEvents>

using editor::ActionId;

class TestMainWindow final : public QObject
{
    Q_OBJECT

    static void drop(QWidget &window, const QStringList &paths)
    {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString &path : paths)
            urls << QUrl::fromLocalFile(path);
        data.setUrls(urls);
        QDragEnterEvent enter({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&window, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&window, &event);
    }

private slots:
    void init()
    {
        QSettings().clear();
        mFolder = std::make_unique<QTemporaryDir>();
    }

    void sampleOpensAndIsDrawn()
    {
        tests::WindowDriver driver;
        const auto samples = editor::samples();
        QVERIFY(!samples.empty());
        QVERIFY(driver.open(samples.front().path));
        QVERIFY(driver.document().path().isEmpty());
        QVERIFY(driver.window.workspace().currentAnimation()->viewport());
        QTRY_VERIFY(driver.document().player().currentFrame());
        QVERIFY(driver.window.statusBar()->findChild<QLabel *>("statusNumbers")->text().contains("fps"));
        QVERIFY(!driver.action(ActionId::Undo).isEnabled());
        QVERIFY(driver.action(ActionId::Trim).isEnabled());
    }

    void withoutADocumentNothingCanBeEdited()
    {
        tests::WindowDriver driver;
        for (const ActionId id : {ActionId::Save, ActionId::SaveAs, ActionId::Undo, ActionId::Trim, ActionId::Reverse,
                                  ActionId::Rename, ActionId::ExportFrames, ActionId::Shaded, ActionId::CloseTab})
            QVERIFY2(!driver.action(id).isEnabled(), qPrintable(driver.action(id).text()));
        for (const ActionId id : {ActionId::Open, ActionId::Prepare, ActionId::Quit, ActionId::About})
            QVERIFY2(driver.action(id).isEnabled(), qPrintable(driver.action(id).text()));
    }

    void droppedFileOpensInATab()
    {
        tests::WindowDriver driver;
        drop(driver.window, {tests::makeAnim(*mFolder, "a.anim"), tests::makeAnim(*mFolder, "b.anim")});
        QTRY_COMPARE(driver.window.workspace().tabs().size(), std::size_t(2));
        QVERIFY(driver.settle());
        QCOMPARE(driver.document().title(), QString("b"));
        driver.action(ActionId::NextTab).trigger();
        QCOMPARE(driver.document().title(), QString("a"));
    }

    void openingAgainShowsTheTab()
    {
        tests::WindowDriver driver;
        const QString path = tests::makeAnim(*mFolder);
        QVERIFY(driver.open(path));
        QVERIFY(driver.open(tests::makeAnim(*mFolder, "other.anim")));
        QVERIFY(driver.open(path));
        QCOMPARE(driver.window.workspace().tabs().size(), std::size_t(2));
        QCOMPARE(driver.document().path(), path);
    }

    void droppedFolderOffersToPrepare()
    {
        tests::WindowDriver driver;
        drop(driver.window, {mFolder->path()});
        views::PrepareDialog *dialog = nullptr;
        QTRY_VERIFY((dialog = driver.window.findChild<views::PrepareDialog *>()) && dialog->isVisible());
    }

    void whatCannotBeOpenedIsSaid_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("damaged") << "bad.anim" << QByteArray("this is no animation");
        QTest::newRow("empty") << "empty.anim" << QByteArray();
        QTest::newRow("unknown") << "notes.odt" << QByteArray("hello");
        QTest::newRow("missing") << "gone.anim" << QByteArray("-");
    }
    void whatCannotBeOpenedIsSaid()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        tests::WindowDriver driver;
        const QString path = mFolder->filePath(name);
        if (bytes != "-") {
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(bytes);
        }
        driver.window.open({path});
        QVERIFY(driver.settle());
        QTRY_COMPARE(driver.window.workspace().messages().texts().size(), 1);
        QVERIFY(driver.window.workspace().messages().texts().constFirst().contains(QFileInfo(name).completeBaseName()));
        QVERIFY(driver.window.workspace().tabs().empty());
        QCOMPARE(int(driver.window.log().level(driver.window.log().rowCount() - 1)), int(views::LogLevel::Error));
    }

    void editsChangeTheDocumentAndAreNamed()
    {
        tests::WindowDriver driver;
        QVERIFY(driver.open(tests::makeAnim(*mFolder)));
        const model::AnimationDocument &document = driver.document().context()->document();
        const std::uint64_t before = document.fingerprint();
        driver.action(ActionId::Reverse).trigger();
        QVERIFY(document.fingerprint() != before);
        QVERIFY(driver.window.isWindowModified());
        QVERIFY2(driver.action(ActionId::Undo).text().contains("Reverse"),
                 qPrintable(driver.action(ActionId::Undo).text()));
        QCOMPARE(driver.window.findChild<QUndoView *>("historySteps")->model()->rowCount(), 2);
        driver.action(ActionId::Undo).trigger();
        QCOMPARE(document.fingerprint(), before);
        QVERIFY(!driver.window.isWindowModified());
        QVERIFY(driver.action(ActionId::Redo).text().contains("Reverse"));
        driver.action(ActionId::Redo).trigger();
        QVERIFY(document.fingerprint() != before);
    }

    void trimmingByItsDialogKeepsTheRange()
    {
        tests::WindowDriver driver;
        QVERIFY(driver.open(tests::makeAnim(*mFolder)));
        driver.document().player().setRange(2, 5);
        tests::withNextDialog([](QDialog &dialog) { tests::clickButton(dialog, "Trim"); });
        driver.action(ActionId::Trim).trigger();
        QTRY_COMPARE(driver.document().context()->document().frameCount(), 4u);
        QCOMPARE(driver.document().player().source()->frameCount(), 4u);
    }

    void savingAndOpeningAgainGivesTheSame()
    {
        const QString path = tests::makeAnim(*mFolder);
        model::Timing timing{model::TimeMap::identity(1), 1};
        std::string name;
        {
            tests::WindowDriver driver;
            QVERIFY(driver.open(path));
            driver.document().context()->push<commands::RenameAnimation>(std::string("Vlna"));
            driver.action(ActionId::Reverse).trigger();
            QVERIFY(driver.action(ActionId::Save).isEnabled());
            driver.action(ActionId::Save).trigger();
            QVERIFY(driver.settle());
            QVERIFY(!driver.document().isModified());
            QVERIFY(driver.document().context()->undoStack().isClean());
            QVERIFY(!driver.action(ActionId::Save).isEnabled());
        }
        tests::WindowDriver driver;
        QVERIFY(driver.open(path));
        const auto &frames = *driver.document().context()->document().frames();
        QCOMPARE(QString::fromStdString(frames.name()), QString("Vlna"));
        QCOMPARE(frames.frameCount(), 12u);
        // Saved unchanged under another name, it is the same animation.
        const std::uint64_t fingerprint = driver.document().context()->document().fingerprint();
        const QString copy = mFolder->filePath("copy.anim");
        driver.document().save(copy);
        QVERIFY(driver.settle());
        tests::WindowDriver again;
        QVERIFY(again.open(copy));
        QCOMPARE(again.document().context()->document().fingerprint(), fingerprint);
    }

    void editsWhileSavingStayUnsaved()
    {
        tests::WindowDriver driver;
        QVERIFY(driver.open(tests::makeAnim(*mFolder)));
        driver.action(ActionId::Reverse).trigger();
        driver.action(ActionId::Save).trigger();
        QVERIFY(driver.document().isSaving());
        driver.document().context()->push<commands::RenameAnimation>(std::string("later"));
        QVERIFY(driver.settle());
        QVERIFY(driver.document().isModified());
        driver.action(ActionId::Undo).trigger(); // back to what was saved
        QVERIFY(!driver.document().isModified());
    }

    void closingAsksAboutUnsavedChanges()
    {
        tests::WindowDriver driver;
        const QString path = tests::makeAnim(*mFolder);
        QVERIFY(driver.open(path));
        driver.action(ActionId::Reverse).trigger();

        tests::withNextDialog([](QDialog &dialog) { tests::clickButton(dialog, "Cancel"); });
        driver.action(ActionId::CloseTab).trigger();
        QCOMPARE(driver.window.workspace().tabs().size(), std::size_t(1));

        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray before = file.readAll();
        tests::withNextDialog([](QDialog &dialog) { tests::clickButton(dialog, "Save"); });
        driver.action(ActionId::CloseTab).trigger();
        QTRY_VERIFY(driver.window.workspace().tabs().empty());
        file.seek(0);
        QFile saved(path);
        QVERIFY(saved.open(QIODevice::ReadOnly));
        QVERIFY(saved.readAll() != before);
    }

    void quittingAsksOnceAboutSeveral()
    {
        tests::WindowDriver driver;
        for (const char *name : {"a.anim", "b.anim"}) {
            QVERIFY(driver.open(tests::makeAnim(*mFolder, name)));
            driver.action(ActionId::Reverse).trigger();
        }
        tests::withNextDialog([](QDialog &dialog) { tests::clickButton(dialog, "Cancel"); });
        QVERIFY(!driver.window.close());
        QVERIFY(driver.window.isVisible());
        tests::withNextDialog([](QDialog &dialog) { tests::clickButton(dialog, "Save All"); });
        driver.window.close();
        QTRY_VERIFY_WITH_TIMEOUT(!driver.window.isVisible(), 20000);
        for (editor::DocumentTab *tab : driver.window.workspace().tabs())
            QVERIFY(!tab->document().isModified());
    }

    void aFileThatAnotherProgramChangedIsNotOverwrittenUnasked()
    {
        tests::WindowDriver driver;
        const QString path = tests::makeAnim(*mFolder);
        QVERIFY(driver.open(path));
        driver.action(ActionId::Reverse).trigger();
        {
            QFile file(path);
            QVERIFY(file.open(QIODevice::Append));
            file.write("somebody else");
        }
        const qint64 size = QFileInfo(path).size();
        bool asked = false;
        tests::withNextDialog([&asked](QDialog &dialog) {
            asked = true;
            tests::clickButton(dialog, "Cancel");
        });
        driver.action(ActionId::Save).trigger();
        QVERIFY(asked);
        QCOMPARE(QFileInfo(path).size(), size);
        QVERIFY(driver.document().isModified());
        tests::withNextDialog([](QDialog &dialog) { tests::clickButton(dialog, "Replace"); });
        driver.action(ActionId::Save).trigger();
        QVERIFY(driver.settle());
        QVERIFY(!driver.document().isModified());
    }

    void savingWhereNobodyMayKeepsTheDocumentModified()
    {
        tests::WindowDriver driver;
        QVERIFY(driver.open(tests::makeAnim(*mFolder)));
        driver.action(ActionId::Reverse).trigger();
        driver.document().save(mFolder->filePath("no/such/folder/x.anim"));
        QVERIFY(driver.settle());
        QVERIFY(driver.document().isModified());
        QCOMPARE(driver.window.workspace().messages().texts().size(), 1);
    }

    void reloadingKeepsTheFrame()
    {
        tests::WindowDriver driver;
        QVERIFY(driver.open(tests::makeAnim(*mFolder)));
        driver.document().player().seek(7);
        driver.action(ActionId::Reload).trigger();
        QVERIFY(driver.settle());
        QCOMPARE(driver.document().player().playback().frame(), 7u);
        QVERIFY(!driver.action(ActionId::Undo).isEnabled());
        QVERIFY(driver.window.findChild<QUndoView *>("historySteps")->stack());
    }

    void cutFilesShowWhatIsThere()
    {
        const QString path = tests::makeAnim(*mFolder, "cut.anim", {model::ReelSettings{0.001, 0}});
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadWrite));
        const QByteArray whole = file.readAll();
        QVERIFY(file.resize(whole.size() - 20));
        file.close();
        tests::WindowDriver driver;
        QVERIFY(driver.open(path));
        editor::OpenAnimation &document = driver.document();
        QVERIFY(document.cut() && document.cut()->details < document.cut()->detailsInFile);
        QCOMPARE(document.title(), QStringLiteral("cut (cut)"));
        QVERIFY(document.path().isEmpty() && !document.isModified());
        const QStringList messages = driver.window.workspace().messages().texts();
        QCOMPARE(messages.size(), 1);
        QVERIFY2(
            messages[0].contains(
                QStringLiteral("%1 of its %2 details").arg(document.cut()->details).arg(document.cut()->detailsInFile)),
            qPrintable(messages[0]));
        // Saved as what is seen, elsewhere; then it is a file like any other.
        const model::FrameSourcePtr shown = document.context()->document().frames();
        const auto frame = shown->frame(3);
        QVERIFY(driver.action(ActionId::Save).isEnabled());
        document.save(mFolder->filePath("saved.anim"));
        QVERIFY(driver.settle());
        QVERIFY(!document.cut());
        QCOMPARE(document.title(), QStringLiteral("saved"));
        const auto saved = model::io::openAnim(mFolder->filePath("saved.anim"));
        QVERIFY(saved.has_value());
        QVERIFY((*saved)->frame(3) == frame);
        QCOMPARE(QFileInfo(path).size(), whole.size() - 20);
        // The rest has come meanwhile.
        QVERIFY(driver.open(path));
        QVERIFY(driver.document().cut().has_value());
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(whole), whole.size());
        file.close();
        driver.action(ActionId::Reload).trigger();
        QVERIFY(driver.settle());
        QVERIFY(!driver.document().cut());
        QCOMPARE(driver.document().path(), path);
    }

    void recentFilesAreOfferedAndMissingOnesSurvived()
    {
        tests::WindowDriver driver;
        const QString path = tests::makeAnim(*mFolder);
        QVERIFY(driver.open(path));
        editor::Settings settings;
        QCOMPARE(settings.recentFiles(), QStringList{path});
        driver.action(ActionId::CloseTab).trigger();
        QVERIFY(QFile::remove(path));
        driver.window.open({path});
        QCOMPARE(driver.window.workspace().messages().texts().size(), 1);
        QVERIFY(settings.recentFiles().isEmpty());
    }

    void tabsCloseByMiddleClick()
    {
        tests::WindowDriver driver;
        QVERIFY(driver.open(tests::makeAnim(*mFolder)));
        auto *bar = driver.window.findChild<QTabWidget *>("documentTabs")->tabBar();
        QTest::mouseClick(bar, Qt::MiddleButton, Qt::NoModifier, bar->tabRect(0).center());
        QTRY_VERIFY(driver.window.workspace().tabs().empty());
    }

    void withoutOpenGlThereIsAMessage()
    {
        const QString path = tests::makeAnim(*mFolder);
        editor::AnimationTab tab(false);
        tab.document().open(path);
        QTRY_VERIFY(tab.document().isOpen());
        QVERIFY(!tab.viewport());
        const auto *page = tab.findChild<views::NoGlView *>();
        QVERIFY(page && page->isVisibleTo(&tab));
        QVERIFY(page->message().contains("OpenGL 3.3"));
        QCOMPARE(tab.errorColoring(), page);
    }

    void languageChangesWhileTheWindowIsOpen()
    {
        tests::WindowDriver driver;
        QVERIFY(driver.open(tests::makeAnim(*mFolder)));
        driver.language.apply("cs");
        QTRY_COMPARE(editor::plainTitle(driver.action(ActionId::Open).text()), QString("Otevřít"));
        driver.language.apply("en");
        QTRY_COMPARE(editor::plainTitle(driver.action(ActionId::Open).text()), QString("Open"));
    }

    void timelineIsNoTallerThanWhatItHolds()
    {
        tests::WindowDriver driver;
        QVERIFY(driver.open(tests::makeAnim(*mFolder)));
        auto *dock = driver.window.findChild<views::TimelineDock *>();
        const auto spare = [dock] { return dock->widget()->height() - dock->widget()->sizeHint().height(); };
        QTRY_COMPARE(spare(), 0);
        const int withoutPlot = dock->height();
        driver.window.resizeDocks({dock}, {400}, Qt::Vertical); // as by dragging its border
        QTRY_COMPARE(spare(), 0);
        views::Comparison &comparison = driver.document().comparison();
        comparison.start("itself",
                         [frames = driver.document().context()->document().frames()](
                             const model::Progress &) -> model::Result<views::Original> {
                             return views::Original{frames, {}};
                         });
        QTRY_VERIFY(dock->height() > withoutPlot + 40); // there is a plot
        QTRY_COMPARE(spare(), 0);
        comparison.stop();
        QTRY_COMPARE(dock->height(), withoutPlot);
        driver.window.resize(700, 750); // the controls wrap
        QTRY_VERIFY(dock->height() > withoutPlot);
        QTRY_COMPARE(spare(), 0);
    }

    void nothingIsClipped_data()
    {
        QTest::addColumn<QString>("language");
        QTest::newRow("English") << "en";
        QTest::newRow("Czech") << "cs";
    }
    void nothingIsClipped()
    {
        QFETCH(QString, language);
        tests::WindowDriver driver;
        QVERIFY(driver.open(tests::makeAnim(*mFolder)));
        driver.language.apply(language);
        QStringList clipped;
        const auto findClipped = [&] {
            clipped.clear();
            for (const QWidget *widget : driver.window.findChildren<QWidget *>()) {
                if (!widget->isVisible())
                    continue;
                const auto *label = qobject_cast<const QLabel *>(widget);
                const auto *button = qobject_cast<const QAbstractButton *>(widget);
                const bool hasText =
                    (label && !label->wordWrap() && !label->text().isEmpty()) || (button && !button->text().isEmpty());
                if (!hasText && !qobject_cast<const QComboBox *>(widget))
                    continue;
                if (widget->width() < widget->minimumSizeHint().width())
                    clipped << QString("%1 '%2' %3 < %4")
                                   .arg(widget->metaObject()->className(), label    ? label->text()
                                                                           : button ? button->text()
                                                                                    : "")
                                   .arg(widget->width())
                                   .arg(widget->minimumSizeHint().width());
            }
            return clipped.isEmpty();
        };
        // Layouts follow a change of texts at the next turns of the event loop.
        const bool fits = QTest::qWaitFor(findClipped, 3000);
        QVERIFY2(fits, qPrintable(clipped.join('\n')));
    }

    void everyFocusableWidgetHasAName()
    {
        tests::WindowDriver driver;
        QVERIFY(driver.open(tests::makeAnim(*mFolder)));
        QStringList nameless;
        for (QWidget *widget : driver.window.findChildren<QWidget *>()) {
            if (!widget->isVisible() || !(widget->focusPolicy() & Qt::TabFocus) || widget->focusProxy())
                continue;
            // Qt keeps one, of no size, for docks that lie on one another while all of them are hidden.
            if (const auto *bar = qobject_cast<QTabBar *>(widget); bar && bar->count() == 0)
                continue;
            QAccessibleInterface *interface = QAccessible::queryAccessibleInterface(widget);
            if (!interface || interface->text(QAccessible::Name).isEmpty())
                nameless << QString("%1 %2").arg(widget->metaObject()->className(), widget->objectName());
        }
        QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join('\n')));
    }

private:
    std::unique_ptr<QTemporaryDir> mFolder;
};

SANDREEL_TEST(TestMainWindow)
#include "tst_mainwindow.moc"
