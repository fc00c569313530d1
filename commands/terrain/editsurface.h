// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/terrain/historybudget.h"
#include "model/document/terraindocument.h"

#include <functional>
#include <vector>

namespace commands {

/// Changes of a terrain's surface as one undo step. It keeps what they wrote over: undo and redo are exact to the byte.
class EditSurface final : public WeightedCommand
{
public:
    using Work = std::function<void(model::terrain::TinEdit &)>;

    /// Carries out `work` as one edit, the first time.
    EditSurface(model::TerrainDocument &document, const QString &text, Work work);
    /// Does an edit that was made on a copy of the terrain and undone there: it leads from the document as it is.
    EditSurface(model::TerrainDocument &document, const QString &text, model::terrain::Edit undone);

    void redo() override;
    void undo() override;
    std::size_t byteSize() const override;

private:
    friend class TerrainContext;

    /// Edits that are done already, and may become more while a gesture goes on.
    EditSurface(model::TerrainDocument &document, const QString &text, std::vector<model::terrain::Edit> done);

    model::TerrainDocument &mDocument;
    Work mWork; ///< empty once it was done
    std::vector<model::terrain::Edit> mEdits;
    bool mIsDone = false;
    std::function<void()> mOnUndo; ///< of an open gesture: ends it
};

} // namespace commands
