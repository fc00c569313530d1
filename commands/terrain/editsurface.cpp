// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/terrain/editsurface.h"

#include <utility>

namespace commands {

using model::terrain::Edit;

EditSurface::EditSurface(model::TerrainDocument &document, const QString &text, Work work)
    : WeightedCommand(text)
    , mDocument(document)
    , mWork(std::move(work))
{}

EditSurface::EditSurface(model::TerrainDocument &document, const QString &text, Edit undone)
    : WeightedCommand(text)
    , mDocument(document)
{
    setObsolete(undone.isEmpty());
    mEdits.push_back(std::move(undone));
}

EditSurface::EditSurface(model::TerrainDocument &document, const QString &text, std::vector<Edit> done)
    : WeightedCommand(text)
    , mDocument(document)
    , mEdits(std::move(done))
    , mIsDone(true)
{}

void EditSurface::redo()
{
    if (mIsDone) // while the gesture ran
        return;
    mIsDone = true;
    if (mWork) {
        if (Edit edit = mDocument.edit(std::exchange(mWork, nullptr)); !edit.isEmpty())
            mEdits.push_back(std::move(edit));
        setObsolete(mEdits.empty());
        return;
    }
    for (Edit &edit : mEdits)
        mDocument.swap(edit);
}

void EditSurface::undo()
{
    if (const auto onUndo = std::exchange(mOnUndo, nullptr))
        onUndo();
    mIsDone = false;
    for (std::size_t i = mEdits.size(); i-- > 0;)
        mDocument.swap(mEdits[i]);
}

std::size_t EditSurface::byteSize() const
{
    std::size_t bytes = sizeof(*this);
    for (const Edit &edit : mEdits)
        bytes += edit.byteSize();
    return bytes;
}

} // namespace commands
