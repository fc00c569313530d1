// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/io/terrain/terrains.h"

#include "model/terrain/tin/tinedit.h"

#include <QFile>

#include <algorithm>
#include <vector>

namespace tests {

using namespace model::terrain;

Terrain specimenTerrain(Ground ground, unsigned seed, int points)
{
    PointSource source(ground, seed);
    auto built = buildTin(source.points(std::size_t(points)), source.domain());
    Terrain terrain(std::move(built->tin));
    terrain.materials = {material(MaterialPreset::DrySand), material(MaterialPreset::Snow),
                         material(MaterialPreset::Mud)};
    terrain.materials[2].name = "Bahno \xc4\x8d. 1";
    terrain.geoReference = {5'500'000.123, -1'100'000.25, "LOCAL_CS[\"somewhere\"]", "metre"};
    TinEdit edit(terrain.tin);
    edit.addLayer(0, 2);
    edit.addLayer(1, 1);
    for (VertexId v = 0; v < terrain.tin.arrays().vertexSlots(); ++v) {
        edit.setLayer(v, 0, {source.uniform(0, 2), float(source.uniform(0, 1))});
        edit.setLayer(v, 1, {v % 3 ? 0.5 : source.uniform(0, 1), 0.25f});
    }
    for (int step = 0; step < points; ++step)
        randomStep(edit, source);
    std::vector<TriangleId> some;
    for (TriangleId t = 0; t < terrain.tin.arrays().triangleSlots() && some.size() < 20; ++t)
        if (terrain.tin.arrays().isTriangle(t))
            some.push_back(t);
    edit.setVoid(some, true);
    edit.commit();
    return terrain;
}

Terrain plainTerrain()
{
    return Terrain(Tin({{0, 0}, {10, 10}}));
}

QByteArray describe(const Terrain &terrain)
{
    const TinArrays &tin = terrain.tin.arrays();
    const auto number = [](double value) {
        return QByteArray::number(quint64(std::bit_cast<std::uint64_t>(value)), 16);
    };
    const auto point = [&](Point2 p) { return number(p.x) + ',' + number(p.y); };
    std::vector<QByteArray> lines;
    for (VertexId v = 0; v < tin.vertexSlots(); ++v) {
        if (!tin.isVertex(v))
            continue;
        QByteArray line = "vertex " + point(tin.points[v]) + ' ' + number(tin.heights[v]);
        for (std::uint32_t l = 0; l < tin.layerCount(); ++l)
            line += ' ' + number(tin.sample(v, l).thickness) + ' ' + number(double(tin.sample(v, l).humidity));
        lines.push_back(line);
    }
    for (TriangleId t = 0; t < tin.triangleSlots(); ++t) {
        if (!tin.isTriangle(t))
            continue;
        std::vector<QByteArray> corners;
        for (Corner c = cornerOf(t, 0); c <= cornerOf(t, 2); ++c)
            corners.push_back(point(tin.pointAt(c)));
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        lines.push_back((tin.isVoid(t) ? "void " : "triangle ") + corners[0] + ' ' + corners[1] + ' ' + corners[2]);
    }
    for (const ConstraintRecord &record : tin.records.values())
        if (record.a != None) {
            QByteArray a = point(tin.points[record.a]), b = point(tin.points[record.b]);
            lines.push_back("line " + std::min(a, b) + ' ' + std::max(a, b) + ' ' + QByteArray::number(record.owner));
        }
    const Ledger &ledger = tin.totals.ledger;
    QByteArray line = "ledger " + number(ledger.start);
    for (const CompensatedSum &sum : {ledger.added, ledger.removed, ledger.moved, ledger.kept, ledger.pressed})
        line += ' ' + number(sum.sum) + ' ' + number(sum.lost);
    for (std::uint32_t l = 0; l < tin.layerCount(); ++l)
        line += "\nlayer " + QByteArray::number(tin.totals.layers.materials[l]) + ' ' +
                number(tin.totals.compacted[l].sum) + ' ' + number(tin.totals.compacted[l].lost);
    lines.push_back(line);
    for (const Material &m : terrain.materials) {
        line = "material " + QByteArray::fromStdString(m.name);
        for (const double value : {m.humidity, m.bulkDensity, m.compressibility, m.insideSlope, m.outsideSlope,
                                   m.roughness, m.liquidity, m.compression})
            line += ' ' + number(value);
        for (const CriticalAngle &angle : m.criticalAngles)
            line += ' ' + number(angle.humidity) + ':' + number(angle.degrees);
        lines.push_back(line);
    }
    const GeoReference &place = terrain.geoReference;
    lines.push_back("place " + number(place.originX) + ' ' + number(place.originY) + ' ' +
                    QByteArray::fromStdString(place.crs + ' ' + place.unit));
    std::sort(lines.begin(), lines.end());
    QByteArray text;
    for (const QByteArray &each : lines)
        text += each + '\n';
    return text;
}

QByteArray readFile(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void writeFile(const QString &path, const QByteArray &bytes)
{
    QFile file(path);
    if (file.open(QIODevice::WriteOnly))
        file.write(bytes);
}

} // namespace tests
