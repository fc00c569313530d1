// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/terrain/terraincontext.h"
#include "views/jobs/job.h"

#include <QObject>

namespace views {

/// A change of a terrain that takes long: carried out on a copy in the background, and then done to the document as one
/// undo step, exact to the byte. If the document changes meanwhile, the work is for nothing, and is called off.
class BackgroundEdit final : public QObject
{
    Q_OBJECT

public:
    using Work = std::function<model::Result<void>(model::terrain::TinEdit &, const model::Progress &)>;

    explicit BackgroundEdit(commands::TerrainContext &context, QObject *parent = nullptr);

    /// Ends an open gesture first. Precondition: nothing runs.
    /// \param text  of the undo step
    void start(const QString &text, Work work);
    /// To show progress, and to cancel.
    Job &job() { return mJob; }

signals:
    /// It is done. Nothing is said about what was cancelled, by the user or by a change of the document.
    void finished();
    /// \param reason  for people
    void failed(const QString &reason);

private:
    commands::TerrainContext &mContext;
    Job mJob;
    std::uint64_t mChanges = 0; ///< of the document since it was opened
};

} // namespace views
