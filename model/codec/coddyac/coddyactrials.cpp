// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/coddyac/coddyaccodec.h"
#include "model/codec/coddyac/coddyacencoder.h"

#include <cmath>

namespace model::codec {

namespace {

// As in `pca`: larger bases are chosen by hand, and a family each 12 % of basis size.
constexpr std::uint32_t MostTrajectories = 160;
constexpr double FamilyRatio = 1.12;
constexpr double CoarsestStep = 0.3;
constexpr double FinestStep = CoddyacSettings::MinStep;
// The basis' step in the coefficients' steps; the README has what others give.
constexpr double BasisStepRatio = 1.2;

class CoddyacTrials final : public TrialEncoder
{
public:
    explicit CoddyacTrials(CoddyacEncoder encoder)
        : mEncoder(std::move(encoder))
        , mEnergy(mEncoder.frames().centredEnergy())
    {
        const std::size_t count = std::max<std::size_t>(1, mEncoder.basisSize());
        for (std::uint32_t size = 1; size < count; size = std::max(size + 1, std::uint32_t(size * FamilyRatio)))
            mBasisSizes.push_back(size);
        mBasisSizes.push_back(std::uint32_t(count));
    }

    std::size_t familyCount() const override { return mBasisSizes.size(); }
    CodecSettings settingsAt(std::size_t family, double fineness) const override
    {
        const double step = CoarsestStep * std::pow(FinestStep / CoarsestStep, fineness);
        return CoddyacSettings{mBasisSizes[family], step, step * BasisStepRatio};
    }

    Result<Trial> attempt(const CodecSettings &settings, const Progress &progress) override
    {
        double squaredError = 0;
        const Result<EncodedAnimation> encoded =
            mEncoder.encode(std::get<CoddyacSettings>(settings), false, squaredError, progress);
        if (!encoded)
            return fail(encoded.error());
        return Trial{settings, encoded->bytes.size(), kgErrorOf(squaredError, mEnergy)};
    }

    Result<EncodedAnimation> encode(const CompressionSettings &settings, const Progress &progress) override
    {
        double squaredError = 0;
        return mEncoder.encode(std::get<CoddyacSettings>(settings.method), settings.keepOrder, squaredError, progress);
    }

private:
    const CoddyacEncoder mEncoder;
    const double mEnergy;
    std::vector<std::uint32_t> mBasisSizes;
};

} // namespace

Result<std::unique_ptr<TrialEncoder>> prepareCoddyacTrials(const FrameSource &source, const Progress &progress)
{
    Result<CoddyacEncoder> encoder = CoddyacEncoder::prepare(source, MostTrajectories, progress);
    if (!encoder)
        return fail(std::move(encoder).error());
    return std::make_unique<CoddyacTrials>(std::move(*encoder));
}

} // namespace model::codec
