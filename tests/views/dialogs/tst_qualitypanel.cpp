// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/metrics.h"
#include "model/io/animationreader.h"
#include "model/io/animfile.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"
#include "tests/views/dialogs/dialogdriver.h"
#include "views/dialogs/preparedialog.h"
#include "views/dialogs/qualitypanel.h"
#include "views/widgets/rateplot.h"

#include <QComboBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>
#include <QSlider>
#include <QTableWidget>
#include <QTemporaryDir>

using tests::click;
using tests::textOf;
using tests::typeInto;
using views::PrepareDialog;
using views::QualityPanel;

/// Quality, targets, expectation and plot in Prepare Animation, driven as a person does.
class TestQualityPanel final : public QObject
{
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> mFolder;

    QString source() const
    {
        return tests::writeObjFrames(mFolder->filePath("walk"), *tests::noise(tests::grid(12, 10), 20));
    }
    static views::RatePlot &plotOf(const PrepareDialog &dialog)
    {
        return *tests::find<views::RatePlot>(dialog, "ratePlot");
    }
    static void waitUntilDone(const PrepareDialog &dialog)
    {
        const auto *panel = dialog.findChild<QualityPanel *>();
        QTRY_VERIFY_WITH_TIMEOUT(!panel->isBusy(), 60'000);
    }
    /// Opens the dialog on the source and waits for the first expectation.
    void openOn(PrepareDialog &dialog) const
    {
        tests::open(dialog);
        dialog.setSource(source());
        QTRY_VERIFY_WITH_TIMEOUT(textOf(dialog, "expected").contains("KG error"), 60'000);
    }
    static void choose(const PrepareDialog &dialog, const char *box, const QString &text)
    {
        auto *combo = tests::find<QComboBox>(dialog, box);
        const int index = combo->findText(text, Qt::MatchStartsWith);
        QVERIFY2(index >= 0, qPrintable(text));
        combo->setCurrentIndex(index);
    }
    /// The KG error that is expected, per cent.
    static double expectedError(const PrepareDialog &dialog)
    {
        const QString text = textOf(dialog, "expected");
        return QRegularExpression("KG error ([0-9.e-]+)\u00a0%").match(text).captured(1).toDouble();
    }

private slots:
    void init()
    {
        mFolder = std::make_unique<QTemporaryDir>();
        QSettings().clear();
        QSettings().setValue("prepareDialog/compression", "pca basis=20 resolution=10000");
        QLocale::setDefault(QLocale("en_US"));
    }
    void cleanup() { QLocale::setDefault(QLocale::c()); }

    void expectationIsWhatEncodingGives()
    {
        PrepareDialog dialog;
        openOn(dialog);
        typeInto(dialog, "pca-basis", "7");
        waitUntilDone(dialog);
        const double expected = expectedError(dialog);
        QVERIFY(expected > 0);
        QCOMPARE(plotOf(dialog).points().size(), std::size_t(2)); // the defaults, and 7
        QVERIFY(plotOf(dialog).current() == 1);
        click(dialog, "encode");
        const auto *tries = tests::find<QTableWidget>(dialog, "tries");
        QTRY_COMPARE_WITH_TIMEOUT(tries->rowCount(), 1, 60'000);
        const double made = tries->item(0, 4)->text().section(QChar(0xa0), 0, 0).toDouble();
        QVERIFY2(std::abs(made - expected) < 0.01 * made, qPrintable(tries->item(0, 4)->text()));
        QVERIFY(textOf(dialog, "expected").startsWith(tries->item(0, 1)->text()));
    }

    void sliderFindsSettings()
    {
        PrepareDialog dialog;
        openOn(dialog);
        for (const int quality : {30, 80}) {
            tests::find<QSlider>(dialog, "quality")->setValue(quality);
            waitUntilDone(dialog);
            QVERIFY(expectedError(dialog) <= model::kgErrorOfQuality(quality / 100.0));
            QVERIFY(expectedError(dialog) > 0.7 * model::kgErrorOfQuality(quality / 100.0));
            QCOMPARE(tests::find<QSlider>(dialog, "quality")->value(), quality);
        }
        // The settings found are those that will be used.
        const double expected = expectedError(dialog);
        const QString basis = textOf(dialog, "pca-basis");
        QVERIFY(basis != "20");
        const QString output = mFolder->filePath("found.anim");
        typeInto(dialog, "output", output);
        click(dialog, "encode");
        QTRY_COMPARE_WITH_TIMEOUT(tests::find<QTableWidget>(dialog, "tries")->rowCount(), 1, 60'000);
        const auto anim = model::io::openAnim(output);
        QVERIFY(anim.has_value());
        QCOMPARE(QString::number(std::get<model::PcaSettings>((*anim)->settings().method).basisSize), basis);
        const auto original = model::io::readAnimation(mFolder->filePath("walk"));
        const auto lost = model::compareAnimations(**original, **anim);
        QVERIFY(std::abs(lost->kgErrorPercent - expected) < 0.01 * expected);
    }

    void eachCodecHasItsOwnFields()
    {
        PrepareDialog dialog;
        openOn(dialog);
        const auto isSeen = [&](const char *name) { return tests::find<QWidget>(dialog, name)->isVisible(); };
        QVERIFY(isSeen("pca-basis") && isSeen("pca-resolution"));
        QVERIFY(!isSeen("direct-resolution") && !isSeen("direct-predictor") && !isSeen("direct-entropy"));
        choose(dialog, "codec", "Direct");
        QVERIFY(!isSeen("pca-basis") && !isSeen("pca-resolution"));
        QVERIFY(isSeen("direct-resolution") && isSeen("direct-predictor") && isSeen("direct-entropy"));
        waitUntilDone(dialog);
        const double error = expectedError(dialog);
        choose(dialog, "direct-predictor", "A");
        waitUntilDone(dialog);
        QCOMPARE(expectedError(dialog), error); // only the size is another
        typeInto(dialog, "direct-resolution", "100");
        waitUntilDone(dialog);
        QVERIFY(expectedError(dialog) > error);
        QCOMPARE(plotOf(dialog).points().size(), std::size_t(4));
        choose(dialog, "codec", "PCA");
        QCOMPARE(textOf(dialog, "pca-basis"), QString("20"));
    }

    void targetsAreFound()
    {
        PrepareDialog dialog;
        openOn(dialog);
        choose(dialog, "codec", "Direct");
        waitUntilDone(dialog);
        choose(dialog, "target", "File size");
        typeInto(dialog, "targetValue", "9");
        click(dialog, "findSettings");
        waitUntilDone(dialog);
        const QString size = textOf(dialog, "expected").section(' ', 0, 0);
        QVERIFY2(size.toDouble() <= 9 && size.toDouble() > 8, qPrintable(textOf(dialog, "expected")));
        choose(dialog, "target", "KG error");
        typeInto(dialog, "targetValue", "2");
        click(dialog, "findSettings");
        waitUntilDone(dialog);
        QVERIFY(expectedError(dialog) <= 2 && expectedError(dialog) > 1.8);
        choose(dialog, "target", "Largest error");
        typeInto(dialog, "targetValue", "0.5");
        click(dialog, "findSettings");
        waitUntilDone(dialog);
        // Half the diagonal of a cell is half a per cent of the box's diagonal at some 100 to 200 cells.
        const double cells = textOf(dialog, "direct-resolution").toDouble();
        QVERIFY2(cells > 60 && cells < 250, qPrintable(textOf(dialog, "direct-resolution")));
    }

    void whatCannotBeReachedIsSaid()
    {
        PrepareDialog dialog;
        openOn(dialog);
        choose(dialog, "target", "File size");
        typeInto(dialog, "targetValue", "0.1");
        click(dialog, "findSettings");
        waitUntilDone(dialog);
        QVERIFY2(textOf(dialog, "expected").contains("cannot be"), qPrintable(textOf(dialog, "expected")));
        QCOMPARE(textOf(dialog, "pca-basis"), QString("20"));
        typeInto(dialog, "targetValue", "0");
        QVERIFY(!tests::find<QPushButton>(dialog, "findSettings")->isEnabled());
    }

    void aPointTakesItsSettings()
    {
        PrepareDialog dialog;
        openOn(dialog);
        typeInto(dialog, "pca-basis", "3");
        waitUntilDone(dialog);
        choose(dialog, "codec", "Direct");
        waitUntilDone(dialog);
        views::RatePlot &plot = plotOf(dialog);
        QCOMPARE(plot.points().size(), std::size_t(3));
        QTest::mouseClick(&plot, Qt::LeftButton, {}, plot.placeOf(1).toPoint());
        QCOMPARE(tests::find<QComboBox>(dialog, "codec")->currentText(), QString("PCA"));
        QCOMPARE(textOf(dialog, "pca-basis"), QString("3"));
        QCOMPARE(plot.current(), 1);
    }

    void anotherSourceForgets()
    {
        PrepareDialog dialog;
        openOn(dialog);
        QVERIFY(!plotOf(dialog).points().empty());
        dialog.setSource(mFolder->filePath("nowhere"));
        QVERIFY(plotOf(dialog).points().empty());
        QCOMPARE(textOf(dialog, "expected"), QString());
        QVERIFY(!tests::find<QSlider>(dialog, "quality")->isEnabled());
    }

    void closingInTheMiddleIsSafe()
    {
        const QString path = source();
        for (int i = 0; i < 3; ++i) {
            PrepareDialog dialog;
            tests::open(dialog);
            dialog.setSource(path);
            QTRY_VERIFY_WITH_TIMEOUT(tests::find<QSlider>(dialog, "quality")->isEnabled(), 60'000);
            tests::find<QSlider>(dialog, "quality")->setValue(90 - i);
            QTest::qWait(200 * i);
        }
    }
};

SANDREEL_TEST(TestQualityPanel)
#include "tst_qualitypanel.moc"
