// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/direct/directtrials.h"

#include "model/base/parallel.h"
#include "model/codec/direct/directcodec.h"
#include "model/codec/direct/grid.h"

#include <cmath>
#include <numeric>

namespace model::codec {

namespace {

constexpr double CoarsestBits = 2; ///< of a coordinate along the longest side
constexpr double FinestBits = 24;

class DirectTrials final : public TrialEncoder
{
public:
    explicit DirectTrials(DirectEncoder encoder)
        : mEncoder(std::move(encoder))
        , mEnergy(mEncoder.frames().centredEnergy())
    {}

    std::size_t familyCount() const override { return 1; }
    CodecSettings settingsAt(std::size_t, double fineness) const override
    {
        const double bits = CoarsestBits + fineness * (FinestBits - CoarsestBits);
        return DirectSettings{std::uint32_t(std::lround(std::exp2(bits)))};
    }

    std::optional<Result<double>> quickKgError(const CodecSettings &settings, const Progress &progress) override
    {
        return kgError(settings, progress);
    }
    Result<double> kgError(const CodecSettings &settings, const Progress &progress) const
    {
        const FrameStack &frames = mEncoder.frames();
        const CellGrid grid = CellGrid::around(frames, std::get<DirectSettings>(settings).resolution);
        std::vector<double> sums(frames.frameCount());
        parallelFor(sums.size(), [&](std::size_t f) {
            if (progress.isCancelled())
                return;
            for (const Vec3f p : frames.frame(f)) {
                const Vec3f q = grid.middleOf(grid.cellOf(p));
                const double x = double(p.x) - double(q.x), y = double(p.y) - double(q.y),
                             z = double(p.z) - double(q.z);
                sums[f] += x * x + y * y + z * z;
            }
        });
        if (progress.isCancelled())
            return fail(ErrorCode::Cancelled);
        return kgErrorOf(std::accumulate(sums.begin(), sums.end(), 0.0), mEnergy);
    }

    Result<Trial> attempt(const CodecSettings &settings, const Progress &progress) override
    {
        const auto error = kgError(settings, progress);
        if (!error)
            return fail(error.error());
        const auto encoded = mEncoder.encode(std::get<DirectSettings>(settings), progress);
        if (!encoded)
            return fail(encoded.error());
        return Trial{settings, encoded->bytes.size(), *error};
    }

    Result<EncodedAnimation> encode(const CompressionSettings &settings, const Progress &progress) override
    {
        return mEncoder.encode(std::get<DirectSettings>(settings.method), progress);
    }

private:
    DirectEncoder mEncoder;
    const double mEnergy;
};

} // namespace

Result<std::unique_ptr<TrialEncoder>> prepareDirectTrials(const FrameSource &source, const Progress &progress)
{
    Result<DirectEncoder> encoder = DirectEncoder::prepare(source, progress);
    if (!encoder)
        return fail(std::move(encoder).error());
    return std::make_unique<DirectTrials>(std::move(*encoder));
}

} // namespace model::codec
