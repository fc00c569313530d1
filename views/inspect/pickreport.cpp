// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/inspect/pickreport.h"

#include "model/geometry/vec3d.h"

#include "views/inspect/numbers.h"
#include "views/inspect/problems.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace views {

namespace {

using Rows = std::vector<std::pair<QString, QString>>;

QString text(const char *source)
{
    return QCoreApplication::translate("PickReport", source);
}

QString placeText(const model::Vec3f &p)
{
    return QStringLiteral("%1; %2; %3")
        .arg(shortNumber(double(p.x)), shortNumber(double(p.y)), shortNumber(double(p.z)));
}

QString degrees(double radians)
{
    return QLocale().toString(radians * 180 / std::numbers::pi, 'f', 1) + QStringLiteral("°");
}

/// Twice the area, along the normal.
model::Vec3d areaVector(const model::PolygonMesh &mesh, std::uint32_t face)
{
    const auto corners = mesh.faces.face(face);
    model::Vec3d sum;
    for (std::size_t i = 2; i < corners.size(); ++i)
        sum = sum + cross(model::Vec3d(mesh.positions[corners[i - 1]] - mesh.positions[corners[0]]),
                          model::Vec3d(mesh.positions[corners[i]] - mesh.positions[corners[0]]));
    return sum;
}

double lengthOf(const model::Vec3d &v)
{
    return std::sqrt(dot(v, v));
}

std::vector<std::uint32_t> facesAt(const model::Faces &faces, std::uint32_t a, std::uint32_t b)
{
    std::vector<std::uint32_t> result;
    for (std::uint32_t f = 0; f < faces.faceCount(); ++f) {
        const auto corners = faces.face(f);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const std::uint32_t from = corners[i], to = corners[(i + 1) % corners.size()];
            if ((a == b && from == a) || (a != b && ((from == a && to == b) || (from == b && to == a)))) {
                result.push_back(f);
                break;
            }
        }
    }
    return result;
}

QString listText(const std::vector<std::uint32_t> &numbers)
{
    constexpr std::size_t Most = 12;
    QStringList parts;
    for (std::size_t i = 0; i < std::min(Most, numbers.size()); ++i)
        parts << QString::number(numbers[i]);
    if (numbers.size() > Most)
        parts << QStringLiteral("…");
    return parts.join(QStringLiteral(", "));
}

void addFields(Rows &rows, Inspection &inspection, std::uint32_t vertex)
{
    // Those of an animation take long: only what somebody has asked for.
    for (const FieldId id : inspection.fields())
        if (const std::vector<float> *values =
                id.kind < FieldKind::CodecError ? inspection.field(id) : inspection.knownField(id)) {
            const float value = (*values)[vertex];
            rows.emplace_back(fieldTitle(id), std::isfinite(value) ? shortNumber(double(value))
                                                                   : text(QT_TRANSLATE_NOOP("PickReport", "none")));
        }
}

/// The component of a face, and what is wrong with what is picked.
void addReport(Rows &rows, const Picked &picked, const Inspection &inspection)
{
    const auto &report = inspection.report();
    if (!report)
        return;
    rows.emplace_back(text(QT_TRANSLATE_NOOP("PickReport", "Component")),
                      QString::number(report->componentOfFace[picked.face]));
    const auto isAtFault = [&](const Problem &problem) {
        const auto &[first, second] = problem.ids;
        const auto [a, b] = std::minmax(picked.vertices[0], picked.vertices[1]);
        const bool isEdgeKind =
            problem.kind == model::ProblemKind::NonManifoldEdge || problem.kind == model::ProblemKind::InconsistentEdge;
        switch (picked.mode) {
        case PickMode::Face:
            return namesOf(problem.kind) == IdsName::Faces && (first == picked.face || second == picked.face);
        case PickMode::Edge:
            return isEdgeKind && first == a && second == b;
        case PickMode::Vertex:
            break;
        }
        return namesOf(problem.kind) == IdsName::Vertices && !isEdgeKind && (first == a || second == a);
    };
    for (const Problem &problem : inspection.problems())
        if (isAtFault(problem))
            rows.emplace_back(text(QT_TRANSLATE_NOOP("PickReport", "Problem")), problemTitle(problem.kind));
}

void describeFace(Rows &rows, const Picked &picked, const model::PolygonMesh &mesh)
{
    const auto corners = mesh.faces.face(picked.face);
    rows.emplace_back(text(QT_TRANSLATE_NOOP("PickReport", "Face")), QString::number(picked.face));
    rows.emplace_back(text(QT_TRANSLATE_NOOP("PickReport", "Vertices")), listText({corners.begin(), corners.end()}));
    const model::Vec3d vector = areaVector(mesh, picked.face);
    const double size = lengthOf(vector);
    rows.emplace_back(text(QT_TRANSLATE_NOOP("PickReport", "Area")), shortNumber(size / 2));
    if (size > 0)
        rows.emplace_back(text(QT_TRANSLATE_NOOP("PickReport", "Normal")),
                          placeText({float(vector.x / size), float(vector.y / size), float(vector.z / size)}));
    QStringList angles, lengths;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const model::Vec3d here = mesh.positions[corners[i]];
        const model::Vec3d next = model::Vec3d(mesh.positions[corners[(i + 1) % corners.size()]]) - here;
        const model::Vec3d last =
            model::Vec3d(mesh.positions[corners[(i + corners.size() - 1) % corners.size()]]) - here;
        angles << degrees(std::atan2(lengthOf(cross(next, last)), dot(next, last)));
        lengths << shortNumber(lengthOf(next));
    }
    rows.emplace_back(text(QT_TRANSLATE_NOOP("PickReport", "Angles")), angles.join(QStringLiteral("; ")));
    rows.emplace_back(text(QT_TRANSLATE_NOOP("PickReport", "Sides")), lengths.join(QStringLiteral("; ")));
}

void describeEdge(Rows &rows, const Picked &picked, const model::PolygonMesh &mesh)
{
    const auto [a, b] = std::minmax(picked.vertices[0], picked.vertices[1]);
    rows.emplace_back(text(QT_TRANSLATE_NOOP("PickReport", "Edge")), QStringLiteral("%1–%2").arg(a).arg(b));
    rows.emplace_back(text(QT_TRANSLATE_NOOP("PickReport", "Length")),
                      shortNumber(double(model::length(mesh.positions[b] - mesh.positions[a]))));
    const std::vector<std::uint32_t> faces = facesAt(mesh.faces, a, b);
    rows.emplace_back(text(QT_TRANSLATE_NOOP("PickReport", "Faces")), listText(faces));
    if (faces.size() == 1)
        rows.emplace_back(text(QT_TRANSLATE_NOOP("PickReport", "Border")),
                          text(QT_TRANSLATE_NOOP("PickReport", "of a hole")));
    if (faces.size() != 2)
        return;
    const model::Vec3d first = areaVector(mesh, faces[0]), second = areaVector(mesh, faces[1]);
    if (lengthOf(first) > 0 && lengthOf(second) > 0)
        rows.emplace_back(text(QT_TRANSLATE_NOOP("PickReport", "Angle between the faces")),
                          degrees(std::numbers::pi - std::atan2(lengthOf(cross(first, second)), dot(first, second))));
}

void describeVertex(Rows &rows, const Picked &picked, const model::PolygonMesh &mesh)
{
    const std::uint32_t vertex = picked.vertices[0];
    rows.emplace_back(text(QT_TRANSLATE_NOOP("PickReport", "Vertex")), QString::number(vertex));
    rows.emplace_back(text(QT_TRANSLATE_NOOP("PickReport", "Position")), placeText(mesh.positions[vertex]));
    const std::vector<std::uint32_t> faces = facesAt(mesh.faces, vertex, vertex);
    std::set<std::uint32_t> neighbours;
    for (const std::uint32_t f : faces) {
        const auto corners = mesh.faces.face(f);
        for (std::size_t i = 0; i < corners.size(); ++i)
            if (corners[i] == vertex) {
                neighbours.insert(corners[(i + 1) % corners.size()]);
                neighbours.insert(corners[(i + corners.size() - 1) % corners.size()]);
            }
    }
    neighbours.erase(vertex);
    rows.emplace_back(text(QT_TRANSLATE_NOOP("PickReport", "Neighbours")),
                      listText({neighbours.begin(), neighbours.end()}));
    rows.emplace_back(text(QT_TRANSLATE_NOOP("PickReport", "Faces")), listText(faces));
}

} // namespace

std::optional<Picked> pickedAt(const model::PolygonMesh &mesh, std::uint32_t face, const model::Vec3f &place,
                               PickMode mode)
{
    const auto corners = mesh.faces.face(face);
    if (corners.size() < 2)
        return std::nullopt;
    Picked picked{mode, face, {corners[0], corners[0]}};
    float nearest = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::uint32_t a = corners[i], b = corners[(i + 1) % corners.size()];
        const model::Vec3f from = mesh.positions[a], way = mesh.positions[b] - from;
        const float size = dot(way, way);
        const float along =
            mode == PickMode::Edge && size > 0 ? std::clamp(dot(place - from, way) / size, 0.0f, 1.0f) : 0.0f;
        const float distance = model::length(place - from - way * along);
        if (distance < nearest) {
            nearest = distance;
            picked.vertices[0] = a;
            picked.vertices[1] = mode == PickMode::Edge ? b : a;
        }
    }
    return picked;
}

std::vector<std::pair<QString, QString>> describe(const Picked &picked, Inspection &inspection)
{
    Rows rows;
    const model::PolygonMesh &mesh = *inspection.mesh();
    switch (picked.mode) {
    case PickMode::Face:
        describeFace(rows, picked, mesh);
        break;
    case PickMode::Edge:
        describeEdge(rows, picked, mesh);
        break;
    case PickMode::Vertex:
        describeVertex(rows, picked, mesh);
        addFields(rows, inspection, picked.vertices[0]);
        break;
    }
    addReport(rows, picked, inspection);
    return rows;
}

} // namespace views
