// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/recovery/recoverydialog.h"
#include "model/io/terrain/newterrain.h"
#include "tests/app/editor/windowdriver.h"
#include "tests/support/testmain.h"
#include "views/terrain/terrainviewport.h"

#include <QListWidget>
#include <QProcess>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QStandardPaths>

#include <cstdio>

using editor::ActionId;
using model::terrain::Point2;

namespace {

constexpr auto ChildVariable = "SANDREEL_TEST_STORY";
/// Where each step is kept as a picture, to be looked at.
constexpr auto PicturesVariable = "SANDREEL_STORY_PICTURES";

/// The reference's arrow: a trace, and its head in two strokes.
const std::vector<std::vector<Point2>> Arrow{
    {{5, 7}, {8, 8.5}, {11, 10}, {14, 11.5}},
    {{11.5, 12.6}, {13, 12.2}, {14.5, 11.75}},
    {{13.2, 8.6}, {14, 10}, {14.7, 11.4}},
};

} // namespace

/// From the first stroke to the day after the crash, as a person would live it.
class TestStory final : public QObject
{
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> mFolder;

    static QString makeFile(const QString &folder)
    {
        model::io::NewTerrain description;
        description.width = description.depth = 20;
        description.spacing = 0.5;
        description.relief = {model::io::ReliefShape::Dunes, 0.6, 9, 3};
        description.layers = {{model::terrain::material(model::terrain::MaterialPreset::DrySand), 2}};
        const auto terrain = model::io::makeTerrain(description);
        const QString path = folder + QStringLiteral("/arrow.terrain");
        if (!terrain || !model::io::saveTerrain(path, *terrain, {}))
            QTest::qFail("the test file cannot be made", __FILE__, __LINE__);
        return path;
    }
    static views::TerrainViewport &viewport(tests::WindowDriver &driver)
    {
        return *driver.window.workspace().currentTerrain()->viewport();
    }
    static QPoint seen(tests::WindowDriver &driver, Point2 p)
    {
        const double z = driver.terrain().terrain().tin().heightAt(p);
        return viewport(driver).placeOf({p.x, p.y, z}).value_or(QPointF()).toPoint();
    }
    static void open(tests::WindowDriver &driver, const QString &path)
    {
        driver.window.open({path});
        QVERIFY(driver.settle());
        QTRY_VERIFY_WITH_TIMEOUT(!viewport(driver).isLoading(), 60000);
    }
    static void press(tests::WindowDriver &driver, const std::vector<Point2> &path)
    {
        QTest::mouseMove(&viewport(driver), seen(driver, path.front()));
        QTest::mousePress(&viewport(driver), Qt::LeftButton, {}, seen(driver, path.front()));
        for (std::size_t i = 1; i < path.size(); ++i)
            for (int step = 1; step <= 4; ++step) {
                const double t = step / 4.0;
                const Point2 &a = path[i - 1], &b = path[i];
                QTest::mouseMove(&viewport(driver), seen(driver, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}));
            }
    }
    static void draw(tests::WindowDriver &driver, const std::vector<Point2> &path)
    {
        press(driver, path);
        QTest::mouseRelease(&viewport(driver), Qt::LeftButton, {}, seen(driver, path.back()));
        // What it set in motion comes to rest.
        QTRY_VERIFY_WITH_TIMEOUT(!driver.terrain().context()->hasGesture(), 120'000);
    }
    static void keep(tests::WindowDriver &driver, const QString &name)
    {
        if (!qEnvironmentVariableIsSet(PicturesVariable))
            return;
        QTRY_VERIFY_WITH_TIMEOUT(!viewport(driver).isLoading(), 60000);
        QTest::qWait(400);
        const QString file = qEnvironmentVariable(PicturesVariable) + QLatin1Char('/') + name + QStringLiteral(".png");
        QVERIFY(driver.window.screen()->grabWindow(driver.window.winId()).save(file));
    }
    static std::uint64_t printOf(tests::WindowDriver &driver) { return driver.terrain().terrain().tin().fingerprint(); }

private slots:
    void init()
    {
        QSettings().clear();
        if (!qEnvironmentVariableIsSet(ChildVariable))
            QDir(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation)).removeRecursively();
        mFolder = std::make_unique<QTemporaryDir>();
    }

    /// Not a test but the program that is killed: a stroke that never ends.
    void child()
    {
        if (!qEnvironmentVariableIsSet(ChildVariable))
            return;
        tests::WindowDriver driver;
        open(driver, qEnvironmentVariable(ChildVariable));
        const model::TerrainDocument &document = driver.terrain().terrain();
        connect(&document, &model::TerrainDocument::changed, &driver.window, [&document] {
            std::printf("drawn %llu\n", static_cast<unsigned long long>(document.fingerprint()));
            std::fflush(stdout);
        });
        press(driver, {{4, 14}, {7, 15}});
        for (int round = 0;; ++round) {
            QTest::mouseMove(&viewport(driver), seen(driver, {7 + 0.25 * (round % 24), 15 - 0.1 * (round % 30)}));
            QTest::qWait(5);
            if (round == 12) {
                driver.terrain().record().waitUntilWritten();
                std::printf("written\n");
                std::fflush(stdout);
            }
        }
    }

    void arrowIsDrawnUndoneRedoneSavedAndOutlivesACrash()
    {
        const QString path = makeFile(mFolder->path());
        std::uint64_t saved = 0;
        {
            tests::WindowDriver driver;
            driver.window.resize(1280, 800);
            open(driver, path);
            keep(driver, "1-opened");
            std::vector<std::uint64_t> prints{printOf(driver)};
            for (const std::vector<Point2> &stroke : Arrow) {
                draw(driver, stroke);
                prints.push_back(printOf(driver));
                QVERIFY(prints.back() != prints[prints.size() - 2]);
            }
            QCOMPARE(driver.terrain().context()->undoStack().count(), int(Arrow.size()));
            keep(driver, "2-arrow");
            for (std::size_t step = Arrow.size(); step-- > 0;) {
                driver.action(ActionId::Undo).trigger();
                QCOMPARE(printOf(driver), prints[step]);
            }
            QVERIFY(!driver.action(ActionId::Undo).isEnabled());
            keep(driver, "3-undone");
            for (std::size_t step = 1; step <= Arrow.size(); ++step) {
                driver.action(ActionId::Redo).trigger();
                QCOMPARE(printOf(driver), prints[step]);
            }
            keep(driver, "4-redone");
            driver.action(ActionId::Save).trigger();
            QVERIFY(driver.settle());
            QVERIFY(!driver.terrain().isModified());
            saved = driver.terrain().terrain().fingerprint();
            driver.window.close();
        }
        QVERIFY(editor::RecoveryEntry::leftovers().empty());

        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(ChildVariable, path);
        process.setProcessEnvironment(environment);
        process.start(QCoreApplication::applicationFilePath(), {"tst_story", "child"});
        QByteArray said;
        QTRY_VERIFY_WITH_TIMEOUT((said += process.readAllStandardOutput()).contains("written\n"), 120000);
        QTest::qWait(200);
        process.kill(); // in mid-stroke
        QVERIFY(process.waitForFinished());
        said += process.readAllStandardOutput();
        QStringList drawn;
        qsizetype written = -1;
        for (const QByteArray &line : said.split('\n')) {
            if (line.startsWith("drawn "))
                drawn << QString::fromLatin1(line.mid(6));
            else if (line == "written")
                written = drawn.size() - 1;
        }
        QVERIFY(written > 0);

        tests::WindowDriver driver;
        driver.window.resize(1280, 800);
        driver.window.offerRecovery();
        auto *dialog = driver.window.findChild<editor::RecoveryDialog *>();
        QVERIFY(dialog && dialog->isVisible());
        QCOMPARE(dialog->findChild<QListWidget *>("leftovers")->count(), 1);
        if (qEnvironmentVariableIsSet(PicturesVariable)) {
            QTest::qWait(1000);
            QVERIFY(
                driver.window.screen()->grabWindow(0).save(qEnvironmentVariable(PicturesVariable) + "/5-offered.png"));
        }
        QTest::mouseClick(dialog->findChild<QPushButton *>("recover"), Qt::LeftButton);
        QTRY_VERIFY(driver.window.workspace().currentTerrain());
        QVERIFY(driver.settle());
        // A moment of the stroke, not before what was in the journal.
        const std::uint64_t recovered = driver.terrain().terrain().fingerprint();
        QVERIFY2(drawn.lastIndexOf(QString::number(recovered)) >= written, qPrintable(said));
        QVERIFY(recovered != saved);
        keep(driver, "6-recovered");
        // And the file is as it was saved.
        const auto file = model::io::openTerrain(path);
        QVERIFY(file);
        QCOMPARE(model::savedFingerprint(file->terrain), saved);
    }
};

SANDREEL_TEST(TestStory)
#include "tst_story.moc"
