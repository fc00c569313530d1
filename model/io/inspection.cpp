// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/inspection.h"

#include "model/mesh/analysis/selfintersections.h"

#include <QJsonArray>

namespace model::io {

namespace {

template <class List>
QJsonArray numbers(const List &list)
{
    QJsonArray array;
    for (const auto value : list)
        array.append(double(value));
    return array;
}

template <class Number>
QJsonValue valueOrNull(const std::optional<Number> &value)
{
    return value ? QJsonValue(double(*value)) : QJsonValue();
}

QJsonObject componentJson(const ComponentReport &component)
{
    return {{"vertices", double(component.vertices)},
            {"edges", double(component.edges)},
            {"faces", double(component.faces)},
            {"euler", double(component.euler())},
            {"genus", valueOrNull(component.genus)},
            {"boundary_loops", double(component.boundaryLoops)},
            {"boundary_edges", double(component.boundaryEdges)},
            {"orientable", component.isOrientable},
            {"manifold", component.isManifold},
            {"inconsistent_edges", double(component.inconsistentEdges)},
            {"area", component.area},
            {"volume", valueOrNull(component.volume)},
            {"first_face", double(component.firstFace)}};
}

QJsonObject holeJson(const HoleReport &hole)
{
    return {{"component", double(hole.component)},
            {"edges", double(hole.loop.sides.size())},
            {"length", hole.length},
            {"area", hole.area},
            {"closed", hole.loop.isClosed},
            {"vertices", numbers(hole.loop.vertices)}};
}

QJsonObject handleJson(const HandleReport &handle)
{
    QJsonArray loops;
    for (const HandleReport::Loop &loop : handle.loops)
        loops.append(QJsonObject{
            {"edges", double(loop.vertices.size())}, {"length", loop.length}, {"vertices", numbers(loop.vertices)}});
    return {{"component", double(handle.component)}, {"loops", loops}};
}

QJsonObject problemJson(const std::vector<ProblemIds> &list)
{
    QJsonArray ids;
    for (const ProblemIds &at : list)
        ids.append(at[1] == NoId ? QJsonValue(double(at[0])) : QJsonValue(numbers(at)));
    return {{"count", double(list.size())}, {"ids", ids}};
}

QJsonObject walkJson(const codec::WalkStatistics &walk)
{
    QJsonObject symbols;
    for (const codec::Clers symbol :
         {codec::Clers::C, codec::Clers::L, codec::Clers::E, codec::Clers::R, codec::Clers::S})
        symbols[QString(QLatin1Char("CSRLE"[int(symbol)]))] = double(walk.symbolCounts[std::size_t(symbol)]);
    QJsonArray holes;
    for (const codec::WalkStatistics::Hole &hole : walk.holes)
        holes.append(QJsonObject{{"edges", double(hole.length)}, {"triangle", valueOrNull(hole.triangle)}});
    return {{"symbols", symbols},
            {"splits", numbers(walk.splits)},
            {"handle_splits", numbers(walk.handleSplits)},
            {"holes", holes},
            {"components", double(walk.components)},
            {"copied_vertices", double(walk.copies)},
            {"bytes", double(walk.bytes)},
            {"bits_per_triangle", walk.bitsPerTriangle}};
}

QString text(double value)
{
    return QString::number(value, 'g', 9);
}
QString text(std::uint32_t value)
{
    return QString::number(value);
}
template <class Number>
QString textOrNothing(const std::optional<Number> &value)
{
    return value ? text(*value) : QString();
}
QString yesNo(bool value)
{
    return value ? QStringLiteral("yes") : QStringLiteral("no");
}
QString joined(const std::vector<std::uint32_t> &ids)
{
    QStringList texts;
    for (const std::uint32_t id : ids)
        texts << text(id);
    return texts.join(' ');
}

} // namespace

Result<Inspection> inspectMesh(const Faces &faces, std::span<const Vec3f> positions, const InspectionOptions &options,
                               const Progress &progress)
{
    const double end = options.selfIntersections ? 0.5 : 1;
    Inspection inspection;
    auto report = analyseMesh(faces, positions, progress.part(0, 0.3 * end));
    if (!report)
        return fail(report.error());
    inspection.report = std::move(*report);
    auto handles = findHandles(faces, positions, inspection.report, progress.part(0.3 * end, 0.8 * end));
    if (!handles)
        return fail(handles.error());
    inspection.handles = std::move(*handles);
    auto walk = codec::walkStatistics(fans(faces), progress.part(0.8 * end, end));
    if (!walk)
        return fail(walk.error());
    inspection.walk = std::move(*walk);
    if (options.selfIntersections) {
        auto pairs = findSelfIntersections(faces, positions, progress.part(end, 1));
        if (!pairs)
            return fail(pairs.error());
        inspection.report.problems[std::size_t(ProblemKind::SelfIntersection)] = std::move(*pairs);
        inspection.hasSelfIntersections = true;
    }
    return inspection;
}

QJsonObject inspectionJson(const Inspection &inspection)
{
    const MeshReport &report = inspection.report;
    QJsonArray components, holes, handles;
    for (const ComponentReport &component : report.components)
        components.append(componentJson(component));
    for (const HoleReport &hole : report.holes)
        holes.append(holeJson(hole));
    for (const HandleReport &handle : inspection.handles)
        handles.append(handleJson(handle));
    QJsonObject problems;
    for (std::size_t i = 0; i < ProblemKindCount; ++i) {
        const auto kind = ProblemKind(i);
        QJsonObject problem = problemJson(report.of(kind));
        if (kind == ProblemKind::SelfIntersection && !inspection.hasSelfIntersections)
            problem["count"] = QJsonValue(); // not looked for
        problems[QLatin1String(problemKey(kind))] = problem;
    }
    return {{"vertices", double(report.vertices)},
            {"edges", double(report.edges)},
            {"faces", double(report.faces)},
            {"euler", double(report.euler())},
            {"genus", valueOrNull(report.genus())},
            {"manifold", report.isManifold()},
            {"orientable", report.isOrientable()},
            {"components", components},
            {"holes", holes},
            {"handles", handles},
            {"problems", problems},
            {"edgebreaker", walkJson(inspection.walk)}};
}

QStringList inspectionCsv(const Inspection &inspection, InspectionTable table)
{
    const MeshReport &report = inspection.report;
    QStringList lines;
    const auto row = [&](const QStringList &fields) { lines << fields.join(','); };
    switch (table) {
    case InspectionTable::Components:
        row({"component", "vertices", "edges", "faces", "euler", "genus", "boundary_loops", "boundary_edges",
             "orientable", "manifold", "area", "volume", "first_face"});
        for (std::uint32_t i = 0; i < report.components.size(); ++i) {
            const ComponentReport &c = report.components[i];
            row({text(i), text(c.vertices), text(c.edges), text(c.faces), QString::number(c.euler()),
                 textOrNothing(c.genus), text(c.boundaryLoops), text(c.boundaryEdges), yesNo(c.isOrientable),
                 yesNo(c.isManifold), text(c.area), textOrNothing(c.volume), text(c.firstFace)});
        }
        break;
    case InspectionTable::Holes:
        row({"hole", "component", "edges", "length", "area", "closed", "vertices"});
        for (std::uint32_t i = 0; i < report.holes.size(); ++i) {
            const HoleReport &hole = report.holes[i];
            row({text(i), text(hole.component), text(std::uint32_t(hole.loop.sides.size())), text(hole.length),
                 text(hole.area), yesNo(hole.loop.isClosed), joined(hole.loop.vertices)});
        }
        break;
    case InspectionTable::Handles:
        row({"handle", "component", "loop", "edges", "length", "vertices"});
        for (std::uint32_t i = 0; i < inspection.handles.size(); ++i)
            for (std::uint32_t k = 0; k < 2; ++k) {
                const HandleReport::Loop &loop = inspection.handles[i].loops[k];
                row({text(i), text(inspection.handles[i].component), text(k), text(std::uint32_t(loop.vertices.size())),
                     text(loop.length), joined(loop.vertices)});
            }
        break;
    case InspectionTable::Problems:
        row({"problem", "id", "other_id"});
        for (std::size_t i = 0; i < ProblemKindCount; ++i)
            for (const ProblemIds &at : report.problems[i])
                row({QLatin1String(problemKey(ProblemKind(i))), text(at[0]), at[1] == NoId ? QString() : text(at[1])});
        break;
    }
    return lines;
}

} // namespace model::io
