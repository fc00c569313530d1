// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/trialbench.h"

#include "model/animation/editedframes.h"

namespace views {

using namespace model;

namespace {

// Of the progress bar, the first time that a codec is asked for.
constexpr double PreparedAt = 0.4;

} // namespace

TrialBench::TrialBench(FrameSourcePtr frames, Normalisation normalisation)
    : mFrames(std::move(frames))
    , mNormalisation(normalisation)
    , mSamples(double(mFrames->frameCount()) * mFrames->vertexCount())
{}

double TrialBench::bitsPerFrameAndVertex(std::uint64_t bytes) const
{
    return mSamples > 0 ? 8 * double(bytes) / mSamples : 0;
}

Result<codec::TrialEncoder *> TrialBench::encoderOf(CodecId codec, const Progress &progress)
{
    if (progress.isCancelled()) // while it waited for another one
        return fail(ErrorCode::Cancelled);
    if (!mIsPlaced) {
        const auto placement = normalisingSimilarity(*mFrames, mNormalisation, progress.part(0, 0.1));
        if (!placement)
            return fail(placement.error());
        if (mNormalisation != Normalisation::None)
            mFrames = std::make_shared<EditedFrames>(mFrames, TimeMap::identity(mFrames->frameCount()), *placement,
                                                     mFrames->frameRate(), mFrames->name());
        mIsPlaced = true;
    }
    auto &encoder = mEncoders[codec];
    if (!encoder) {
        auto prepared = codec::prepareTrials(*mFrames, codec, progress.part(0.1, PreparedAt));
        if (!prepared)
            return fail(std::move(prepared).error());
        encoder = std::move(*prepared);
    }
    return encoder.get();
}

Result<TrialOutcome> TrialBench::attempt(const CodecSettings &settings, const Progress &progress)
{
    const std::lock_guard lock(mMutex);
    const auto encoder = encoderOf(CompressionSettings{settings}.codec(), progress);
    if (!encoder)
        return fail(encoder.error());
    auto trial = (*encoder)->attempt(settings, progress.part(PreparedAt, 1));
    if (!trial)
        return fail(std::move(trial).error());
    return TrialOutcome{*trial, {*trial}};
}

Result<TrialOutcome> TrialBench::search(CodecId codec, const QualityTarget &target, const Progress &progress)
{
    const std::lock_guard lock(mMutex);
    const auto encoder = encoderOf(codec, progress);
    if (!encoder)
        return fail(encoder.error());
    TrialOutcome outcome;
    const codec::TrialObserver observe = [&](const codec::Trial &trial) { outcome.tried.push_back(trial); };
    const Progress rest = progress.part(PreparedAt, 1);
    if (!std::holds_alternative<MaxVertexError>(target)) {
        auto found = codec::searchSettings(**encoder, target, rest, observe);
        if (!found)
            return fail(std::move(found).error());
        outcome.found = std::move(*found);
        return outcome;
    }
    const auto made = codec::encodeToTarget(*mFrames, **encoder, false, target, rest, observe);
    if (!made)
        return fail(made.error());
    outcome.found = {made->settings.method, made->encoded.bytes.size(), made->errors.kgErrorPercent};
    outcome.tried.push_back(outcome.found);
    return outcome;
}

} // namespace views
