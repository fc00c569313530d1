// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/connectivity/walkstatistics.h"
#include "model/mesh/analysis/handles.h"

#include <QJsonObject>
#include <QString>
#include <QStringList>

namespace model::io {

/// All that is found out about one mesh: what the inspector shows and `sandreel-cli inspect` prints.
struct Inspection
{
    MeshReport report;
    std::vector<HandleReport> handles;
    codec::WalkStatistics walk;        ///< of the faces as fans
    bool hasSelfIntersections = false; ///< they were looked for, and are in `report`
};

struct InspectionOptions
{
    bool selfIntersections = false;
};

/// \param positions  #V
/// \error LimitExceeded (more triangles than EdgeBreaker can number), Cancelled
Result<Inspection> inspectMesh(const Faces &faces, std::span<const Vec3f> positions,
                               const InspectionOptions &options = {}, const Progress &progress = Progress());

/// As docs/inspect.md describes it. Vertices, faces and components are numbered from 0, in the order of the file.
QJsonObject inspectionJson(const Inspection &inspection);

/// The tables that a person may want in a spreadsheet.
enum class InspectionTable : std::uint8_t { Components, Holes, Handles, Problems };

/// A first line of names, then a line for each row; fields are separated by commas, numbers are C's.
QStringList inspectionCsv(const Inspection &inspection, InspectionTable table);

} // namespace model::io
