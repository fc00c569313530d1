// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/heightframes.h"
#include "model/document/terraindocument.h"

#include <QObject>
#include <QTimer>

namespace model {

/// What a recording may take.
struct RecordingLimits
{
    std::uint32_t vertices = 22'500;                ///< of the mesh; at least 4
    double frameRate = 25;                          ///< frames per second, above zero
    std::uint64_t bytes = std::uint64_t(256) << 20; ///< of all frames in memory; at least one frame is taken
};

/// Records what happens to a terrain as an animation: its heights at the places of a regular grid over the domain,
/// which stays the same however the TIN changes. A frame is taken with the rate's beat, of changes only: where nothing
/// happens, no time passes. Must not outlive the document.
///
/// Axes are the animations': x east, y up, z south, the middle of the domain at the origin.
class TerrainRecorder final : public QObject
{
    Q_OBJECT

public:
    /// Takes the first frame.
    TerrainRecorder(const TerrainDocument &document, const RecordingLimits &limits, QObject *parent = nullptr);

    std::uint32_t frameCount() const { return std::uint32_t(mHeights.size()); }
    /// Frames that fit into the limits.
    std::uint32_t frameLimit() const { return mFrameLimit; }
    std::uint32_t columns() const { return mColumns; }
    std::uint32_t rows() const { return mRows; }
    std::uint64_t byteLimit() const { return std::uint64_t(mFrameLimit) * mPlaces.size() * sizeof(float); }

    /// Takes a frame now if there is room and something has changed since the last one.
    void takeFrame();
    /// What was recorded, with the terrain as it is now at the end. Afterwards nothing more is.
    FrameSourcePtr finish(std::string name);

signals:
    void frameTaken();
    /// No other frame fits: finish() what there is.
    void limitReached();

private:
    void sample();
    /// Calls `visit(place, its triangle, a vertex of that)` for each place.
    template <class Visit>
    void forEachPlace(Visit visit) const;
    Connectivity connectivity() const;

    const TerrainDocument &mDocument;
    const double mFrameRate;
    std::uint32_t mColumns = 2, mRows = 2;
    std::uint32_t mFrameLimit = 1;
    double mMiddle = 0; ///< height that is 0 in the frames
    std::vector<terrain::Point2> mPlaces;
    std::vector<std::vector<float>> mHeights; ///< of each frame
    bool mHasChanged = false;
    QTimer mBeat;
};

} // namespace model
