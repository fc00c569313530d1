// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/metrics.h"
#include "model/codec/connectivity/codedorder.h"
#include "model/io/animationreader.h"
#include "model/io/animfile.h"
#include "tests/support/realdata.h"
#include "tests/support/testmain.h"
#include "tests/views/dialogs/dialogdriver.h"
#include "views/dialogs/preparedialog.h"

#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>

using namespace tests;
using views::PrepareDialog;

/// Real sequences through the dialog, as a person prepares them: from the source to the opened file.
class TestRealSequencesInDialog final : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { SANDREEL_REQUIRE_DATA(); }
    void init() { QSettings().clear(); }

    void isPrepared_data()
    {
        QTest::addColumn<QString>("source");
        QTest::addColumn<quint32>("vertices");
        QTest::addColumn<quint32>("triangles");
        QTest::addColumn<quint32>("frames");
        QTest::addColumn<double>("kgLimit"); // per cent, at the dialog's own settings
        QTest::newRow("chicken") << "chicken/chicken.pc2" << 3030u << 5664u << 400u << 5.0;
        QTest::newRow("cow") << "cow/cow.pc2" << 2904u << 5804u << 204u << 2.5;
        QTest::newRow("dance") << "dance/dance.pc2" << 7061u << 14118u << 201u << 1.5;
        QTest::newRow("samba") << "samba/samba.pc2" << 9971u << 19938u << 175u << 2.5;
        QTest::newRow("horse-gallop") << "horse-gallop" << 8431u << 16843u << 48u << 1.0;
    }
    void isPrepared()
    {
        QFETCH(QString, source);
        QFETCH(quint32, vertices);
        QFETCH(quint32, triangles);
        QFETCH(quint32, frames);
        QFETCH(double, kgLimit);
        constexpr int Patience = 120'000; // ms; a loaded machine, with sanitizers
        const QString path = sequenceFolder(source.section('/', 0, 0)) + source.mid(source.section('/', 0, 0).size());
        const QTemporaryDir folder;
        const QString output = folder.filePath("real.anim");

        PrepareDialog dialog;
        tests::open(dialog);
        QSignalSpy opened(&dialog, &PrepareDialog::openRequested);
        typeInto(dialog, "source", path);
        QTRY_VERIFY_WITH_TIMEOUT(tests::find<QPushButton>(dialog, "encode")->isEnabled(), Patience);
        QCOMPARE(QLocale().toUInt(textOf(dialog, "factVertices")), vertices);
        QCOMPARE(QLocale().toUInt(textOf(dialog, "factTriangles")), triangles);
        typeInto(dialog, "output", output);
        click(dialog, "encode");
        QTRY_COMPARE_WITH_TIMEOUT(tests::find<QTableWidget>(dialog, "tries")->rowCount(), 1, Patience);

        const auto anim = model::io::openAnim(output);
        QVERIFY(anim.has_value());
        QCOMPARE((*anim)->vertexCount(), vertices);
        QCOMPARE(std::uint32_t((*anim)->connectivity().triangles.size()), triangles);
        QCOMPARE((*anim)->frameCount(), frames);
        const auto original = model::io::readAnimation(path);
        QVERIFY(original.has_value());
        // The default codec does not keep the order of the vertices.
        const auto order = model::codec::codedOrder((*original)->connectivity(), (*anim)->connectivity());
        QVERIFY(order.has_value() && !order->empty());
        const auto lost = model::compareAnimations(**original, **anim, *order);
        QVERIFY(lost.has_value());
        QVERIFY2(lost->kgErrorPercent < kgLimit, qPrintable(QString::number(lost->kgErrorPercent)));
        QVERIFY((*anim)->encodedBytes() * 200 < 12ull * vertices * frames);
    }
};

SANDREEL_TEST(TestRealSequencesInDialog)
#include "tst_realsequences.moc"
