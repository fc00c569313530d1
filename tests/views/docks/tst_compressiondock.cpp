// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/docks/compressiondock.h"

#include "model/codec/animationcodec.h"
#include "tests/support/busyjobs.h"
#include "tests/support/meshes.h"
#include "tests/support/testmain.h"

#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QPushButton>
#include <QTreeWidget>

using namespace views;

/// Driven as a person does, looking at the document.
class TestCompressionDock final : public QObject
{
    Q_OBJECT

    std::unique_ptr<model::AnimationDocument> mDocument;
    std::unique_ptr<commands::AnimationContext> mContext;
    std::unique_ptr<QMainWindow> mWindow;
    CompressionDock *mDock = nullptr;

    template <class Widget>
    Widget *find(const char *name) const
    {
        auto *widget = mDock->findChild<Widget *>(QLatin1String(name));
        if (!widget)
            qFatal("no %s in the dock", name);
        return widget;
    }
    QLineEdit *basisField() const { return find<QWidget>("pca-basis")->findChild<QLineEdit *>(); }
    QPushButton *measureButton() const { return find<QPushButton>("measure"); }
    QLabel *measured() const { return find<QLabel>("measured"); }
    void type(const QString &text) const
    {
        basisField()->setFocus();
        basisField()->selectAll();
        QTest::keyClicks(basisField(), text);
    }
    void leaveField() const { QTest::keyClick(basisField(), Qt::Key_Return); }
    static std::uint32_t basisSizeOf(const model::AnimationDocument &document)
    {
        return std::get<model::PcaSettings>(document.compression().method).basisSize;
    }
    std::uint32_t basisSize() const { return basisSizeOf(*mDocument); }
    int steps() const { return mContext->undoStack().count(); }

private slots:
    void init()
    {
        QLocale::setDefault(QLocale("en_US"));
        mDocument = std::make_unique<model::AnimationDocument>(tests::wave(tests::grid(6, 4)),
                                                               model::CompressionSettings{model::PcaSettings()});
        mContext = std::make_unique<commands::AnimationContext>(*mDocument);
        mWindow = std::make_unique<QMainWindow>();
        mDock = new CompressionDock;
        mWindow->addDockWidget(Qt::RightDockWidgetArea, mDock);
        mDock->setDocument(mContext.get(), std::nullopt);
        mWindow->resize(500, 700);
        mWindow->show();
        mWindow->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(mWindow.get()));
    }
    void cleanup()
    {
        mWindow.reset();
        mContext.reset();
        mDocument.reset();
        QLocale::setDefault(QLocale::c());
    }

    void typedSettingIsAStepOfTheHistory()
    {
        QCOMPARE(basisField()->text(), QString::number(basisSize()));
        type("7");
        QCOMPARE(basisSize(), 7u);
        QCOMPARE(steps(), 1);
        QVERIFY(!mContext->undoStack().undoText().isEmpty());
        mContext->undoStack().undo();
        QCOMPARE(basisSize(), model::PcaSettings().basisSize);
        QCOMPARE(basisField()->text(), QString::number(basisSize()));
        mContext->undoStack().redo();
        QCOMPARE(basisField()->text(), QString("7"));
    }

    void whatIsTypedInOneGoIsOneStep()
    {
        type("123"); // 1, 12, 123
        QCOMPARE(basisSize(), 123u);
        QCOMPARE(steps(), 1);
        leaveField();
        type("45");
        leaveField();
        QCOMPARE(steps(), 2);
        mContext->undoStack().undo();
        QCOMPARE(basisSize(), 123u);
    }

    void valueOutOfRangeChangesNothing()
    {
        const std::uint32_t before = basisSize();
        type("0");
        QCOMPARE(basisSize(), before);
        QCOMPARE(steps(), 0);
        QCOMPARE(basisField()->text(), QString("0")); // what was typed stays, and may be corrected
    }

    void withoutADocumentThereIsNothingToSet()
    {
        mDock->setDocument(nullptr, std::nullopt);
        QVERIFY(!basisField()->isEnabled());
        QVERIFY(!measureButton()->isEnabled());
        mDock->setDocument(mContext.get(), std::nullopt);
        QVERIFY(basisField()->isEnabled());
        QVERIFY(measureButton()->isEnabled());
    }

    void otherDocumentShowsItsOwnSettings()
    {
        model::CompressionSettings settings{model::PcaSettings{.basisSize = 3}};
        model::AnimationDocument other(tests::wave(tests::oneTriangle()), settings);
        commands::AnimationContext context(other);
        mDock->setDocument(&context, std::nullopt);
        QCOMPARE(basisField()->text(), QString("3"));
        type("5");
        QCOMPARE(basisSizeOf(other), 5u);
        QCOMPARE(steps(), 0);
        mDock->setDocument(mContext.get(), std::nullopt);
        QCOMPARE(basisField()->text(), QString::number(basisSize()));
    }

    void factsOfTheFileAreShown()
    {
        QVERIFY(!find<QTreeWidget>("chunks")->isVisible());
        FileFacts facts;
        facts.bytes = 2000;
        facts.frameCount = 10;
        facts.vertexCount = 100;
        facts.creator = "Sandreel 9.8";
        facts.chunks = {{"HEAD", 500}, {"COEF", 1500}};
        mDock->setDocument(mContext.get(), facts);
        const auto *const chunks = find<QTreeWidget>("chunks");
        QVERIFY(chunks->isVisible());
        QCOMPARE(chunks->topLevelItemCount(), 2);
        QCOMPARE(chunks->topLevelItem(1)->text(0), QString("COEF"));
        QCOMPARE(chunks->topLevelItem(1)->text(1), QString("1,500"));
        QCOMPARE(chunks->topLevelItem(1)->text(2), QString("75 %"));
        QStringList texts;
        for (const QLabel *label : mDock->findChildren<QLabel *>())
            texts << label->text();
        QVERIFY2(texts.contains("6 : 1"), qPrintable(texts.join('|'))); // 12000 bytes of float32
        QVERIFY2(texts.contains("16"), qPrintable(texts.join('|')));    // bits per vertex and frame
        QVERIFY2(texts.contains("Sandreel 9.8"), qPrintable(texts.join('|')));
    }

    /// Against what the codec itself says.
    void measuringTellsSizeAndError()
    {
        type("2");
        QTest::mouseClick(measureButton(), Qt::LeftButton);
        QTRY_VERIFY(measured()->isVisible());
        const auto encoded = model::codec::encodeAnimation(*mDocument->frames(), mDocument->compression());
        const auto decoded = model::codec::decodeAnimation(encoded->bytes);
        const auto lost = model::compareAnimations(*mDocument->frames(), **decoded, encoded->permutation);
        const QString text = measured()->text();
        const double ratio = 5040.0 / double(encoded->bytes.size()); // 35 * 12 * 12 bytes
        QVERIFY2(text.contains(QString("ratio %1 : 1").arg(ratio, 0, 'f', ratio < 10 ? 1 : 0)), qPrintable(text));
        const QString shown = text.section("KG error ", 1).section(' ', 0, 0);
        QVERIFY2(std::abs(shown.toDouble() - lost->kgErrorPercent) <= 0.01 * lost->kgErrorPercent, qPrintable(text));
        QCOMPARE(steps(), 1); // measuring is no edit

        type("3"); // and its answer is not that of other settings
        QVERIFY(!measured()->isVisible());
    }

    void answerForWhatHasChangedIsDropped()
    {
        {
            const tests::BusyJobs busy;
            QTest::mouseClick(measureButton(), Qt::LeftButton);
            QVERIFY(!measureButton()->isVisible()); // the bar with its Cancel is there instead
            QVERIFY(find<QPushButton>("cancelJob")->isVisible());
            type("3");
        }
        QTRY_VERIFY(measureButton()->isVisible());
        QVERIFY(!measured()->isVisible());
    }

    void measuringMayBeCancelled()
    {
        {
            const tests::BusyJobs busy;
            QTest::mouseClick(measureButton(), Qt::LeftButton);
            QTest::mouseClick(find<QPushButton>("cancelJob"), Qt::LeftButton);
        }
        QTRY_VERIFY(measureButton()->isVisible());
        QVERIFY(!measured()->isVisible()); // neither a measurement nor an error
        QVERIFY(measureButton()->isEnabled());
    }

    void documentMayGoWhileItIsMeasured()
    {
        auto busy = std::make_unique<tests::BusyJobs>();
        QTest::mouseClick(measureButton(), Qt::LeftButton);
        mContext.reset();
        mDocument.reset();
        mDock->setDocument(nullptr, std::nullopt);
        busy.reset();
        QTRY_VERIFY(measureButton()->isVisible());
        QVERIFY(!measured()->isVisible());
        QVERIFY(!measureButton()->isEnabled());
    }
};

SANDREEL_TEST(TestCompressionDock)
#include "tst_compressiondock.moc"
