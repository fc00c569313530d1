// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/entropy/indexstage.h"
#include "model/codec/pca/pcacodec.h"

#include <charconv>
#include <cmath>
#include <numeric>

namespace model::codec {

namespace {

// Larger bases are found by hand: so many trajectories at once are what the analysis of a long animation can afford.
constexpr std::uint32_t MostTrajectories = 160;
// Basis sizes of the families: 1, 2, 3, ... each some 12 % above the one before, which is 1 % of size.
constexpr double FamilyRatio = 1.12;
// Of the longest side of the animation's box, 0.2 % of a thousandth to 3 %: beyond, nothing is gained or left.
constexpr double CoarsestSteps = 30;
constexpr double FinestSteps = 3e6;

/// Rounded to four significant digits: a number that people can read, and type again.
double fourDigits(double value)
{
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 4).ptr;
    std::from_chars(text, end, value);
    return value;
}

class PcaTrials final : public TrialEncoder
{
public:
    PcaTrials(const FrameSource &source, FrameStack frames, PrincipalComponents components, Bytes indices)
        : mSource(source)
        , mFrames(std::move(frames))
        , mComponents(std::move(components))
        , mIndices(std::move(indices))
        , mEnergy(mFrames.centredEnergy())
    {
        const std::size_t count = std::max<std::size_t>(1, mComponents.count());
        for (std::uint32_t size = 1; size < count; size = std::max(size + 1, std::uint32_t(size * FamilyRatio)))
            mBasisSizes.push_back(size);
        mBasisSizes.push_back(std::uint32_t(count));
        // Steps are counted in an animation's own measure: the root mean square distance from its mean vertices.
        const double samples = double(mFrames.frameCount()) * mFrames.vertexCount();
        mUnit = mEnergy > 0 ? std::sqrt(mEnergy / samples) : 1;
    }

    std::size_t familyCount() const override { return mBasisSizes.size(); }
    CodecSettings settingsAt(std::size_t family, double fineness) const override
    {
        const double steps = CoarsestSteps * std::pow(FinestSteps / CoarsestSteps, fineness);
        return PcaSettings{mBasisSizes[family], std::clamp(fourDigits(steps / mUnit), PcaSettings::MinResolution,
                                                           PcaSettings::MaxResolution)};
    }

    Result<Trial> attempt(const CodecSettings &settings, const Progress &progress) override
    {
        double squaredError = 0;
        const Result<Bytes> file = bytesOf(std::get<PcaSettings>(settings), squaredError, progress);
        if (!file)
            return fail(file.error());
        return Trial{settings, file->size(), kgErrorOf(squaredError, mEnergy)};
    }

    Result<EncodedAnimation> encode(const CompressionSettings &settings, const Progress &progress) override
    {
        double squaredError = 0;
        Result<Bytes> file = bytesOf(std::get<PcaSettings>(settings.method), squaredError, progress);
        if (!file)
            return fail(std::move(file).error());
        EncodedAnimation encoded{std::move(*file), std::vector<std::uint32_t>(mSource.vertexCount())};
        std::iota(encoded.permutation.begin(), encoded.permutation.end(), 0u);
        return encoded;
    }

private:
    Result<Bytes> bytesOf(const PcaSettings &settings, double &squaredError, const Progress &progress) const
    {
        const Result<QuantizedPca> pca = mComponents.quantized(mFrames, settings, progress.part(0, 0.5));
        if (!pca)
            return fail(pca.error());
        squaredError = pca->squaredError;
        return assemblePca(mSource, settings, *pca, mIndices, progress.part(0.5, 1));
    }

    const FrameSource &mSource;
    const FrameStack mFrames;
    const PrincipalComponents mComponents;
    const Bytes mIndices;
    const double mEnergy;
    double mUnit = 1;
    std::vector<std::uint32_t> mBasisSizes;
};

} // namespace

Result<std::unique_ptr<TrialEncoder>> preparePcaTrials(const FrameSource &source, const Progress &progress)
{
    Result<FrameStack> frames = FrameStack::gather(source, progress.part(0, 0.1));
    if (!frames)
        return fail(std::move(frames).error());
    Result<PrincipalComponents> components =
        PrincipalComponents::of(*frames, MostTrajectories, progress.part(0.1, 0.95));
    if (!components)
        return fail(std::move(components).error());
    Result<Bytes> indices = encodeIndices(source.connectivity(), progress.part(0.95, 1));
    if (!indices)
        return fail(std::move(indices).error());
    return std::make_unique<PcaTrials>(source, std::move(*frames), std::move(*components), std::move(*indices));
}

} // namespace model::codec
