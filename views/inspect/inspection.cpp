// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/inspect/inspection.h"

#include "model/mesh/analysis/selfintersections.h"
#include "views/inspect/meshscenery.h"
#include "views/inspect/problems.h"

#include <algorithm>

namespace views {

Inspection::Inspection(QObject *parent)
    : QObject(parent)
{
    connect(&mWork, &Job::runningChanged, this, &Inspection::busyChanged);
}

Inspection::~Inspection() = default;

void Inspection::setMesh(MeshPtr mesh)
{
    mMesh = std::move(mesh);
    mReport.reset();
    mHandles.reset();
    mProblems.clear();
    mFields.clear();
    mOffers.clear();
    mWanted.clear();
    const bool hadSelection = !mSelection.empty();
    mSelection.clear();
    if (!mMesh)
        mScenery.reset();
    emit meshChanged();
    emit fieldsChanged();
    if (hadSelection)
        emit selectionChanged();
    if (mMesh)
        makeScenery();
}

void Inspection::makeScenery()
{
    mWork.start([mesh = mMesh](const model::Progress &progress) { return views::makeScenery(mesh, progress); },
                [this](model::Result<MeshSceneryPtr> made) {
                    if (!made) {
                        emit failed(made.error());
                        return;
                    }
                    mScenery = std::move(*made);
                    emit sceneryReady();
                    analyse();
                });
}

void Inspection::analyse()
{
    mWork.start(
        [mesh = mMesh](const model::Progress &progress) {
            return model::analyseMesh(mesh->faces, mesh->positions, progress);
        },
        [this](model::Result<model::MeshReport> made) {
            if (!made) {
                emit failed(made.error());
                return;
            }
            takeReport(std::move(*made));
            findHandles();
        });
}

void Inspection::takeReport(model::MeshReport report)
{
    mReport = std::make_shared<const model::MeshReport>(std::move(report));
    mProblems.clear();
    for (std::size_t kind = 0; kind < model::ProblemKindCount; ++kind)
        for (const model::ProblemIds &ids : mReport->problems[kind])
            mProblems.push_back({model::ProblemKind(kind), ids});
    emit found();
}

void Inspection::findHandles()
{
    mWork.start(
        [mesh = mMesh, report = mReport](const model::Progress &progress) {
            return model::findHandles(mesh->faces, mesh->positions, *report, progress);
        },
        [this](model::Result<std::vector<model::HandleReport>> made) {
            if (!made) {
                emit failed(made.error());
                return;
            }
            mHandles = std::move(*made);
            emit found();
            findSelfIntersections();
        });
}

void Inspection::findSelfIntersections()
{
    mWork.start(
        [mesh = mMesh](const model::Progress &progress) {
            return model::findSelfIntersections(mesh->faces, mesh->positions, progress);
        },
        [this](model::Result<std::vector<model::ProblemIds>> made) {
            if (!made) {
                emit failed(made.error());
                return;
            }
            model::MeshReport report = *mReport;
            report.problems[std::size_t(model::ProblemKind::SelfIntersection)] = std::move(*made);
            takeReport(std::move(report));
        });
}

std::uint32_t Inspection::countOf(PartKind kind) const
{
    switch (kind) {
    case PartKind::Component:
        return mReport ? std::uint32_t(mReport->components.size()) : 0;
    case PartKind::Hole:
        return mReport ? std::uint32_t(mReport->holes.size()) : 0;
    case PartKind::Handle:
        return mHandles ? std::uint32_t(mHandles->size()) : 0;
    case PartKind::Problem:
        break;
    }
    return std::uint32_t(mProblems.size());
}

bool Inspection::isKnown(PartKind kind) const
{
    return kind == PartKind::Handle ? mHandles.has_value() : mReport != nullptr;
}

bool Inspection::isSelected(PartId part) const
{
    return std::binary_search(mSelection.begin(), mSelection.end(), part);
}

void Inspection::select(std::vector<PartId> parts, bool frame)
{
    std::erase_if(parts, [this](PartId part) { return part.index >= countOf(part.kind); });
    std::sort(parts.begin(), parts.end());
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    if (parts != mSelection) {
        mSelection = std::move(parts);
        emit selectionChanged();
    }
    if (frame && !mSelection.empty())
        emit frameAsked();
}

model::Box3f Inspection::selectionBox() const
{
    model::Box3f box;
    for (const PartId part : mSelection)
        box.add(boxOf(part));
    return box;
}

model::Box3f Inspection::boxOf(PartId part) const
{
    model::Box3f box;
    const model::Faces &faces = mMesh->faces;
    const auto addFace = [&](std::uint32_t face) {
        for (const std::uint32_t vertex : faces.face(face))
            addBox(box, vertex);
    };
    switch (part.kind) {
    case PartKind::Component:
        return mReport->components[part.index].box;
    case PartKind::Hole:
        for (const std::uint32_t side : mReport->holes[part.index].loop.sides) {
            addBox(box, faces.vertex(side));
            addBox(box, faces.vertex(faces.next(side)));
        }
        break;
    case PartKind::Handle:
        for (const model::HandleReport::Loop &loop : (*mHandles)[part.index].loops)
            for (const std::uint32_t vertex : loop.vertices)
                addBox(box, vertex);
        break;
    case PartKind::Problem: {
        const Problem &problem = mProblems[part.index];
        for (const std::uint32_t id : problem.ids) {
            if (id == model::NoId)
                continue;
            switch (namesOf(problem.kind)) {
            case IdsName::Vertices:
                addBox(box, id);
                break;
            case IdsName::Faces:
                addFace(id);
                break;
            case IdsName::Components:
                box.add(mReport->components[id].box);
                break;
            }
        }
        break;
    }
    }
    return box;
}

void Inspection::setOffers(std::vector<FieldOffer> offers)
{
    mFields.clear();
    mWanted.clear();
    mOffers = std::move(offers);
    emit fieldsChanged();
}

std::vector<FieldId> Inspection::fields() const
{
    std::vector<FieldId> ids;
    for (const FieldOffer &offer : mOffers)
        ids.push_back(offer.id);
    return ids;
}

const std::vector<float> *Inspection::knownField(FieldId id) const
{
    const auto known = mFields.find(id);
    return known == mFields.end() ? nullptr : &known->second;
}

const std::vector<float> *Inspection::field(FieldId id)
{
    if (const std::vector<float> *known = knownField(id))
        return known;
    if (std::find(mWanted.begin(), mWanted.end(), id) == mWanted.end()) {
        mWanted.push_back(id);
        if (mWanted.size() == 1)
            makeFields();
    }
    return nullptr;
}

void Inspection::makeFields()
{
    const auto offer = std::find_if(mOffers.begin(), mOffers.end(),
                                    [this](const FieldOffer &other) { return other.id == mWanted.front(); });
    if (offer == mOffers.end()) {
        mWanted.clear();
        return;
    }
    mFieldWork.start(offer->make, [this, id = offer->id](model::Result<std::vector<float>> made) {
        std::erase(mWanted, id);
        if (made && mMesh && made->size() == mMesh->positions.size()) {
            mFields[id] = std::move(*made);
            emit fieldReady(id);
        } else if (!made) {
            emit failed(made.error());
        }
        if (!mWanted.empty())
            makeFields();
    });
}

} // namespace views
