// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testmain.h"
#include "views/dialogs/numberfield.h"

#include <QLocale>
#include <QSignalSpy>

using views::NumberField;

class TestNumberField final : public QObject
{
    Q_OBJECT

private slots:
    void cleanup() { QLocale::setDefault(QLocale::c()); }

    void textIsTakenOrRefused_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<int>("decimals");
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("value"); // NaN: refused
        const double refused = std::nan("");
        QTest::newRow("least") << "en_US" << 0 << "1" << 1.0;
        QTest::newRow("most") << "en_US" << 0 << "1000" << 1000.0;
        QTest::newRow("grouped") << "en_US" << 0 << "1,000" << 1000.0;
        QTest::newRow("too small") << "en_US" << 0 << "0" << refused;
        QTest::newRow("too large") << "en_US" << 0 << "1001" << refused;
        QTest::newRow("negative") << "en_US" << 0 << "-5" << refused;
        QTest::newRow("nothing") << "en_US" << 0 << "" << refused;
        QTest::newRow("letters") << "en_US" << 0 << "abc" << refused;
        QTest::newRow("not whole") << "en_US" << 0 << "2.5" << refused;
        QTest::newRow("infinite") << "en_US" << 2 << "inf" << refused;
        QTest::newRow("not a number") << "en_US" << 2 << "nan" << refused;
        QTest::newRow("decimal point") << "en_US" << 2 << "29.97" << 29.97;
        QTest::newRow("spaces around") << "en_US" << 2 << " 29.97 " << 29.97;
        QTest::newRow("Czech decimal comma") << "cs_CZ" << 2 << "29,97" << 29.97;
        QTest::newRow("Czech decimal point") << "cs_CZ" << 2 << "29.97" << 29.97;
    }
    void textIsTakenOrRefused()
    {
        QFETCH(QString, language);
        QFETCH(int, decimals);
        QFETCH(QString, text);
        QFETCH(double, value);
        QLocale::setDefault(QLocale(language));
        NumberField field("Rate", {1, 1000, decimals});
        field.show();
        field.input().clear();
        QTest::keyClicks(&field.input(), text);
        QCOMPARE(field.input().text(), text); // what was typed is never bent
        QCOMPARE(field.value().has_value(), !std::isnan(value));
        QCOMPARE(field.input().isRefused(), std::isnan(value));
        QCOMPARE(field.problem().isEmpty(), !std::isnan(value));
        if (field.value())
            QCOMPARE(*field.value(), value);
    }

    void refusalSaysTheRangeBesideTheField()
    {
        QLocale::setDefault(QLocale("en_US"));
        NumberField field("Basis size", {1, 1000, 0});
        field.setHint("vectors");
        const auto *hint = field.findChild<views::HintLabel *>();
        QCOMPARE(hint->text(), QString("vectors"));
        field.input().setText("5000");
        QCOMPARE(hint->text(), QString("Allowed: a whole number from 1 to 1,000"));
        QCOMPARE(field.problem(), QString("Basis size: enter a whole number from 1 to 1,000."));
        field.input().setText("500");
        QCOMPARE(hint->text(), QString("vectors"));
    }

    void valuesAreShownInTheLanguageAndReadBack()
    {
        QLocale::setDefault(QLocale("cs_CZ"));
        NumberField field("Rate", {0, 1e7, 3});
        for (const double value : {0.0, 25.0, 29.97, 1234567.125}) {
            field.setValue(value);
            QCOMPARE(*field.value(), value);
        }
        field.setValue(29.97);
        QCOMPARE(field.input().text(), QString("29,97"));
    }

    void upAndDownStepWithinTheRange()
    {
        NumberField field("Basis size", {1, 3, 0});
        QSignalSpy changed(&field, &NumberField::changed);
        QTest::keyClick(&field.input(), Qt::Key_Up);
        QCOMPARE(*field.value(), 2.0);
        QTest::keyClick(&field.input(), Qt::Key_Up);
        QTest::keyClick(&field.input(), Qt::Key_Up);
        QCOMPARE(*field.value(), 3.0);
        QCOMPARE(changed.size(), 2);
        QTest::keyClick(&field.input(), Qt::Key_Down);
        QCOMPARE(*field.value(), 2.0);
    }
};

SANDREEL_TEST(TestNumberField)
#include "tst_numberfield.moc"
