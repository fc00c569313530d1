// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/editedframes.h"
#include "model/base/error.h"
#include "model/base/progress.h"
#include "model/geometry/similarity.h"

namespace model {

/// What is made to fit the cube (-1,-1,-1)..(1,1,1).
enum class Normalisation : std::uint8_t { None, FirstFrame, AllFrames };

/// The box of one frame, or of all of them.
Box3f boundingBoxOf(const FrameSource &source, std::uint32_t frame);
/// \error Cancelled
Result<Box3f> boundingBoxOfAll(const FrameSource &source, const Progress &progress = Progress());

/// The similarity that centres the chosen box in the cube and makes its longest side fill it, one factor for all axes.
/// A box without extent is only centred. None gives the identity.
/// \error Cancelled
Result<Similarity> normalisingSimilarity(const FrameSource &source, Normalisation mode,
                                         const Progress &progress = Progress());

/// The placement that normalises an edited animation: counted from its source as EditedFrames::placement() is, so it
/// replaces the present one and does not add to it. None gives the identity: the source's own coordinates.
/// \error Cancelled
Result<Similarity> normalisingPlacement(const EditedFrames &frames, Normalisation mode,
                                        const Progress &progress = Progress());

} // namespace model
