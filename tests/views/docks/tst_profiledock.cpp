// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/commands/terrain/sandbox.h"
#include "tests/support/testmain.h"
#include "views/dialogs/measuretext.h"
#include "views/dialogs/quantitytext.h"
#include "views/docks/terrain/profilecsv.h"
#include "views/docks/terrain/profiledock.h"
#include "views/docks/terrain/profileplot.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QMainWindow>
#include <QPushButton>
#include <QToolButton>
#include <QTranslator>

using namespace model::terrain;
using namespace views;

namespace {

struct Editor
{
    model::TerrainDocument document{tests::sandbox()};
    commands::TerrainContext context{document};
    GroundReference reference{document};
    ProfileLine line{nullptr};
    QAction pick;
    QMainWindow window;
    ProfileDock *dock = nullptr;

    Editor()
    {
        pick.setCheckable(true);
        dock = new ProfileDock(pick, &window);
        window.addDockWidget(Qt::BottomDockWidgetArea, dock);
        dock->setTerrain(&document, &line, &reference);
        window.resize(900, 320);
        window.show();
    }
    ~Editor() { dock->setTerrain(nullptr, nullptr, nullptr); }

    QString reading() const { return dock->findChild<QLabel *>(QStringLiteral("profileReading"))->text(); }
    void click(const char *name)
    {
        auto *button = dock->findChild<QPushButton *>(QLatin1String(name));
        QVERIFY(button && button->isEnabled());
        QTest::mouseClick(button, Qt::LeftButton);
    }
    void raise(double height)
    {
        context.push<commands::EditSurface>(QStringLiteral("Raise"), [height](TinEdit &edit) {
            for (VertexId v = 4; v < edit.tin().vertexCount(); ++v)
                edit.setHeight(v, edit.tin().arrays().heights[v] + height);
        });
    }
};

} // namespace

class TestProfileDock final : public QObject
{
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale("en_US")); }

    void theCurveFollowsTheLineAndTheTerrain()
    {
        Editor editor;
        ProfilePlot &plot = editor.dock->plot();
        QVERIFY(plot.now().empty());
        QVERIFY(!editor.dock->findChild<QPushButton *>("copyTable")->isEnabled());
        QTRY_VERIFY(editor.reference.terrain());
        editor.line.setEnds(ProfileLine::Ends{{0.2, 0.3}, {0.8, 0.6}});
        QVERIFY(plot.now().size() > 10);
        const double length = std::hypot(0.6, 0.3);
        QVERIFY2(editor.reading().contains(lengthText(length)), qPrintable(editor.reading()));
        const auto before = heightAt(plot.now(), length / 2);
        QVERIFY(before && heightAt(plot.before(), length / 2) == before);

        editor.raise(0.25);
        QTRY_VERIFY(std::abs(*heightAt(plot.now(), length / 2) - *before - 0.25) < 1e-9);
        QCOMPARE(heightAt(plot.before(), length / 2), before); // the reference stays
        plot.setCursor(length / 2);
        QVERIFY2(editor.reading().contains("+0.25"), qPrintable(editor.reading()));
        editor.click("clearProfile");
        QVERIFY(plot.now().empty() && !editor.line.ends());
    }
    void mouseAndKeysReadTheCurve()
    {
        Editor editor;
        editor.line.setEnds(ProfileLine::Ends{{0.1, 0.5}, {0.9, 0.5}});
        ProfilePlot &plot = editor.dock->plot();
        QVERIFY(!plot.cursor());
        const QPointF there = plot.placeOf(0.2, 1);
        QTest::mouseMove(&plot, QPoint(2, 2));
        QTest::mouseMove(&plot, there.toPoint());
        QTRY_VERIFY(plot.cursor() && std::abs(*plot.cursor() - 0.2) < 0.005);
        QVERIFY(!editor.line.lines().empty());
        plot.setFocus();
        QTest::keyClick(&plot, Qt::Key_Home);
        QCOMPARE(plot.cursor(), std::optional(0.0));
        QTest::keyClick(&plot, Qt::Key_Left);
        QCOMPARE(plot.cursor(), std::optional(0.0));
        QTest::keyClick(&plot, Qt::Key_Right);
        const double step = *plot.cursor();
        QVERIFY(step > 0);
        QTest::keyClick(&plot, Qt::Key_Right, Qt::ShiftModifier);
        QVERIFY(*plot.cursor() > 5 * step);
        QTest::keyClick(&plot, Qt::Key_End);
        QVERIFY(std::abs(*plot.cursor() - 0.8) < 1e-12);
        QCOMPARE(plot.accessibleDescription(), editor.reading()); // what a screen reader says
        QVERIFY(editor.reading().contains("height"));
    }
    void theTableIsForSpreadsheets()
    {
        Editor editor;
        QLocale::setDefault(QLocale("cs_CZ")); // a comma is no decimal point in it
        QTRY_VERIFY(editor.reference.terrain());
        editor.line.setEnds(ProfileLine::Ends{{0.1, 0.5}, {0.9, 0.5}});
        editor.click("copyTable");
        const QStringList lines = QGuiApplication::clipboard()->text().trimmed().split('\n');
        QCOMPARE(lines[0], QStringLiteral("distance_m,height_m,reference_m"));
        QCOMPARE(std::size_t(lines.size()), editor.dock->plot().now().size() + 1);
        for (int i = 1; i < lines.size(); ++i) {
            const QStringList cells = lines[i].split(',');
            QCOMPARE(cells.size(), 3);
            const double distance = cells[0].toDouble();
            QVERIFY(std::abs(cells[1].toDouble() - editor.document.tin().heightAt({0.1 + distance, 0.5})) < 1e-9);
            QCOMPARE(cells[2], cells[1]);
        }
    }
    void aVoidHasNoHeightInTheTable()
    {
        const std::vector<ProfilePoint> now{{0, 1, false}, {1, 2, true}, {3, 4, false}, {4, 4.5, false}};
        const std::vector<ProfilePoint> before{{0, 0, false}, {4, 4, false}};
        QCOMPARE(profileCsv(now, {}), QStringLiteral("distance_m,height_m\n0,1\n1,\n3,4\n4,4.5\n"));
        QCOMPARE(profileCsv(now, before), QStringLiteral("distance_m,height_m,reference_m\n0,1,0\n1,,1\n3,4,3\n"
                                                         "4,4.5,4\n"));
    }
    void thePictureShowsTheCurve()
    {
        Editor editor;
        QTRY_VERIFY(editor.reference.terrain());
        editor.line.setEnds(ProfileLine::Ends{{0.1, 0.5}, {0.9, 0.5}});
        editor.raise(0.1);
        QTRY_VERIFY(std::abs(editor.dock->plot().now()[3].height - editor.dock->plot().before()[3].height) > 0.05);
        editor.click("copyPicture");
        const QImage picture = QGuiApplication::clipboard()->image();
        QCOMPARE(picture.size(), editor.dock->plot().size());
        QSet<QRgb> colors;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                colors.insert(picture.pixel(x, y));
        QVERIFY(colors.size() > 20);
        // The curve passes where it says.
        const QPoint there = editor.dock->plot().placeOf(0.4, *heightAt(editor.dock->plot().now(), 0.4)).toPoint();
        const QPoint sky = editor.dock->plot().placeOf(0.4, 1.24).toPoint();
        QVERIFY(picture.pixel(there) != picture.pixel(sky));
    }
    void scalesFromMillimetresToKilometres()
    {
        QCOMPARE(lengthText(0.0125), QStringLiteral("12.5\u00a0mm"));
        QCOMPARE(lengthText(25), QStringLiteral("25\u00a0m"));
        QCOMPARE(lengthText(-0.5), QStringLiteral("-0.5\u00a0m"));
        QCOMPARE(lengthText(12345), QStringLiteral("12.35\u00a0km")); // four digits
        QCOMPARE(lengthText(0), QStringLiteral("0\u00a0m"));
        QCOMPARE(volumeText(0), QStringLiteral("0\u00a0m³"));
        QCOMPARE(volumeText(2.5), QStringLiteral("2.5\u00a0m³"));
        QCOMPARE(volumeText(0.0345), QStringLiteral("34.5\u00a0l"));
        QCOMPARE(volumeText(1.2e-5), QStringLiteral("12\u00a0cm³"));
        QCOMPARE(significantText(1.25e-9), QStringLiteral("1.25\u00a0×\u00a010⁻⁹"));
        QCOMPARE(significantText(-9.99996e-6), QStringLiteral("-1\u00a0×\u00a010⁻⁵"));
        QCOMPARE(significantText(1.5e12), QStringLiteral("1.5\u00a0×\u00a010¹²"));
        QLocale::setDefault(QLocale("cs_CZ"));
        QCOMPARE(significantText(1.25e-9), QStringLiteral("1,25\u00a0×\u00a010⁻⁹"));
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
        QTranslator translator;
        QVERIFY(translator.load(QStringLiteral(":/i18n/sandreel_%1.qm").arg(language)));
        QCoreApplication::installTranslator(&translator);
        QLocale::setDefault(QLocale(language));
        Editor editor;
        QTRY_VERIFY(editor.reference.terrain());
        editor.line.setEnds(ProfileLine::Ends{{0.05, 0.1}, {0.95, 0.7}});
        editor.raise(0.05);
        QTest::qWait(200);
        editor.dock->plot().setCursor(0.6);
        for (const auto *button : editor.dock->findChildren<QAbstractButton *>())
            if (button->isVisible() && !button->text().isEmpty())
                QVERIFY2(button->width() >= button->sizeHint().width(), qPrintable(button->text()));
        if (const QString folder = qEnvironmentVariable("SANDREEL_PICTURES"); !folder.isEmpty())
            editor.window.grab().save(QStringLiteral("%1/profiledock-%2.png").arg(folder, language));
    }
};

SANDREEL_TEST(TestProfileDock)
#include "tst_profiledock.moc"
