// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/actions/recordactions.h"

#include "app/editor/actions/fileactions.h"
#include "app/editor/documents/terraintab.h"
#include "app/editor/window/workspace.h"
#include "views/dialogs/quantitytext.h"

#include <QStatusBar>

namespace editor {

RecordActions::RecordActions(Actions &actions, Workspace &workspace, FileActions &files, QStatusBar &status)
    : mActions(actions)
    , mWorkspace(workspace)
    , mFiles(files)
    , mStatus(status)
{
    connect(&actions[ActionId::Record], &QAction::triggered, this, [this](bool isOn) {
        if (!isOn)
            stop();
        else if (TerrainTab *tab = mWorkspace.currentTerrain(); tab && tab->document().isOpen())
            start(*tab);
        update();
    });
    connect(&workspace, &Workspace::currentChanged, this, &RecordActions::update);
    connect(&workspace, &Workspace::currentStateChanged, this, &RecordActions::update);
    update();
}

RecordActions::~RecordActions() = default;

void RecordActions::start(TerrainTab &tab)
{
    const OpenTerrain &document = tab.document();
    mTitle = document.title();
    mRecorder = std::make_unique<model::TerrainRecorder>(document.terrain(), mLimits);
    connect(mRecorder.get(), &model::TerrainRecorder::frameTaken, this, &RecordActions::showProgress);
    // Not from within its own signal: it goes then.
    connect(mRecorder.get(), &model::TerrainRecorder::limitReached, this, &RecordActions::stop, Qt::QueuedConnection);
    connect(&document, &Document::aboutToBeReplaced, mRecorder.get(), [this] { stop(); });
    mWorkspace.messages().add(
        views::MessageBar::Kind::Note,
        tr("Recording %1: heights at %L2 × %L3 places, up to %L4 frames (%5 of memory). Record again to stop.")
            .arg(mTitle)
            .arg(mRecorder->columns())
            .arg(mRecorder->rows())
            .arg(mRecorder->frameLimit())
            .arg(views::bytesText(mRecorder->byteLimit())));
    showProgress();
}

void RecordActions::showProgress()
{
    mStatus.showMessage(tr("Recording %1: %n frame(s)", nullptr, int(mRecorder->frameCount())).arg(mTitle));
}

void RecordActions::stop()
{
    if (!mRecorder)
        return;
    const std::unique_ptr<model::TerrainRecorder> recorder = std::move(mRecorder);
    recorder->disconnect(this);
    mStatus.clearMessage();
    const std::uint32_t limit = recorder->frameLimit();
    const model::FrameSourcePtr frames = recorder->finish(tr("%1 in motion").arg(mTitle).toStdString());
    if (frames->frameCount() < 2)
        mWorkspace.messages().add(views::MessageBar::Kind::Note,
                                  tr("Nothing happened to %1 that could be shown.").arg(mTitle));
    else
        mFiles.openMade(frames);
    if (frames->frameCount() >= limit)
        mWorkspace.messages().add(views::MessageBar::Kind::Note,
                                  tr("The recording ended at its limit of %L1 frames.").arg(limit));
    update();
}

void RecordActions::update()
{
    const TerrainTab *tab = mWorkspace.currentTerrain();
    mActions[ActionId::Record].setEnabled(isRecording() || (tab && tab->document().isOpen()));
    mActions[ActionId::Record].setChecked(isRecording());
}

} // namespace editor
