// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/maskjson.h"

#include <QByteArray>
#include <QtEndian>

namespace model::io {

using terrain::PaintMask;

QJsonObject jsonOf(const PaintMask &mask)
{
    const std::span<const std::uint8_t> values = mask.values();
    const QByteArray packed = qCompress(values.data(), qsizetype(values.size()));
    return {{"columns", qint64(mask.columns())},
            {"rows", qint64(mask.rows())},
            {"values", QString::fromLatin1(packed.toBase64())}};
}

Result<PaintMask> maskOf(const QJsonObject &json, const terrain::Rectangle &domain)
{
    const auto count = [&](const char *key) {
        const double value = json[QLatin1String(key)].toDouble();
        return value >= 1 && value <= PaintMask::MostCells ? std::uint32_t(value) : 0;
    };
    const std::uint32_t columns = count("columns"), rows = count("rows");
    const QByteArray packed = QByteArray::fromBase64(json["values"].toString().toLatin1());
    // qUncompress() believes the size at the front.
    const std::uint64_t size = std::uint64_t(columns) * rows;
    if (packed.size() < 4 || size == 0 || qFromBigEndian<quint32>(packed.constData()) != size)
        return fail(ErrorCode::BadValue, "cells of the mask", std::to_string(columns) + " x " + std::to_string(rows),
                    "those of its values");
    const QByteArray values = qUncompress(packed);
    if (std::uint64_t(values.size()) != size)
        return fail(ErrorCode::CorruptStream, "mask");
    return PaintMask::restore(domain, columns, rows, {values.begin(), values.end()});
}

} // namespace model::io
