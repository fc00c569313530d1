// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/base/documentcontext.h"
#include "commands/terrain/editsurface.h"
#include "model/document/terraindocument.h"
#include "model/terrain/tin/journal/editjoiner.h"

#include <optional>

namespace commands {

/// The way to change a terrain.
///
/// A gesture changes the surface edit by edit while it runs: the stamps of a stroke, then what slides. All of it is one
/// undo step, which lies on the undo stack from the first edit on. So undo in the midst of a gesture ends it and takes
/// back all of it, whoever asked the stack; any other command that is pushed ends the gesture too. Nobody goes on
/// changing what was saved: after a save in the midst of a gesture, its next edits are a step of their own.
///
/// The edits of a step are joined as they come: however long sand slides, its step keeps what it wrote over once.
class TerrainContext final : public DocumentContext<model::TerrainDocument>
{
    Q_OBJECT

public:
    explicit TerrainContext(model::TerrainDocument &document, QObject *parent = nullptr);
    ~TerrainContext() override;

    void pushCommand(std::unique_ptr<QUndoCommand> command) override;

    /// Begins a gesture, and ends the one before. A gesture without edits leaves no step.
    void beginGesture(const QString &text);
    bool hasGesture() const { return mHasGesture; }
    /// Carries out `work(TinEdit &)` as one edit of the gesture. \returns the edit, until the next one; null if it
    /// wrote nothing. Precondition: hasGesture().
    template <class Work>
    const model::terrain::Edit *edit(Work work, model::terrain::VolumeRule rule = model::terrain::VolumeRule::GiveBack)
    {
        return keep(mDocument.edit(std::move(work), rule));
    }
    /// The step stays.
    void endGesture();
    /// The terrain becomes what it was when the gesture began, to the byte, and no step is left. What could be redone
    /// before the gesture began is gone all the same.
    void cancelGesture();

    HistoryBudget &history() { return mHistory; }
    const HistoryBudget &history() const { return mHistory; }

signals:
    /// The gesture has ended, whoever ended it, and goes no further. Sent before an undo takes it back.
    void gestureEnded();

private:
    const model::terrain::Edit *keep(model::terrain::Edit edit);
    void joinLast();

    HistoryBudget mHistory;
    bool mHasGesture = false;
    QString mText;
    std::shared_ptr<EditSurface> mStep;                ///< of the gesture, once there is an edit
    std::optional<model::terrain::EditJoiner> mJoiner; ///< for the last but one of its edits
};

} // namespace commands
