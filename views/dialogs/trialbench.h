// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/normalisation.h"
#include "model/codec/ratecontrol.h"

#include <map>
#include <mutex>
#include <vector>

namespace views {

/// What a search found, and all that it tried on the way.
struct TrialOutcome
{
    model::codec::Trial found;
    std::vector<model::codec::Trial> tried; ///< `found` among them
};

/// An animation prepared for trying settings, each codec once it is asked for. Lives in a shared_ptr, so that work in
/// the background may outlast the window that began it. Thread-safe: who comes second waits.
class TrialBench
{
public:
    TrialBench(model::FrameSourcePtr frames, model::Normalisation normalisation);

    /// Size and error of some settings. Errors as codec::encodeAnimation.
    model::Result<TrialOutcome> attempt(const model::CodecSettings &settings, const model::Progress &progress);
    /// The settings that reach a target. Errors as codec::searchSettings.
    model::Result<TrialOutcome> search(model::CodecId codec, const model::QualityTarget &target,
                                       const model::Progress &progress);
    /// Bits per frame and vertex of a file of so many bytes.
    double bitsPerFrameAndVertex(std::uint64_t bytes) const;

private:
    model::Result<model::codec::TrialEncoder *> encoderOf(model::CodecId codec, const model::Progress &progress);

    std::mutex mMutex; ///< of all below
    model::FrameSourcePtr mFrames;
    model::Normalisation mNormalisation;
    bool mIsPlaced = false; ///< mFrames are normalised
    std::map<model::CodecId, std::unique_ptr<model::codec::TrialEncoder>> mEncoders;
    const double mSamples; ///< frames times vertices
};

} // namespace views
