// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/terrain.h"
#include "tests/model/terrain/tin/randomedits.h"
#include "tests/support/compareerror.h"

#include <QByteArray>
#include <QString>

namespace tests {

/// A terrain with everything that a file holds: layers of two materials, constraints of several owners, voids, a
/// ledger, free slots, a place in the world.
model::terrain::Terrain specimenTerrain(Ground ground = Ground::Random, unsigned seed = 1, int points = 300);

/// A flat terrain of 10 x 10 without layers.
model::terrain::Terrain plainTerrain();

/// Everything of a terrain but the numbers of its vertices, triangles and constraints, as lines of text with every bit:
/// what a save has to keep, computed by nobody else.
QByteArray describe(const model::terrain::Terrain &terrain);

QByteArray readFile(const QString &path);
void writeFile(const QString &path, const QByteArray &bytes);

} // namespace tests
