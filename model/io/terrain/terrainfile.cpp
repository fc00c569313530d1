// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/terrainfile.h"

#include "model/base/memory.h"
#include "model/base/outofmemory.h"
#include "model/io/failure.h"
#include "model/io/filebuffer.h"
#include "model/io/savefile.h"
#include "model/io/terrain/ledgerfields.h"
#include "model/io/terrain/materialjson.h"
#include "model/io/terrain/tiles/packing.h"
#include "model/io/terrain/tiles/tilecodec.h"
#include "model/io/terrain/zipfile.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <cmath>

#include <zlib.h>

namespace model::io {

using namespace terrain;

namespace {

// Names of the entries. FORMAT.md, 2.
constexpr const char *MimeTypeEntry = "mimetype";
constexpr const char *ManifestEntry = "manifest.json";
constexpr const char *SurfaceEntry = "terrain/surface";
constexpr const char *ConstraintsEntry = "terrain/constraints";
constexpr const char *LedgerEntry = "terrain/ledger";
constexpr const char *MaterialsEntry = "materials.json";
constexpr const char *ToolsEntry = "tools.json";
constexpr const char *ThumbnailEntry = "thumbnail.png";

constexpr std::string_view MimeType = "application/vnd.sandreel.terrain";
constexpr const char *FormatName = "sandreel-terrain";
/// What a file may require of its readers that we know: nothing yet.
constexpr std::array<const char *, 0> KnownFeatures{};
constexpr const char *KnownKeys[] = {"format", "version", "requires", "optional", "origin",
                                     "unit",   "crs",     "step",     "entries"};

Bytes bytesOf(const QJsonDocument &document)
{
    const QByteArray text = document.toJson(QJsonDocument::Indented);
    return {text.begin(), text.end()};
}

QString crcOf(std::span<const std::uint8_t> bytes)
{
    uLong crc = crc32(0, nullptr, 0);
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t count = std::min<std::size_t>(bytes.size() - at, 1u << 30);
        crc = crc32(crc, bytes.data() + at, uInt(count));
        at += count;
    }
    return QStringLiteral("%1").arg(quint32(crc), 8, 16, QLatin1Char('0'));
}

// The constraints. FORMAT.md, 5.5.

Bytes formatConstraints(const TinArrays &tin, std::span<const VertexId> fileIds)
{
    std::vector<ConstrainedEdge> edges = constrainedEdges(tin);
    for (ConstrainedEdge &edge : edges) {
        edge.a = fileIds[edge.a];
        edge.b = fileIds[edge.b];
        if (edge.a > edge.b)
            std::swap(edge.a, edge.b);
    }
    std::sort(edges.begin(), edges.end(), [](const ConstrainedEdge &a, const ConstrainedEdge &b) {
        return std::tie(a.a, a.b, a.owner) < std::tie(b.a, b.b, b.owner);
    });
    ByteWriter raw;
    std::uint32_t before = 0;
    for (const ConstrainedEdge &edge : edges) {
        raw.varUint(edge.a - before);
        raw.varUint(edge.b - edge.a);
        raw.varUint(edge.owner);
        before = edge.a;
    }
    ByteWriter out;
    out.varUint(edges.size());
    out.varUint(raw.data().size());
    writePacked(out, raw.data());
    return out.take();
}

Result<std::vector<ConstrainedEdge>> parseConstraints(std::span<const std::uint8_t> bytes, std::uint64_t vertexCount)
{
    ByteReader in(bytes);
    const std::uint64_t count = in.varUint(), size = in.varUint();
    Bytes raw;
    constexpr std::uint64_t LeastBytes = 3, MostBytes = 15;
    if (!in.require(size >= count * LeastBytes && count <= size && size <= count * MostBytes, "constraint count", count,
                    "a third to a fifteenth of the bytes") ||
        !readPacked(in, std::size_t(size), raw) || !in.requireEnd())
        return fail(in.error());
    ByteReader edgesIn(raw);
    std::vector<ConstrainedEdge> edges(std::size_t{count});
    std::uint64_t a = 0;
    for (ConstrainedEdge &edge : edges) {
        a += edgesIn.varUint();
        const std::uint64_t b = a + edgesIn.varUint(), owner = edgesIn.varUint();
        if (!edgesIn.require(a < b && b < vertexCount, "constraint", b, "two different vertices") ||
            !edgesIn.require(owner < VoidOwner, "owner of a constraint", owner, "at most 4294967293"))
            return fail(edgesIn.error());
        edge = {std::uint32_t(a), std::uint32_t(b), std::uint32_t(owner)};
    }
    if (!edgesIn.requireEnd())
        return fail(edgesIn.error());
    return edges;
}

// The ledger. FORMAT.md, 5.6.

Bytes formatLedger(TinTotals totals)
{
    ByteWriter out;
    forEachLedgerField(totals, [&](double &value) { out.f64(value); });
    return out.take();
}

Result<void> parseLedger(std::span<const std::uint8_t> bytes, TinTotals &totals)
{
    ByteReader in(bytes);
    bool isFinite = true;
    forEachLedgerField(totals, [&](double &value) {
        value = in.f64();
        isFinite = isFinite && std::isfinite(value);
    });
    if (!in.requireEnd())
        return fail(in.error());
    if (!isFinite)
        return fail(ErrorCode::NonFinite, "volume");
    return {};
}

// The manifest. FORMAT.md, 3.

QJsonObject makeManifest(const Terrain &terrain, const TerrainExtras &extras, const std::vector<ZipEntry> &entries)
{
    QJsonObject list;
    for (const ZipEntry &entry : entries)
        list[QString::fromStdString(entry.name)] =
            QJsonObject{{"bytes", double(entry.bytes.size())}, {"crc32", crcOf(entry.bytes)}};
    QJsonObject manifest = extras.manifest;
    manifest["format"] = FormatName;
    manifest["version"] = QJsonArray{TerrainFormatMajor, TerrainFormatMinor};
    manifest["requires"] = QJsonArray{};
    manifest["optional"] = QJsonArray{};
    manifest["origin"] = QJsonArray{terrain.geoReference.originX, terrain.geoReference.originY};
    manifest["unit"] = QString::fromStdString(terrain.geoReference.unit);
    manifest["crs"] = QString::fromStdString(terrain.geoReference.crs);
    if (extras.step.x > 0 && extras.step.y > 0)
        manifest["step"] = QJsonArray{extras.step.x, extras.step.y};
    manifest["entries"] = list;
    return manifest;
}

tl::unexpected<Error> failManifest(const char *key, const QJsonValue &value, const char *expected)
{
    QByteArray text = QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact);
    text = text.mid(1, text.size() - 2).left(80);
    return fail(ErrorCode::BadValue, key, text.toStdString(), expected);
}

/// Two finite numbers.
bool readPair(const QJsonValue &value, double &x, double &y)
{
    const QJsonArray pair = value.toArray();
    if (pair.size() != 2 || !pair[0].isDouble() || !pair[1].isDouble())
        return false;
    x = pair[0].toDouble();
    y = pair[1].toDouble();
    return std::isfinite(x) && std::isfinite(y);
}

Result<QJsonObject> readObject(std::span<const std::uint8_t> bytes)
{
    QJsonParseError error;
    const auto document = QJsonDocument::fromJson(
        QByteArray::fromRawData(reinterpret_cast<const char *>(bytes.data()), qsizetype(bytes.size())), &error);
    if (error.error != QJsonParseError::NoError)
        return fail(fail(ErrorCode::SyntaxError, "JSON", error.errorString().toStdString())
                        .value()
                        .atByte(std::uint64_t(error.offset)));
    if (!document.isObject())
        return fail(ErrorCode::SyntaxError, QT_TRANSLATE_NOOP("ErrorText", "a JSON object"), "JSON");
    return document.object();
}

/// Which version it is, and whether we can read it; before anything else of the file is looked at.
Result<void> checkVersion(const QJsonObject &manifest, bool &isNewer)
{
    if (manifest["format"] != QLatin1String(FormatName))
        return failManifest("format", manifest["format"], FormatName);
    double major = 0, minor = 0;
    if (!readPair(manifest["version"], major, minor) || major < 1 || minor < 0)
        return failManifest("version", manifest["version"], "[major, minor]");
    const auto text = [](double a, double b) {
        return QStringLiteral("%1.%2").arg(a, 0, 'f', 0).arg(b, 0, 'f', 0).toStdString();
    };
    if (major > TerrainFormatMajor)
        return fail(ErrorCode::UnsupportedVersion, text(major, minor), text(TerrainFormatMajor, TerrainFormatMinor));
    isNewer = minor > TerrainFormatMinor;
    if (!manifest["requires"].isArray())
        return failManifest("requires", manifest["requires"], "a list");
    const QJsonArray features = manifest["requires"].toArray();
    for (const QJsonValue &feature : features)
        if (std::none_of(KnownFeatures.begin(), KnownFeatures.end(),
                         [&](const char *known) { return feature == QLatin1String(known); }))
            return fail(ErrorCode::UnsupportedFeature, feature.toString().left(80).toStdString());
    return {};
}

class TerrainParser
{
public:
    TerrainParser(std::vector<ZipEntry> entries, std::uint64_t memoryLimit)
        : mEntries(std::move(entries))
        , mMemoryLimit(memoryLimit)
    {}

    Result<TerrainFile> run(const Progress &progress)
    {
        if (mEntries.empty() || mEntries[0].name != MimeTypeEntry ||
            std::string_view(reinterpret_cast<const char *>(mEntries[0].bytes.data()), mEntries[0].bytes.size()) !=
                MimeType)
            return fail(ErrorCode::BadMagic, ".terrain");
        const Bytes *const manifestBytes = find(ManifestEntry);
        if (!manifestBytes)
            return fail(ErrorCode::MissingChunk, ManifestEntry);
        Result<QJsonObject> manifest = readObject(*manifestBytes);
        if (!manifest)
            return failAt(ManifestEntry, manifest.error());
        bool isNewer = false;
        if (auto checked = checkVersion(*manifest, isNewer).and_then([&] { return checkEntries(*manifest); }); !checked)
            return fail(checked.error());
        Result<Tin> tin = readTin(progress);
        if (!tin)
            return fail(tin.error());
        TerrainFile file{Terrain(std::move(*tin)), {}, isNewer};
        if (auto read = readManifest(*manifest, file).and_then([&] { return readMaterials(file.terrain); }); !read)
            return fail(read.error());
        if (const Bytes *const tools = find(ToolsEntry)) {
            Result<QJsonObject> object = readObject(*tools);
            if (!object)
                return failAt(ToolsEntry, object.error());
            file.extras.tools = *object;
        }
        if (const Bytes *const thumbnail = find(ThumbnailEntry))
            file.extras.thumbnail = *thumbnail;
        for (ZipEntry &entry : mEntries)
            if (!isKnown(entry.name))
                file.extras.others.push_back({std::move(entry.name), std::move(entry.bytes)});
        return file;
    }

private:
    const Bytes *find(std::string_view name) const
    {
        const auto found =
            std::find_if(mEntries.begin(), mEntries.end(), [&](const auto &e) { return e.name == name; });
        return found == mEntries.end() ? nullptr : &found->bytes;
    }
    static bool isKnown(std::string_view name)
    {
        for (const char *known : {MimeTypeEntry, ManifestEntry, SurfaceEntry, ConstraintsEntry, LedgerEntry,
                                  MaterialsEntry, ToolsEntry, ThumbnailEntry})
            if (name == known)
                return true;
        return false;
    }
    /// Bytes in errors are those of the entry, which is named until openTerrain() names the file.
    static tl::unexpected<Error> failAt(const char *entry, Error error) { return fail(std::move(error).in(entry)); }

    Result<void> checkEntries(const QJsonObject &manifest) const
    {
        const QJsonObject entries = manifest["entries"].toObject();
        for (auto it = entries.begin(); it != entries.end(); ++it) {
            const std::string name = it.key().toStdString();
            const Bytes *const bytes = find(name);
            if (!bytes)
                return fail(ErrorCode::MissingChunk, name);
            const QJsonObject says = it.value().toObject();
            if (says["bytes"].toDouble(-1) != double(bytes->size()) || says["crc32"].toString() != crcOf(*bytes))
                return fail(ErrorCode::ChecksumMismatch, name);
        }
        for (const char *needed : {SurfaceEntry, ConstraintsEntry, LedgerEntry, MaterialsEntry})
            if (!find(needed) || !entries.contains(QLatin1String(needed)))
                return fail(ErrorCode::MissingChunk, needed);
        return {};
    }

    Result<Tin> readTin(const Progress &progress) const
    {
        Result<DecodedSurface> surface = decodeSurface(*find(SurfaceEntry), mMemoryLimit, progress.part(0.0, 0.5));
        if (!surface)
            return failAt(SurfaceEntry, surface.error());
        const auto edges = parseConstraints(*find(ConstraintsEntry), surface->arrays.points.size());
        if (!edges)
            return failAt(ConstraintsEntry, edges.error());
        if (auto ledger = parseLedger(*find(LedgerEntry), surface->arrays.totals); !ledger)
            return failAt(LedgerEntry, ledger.error());
        return restoreTin(std::move(surface->arrays), surface->domain, *edges, LedgerStart::Kept);
    }

    static Result<void> readManifest(const QJsonObject &manifest, TerrainFile &file)
    {
        GeoReference &place = file.terrain.geoReference;
        if (!readPair(manifest["origin"], place.originX, place.originY))
            return failManifest("origin", manifest["origin"], "two numbers");
        if (!manifest["unit"].isString())
            return failManifest("unit", manifest["unit"], "a text");
        if (!manifest["crs"].isString())
            return failManifest("crs", manifest["crs"], "a text");
        place.unit = manifest["unit"].toString().toStdString();
        place.crs = manifest["crs"].toString().toStdString();
        Point2 &step = file.extras.step;
        if (manifest.contains("step") &&
            (!readPair(manifest["step"], step.x, step.y) || !(step.x > 0) || !(step.y > 0)))
            return failManifest("step", manifest["step"], "two numbers above zero");
        file.extras.manifest = manifest;
        for (const char *key : KnownKeys)
            file.extras.manifest.remove(QLatin1String(key));
        return {};
    }

    Result<void> readMaterials(Terrain &terrain) const
    {
        const Result<QJsonObject> json = readObject(*find(MaterialsEntry));
        if (!json)
            return failAt(MaterialsEntry, json.error());
        const QJsonArray list = json->value("materials").toArray();
        if (std::size_t(list.size()) > LargestMaterialList)
            return fail(ErrorCode::LimitExceeded, "number of materials", std::to_string(list.size()),
                        std::to_string(LargestMaterialList));
        for (const QJsonValue &entry : list) {
            Material material;
            if (auto read = readMaterial(entry.toObject(), material); !read)
                return failAt(MaterialsEntry, read.error());
            terrain.materials.push_back(std::move(material));
        }
        const LayerTable &layers = terrain.tin.arrays().totals.layers;
        for (std::uint32_t l = 0; l < layers.count; ++l)
            if (layers.materials[l] >= terrain.materials.size())
                return fail(ErrorCode::BadValue, "material of layer " + std::to_string(l),
                            std::to_string(layers.materials[l]), "below " + std::to_string(terrain.materials.size()));
        return {};
    }

    std::vector<ZipEntry> mEntries;
    const std::uint64_t mMemoryLimit;
};

} // namespace

Result<Bytes> formatTerrain(const Terrain &terrain, const TerrainExtras &extras, std::vector<VertexId> *fileIds,
                            const Progress &progress)
{
    std::vector<VertexId> ids;
    Result<Bytes> surface =
        encodeSurface(terrain.tin.arrays(), terrain.tin.domain(), extras.step, &ids, progress.part(0.0, 0.8));
    if (!surface)
        return surface;
    QJsonArray materials;
    for (const Material &material : terrain.materials)
        materials.append(jsonOf(material));
    std::vector<ZipEntry> entries;
    entries.push_back({SurfaceEntry, std::move(*surface), false});
    entries.push_back({ConstraintsEntry, formatConstraints(terrain.tin.arrays(), ids), false});
    entries.push_back({LedgerEntry, formatLedger(terrain.tin.arrays().totals), false});
    entries.push_back({MaterialsEntry, bytesOf(QJsonDocument(QJsonObject{{"materials", materials}})), true});
    if (!extras.tools.isEmpty())
        entries.push_back({ToolsEntry, bytesOf(QJsonDocument(extras.tools)), true});
    if (!extras.thumbnail.empty())
        entries.push_back({ThumbnailEntry, extras.thumbnail, false});
    for (const ForeignEntry &other : extras.others)
        entries.push_back({other.name, other.bytes, true});
    const Bytes manifest = bytesOf(QJsonDocument(makeManifest(terrain, extras, entries)));
    entries.insert(entries.begin(), {ManifestEntry, manifest, true});
    entries.insert(entries.begin(), {MimeTypeEntry, Bytes(MimeType.begin(), MimeType.end()), false});
    if (fileIds)
        *fileIds = std::move(ids);
    return writeZip(entries);
}

Result<TerrainFile> parseTerrain(std::span<const std::uint8_t> bytes, std::uint64_t memoryLimit,
                                 const Progress &progress)
{
    return catchBadAlloc([&]() -> Result<TerrainFile> {
        Result<std::vector<ZipEntry>> entries = readZip(bytes, memoryLimit);
        if (!entries)
            return fail(entries.error());
        return TerrainParser(std::move(*entries), memoryLimit).run(progress);
    });
}

Result<void> saveTerrain(const QString &path, const Terrain &terrain, const TerrainExtras &extras,
                         const Progress &progress)
{
    SaveFile file(path);
    if (auto opened = file.open(); !opened)
        return opened;
    const Result<Bytes> bytes = formatTerrain(terrain, extras, nullptr, progress);
    if (!bytes)
        return failIn(path, bytes.error());
    return file.write(*bytes).and_then([&] { return file.commit(); });
}

Result<TerrainFile> openTerrain(const QString &path, const Progress &progress)
{
    FileBuffer buffer;
    const auto bytes = buffer.load(path, progress.part(0.0, 0.1));
    if (!bytes)
        return fail(bytes.error());
    const std::uint64_t memory = physicalMemory();
    Result<TerrainFile> file = parseTerrain({reinterpret_cast<const std::uint8_t *>(bytes->data()), bytes->size()},
                                            memory > 0 ? memory / 2 : std::uint64_t(8) << 30, progress.part(0.1, 1.0));
    if (!file) {
        Error error = file.error();
        // Which part of the file it was is for those who look into it; people know the file.
        error.file.clear();
        return failIn(path, std::move(error));
    }
    return file;
}

} // namespace model::io
