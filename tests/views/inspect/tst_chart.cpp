// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testmain.h"
#include "views/inspect/chart.h"
#include "views/inspect/chartwidget.h"

#include <QFile>
#include <QImage>
#include <QLocale>
#include <QPalette>
#include <QTemporaryDir>

using namespace views;

namespace {

Chart rates()
{
    Chart chart;
    chart.title = QStringLiteral("Křivka zkreslení");
    chart.x = {QStringLiteral("Bity na vrchol a snímek"), true};
    chart.y = {QStringLiteral("Chyba KG v %"), true};
    chart.shape = Chart::Shape::Points;
    chart.series = {{"PCA", {0.5, 1, 2, 4}, {8, 3, 1.2, 0.5}}, {"Reel", {0.3, 0.7, 1.5, 3}, {7, 2, 0.8, 0.2}}};
    return chart;
}

Chart valences()
{
    Chart chart;
    chart.title = QStringLiteral("Valence");
    chart.x.title = QStringLiteral("Edges");
    chart.y.title = QStringLiteral("Vertices");
    chart.shape = Chart::Shape::Bars;
    chart.series = {{QString(), {0, 1, 2}, {10, 40, 20}}};
    chart.categories = {"4", "5", "6"};
    return chart;
}

/// Pixels that are not the ground.
int ink(const QImage &image)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            count += image.pixel(x, y) != image.pixel(0, 0);
    return count;
}

} // namespace

class TestChart final : public QObject
{
    Q_OBJECT

private slots:
    void tablesHaveARowForEachPlace()
    {
        QCOMPARE(chartCsv(valences()), QString("Edges,Vertices\n4,10\n5,40\n6,20\n"));
        const QStringList lines = chartCsv(rates()).split('\n');
        QCOMPARE(lines[0], QString("Bity na vrchol a snímek,PCA,Reel"));
        QCOMPARE(lines[1], QString("0.3,,7"));
        QCOMPARE(lines.size(), 1 + 8 + 1);
    }

    void picturesGrowWithTheRatio()
    {
        const QTemporaryDir folder;
        for (const Chart &chart : {rates(), valences()}) {
            const QString once = folder.filePath("once.png"), twice = folder.filePath("twice.png");
            QVERIFY(saveChart(once, chart, QPalette(Qt::white), {500, 320}, 1));
            QVERIFY(saveChart(twice, chart, QPalette(Qt::white), {500, 320}, 2));
            const QImage small(once), large(twice);
            QCOMPARE(large.size(), 2 * small.size());
            const double growth = double(ink(large)) / ink(small);
            QVERIFY2(growth > 2 && growth < 5, qPrintable(QString::number(growth))); // lines and letters grow too
        }
    }

    void vectorFilesKeepTextAsLetters()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("chart.svg");
        QVERIFY(saveChart(path, rates(), QPalette(Qt::white), {500, 320}, 1));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(file.readAll());
        QVERIFY(text.contains(QString("Křivka zkreslení")));
        QVERIFY(text.contains("Bity na vrchol"));
    }

    void numbersAreWrittenInTheLanguage()
    {
        const QTemporaryDir folder;
        const QLocale before;
        QLocale::setDefault(QLocale(QLocale::Czech));
        const QString path = folder.filePath("chart.svg");
        QVERIFY(saveChart(path, rates(), QPalette(Qt::white), {500, 320}, 1));
        QLocale::setDefault(before);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(QString::fromUtf8(file.readAll()).contains(">0,"));
    }

    void whatCannotBeWrittenSaysSo()
    {
        const QTemporaryDir folder;
        const auto unknown = saveChart(folder.filePath("chart.gif"), rates(), QPalette(), {100, 100}, 1);
        QVERIFY(!unknown && unknown.error().code == model::ErrorCode::UnknownFormat);
        const auto nowhere = saveChart("/nowhere/chart.csv", rates(), QPalette(), {100, 100}, 1);
        QVERIFY(!nowhere && nowhere.error().code == model::ErrorCode::CannotOpen);
    }

    void theWidgetShowsItOrSaysWhyNot()
    {
        ChartWidget widget;
        widget.resize(500, 320);
        widget.setMessage("Nothing to show");
        const QImage empty = widget.grab().toImage();
        widget.setChart(valences());
        QVERIFY(ink(widget.grab().toImage()) > 4 * ink(empty));
        QCOMPARE(widget.accessibleName(), QString("Valence"));
    }
};

SANDREEL_TEST(TestChart)
#include "tst_chart.moc"
