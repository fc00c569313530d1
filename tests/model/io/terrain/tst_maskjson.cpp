// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/maskjson.h"
#include "tests/support/testmain.h"

#include <QByteArray>

using namespace model;
using terrain::PaintMask;

class TestMaskJson final : public QObject
{
    Q_OBJECT

    static constexpr terrain::Rectangle Domain{{0, 0}, {2, 1}};

    static QJsonObject painted()
    {
        PaintMask mask(Domain);
        mask.paint({0.2, 0.2}, {1.5, 0.8}, 0.2, 0.7, false);
        return io::jsonOf(mask);
    }
    static std::optional<ErrorCode> codeOf(const QJsonObject &json)
    {
        const auto mask = io::maskOf(json, Domain);
        return mask ? std::optional<ErrorCode>() : mask.error().code;
    }

private slots:
    void itComesBackAsItWas()
    {
        PaintMask mask(Domain);
        mask.paint({0.2, 0.2}, {1.5, 0.8}, 0.2, 0.7, false);
        const auto again = io::maskOf(io::jsonOf(mask), Domain);
        QVERIFY(again);
        QCOMPARE(*again, mask);
    }
    void whatDoesNotFitIsRefused()
    {
        QVERIFY(!codeOf(painted()));
        QCOMPARE(codeOf({}), std::optional(ErrorCode::BadValue));
        QJsonObject other = painted();
        other["columns"] = other["columns"].toInt() + 1;
        QCOMPARE(codeOf(other), std::optional(ErrorCode::BadValue));
        other = painted();
        other["rows"] = -1;
        QCOMPARE(codeOf(other), std::optional(ErrorCode::BadValue));
        other = painted();
        QByteArray packed = QByteArray::fromBase64(other["values"].toString().toLatin1());
        packed.truncate(packed.size() - 5);
        other["values"] = QString::fromLatin1(packed.toBase64());
        QCOMPARE(codeOf(other), std::optional(ErrorCode::CorruptStream));
        // The size at the front says how much would be allocated.
        packed[0] = '\x7f';
        other["values"] = QString::fromLatin1(packed.toBase64());
        QCOMPARE(codeOf(other), std::optional(ErrorCode::BadValue));
    }
};

SANDREEL_TEST(TestMaskJson)
#include "tst_maskjson.moc"
