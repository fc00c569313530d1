// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/actions/actions.h"
#include "model/document/terrainrecorder.h"

#include <QPointer>

#include <memory>

class QStatusBar;

namespace editor {

class FileActions;
class TerrainTab;
class Workspace;

/// Records what happens to one terrain at a time, and opens the animation in a tab of its own.
class RecordActions final : public QObject
{
    Q_OBJECT

public:
    RecordActions(Actions &actions, Workspace &workspace, FileActions &files, QStatusBar &status);
    ~RecordActions() override;

    /// Another one than the usual; of the next recording.
    void setLimits(const model::RecordingLimits &limits) { mLimits = limits; }
    /// Ends the recording and shows it, if there is one.
    void stop();
    /// Forgets it instead.
    void drop() { mRecorder.reset(); }
    bool isRecording() const { return mRecorder != nullptr; }

private:
    void start(TerrainTab &tab);
    void update();
    void showProgress();

    Actions &mActions;
    Workspace &mWorkspace;
    FileActions &mFiles;
    QStatusBar &mStatus;
    model::RecordingLimits mLimits;
    std::unique_ptr<model::TerrainRecorder> mRecorder;
    QString mTitle; ///< of the terrain that is recorded
};

} // namespace editor
