// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/terraindocument.h"

#include "model/base/digest.h"

#include <algorithm>
#include <utility>

namespace model {

using namespace terrain;

namespace {

std::uint64_t digestOfPoint(Point2 p, std::uint64_t seed)
{
    const double numbers[] = {p.x, p.y};
    return digestOfArray(std::span<const double>(numbers), seed);
}

std::uint64_t digestOfText(const std::string &text, std::uint64_t seed)
{
    return digestOfArray(std::span<const char>(text), seed);
}

std::uint64_t digestOfVertex(const TinArrays &tin, VertexId v)
{
    constexpr std::uint64_t VertexSeed = 1;
    std::uint64_t digest =
        digestOfArray(std::span<const double>(&tin.heights[v], 1), digestOfPoint(tin.points[v], VertexSeed));
    const std::uint32_t layers = tin.layerCount();
    if (layers == 0)
        return digest;
    digest = digestOfArray(std::span<const double>(tin.thicknesses.data() + tin.layerSlot(v, 0), layers), digest);
    return digestOfArray(std::span<const float>(tin.humidities.data() + tin.layerSlot(v, 0), layers), digest);
}

std::uint64_t digestOfRecord(const TinArrays &tin, const ConstraintRecord &record)
{
    constexpr std::uint64_t RecordSeed = 2;
    Point2 a = tin.points[record.a], b = tin.points[record.b];
    if (std::pair(b.x, b.y) < std::pair(a.x, a.y))
        std::swap(a, b);
    return digestOfArray(std::span<const OwnerId>(&record.owner, 1), digestOfPoint(b, digestOfPoint(a, RecordSeed)));
}

std::uint64_t digestOfVoid(const TinArrays &tin, TriangleId t)
{
    constexpr std::uint64_t VoidSeed = 3;
    // From the least point on, as the order of the three is no part of a triangle.
    Corner first = cornerOf(t, 0);
    for (const Corner c : {cornerOf(t, 1), cornerOf(t, 2)}) {
        const Point2 p = tin.pointAt(c), least = tin.pointAt(first);
        if (std::pair(p.x, p.y) < std::pair(least.x, least.y))
            first = c;
    }
    return digestOfPoint(tin.pointAt(previous(first)),
                         digestOfPoint(tin.pointAt(next(first)), digestOfPoint(tin.pointAt(first), VoidSeed)));
}

/// Of everything that has no order: a sum does not depend on one.
std::uint64_t digestOfTin(const Tin &surface)
{
    const TinArrays &tin = surface.arrays();
    std::uint64_t sum = 0;
    for (VertexId v = 0; v < tin.vertexSlots(); ++v)
        if (tin.isVertex(v))
            sum += digestOfVertex(tin, v);
    for (const ConstraintRecord &record : tin.records.values())
        if (record.a != terrain::None)
            sum += digestOfRecord(tin, record);
    for (TriangleId t = 0; t < tin.triangleSlots(); ++t)
        if (tin.isTriangle(t) && tin.isVoid(t))
            sum += digestOfVoid(tin, t);
    const TinTotals &totals = tin.totals;
    std::uint64_t digest = digestOfArray(std::span<const std::uint64_t>(&sum, 1));
    const Rectangle domain = surface.domain();
    digest = digestOfPoint(domain.high, digestOfPoint(domain.low, digest));
    digest = digestOfArray(std::span<const std::uint8_t>(totals.layers.materials, totals.layers.count), digest);
    const Ledger &ledger = totals.ledger;
    digest = digestOfArray(std::span<const double>(&ledger.start, 1), digest);
    for (const CompensatedSum *const entry :
         {&ledger.added, &ledger.removed, &ledger.moved, &ledger.kept, &ledger.pressed})
        digest = digestOfArray(std::span<const CompensatedSum>(entry, 1), digest);
    return digestOfArray(std::span<const CompensatedSum>(totals.compacted, totals.layers.count), digest);
}

} // namespace

std::uint64_t savedFingerprint(const Terrain &terrain)
{
    std::uint64_t digest = digestOfTin(terrain.tin);
    for (const Material &m : terrain.materials) {
        const double numbers[] = {m.humidity,     m.bulkDensity, m.compressibility, m.insideSlope,
                                  m.outsideSlope, m.roughness,   m.liquidity,       m.compression};
        digest = digestOfArray(std::span<const double>(numbers), digestOfText(m.name, digest));
        digest = digestOfArray(std::span<const CriticalAngle>(m.criticalAngles), digest);
    }
    const GeoReference &place = terrain.geoReference;
    return digestOfText(place.unit, digestOfText(place.crs, digestOfPoint({place.originX, place.originY}, digest)));
}

TerrainDocument::TerrainDocument(Terrain terrain, QObject *parent)
    : QObject(parent)
    , mState(new State{std::move(terrain), {}})
{}

void TerrainDocument::notify(const Edit &edit)
{
    if (!edit.isEmpty())
        emit changed(SurfaceChanged{&edit});
}

void TerrainDocument::swap(Edit &edit)
{
    {
        const std::lock_guard lock(mState->changing);
        mState->terrain.tin.swap(edit);
    }
    notify(edit);
}

std::vector<Material> TerrainDocument::setMaterials(std::vector<Material> materials)
{
    if (materials == mState->terrain.materials)
        return materials;
    std::unique_lock lock(mState->changing);
    std::vector<Material> old = std::exchange(mState->terrain.materials, std::move(materials));
    lock.unlock();
    emit changed(MaterialsChanged{});
    return old;
}

GeoReference TerrainDocument::setGeoReference(GeoReference geoReference)
{
    if (geoReference == mState->terrain.geoReference)
        return geoReference;
    std::unique_lock lock(mState->changing);
    GeoReference old = std::exchange(mState->terrain.geoReference, std::move(geoReference));
    lock.unlock();
    emit changed(GeoReferenceChanged{});
    return old;
}

std::shared_ptr<const Terrain> TerrainDocument::snapshot() const
{
    return std::make_shared<const Terrain>(terrain());
}

std::function<Terrain()> TerrainDocument::copier() const
{
    return [state = mState] {
        const std::lock_guard lock(state->changing);
        return state->terrain;
    };
}

std::uint64_t TerrainDocument::fingerprint() const
{
    return savedFingerprint(terrain());
}

} // namespace model
