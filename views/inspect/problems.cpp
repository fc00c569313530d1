// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/inspect/problems.h"

#include <QCoreApplication>

namespace views {

namespace {

QString text(const char *source)
{
    return QCoreApplication::translate("MeshProblems", source);
}

bool isEdge(model::ProblemKind kind)
{
    return kind == model::ProblemKind::NonManifoldEdge || kind == model::ProblemKind::InconsistentEdge;
}

} // namespace

IdsName namesOf(model::ProblemKind kind)
{
    switch (kind) {
    case model::ProblemKind::NonManifoldEdge:
    case model::ProblemKind::NonManifoldVertex:
    case model::ProblemKind::InconsistentEdge:
    case model::ProblemKind::IsolatedVertex:
    case model::ProblemKind::CoincidentVertex:
        return IdsName::Vertices;
    case model::ProblemKind::InsideOutComponent:
        return IdsName::Components;
    default:
        return IdsName::Faces;
    }
}

QString problemTitle(model::ProblemKind kind)
{
    switch (kind) {
    case model::ProblemKind::NonManifoldEdge:
        return text(QT_TRANSLATE_NOOP("MeshProblems", "Edge of three faces or more"));
    case model::ProblemKind::NonManifoldVertex:
        return text(QT_TRANSLATE_NOOP("MeshProblems", "Vertex where fans of faces touch"));
    case model::ProblemKind::InconsistentEdge:
        return text(QT_TRANSLATE_NOOP("MeshProblems", "Faces wound against each other"));
    case model::ProblemKind::DegenerateFace:
        return text(QT_TRANSLATE_NOOP("MeshProblems", "Face with a vertex twice"));
    case model::ProblemKind::ZeroAreaFace:
        return text(QT_TRANSLATE_NOOP("MeshProblems", "Face without area"));
    case model::ProblemKind::DuplicateFace:
        return text(QT_TRANSLATE_NOOP("MeshProblems", "Face that is there twice"));
    case model::ProblemKind::IsolatedVertex:
        return text(QT_TRANSLATE_NOOP("MeshProblems", "Vertex without faces"));
    case model::ProblemKind::CoincidentVertex:
        return text(QT_TRANSLATE_NOOP("MeshProblems", "Vertices at one place"));
    case model::ProblemKind::InsideOutComponent:
        return text(QT_TRANSLATE_NOOP("MeshProblems", "Component turned inside out"));
    case model::ProblemKind::SelfIntersection:
        break;
    }
    return text(QT_TRANSLATE_NOOP("MeshProblems", "Faces that cut each other"));
}

QString problemPlace(model::ProblemKind kind, const model::ProblemIds &ids)
{
    const bool isPair = ids[1] != model::NoId;
    QString pattern;
    if (isEdge(kind))
        pattern = text(QT_TRANSLATE_NOOP("MeshProblems", "Edge %1–%2"));
    else if (namesOf(kind) == IdsName::Vertices)
        pattern = isPair ? text(QT_TRANSLATE_NOOP("MeshProblems", "Vertices %1 and %2"))
                         : text(QT_TRANSLATE_NOOP("MeshProblems", "Vertex %1"));
    else if (namesOf(kind) == IdsName::Components)
        pattern = text(QT_TRANSLATE_NOOP("MeshProblems", "Component %1"));
    else
        pattern = isPair ? text(QT_TRANSLATE_NOOP("MeshProblems", "Faces %1 and %2"))
                         : text(QT_TRANSLATE_NOOP("MeshProblems", "Face %1"));
    return isPair ? pattern.arg(ids[0]).arg(ids[1]) : pattern.arg(ids[0]);
}

} // namespace views
