// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/recovery.h"

#include "model/base/memory.h"
#include "model/base/outofmemory.h"
#include "model/io/failure.h"
#include "model/io/filebuffer.h"
#include "model/io/savefile.h"
#include "model/io/terrain/ledgerfields.h"
#include "model/io/terrain/materialjson.h"
#include "model/terrain/tin/restoretin.h"
#include "model/terrain/tin/tinedit.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include <unistd.h>
#include <zlib.h>

namespace model::io {

using namespace terrain;

namespace {

constexpr std::uint8_t Magic[8] = {'S', 'R', 'J', 'O', 'U', 'R', 'N', 1};
constexpr std::size_t FrameHeader = 8;
enum FrameKind : std::uint8_t { BaseFrame, SnapshotFrame, EditFrame, SettingsFrame };

std::uint32_t crcOf(std::span<const std::uint8_t> bytes)
{
    return std::uint32_t(crc32_z(crc32(0, nullptr, 0), bytes.data(), bytes.size()));
}

std::span<const std::uint8_t> bytesOf(std::string_view text)
{
    return {reinterpret_cast<const std::uint8_t *>(text.data()), text.size()};
}

Bytes jsonBytes(const QJsonObject &json)
{
    const QByteArray text = QJsonDocument(json).toJson(QJsonDocument::Compact);
    return {text.begin(), text.end()};
}

Bytes frameOf(std::uint8_t kind, std::span<const std::uint8_t> payload)
{
    Bytes body{kind};
    body.insert(body.end(), payload.begin(), payload.end());
    ByteWriter frame;
    frame.u32(std::uint32_t(body.size()));
    frame.u32(crcOf(body));
    frame.bytes(body);
    return frame.take();
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

/// The triangle that the void mark is about: at the domain's first corner, along its south border.
bool isFirstVoid(const TinArrays &tin)
{
    return tin.isVoid(triangleOf(tin.firstAround(0)));
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

// Replaying

struct PointKey
{
    std::uint64_t x, y;

    explicit PointKey(Point2 p)
        : x(std::bit_cast<std::uint64_t>(p.x + 0.0))
        , y(std::bit_cast<std::uint64_t>(p.y + 0.0))
    {}
    friend auto operator<=>(const PointKey &, const PointKey &) = default;
};

struct LineKey
{
    PointKey a, b;
    OwnerId owner;

    explicit LineKey(const EditChanges::Line &line)
        : a(std::min(PointKey(line.a), PointKey(line.b)))
        , b(std::max(PointKey(line.a), PointKey(line.b)))
        , owner(line.owner)
    {}
    friend auto operator<=>(const LineKey &, const LineKey &) = default;
};

struct VertexState
{
    bool isThere = false;
    Point3 point;
    std::vector<LayerSample> samples;
};

class Replay
{
public:
    Replay(TerrainFile file)
        : mFile(std::move(file))
        , mTotals(mFile.terrain.tin.arrays().totals)
        , mIsFirstVoid(isFirstVoid(mFile.terrain.tin.arrays()))
    {}

    bool addEdit(ByteReader &in)
    {
        const std::uint32_t layers = in.u8();
        if (!in.require(layers == mTotals.layers.count, "layer count", layers, "that of the file"))
            return false;
        mHasEdits = true;
        const auto count = [&](std::uint64_t least) {
            const std::uint64_t value = in.varUint();
            return in.require(value <= in.left() / least, "vertex count", value, "at most the bytes left") ? value : 0;
        };
        for (std::uint64_t i = count(16); i > 0; --i)
            mVertices[PointKey(readPoint(in))] = {};
        for (std::uint64_t i = count(24); i > 0; --i) {
            const Point2 p = readPoint(in);
            VertexState state{true, {p.x, p.y, in.f64()}, {}};
            for (std::uint32_t l = 0; l < layers; ++l) {
                const double thickness = in.f64();
                state.samples.push_back({thickness, in.f32()});
            }
            mVertices[PointKey(p)] = std::move(state);
        }
        for (const bool isThere : {false, true})
            for (std::uint64_t i = count(36); i > 0; --i) {
                EditChanges::Line line;
                line.a = readPoint(in);
                line.b = readPoint(in);
                line.owner = in.u32();
                mLines.insert_or_assign(LineKey(line), std::pair(line, isThere));
            }
        mIsFirstVoid = in.u8() != 0;
        forEachLedgerField(mTotals, [&](double &value) { value = in.f64(); });
        return in.requireEnd();
    }

    Result<void> addSettings(const QJsonObject &json)
    {
        std::vector<Material> materials;
        const QJsonArray list = json["materials"].toArray();
        for (const QJsonValue &entry : list) {
            Material material;
            if (auto read = readMaterial(entry.toObject(), material); !read)
                return read;
            materials.push_back(std::move(material));
        }
        if (materials.size() > LargestMaterialList)
            return fail(ErrorCode::LimitExceeded, "number of materials", std::to_string(materials.size()),
                        std::to_string(LargestMaterialList));
        const QJsonArray origin = json["origin"].toArray();
        if (origin.size() != 2)
            return fail(ErrorCode::BadValue, "origin", "", "two numbers");
        mFile.terrain.materials = std::move(materials);
        mFile.terrain.geoReference = {origin[0].toDouble(), origin[1].toDouble(), json["crs"].toString().toStdString(),
                                      json["unit"].toString().toStdString()};
        return {};
    }

    Result<TerrainFile> finish()
    {
        if (mHasEdits) {
            Result<Tin> tin = build();
            if (!tin)
                return fail(tin.error());
            mFile.terrain.tin = std::move(*tin);
        }
        const LayerTable &layers = mFile.terrain.tin.arrays().totals.layers;
        for (std::uint32_t l = 0; l < layers.count; ++l)
            if (layers.materials[l] >= mFile.terrain.materials.size())
                return fail(ErrorCode::BadValue, "material of layer " + std::to_string(l),
                            std::to_string(layers.materials[l]),
                            "below " + std::to_string(mFile.terrain.materials.size()));
        return std::move(mFile);
    }

private:
    static Point2 readPoint(ByteReader &in)
    {
        const double x = in.f64();
        return {x, in.f64()};
    }

    /// Points and constraints determine the triangulation: it is made anew from them, whatever the order of edits was.
    Result<Tin> build() const
    {
        const TinArrays &from = mFile.terrain.tin.arrays();
        const std::uint32_t layers = from.layerCount();
        std::vector<Point3> points;
        std::vector<LayerSample> samples;
        for (VertexId v = 0; v < from.vertexSlots(); ++v) {
            if (!from.isVertex(v) || mVertices.contains(PointKey(from.points[v])))
                continue;
            points.push_back({from.points[v].x, from.points[v].y, from.heights[v]});
            for (std::uint32_t l = 0; l < layers; ++l)
                samples.push_back(from.sample(v, l));
        }
        for (const auto &[key, state] : mVertices)
            if (state.isThere) {
                points.push_back(state.point);
                samples.insert(samples.end(), state.samples.begin(), state.samples.end());
            }
        const Rectangle domain = mFile.terrain.tin.domain();
        Result<BuiltTin> built = buildTin(points, domain);
        if (!built)
            return fail(built.error());

        std::vector<EditChanges::Line> lines;
        for (const ConstraintRecord &record : from.records.values())
            if (record.a != terrain::None) {
                const EditChanges::Line line{from.points[record.a], from.points[record.b], record.owner};
                if (!mLines.contains(LineKey(line)))
                    lines.push_back(line);
            }
        for (const auto &[key, line] : mLines)
            if (line.second)
                lines.push_back(line.first);
        Tin &tin = built->tin;
        TinEdit edit(tin, VolumeRule::Keep);
        std::set<std::pair<VertexId, VertexId>> fences;
        for (const EditChanges::Line &line : lines) {
            const VertexId a = vertexAt(tin, line.a), b = vertexAt(tin, line.b);
            if (a == terrain::None || b == terrain::None || a == b || line.owner == terrain::None)
                return fail(ErrorCode::BrokenTerrain, "constraint", std::to_string(line.owner));
            if (auto done = edit.constrain(a, b, line.owner); !done)
                return fail(done.error());
            if (line.owner == VoidOwner)
                fences.insert({std::min(a, b), std::max(a, b)});
        }
        edit.setVoid(voidsBetween(tin.arrays(), fences), true);
        edit.commit();

        TinArrays arrays = tin.arrays();
        const std::vector<ConstrainedEdge> edges = constrainedEdges(arrays);
        arrays.totals.layers = mTotals.layers;
        arrays.totals.ledger = mTotals.ledger;
        std::copy(std::begin(mTotals.compacted), std::end(mTotals.compacted), arrays.totals.compacted);
        arrays.resizeVertices(arrays.vertexSlots());
        std::fill_n(arrays.thicknesses.data(), arrays.thicknesses.size(), 0.0);
        std::fill_n(arrays.humidities.data(), arrays.humidities.size(), 0.0f);
        for (std::size_t p = 0; p < points.size(); ++p) {
            const VertexId v = built->vertexOf[p];
            arrays.heights[v] = points[p].z;
            for (std::uint32_t l = 0; l < layers; ++l) {
                arrays.thicknesses[arrays.layerSlot(v, l)] = samples[p * layers + l].thickness;
                arrays.humidities[arrays.layerSlot(v, l)] = samples[p * layers + l].humidity;
            }
        }
        return restoreTin(std::move(arrays), domain, edges, LedgerStart::Kept);
    }

    static VertexId vertexAt(const Tin &tin, Point2 p)
    {
        if (!tin.domain().contains(p))
            return terrain::None;
        const Location location = tin.locate(p);
        return location.kind == Location::Kind::Vertex ? tin.arrays().vertex(location.corner) : terrain::None;
    }

    /// Every fence has void on one side of it: from one triangle, of which that is known, it follows for all.
    std::vector<TriangleId> voidsBetween(const TinArrays &tin,
                                         const std::set<std::pair<VertexId, VertexId>> &fences) const
    {
        std::vector<TriangleId> voids;
        if (fences.empty() && !mIsFirstVoid)
            return voids;
        std::vector<bool> isSeen(tin.triangleSlots());
        std::vector<std::pair<TriangleId, bool>> open{{triangleOf(tin.firstAround(0)), mIsFirstVoid}};
        isSeen[open[0].first] = true;
        while (!open.empty()) {
            const auto [t, isVoid] = open.back();
            open.pop_back();
            if (isVoid)
                voids.push_back(t);
            for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c) {
                const Corner o = tin.opposite(c);
                if (o == NoCorner || isSeen[triangleOf(o)])
                    continue;
                isSeen[triangleOf(o)] = true;
                const VertexId a = tin.vertex(next(c)), b = tin.vertex(previous(c));
                const bool isFence = tin.isConstrained(c) && fences.contains({std::min(a, b), std::max(a, b)});
                open.push_back({triangleOf(o), isVoid != isFence});
            }
        }
        return voids;
    }

    TerrainFile mFile;
    TinTotals mTotals;
    bool mIsFirstVoid;
    bool mHasEdits = false;
    std::map<PointKey, VertexState> mVertices;
    std::map<LineKey, std::pair<EditChanges::Line, bool>> mLines;
};

struct Frame
{
    std::uint8_t kind;
    std::uint64_t offset;
    std::span<const std::uint8_t> payload;
};

/// The frames that are whole, up to the first that is not.
Result<std::vector<Frame>> readFrames(std::span<const std::uint8_t> journal, std::uint64_t &tornBytes)
{
    const std::size_t known = std::min(journal.size(), sizeof Magic - 1);
    if (!std::equal(journal.begin(), journal.begin() + std::ptrdiff_t(known), Magic))
        return fail(ErrorCode::BadMagic, QT_TRANSLATE_NOOP("ErrorText", "recovery"));
    if (journal.size() < sizeof Magic)
        return fail(ErrorCode::Truncated, std::to_string(sizeof Magic), std::to_string(journal.size()));
    if (journal[sizeof Magic - 1] != Magic[sizeof Magic - 1])
        return fail(ErrorCode::UnsupportedVersion, std::to_string(journal[sizeof Magic - 1]), "1");
    std::vector<Frame> frames;
    std::size_t at = sizeof Magic;
    while (journal.size() - at >= FrameHeader) {
        ByteReader in(journal.subspan(at, FrameHeader));
        const std::uint32_t size = in.u32(), crc = in.u32();
        if (size == 0 || size > journal.size() - at - FrameHeader)
            break;
        const auto body = journal.subspan(at + FrameHeader, size);
        if (crcOf(body) != crc)
            break;
        frames.push_back({body[0], at + FrameHeader + 1, body.subspan(1)});
        at += FrameHeader + size;
    }
    tornBytes = journal.size() - at;
    return frames;
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

Result<RecoveredTerrain> replay(std::span<const std::uint8_t> journal, std::span<const std::uint8_t> saved,
                                std::uint64_t memoryLimit, const Progress &progress)
{
    std::uint64_t tornBytes = 0;
    const auto frames = readFrames(journal, tornBytes);
    if (!frames)
        return fail(frames.error());
    const Result<RecoveryBase> base = readBase(*frames);
    if (!base)
        return fail(base.error());
    std::optional<Replay> state;
    std::size_t next = 1;
    const auto openBytes = [&](std::span<const std::uint8_t> bytes) -> Result<void> {
        Result<TerrainFile> file = parseTerrain(bytes, memoryLimit, progress.part(0.0, 0.5));
        if (!file)
            return fail(file.error());
        state.emplace(std::move(*file));
        return {};
    };
    if (base->bytes > 0) {
        if (saved.size() != base->bytes || crcOf(saved) != base->crc)
            return fail(ErrorCode::ChecksumMismatch, QT_TRANSLATE_NOOP("ErrorText", "the saved file"));
        if (auto opened = openBytes(saved); !opened)
            return fail(opened.error());
    } else if (frames->size() < 2 || (*frames)[1].kind != SnapshotFrame) {
        return fail(ErrorCode::Truncated, "2", std::to_string(frames->size()));
    }
    for (; next < frames->size(); ++next) {
        const Frame &frame = (*frames)[next];
        if (progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        if (frame.kind == SnapshotFrame) {
            if (auto opened = openBytes(frame.payload); !opened)
                return fail(opened.error());
        } else if (frame.kind == EditFrame) {
            ByteReader in(frame.payload, frame.offset);
            if (!state->addEdit(in))
                return fail(in.error());
        } else if (frame.kind == SettingsFrame) {
            const QByteArray text(reinterpret_cast<const char *>(frame.payload.data()),
                                  qsizetype(frame.payload.size()));
            if (auto read = state->addSettings(QJsonDocument::fromJson(text).object()); !read)
                return fail(read.error());
        } else {
            return fail(ErrorCode::UnsupportedFeature, "frame " + std::to_string(frame.kind));
        }
    }
    Result<TerrainFile> file = state->finish();
    if (!file)
        return fail(file.error());
    return RecoveredTerrain{std::move(file->terrain), std::move(file->extras), base->path, frames->size() - 1,
                            tornBytes};
}

} // namespace

JournalFrame frameOfChanges(const EditChanges &changes, const TinArrays &tin)
{
    return {EditFrame, formatEdit(changes, tin)};
}

JournalFrame frameOfSettings(const Terrain &terrain)
{
    return {SettingsFrame, jsonBytes(settingsOf(terrain))};
}

Result<RecoveryBase> recoveryBaseOf(const QString &path)
{
    FileBuffer buffer;
    const auto bytes = buffer.load(path);
    if (!bytes)
        return fail(bytes.error());
    return RecoveryBase{path, crcOf(bytesOf(*bytes)), bytes->size()};
}

Result<std::unique_ptr<RecoveryJournal>> RecoveryJournal::begin(const QString &path, const RecoveryBase &base,
                                                                const Terrain &terrain)
{
    Bytes start(std::begin(Magic), std::end(Magic));
    const Bytes head = frameOf(
        BaseFrame, jsonBytes({{"path", base.path}, {"crc32", double(base.crc)}, {"bytes", double(base.bytes)}}));
    start.insert(start.end(), head.begin(), head.end());
    if (base.bytes == 0) {
        const Result<Bytes> snapshot = formatTerrain(terrain, {});
        if (!snapshot)
            return fail(snapshot.error());
        const Bytes frame = frameOf(SnapshotFrame, *snapshot);
        start.insert(start.end(), frame.begin(), frame.end());
    }
    if (auto saved = saveBytes(path, start); !saved)
        return fail(saved.error());
    std::unique_ptr<RecoveryJournal> journal(new RecoveryJournal(path));
    if (!journal->mFile.open(QIODevice::ReadWrite | QIODevice::Unbuffered) ||
        !journal->mFile.seek(qint64(start.size())))
        return failIn(journal->mFile, ErrorCode::CannotOpen);
    journal->mBytes = start.size();
    journal->mSinceSync.start();
    return journal;
}

Result<void> RecoveryJournal::append(std::uint8_t kind, std::span<const std::uint8_t> payload)
{
    const Bytes frame = frameOf(kind, payload);
    if (auto written = writeAll(mFile, frame); !written) {
        // Half a frame would hide all that come after it.
        (void)mFile.resize(qint64(mBytes));
        (void)mFile.seek(qint64(mBytes));
        return written;
    }
    mBytes += frame.size();
    mIsDirty = true;
    return {};
}

Result<void> RecoveryJournal::addEdit(const Edit &edit, const Terrain &terrain)
{
    if (edit.isEmpty())
        return {};
    const EditChanges changes = changesOf(edit, terrain.tin.arrays());
    if (!changes.changesLayers)
        return add(frameOfChanges(changes, terrain.tin.arrays()));
    // Every vertex has other layers now.
    const Result<Bytes> snapshot = formatTerrain(terrain, {});
    return snapshot ? append(SnapshotFrame, *snapshot) : fail(snapshot.error());
}

Result<void> RecoveryJournal::addSettings(const Terrain &terrain)
{
    return add(frameOfSettings(terrain));
}

Result<void> RecoveryJournal::sync(int interval)
{
    if (!mIsDirty || mSinceSync.elapsed() < interval)
        return {};
    if (::fdatasync(mFile.handle()) != 0)
        return failIn(mFile.fileName(), ErrorCode::CannotWrite, std::strerror(errno));
    mIsDirty = false;
    mSinceSync.restart();
    return {};
}

Result<RecoveredTerrain> replayJournal(std::span<const std::uint8_t> journal, std::span<const std::uint8_t> saved,
                                       std::uint64_t memoryLimit, const Progress &progress)
{
    return catchBadAlloc([&] { return replay(journal, saved, memoryLimit, progress); });
}

Result<RecoveryBase> journalBaseOf(const QString &journalPath)
{
    // The base is the first frame: a snapshot after it may be large, and is not wanted here.
    constexpr qint64 MostBytes = 64 * 1024;
    QFile file(journalPath);
    if (!file.exists())
        return failIn(journalPath, ErrorCode::NotFound);
    if (!file.open(QIODevice::ReadOnly))
        return failIn(file, ErrorCode::CannotOpen);
    const QByteArray bytes = file.read(MostBytes);
    std::uint64_t tornBytes = 0;
    auto base =
        readFrames({reinterpret_cast<const std::uint8_t *>(bytes.constData()), std::size_t(bytes.size())}, tornBytes)
            .and_then(readBase);
    return base ? base : failIn(journalPath, base.error());
}

Result<RecoveredTerrain> recoverTerrain(const QString &journalPath, const Progress &progress)
{
    FileBuffer journal, saved;
    const auto bytes = journal.load(journalPath);
    if (!bytes)
        return fail(bytes.error());
    std::uint64_t tornBytes = 0;
    const auto base = readFrames(bytesOf(*bytes), tornBytes).and_then(readBase);
    if (!base)
        return failIn(journalPath, base.error());
    std::string_view savedBytes;
    if (base->bytes > 0) {
        const auto loaded = saved.load(base->path);
        if (!loaded)
            return fail(loaded.error());
        savedBytes = *loaded;
    }
    const std::uint64_t memory = physicalMemory();
    auto recovered =
        replayJournal(bytesOf(*bytes), bytesOf(savedBytes), memory > 0 ? memory / 2 : std::uint64_t(8) << 30, progress);
    if (!recovered)
        return failIn(journalPath, recovered.error());
    return recovered;
}

} // namespace model::io
