// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/terrainsnapshot.h"

#include <QFuture>
#include <QPromise>
#include <QThreadPool>

#include <utility>

namespace model {

namespace {

using TerrainPtr = std::shared_ptr<const terrain::Terrain>;

/// Copies that were too late, each by a change that came meanwhile, after which the document has to wait for one.
constexpr int MostTries = 4;

} // namespace

TerrainSnapshot::TerrainSnapshot(const TerrainDocument &document, QObject *parent)
    : QObject(parent)
    , mDocument(document)
{
    mTurn.setSingleShot(true);
    connect(&mTurn, &QTimer::timeout, this, &TerrainSnapshot::take);
    connect(&document, &TerrainDocument::changed, this, [this] { ++mChanges; });
}

void TerrainSnapshot::start(Taken taken)
{
    mTaken = std::move(taken);
    ++mRun;
    mTries = 0;
    mTurn.start(0);
}

void TerrainSnapshot::cancel()
{
    ++mRun;
    mTurn.stop();
    mTaken = nullptr;
}

void TerrainSnapshot::take()
{
    if (++mTries > MostTries)
        return give(mDocument.snapshot());
    const auto promise = std::make_shared<QPromise<TerrainPtr>>();
    promise->future().then(this, [this, run = mRun, changes = mChanges](const TerrainPtr &copy) {
        if (run != mRun)
            return;
        if (changes == mChanges)
            give(copy);
        else
            take();
    });
    promise->start();
    QThreadPool::globalInstance()->start([promise, copy = mDocument.copier()] {
        promise->addResult(std::make_shared<const terrain::Terrain>(copy()));
        promise->finish();
    });
}

void TerrainSnapshot::give(const TerrainPtr &terrain)
{
    std::exchange(mTaken, nullptr)(terrain);
}

} // namespace model
