// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/reel/reelcodec.h"

#include <cmath>

namespace model::codec {

namespace {

// From a KG error of some 15 % to below 0.005 %, where the estimate of the error would drown in floats.
constexpr double CoarsestStep = 0.1;
constexpr double FinestStep = 2e-5;

class ReelTrials final : public TrialEncoder
{
public:
    ReelTrials(const FrameSource &source, std::unique_ptr<FrameStack> frames, ReelEncoder encoder)
        : mSource(source)
        , mFrames(std::move(frames))
        , mEncoder(std::move(encoder))
    {}

    std::size_t familyCount() const override { return 1; }
    CodecSettings settingsAt(std::size_t, double fineness) const override
    {
        return ReelSettings{CoarsestStep * std::pow(FinestStep / CoarsestStep, fineness), 0};
    }

    Result<Trial> attempt(const CodecSettings &settings, const Progress &progress) override
    {
        const Result<ReelChoice> choice = mEncoder.choose(std::get<ReelSettings>(settings), progress.part(0, 0.8));
        if (!choice)
            return fail(choice.error());
        const Result<EncodedAnimation> file = assembleReel(mSource, mEncoder, *choice, false, progress.part(0.8, 1));
        if (!file)
            return fail(file.error());
        return Trial{settings, file->bytes.size(), kgErrorOf(choice->squaredError, mEncoder.energy())};
    }

    Result<EncodedAnimation> encode(const CompressionSettings &settings, const Progress &progress) override
    {
        const Result<ReelChoice> choice =
            mEncoder.choose(std::get<ReelSettings>(settings.method), progress.part(0, 0.8));
        if (!choice)
            return fail(choice.error());
        return assembleReel(mSource, mEncoder, *choice, settings.keepOrder, progress.part(0.8, 1));
    }

private:
    const FrameSource &mSource;
    const std::unique_ptr<FrameStack> mFrames; ///< that the encoder refers to
    ReelEncoder mEncoder;
};

} // namespace

Result<std::unique_ptr<TrialEncoder>> prepareReelTrials(const FrameSource &source, const Progress &progress)
{
    Result<FrameStack> frames = FrameStack::gather(source, progress.part(0, 0.2));
    if (!frames)
        return fail(std::move(frames).error());
    Result<EncodedConnectivity> connectivity = encodeConnectivity(source.connectivity(), progress.part(0.2, 0.3));
    if (!connectivity)
        return fail(std::move(connectivity).error());
    auto kept = std::make_unique<FrameStack>(std::move(*frames));
    Result<ReelEncoder> encoder = ReelEncoder::prepare(*kept, std::move(*connectivity), progress.part(0.3, 1));
    if (!encoder)
        return fail(std::move(encoder).error());
    return std::make_unique<ReelTrials>(source, std::move(kept), std::move(*encoder));
}

} // namespace model::codec
