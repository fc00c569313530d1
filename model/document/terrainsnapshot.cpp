// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/terrainsnapshot.h"

#include <utility>

namespace model {

TerrainSnapshot::TerrainSnapshot(const TerrainDocument &document, QObject *parent)
    : QObject(parent)
    , mDocument(document)
{
    mTurn.setSingleShot(true);
    connect(&mTurn, &QTimer::timeout, this, &TerrainSnapshot::take);
}

void TerrainSnapshot::start(Taken taken)
{
    mTaken = std::move(taken);
    mTurn.start(0);
}

void TerrainSnapshot::cancel()
{
    mTurn.stop();
    mTaken = nullptr;
}

void TerrainSnapshot::take()
{
    std::exchange(mTaken, nullptr)(mDocument.snapshot());
}

} // namespace model
