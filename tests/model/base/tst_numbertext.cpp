// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/numbertext.h"
#include "tests/support/testmain.h"

#include <cmath>
#include <limits>

class TestNumberText final : public QObject
{
    Q_OBJECT

private slots:
    void shortestTextThatReadsBack()
    {
        QCOMPARE(model::numberText(0.1), std::string("0.1"));
        QCOMPARE(model::numberText(30.0), std::string("30"));
        QCOMPARE(model::numberText(0.1f), std::string("0.1"));
        QCOMPARE(model::numberText(1u << 31), std::string("2147483648"));
        for (const double value : {1.0 / 3, -M_PI * 1e-300, 5500000.01, std::numeric_limits<double>::max(),
                                   std::numeric_limits<double>::denorm_min()}) {
            const std::string text = model::numberText(value);
            QVERIFY2(QByteArray(text.c_str()).toDouble() == value, text.c_str());
            QVERIFY(text.find(',') == std::string::npos);
        }
    }

    void isAppended()
    {
        std::string text = "x ";
        model::appendNumber(text, -0.5);
        model::appendNumber(text, 7);
        QCOMPARE(text, std::string("x -0.57"));
    }
};

SANDREEL_TEST(TestNumberText)
#include "tst_numbertext.moc"
