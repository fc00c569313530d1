// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/outofmemory.h"
#include "model/io/terrain/ledgerfields.h"
#include "model/io/terrain/maskjson.h"
#include "model/io/terrain/materialjson.h"
#include "model/io/terrain/recovery/journalframes.h"
#include "model/terrain/tin/build/restoretin.h"
#include "model/terrain/tin/tinedit.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <bit>
#include <map>
#include <optional>
#include <set>

namespace model::io {

using namespace terrain;

namespace {

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

    const QJsonObject &tools() const { return mFile.extras.tools; }
    /// What it protects is looked at when it is used: the terrain is worth more than a mask.
    void addMask(const QJsonObject &json)
    {
        if (json.isEmpty())
            mFile.extras.tools.remove(MaskKey);
        else
            mFile.extras.tools[MaskKey] = json;
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

QJsonObject jsonOfFrame(const Frame &frame)
{
    const QByteArray text(reinterpret_cast<const char *>(frame.payload.data()), qsizetype(frame.payload.size()));
    return QJsonDocument::fromJson(text).object();
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
        if (state) // a snapshot is of the terrain alone
            file->extras.tools = state->tools();
        state.emplace(std::move(*file));
        return {};
    };
    if (base->bytes > 0) {
        if (saved.size() != base->bytes || journalCrcOf(saved) != base->crc)
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
            if (auto read = state->addSettings(jsonOfFrame(frame)); !read)
                return fail(read.error());
        } else if (frame.kind == MaskFrame) {
            state->addMask(jsonOfFrame(frame));
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

Result<RecoveredTerrain> replayJournal(std::span<const std::uint8_t> journal, std::span<const std::uint8_t> saved,
                                       std::uint64_t memoryLimit, const Progress &progress)
{
    return catchBadAlloc([&] { return replay(journal, saved, memoryLimit, progress); });
}

} // namespace model::io
