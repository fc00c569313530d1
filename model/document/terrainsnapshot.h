// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/terraindocument.h"

#include <QObject>
#include <QTimer>

#include <functional>
#include <memory>

namespace model {

/// Takes snapshots of a terrain for work in the background, which are copied there too: of 1M vertices that takes some
/// 30 ms. Must not outlive the document.
class TerrainSnapshot final : public QObject
{
    Q_OBJECT

public:
    using Taken = std::function<void(std::shared_ptr<const terrain::Terrain>)>;

    explicit TerrainSnapshot(const TerrainDocument &document, QObject *parent = nullptr);

    /// Begins one, in place of the one that is being taken.
    /// \param taken  called from the event loop, when the document is as the snapshot
    void start(Taken taken);
    void cancel();
    bool isRunning() const { return mTaken != nullptr; }

private:
    void take();
    void give(const std::shared_ptr<const terrain::Terrain> &terrain);

    const TerrainDocument &mDocument;
    Taken mTaken;
    std::uint64_t mRun = 0;     ///< start() and cancel() so far
    std::uint64_t mChanges = 0; ///< of the document
    int mTries = 0;
    QTimer mTurn;
};

} // namespace model
