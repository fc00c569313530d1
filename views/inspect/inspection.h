// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/analysis/handles.h"
#include "views/inspect/meshfields.h"
#include "views/jobs/job.h"

#include <map>
#include <optional>

namespace views {

struct MeshScenery;

/// The four lists of an inspection.
enum class PartKind : std::uint8_t { Component, Hole, Handle, Problem };
inline constexpr PartKind EveryPartKind[] = {PartKind::Component, PartKind::Hole, PartKind::Handle, PartKind::Problem};

/// A row of one of the lists.
struct PartId
{
    PartKind kind;
    std::uint32_t index;
    friend auto operator<=>(const PartId &, const PartId &) = default;
};

struct Problem
{
    model::ProblemKind kind;
    model::ProblemIds ids;
};

/// What is known of a mesh, and what of it is selected: shared by the lists and all views of the mesh. Everything is
/// found in the background, in the order in which people want to see it: what is drawn, the report, handles,
/// self-intersections.
class Inspection final : public QObject
{
    Q_OBJECT

public:
    using MeshPtr = std::shared_ptr<const model::PolygonMesh>;

    explicit Inspection(QObject *parent = nullptr);
    ~Inspection() override;

    /// Begins anew. Null: nothing to inspect.
    void setMesh(MeshPtr mesh);
    const MeshPtr &mesh() const { return mMesh; }
    /// What views draw; null until it is made. After setMesh() that of the mesh before, for as long.
    const std::shared_ptr<const MeshScenery> &scenery() const { return mScenery; }
    /// Null until it is made.
    const std::shared_ptr<const model::MeshReport> &report() const { return mReport; }
    /// Null until they are found.
    const std::vector<model::HandleReport> *handles() const { return mHandles ? &*mHandles : nullptr; }
    /// Of the report, in its order; self-intersections follow when they are found.
    const std::vector<Problem> &problems() const { return mProblems; }
    /// Rows of one list; 0 as long as they are not known.
    std::uint32_t countOf(PartKind kind) const;
    /// Something is still being found.
    bool isBusy() const { return mWork.isRunning(); }
    bool isKnown(PartKind kind) const;

    /// Ascending, each once.
    const std::vector<PartId> &selection() const { return mSelection; }
    bool isSelected(PartId part) const;
    /// Rows that do not exist are left out. \param frame  views show them in full
    void select(std::vector<PartId> parts, bool frame);
    /// Of the selected parts; empty if there is none.
    model::Box3f selectionBox() const;
    model::Box3f boxOf(PartId part) const;

    /// The fields that can be chosen; those before are dropped, as by setMesh().
    void setOffers(std::vector<FieldOffer> offers);
    std::vector<FieldId> fields() const;
    /// The values of a field; null until they are made, which asking for them begins: fieldReady() follows.
    const std::vector<float> *field(FieldId id);
    /// The values if they are made already.
    const std::vector<float> *knownField(FieldId id) const;

signals:
    /// Another mesh; nothing is known of it yet.
    void meshChanged();
    void sceneryReady();
    /// Report, handles or problems became known.
    void found();
    void selectionChanged();
    void frameAsked();
    /// Another list of fields.
    void fieldsChanged();
    void fieldReady(views::FieldId id);
    void failed(const model::Error &error);
    void busyChanged();

private:
    void makeScenery();
    void analyse();
    void findHandles();
    void findSelfIntersections();
    void takeReport(model::MeshReport report);
    void makeFields();
    void addBox(model::Box3f &box, std::uint32_t vertex) const { box.add(mMesh->positions[vertex]); }

    MeshPtr mMesh;
    std::shared_ptr<const MeshScenery> mScenery;
    std::shared_ptr<const model::MeshReport> mReport;
    std::optional<std::vector<model::HandleReport>> mHandles;
    std::vector<Problem> mProblems;
    std::vector<PartId> mSelection;
    std::vector<FieldOffer> mOffers;
    std::map<FieldId, std::vector<float>> mFields;
    std::vector<FieldId> mWanted; ///< fields to be made, the next one first
    // Last: destroyed first, so that no result comes to what is half gone.
    Job mWork;
    Job mFieldWork;
};

} // namespace views
