// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/recovery/journalframes.h"

#include "model/io/terrain/ledgerfields.h"
#include "model/io/terrain/maskjson.h"
#include "model/io/terrain/materialjson.h"
#include "model/terrain/tin/tinedit.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>

#include <zlib.h>

namespace model::io {

using namespace terrain;

namespace {

constexpr std::size_t FrameHeader = 8;

Bytes jsonBytes(const QJsonObject &json)
{
    const QByteArray text = QJsonDocument(json).toJson(QJsonDocument::Compact);
    return {text.begin(), text.end()};
}

QJsonObject settingsOf(const Terrain &terrain)
{
    QJsonArray materials;
    for (const Material &material : terrain.materials)
        materials.append(jsonOf(material));
    const GeoReference &place = terrain.geoReference;
    return {{"materials", materials},
            {"origin", QJsonArray{place.originX, place.originY}},
            {"crs", QString::fromStdString(place.crs)},
            {"unit", QString::fromStdString(place.unit)}};
}

void writePoint(ByteWriter &out, Point2 p)
{
    out.f64(p.x);
    out.f64(p.y);
}

Bytes formatEdit(const EditChanges &changes, const TinArrays &tin)
{
    ByteWriter out;
    out.u8(std::uint8_t(tin.layerCount()));
    out.varUint(changes.removed.size());
    for (const Point2 &p : changes.removed)
        writePoint(out, p);
    out.varUint(changes.present.size());
    for (const VertexId v : changes.present) {
        writePoint(out, tin.points[v]);
        out.f64(tin.heights[v]);
        for (std::uint32_t l = 0; l < tin.layerCount(); ++l) {
            out.f64(tin.sample(v, l).thickness);
            out.f32(tin.sample(v, l).humidity);
        }
    }
    for (const auto *const lines : {&changes.released, &changes.constrained}) {
        out.varUint(lines->size());
        for (const EditChanges::Line &line : *lines) {
            writePoint(out, line.a);
            writePoint(out, line.b);
            out.u32(line.owner);
        }
    }
    out.u8(isFirstVoid(tin));
    TinTotals totals = tin.totals;
    forEachLedgerField(totals, [&](double &value) { out.f64(value); });
    return out.take();
}

} // namespace

std::uint32_t journalCrcOf(std::span<const std::uint8_t> bytes)
{
    return std::uint32_t(crc32_z(crc32(0, nullptr, 0), bytes.data(), bytes.size()));
}

Bytes frameOf(std::uint8_t kind, std::span<const std::uint8_t> payload)
{
    Bytes body{kind};
    body.insert(body.end(), payload.begin(), payload.end());
    ByteWriter frame;
    frame.u32(std::uint32_t(body.size()));
    frame.u32(journalCrcOf(body));
    frame.bytes(body);
    return frame.take();
}

Bytes frameOfBase(const RecoveryBase &base)
{
    return frameOf(BaseFrame,
                   jsonBytes({{"path", base.path}, {"crc32", double(base.crc)}, {"bytes", double(base.bytes)}}));
}

Result<RecoveryBase> readBase(const std::vector<Frame> &frames)
{
    if (frames.empty() || frames[0].kind != BaseFrame)
        return fail(ErrorCode::Truncated, "1", "0");
    const QJsonObject json =
        QJsonDocument::fromJson(
            QByteArray(reinterpret_cast<const char *>(frames[0].payload.data()), qsizetype(frames[0].payload.size())))
            .object();
    RecoveryBase base;
    base.path = json["path"].toString();
    base.crc = std::uint32_t(json["crc32"].toDouble());
    base.bytes = std::uint64_t(std::max(0.0, json["bytes"].toDouble()));
    return base;
}

Result<std::vector<Frame>> readFrames(std::span<const std::uint8_t> journal, std::uint64_t &tornBytes)
{
    const std::size_t known = std::min(journal.size(), sizeof JournalMagic - 1);
    if (!std::equal(journal.begin(), journal.begin() + std::ptrdiff_t(known), JournalMagic))
        return fail(ErrorCode::BadMagic, QT_TRANSLATE_NOOP("ErrorText", "recovery"));
    if (journal.size() < sizeof JournalMagic)
        return fail(ErrorCode::Truncated, std::to_string(sizeof JournalMagic), std::to_string(journal.size()));
    if (journal[sizeof JournalMagic - 1] != JournalMagic[sizeof JournalMagic - 1])
        return fail(ErrorCode::UnsupportedVersion, std::to_string(journal[sizeof JournalMagic - 1]), "1");
    std::vector<Frame> frames;
    std::size_t at = sizeof JournalMagic;
    while (journal.size() - at >= FrameHeader) {
        ByteReader in(journal.subspan(at, FrameHeader));
        const std::uint32_t size = in.u32(), crc = in.u32();
        if (size == 0 || size > journal.size() - at - FrameHeader)
            break;
        const auto body = journal.subspan(at + FrameHeader, size);
        if (journalCrcOf(body) != crc)
            break;
        frames.push_back({body[0], at + FrameHeader + 1, body.subspan(1)});
        at += FrameHeader + size;
    }
    tornBytes = journal.size() - at;
    return frames;
}

bool isFirstVoid(const TinArrays &tin)
{
    return tin.isVoid(triangleOf(tin.firstAround(0)));
}

JournalFrame frameOfChanges(const EditChanges &changes, const TinArrays &tin)
{
    return {EditFrame, formatEdit(changes, tin)};
}

JournalFrame frameOfSettings(const Terrain &terrain)
{
    return {SettingsFrame, jsonBytes(settingsOf(terrain))};
}

JournalFrame frameOfMask(const PaintMask *mask)
{
    return {MaskFrame, jsonBytes(mask ? jsonOf(*mask) : QJsonObject())};
}

} // namespace model::io
