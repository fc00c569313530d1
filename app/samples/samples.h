// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/compressionsettings.h"
#include "model/animation/sequence.h"
#include "model/base/error.h"
#include "model/terrain/terrain.h"

#include <span>

namespace samples {

/// A bundled animation and how it is made. The same on every run: no clock, no random seed.
struct Sample
{
    const char *name;
    const char *description;
    model::Sequence (*make)();
    model::CompressionSettings settings; ///< of the bundled file: small, and no difference to the eye
};

/// A square cloth that falls over a ball and settles in hanging folds. Two components, one a disc.
model::Sequence makeCloth();
/// A four-legged creature walking on the spot, in a loop: rigid parts, and a tail that bends.
model::Sequence makeWalker();
/// A jellyfish that pulses, in a loop: a smooth bell and waving tentacles.
model::Sequence makeJellyfish();

std::span<const Sample> allSamples();

/// Dunes of dry sand on moist sand: the bundled terrain.
model::Result<model::terrain::Terrain> makeDunes();

} // namespace samples
