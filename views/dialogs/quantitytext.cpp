// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/quantitytext.h"

#include <QCoreApplication>
#include <QLocale>

#include <cmath>

namespace views {

namespace {

struct Quantities
{
    Q_DECLARE_TR_FUNCTIONS(views::Quantities)
};

} // namespace

QString numberText(double value, int decimals)
{
    const QLocale locale;
    QString text = locale.toString(value, 'f', decimals);
    if (decimals == 0)
        return text;
    while (text.endsWith(locale.zeroDigit()))
        text.chop(1);
    if (text.endsWith(locale.decimalPoint()))
        text.chop(locale.decimalPoint().size());
    return text;
}

QString significantText(double value)
{
    const QLocale locale;
    const QString plain = QString::number(value, 'g', 4);
    const qsizetype at = plain.indexOf(QLatin1Char('e'));
    if (at < 0)
        return locale.toString(value, 'g', 4);
    // Not "1.2e-09": the exponent as on paper.
    static const QString Raised = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    const int power = plain.mid(at + 1).toInt();
    QString exponent = power < 0 ? QStringLiteral("⁻") : QString();
    for (const QChar digit : QString::number(std::abs(power)))
        exponent += Raised[digit.digitValue()];
    return locale.toString(plain.left(at).toDouble(), 'g', 4) + QStringLiteral("\u00a0×\u00a010") + exponent;
}

QString percentText(double percent)
{
    return significantText(percent) + QStringLiteral("\u00a0%");
}

QString countText(std::uint64_t count)
{
    return QLocale().toString(qulonglong(count));
}

QString bytesText(std::uint64_t bytes)
{
    return QLocale().formattedDataSize(qint64(bytes), bytes < 1000 ? 0 : 1, QLocale::DataSizeSIFormat);
}

QString durationText(double seconds)
{
    if (seconds < 9.95)
        return Quantities::tr("%1 s").arg(numberText(seconds, 1));
    const auto whole = qint64(std::llround(seconds));
    if (whole < 60)
        return Quantities::tr("%1 s").arg(whole);
    if (whole < 3600)
        return Quantities::tr("%1 min %2 s").arg(whole / 60).arg(whole % 60);
    return Quantities::tr("%1 h %2 min").arg(whole / 3600).arg(whole % 3600 / 60);
}

} // namespace views
