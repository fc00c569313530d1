// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/sculpt/groundreference.h"

#include <utility>

namespace views {

GroundReference::GroundReference(const model::TerrainDocument &document, QObject *parent)
    : QObject(parent)
    , mDocument(document)
{
    copy();
}

void GroundReference::take()
{
    mIsTaken = true;
    copy();
}

void GroundReference::noteSaved(TerrainPtr saved)
{
    if (mIsTaken)
        return;
    mTerrain = std::move(saved);
    emit changed();
}

void GroundReference::copy()
{
    mCopying.start(
        [copier = mDocument.copier()](const model::Progress &) -> model::Result<TerrainPtr> {
            return std::make_shared<const model::terrain::Terrain>(copier());
        },
        [this](model::Result<TerrainPtr> copied) {
            if (!copied)
                return; // no memory for it: the one before stays
            mTerrain = std::move(*copied);
            emit changed();
        });
}

} // namespace views
