// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/terraindocument.h"

#include <QUndoCommand>

namespace tests {

/// Raises every vertex whose number is a multiple of `every`: the simplest step there is.
class RaiseGround final : public QUndoCommand
{
public:
    RaiseGround(model::TerrainDocument &document, double height, std::uint32_t every = 3)
        : QUndoCommand(QStringLiteral("Raise Ground"))
        , mDocument(document)
        , mHeight(height)
        , mEvery(every)
    {}

    void redo() override
    {
        if (mIsDone)
            mDocument.swap(mEdit);
        else
            mEdit = mDocument.edit([this](model::terrain::TinEdit &edit) {
                const model::terrain::TinArrays &tin = mDocument.tin().arrays();
                for (model::terrain::VertexId v = 0; v < tin.vertexSlots(); v += mEvery)
                    edit.setHeight(v, tin.heights[v] + mHeight);
            });
        mIsDone = true;
    }
    void undo() override { mDocument.swap(mEdit); }

private:
    model::TerrainDocument &mDocument;
    const double mHeight;
    const std::uint32_t mEvery;
    bool mIsDone = false;
    model::terrain::Edit mEdit;
};

} // namespace tests
