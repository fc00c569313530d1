// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/ratecontrol.h"

#include "model/animation/settingsfields.h"
#include "model/codec/container/syntax.h"

#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace model::codec {

namespace {

// A family is worth comparing once its error lies this close below the target, the best one is refined to this close.
// Tried on dance and cow: coarser comparisons pick other families at times, for 1 % of size; finer ones take longer.
constexpr double CompareTolerance = 0.05;
constexpr double FinalTolerance = 0.003;
constexpr int MostSteps = 24;
// Decoders round positions to float: a hair's breadth is left for that.
constexpr double RoundingShare = 1e-4;
// How often a target is tightened when what was decoded turns out to miss it.
constexpr int MostCorrections = 8;

double logOf(double value)
{
    return std::log(std::max(value, 1e-300));
}

/// A position between 0 and 1 where a falling function of it passes from above `limit` to below it.
///
/// \param value      called with positions; its logarithm should fall about evenly
/// \param tolerance  done when the value is within this share below the limit
/// \returns          the coarsest position found whose value is not above the limit; nothing if even that at 1 is
template <class Function>
Result<std::optional<double>> crossing(Function &&value, double limit, double tolerance)
{
    double coarse = 0, fine = 1;
    const Result<double> atFine = value(fine);
    if (!atFine)
        return fail(atFine.error());
    if (*atFine > limit)
        return std::optional<double>();
    const Result<double> atCoarse = value(coarse);
    if (!atCoarse)
        return fail(atCoarse.error());
    if (*atCoarse <= limit)
        return std::optional(coarse);
    // False position aimed at the middle of what will do; an end that stays twice in a row counts half (Illinois), or
    // it would hold the other one back where the values bend. Halving where even that is slow.
    constexpr int Patience = 8;
    const double aim = logOf(limit) + std::log1p(-tolerance / 2);
    double above = logOf(*atCoarse) - aim, below = logOf(*atFine) - aim;
    double reached = logOf(*atFine);
    int side = 0;
    for (int step = 0; step < MostSteps && reached < logOf(limit) + std::log1p(-tolerance); ++step) {
        const double share = step < Patience ? std::clamp(above / (above - below), 0.02, 0.98) : 0.5;
        const double at = coarse + share * (fine - coarse);
        const Result<double> found = value(at);
        if (!found)
            return fail(found.error());
        if (*found > limit) {
            coarse = at;
            above = std::max(logOf(*found) - aim, 0.0);
            below *= side > 0 ? 0.5 : 1;
            side = 1;
        } else {
            fine = at;
            reached = logOf(*found);
            below = std::min(reached - aim, 0.0);
            above *= side < 0 ? 0.5 : 1;
            side = -1;
        }
        if (fine - coarse < 1e-4)
            break;
    }
    return std::optional(fine);
}

/// One search: what it looks for, and everything it has tried.
class Search
{
public:
    Search(TrialEncoder &encoder, const Progress &progress, const TrialObserver &observe)
        : mEncoder(encoder)
        , mProgress(progress)
        , mObserve(observe)
    {}

    /// The smallest file whose error is at most `percent`.
    Result<std::optional<Trial>> withinError(double percent)
    {
        return best(
            [&](std::size_t family, double tolerance) -> Result<std::optional<Trial>> {
                const auto position =
                    crossing([&](double fineness) { return countedError(mEncoder.settingsAt(family, fineness)); },
                             percent, tolerance);
                return trialAt(family, position);
            },
            [](const Trial &trial) { return double(trial.bytes); });
    }

    /// The least error in at most so many bytes.
    Result<std::optional<Trial>> withinBytes(std::uint64_t bytes)
    {
        return best(
            [&](std::size_t family, double tolerance) -> Result<std::optional<Trial>> {
                // Sizes fall as fineness does: the position is counted from the fine end.
                const auto position = crossing(
                    [&](double coarseness) {
                        return attempt(mEncoder.settingsAt(family, 1 - coarseness)).map([](const Trial &trial) {
                            return double(trial.bytes);
                        });
                    },
                    double(bytes), tolerance);
                if (!position)
                    return fail(position.error());
                return trialAt(family, *position ? std::optional(1 - **position) : std::nullopt);
            },
            [](const Trial &trial) { return trial.kgErrorPercent; });
    }

    /// The family of what was found last.
    std::size_t family() const { return mFamily; }

private:
    static constexpr double Nothing = std::numeric_limits<double>::infinity();

    Result<Trial> attempt(const CodecSettings &settings)
    {
        const std::string key = settingsText({settings});
        if (const auto known = mTrials.find(key); known != mTrials.end())
            return known->second;
        count();
        Result<Trial> trial = mEncoder.attempt(settings, silent());
        if (!trial)
            return trial;
        mTrials.emplace(key, *trial);
        if (mObserve)
            mObserve(*trial);
        return trial;
    }

    Result<double> countedError(const CodecSettings &settings)
    {
        if (const auto known = mTrials.find(settingsText({settings})); known != mTrials.end())
            return known->second.kgErrorPercent;
        if (auto quick = mEncoder.quickKgError(settings, silent())) {
            count();
            return std::move(*quick);
        }
        return attempt(settings).map([](const Trial &trial) { return trial.kgErrorPercent; });
    }

    Result<std::optional<Trial>> trialAt(std::size_t family, const Result<std::optional<double>> &position)
    {
        if (!position)
            return fail(position.error());
        if (!*position)
            return std::optional<Trial>();
        Result<Trial> trial = attempt(mEncoder.settingsAt(family, **position));
        if (!trial)
            return fail(std::move(trial).error());
        return std::optional(std::move(*trial));
    }

    /// The best family by thirds: its neighbours are worse and worse. Families that cannot reach the target at all lie
    /// at the beginning of the list.
    template <class Solve, class Cost>
    Result<std::optional<Trial>> best(Solve &&solve, Cost &&cost)
    {
        std::map<std::size_t, double> costs;
        std::optional<Error> error;
        const auto costOf = [&](std::size_t family) {
            if (const auto known = costs.find(family); known != costs.end())
                return known->second;
            const Result<std::optional<Trial>> trial = solve(family, CompareTolerance);
            if (!trial)
                error = trial.error();
            return costs[family] = trial && *trial ? cost(**trial) : Nothing;
        };
        std::size_t low = 0, high = mEncoder.familyCount() - 1;
        while (high - low > 2 && !error) {
            const std::size_t third = (high - low) / 3;
            const std::size_t left = low + third, right = high - third;
            if (costOf(left) < costOf(right))
                high = right;
            else
                low = left;
        }
        std::size_t family = high;
        for (std::size_t i = low; i < high && !error; ++i)
            if (costOf(i) < costOf(family))
                family = i;
        if (error)
            return fail(*error);
        mFamily = family;
        return solve(family, FinalTolerance);
    }

    Progress silent() const { return mProgress.part(mDone, mDone); }
    /// How many trials there will be is not known: the report nears the end without reaching it.
    void count()
    {
        constexpr double Typical = 30;
        mTries += 1;
        mDone = mTries / (mTries + Typical);
        mProgress.report(mDone);
    }

    TrialEncoder &mEncoder;
    const Progress mProgress;
    const TrialObserver &mObserve;
    std::map<std::string, Trial> mTrials;
    std::size_t mFamily = 0;
    double mTries = 0;
    double mDone = 0;
};

/// The error of a target that no settings of the codec reach, with the best that they do.
tl::unexpected<Error> unreachable(TrialEncoder &encoder, const QualityTarget &target, const Progress &progress)
{
    const bool isSize = std::holds_alternative<MaxBytes>(target);
    const auto best =
        encoder.attempt(isSize ? encoder.settingsAt(0, 0) : encoder.settingsAt(encoder.familyCount() - 1, 1), progress);
    if (!best)
        return fail(best.error());
    if (isSize)
        return fail(ErrorCode::BadSetting, "largest size", std::to_string(std::get<MaxBytes>(target).bytes),
                    "from " + std::to_string(best->bytes) + " bytes with this codec");
    const std::string least = "from a KG error of " + numberText(best->kgErrorPercent) + " % with this codec";
    if (const auto *quality = std::get_if<Quality>(&target))
        return fail(ErrorCode::BadSetting, "quality", numberText(quality->value), least);
    if (const auto *vertex = std::get_if<MaxVertexError>(&target))
        return fail(ErrorCode::BadSetting, "largest vertex error", numberText(vertex->fraction), least);
    return fail(ErrorCode::BadSetting, "largest KG error", numberText(std::get<MaxKgError>(target).percent), least);
}

double kgTargetOf(const QualityTarget &target)
{
    if (const auto *quality = std::get_if<Quality>(&target))
        return kgErrorOfQuality(quality->value);
    return std::get<MaxKgError>(target).percent;
}

Result<void> checkTarget(const QualityTarget &target)
{
    const auto check = [](const char *what, double value, double least, double most) -> Result<void> {
        if (value >= least && value <= most)
            return {};
        return fail(ErrorCode::BadSetting, what, numberText(value), numberText(least) + " ... " + numberText(most));
    };
    return std::visit(
        [&](const auto &t) -> Result<void> {
            using T = std::decay_t<decltype(t)>;
            if constexpr (std::is_same_v<T, Quality>)
                return check("quality", t.value, 0, 1);
            else if constexpr (std::is_same_v<T, MaxKgError>)
                return check("largest KG error", t.percent, MinKgTarget, MaxKgTarget);
            else if constexpr (std::is_same_v<T, MaxVertexError>)
                return check("largest vertex error", t.fraction, MinVertexTarget, MaxVertexTarget);
            else
                return {};
        },
        target);
}

/// Encodes, decodes and measures.
Result<TargetedEncoding> measured(const FrameSource &source, TrialEncoder &encoder, const CompressionSettings &settings,
                                  const Progress &progress)
{
    auto encoded = encoder.encode(settings, progress.part(0, 0.5));
    if (!encoded)
        return fail(encoded.error());
    const auto decoded = decodeAnimation(encoded->bytes, progress.part(0.5, 0.6));
    if (!decoded)
        return fail(decoded.error());
    auto errors = compareAnimations(source, **decoded, encoded->permutation, progress.part(0.6, 1));
    if (!errors)
        return fail(errors.error());
    return TargetedEncoding{std::move(*encoded), settings, std::move(*errors)};
}

} // namespace

Result<Trial> searchSettings(TrialEncoder &encoder, const QualityTarget &target, const Progress &progress,
                             const TrialObserver &observe)
{
    if (const auto checked = checkTarget(target); !checked)
        return fail(checked.error());
    assert(!std::holds_alternative<MaxVertexError>(target));
    Search search(encoder, progress, observe);
    const auto *size = std::get_if<MaxBytes>(&target);
    Result<std::optional<Trial>> found =
        size ? search.withinBytes(size->bytes) : search.withinError(kgTargetOf(target) * (1 - RoundingShare));
    if (!found)
        return fail(std::move(found).error());
    if (!*found)
        return unreachable(encoder, target, progress);
    return std::move(**found);
}

namespace {

bool isUnreachable(const Error &error)
{
    return error.code == ErrorCode::BadSetting;
}

/// Until what is decoded keeps to the KG error too.
Result<TargetedEncoding> encodeWithinError(const FrameSource &source, TrialEncoder &encoder, bool keepOrder,
                                           const QualityTarget &target, const Progress &progress,
                                           const TrialObserver &observe)
{
    const double percent = kgTargetOf(target);
    double aim = percent;
    for (int i = 0; i < MostCorrections; ++i) {
        const Result<Trial> trial = searchSettings(encoder, MaxKgError{std::max(aim, MinKgTarget)}, progress, observe);
        if (!trial)
            return isUnreachable(trial.error()) ? unreachable(encoder, target, progress) : fail(trial.error());
        Result<TargetedEncoding> result =
            measured(source, encoder, {trial->settings, keepOrder}, progress.part(0.9, 1));
        if (!result || result->errors.kgErrorPercent <= percent)
            return result;
        aim *= std::min(0.999, percent / result->errors.kgErrorPercent * 0.999);
    }
    return unreachable(encoder, target, progress);
}

/// The largest error of a vertex is not seen in the coefficients: the family is chosen by a KG error that is guessed
/// from it, corrected once, and within that family frames are decoded.
Result<TargetedEncoding> encodeWithinVertexError(const FrameSource &source, TrialEncoder &encoder, bool keepOrder,
                                                 const MaxVertexError &target, const Progress &progress,
                                                 const TrialObserver &observe)
{
    constexpr double Tolerance = 0.02;
    std::optional<TargetedEncoding> best;
    /// The largest error over the one allowed.
    const auto ratioOf = [&](const CodecSettings &settings) -> Result<double> {
        Result<TargetedEncoding> result = measured(source, encoder, {settings, keepOrder}, progress.part(0.9, 0.9));
        if (!result)
            return fail(std::move(result).error());
        const double allowed = target.fraction * result->errors.diagonal;
        const double largest = result->errors.maxVertexError;
        const double ratio = allowed > 0 ? largest / allowed : largest > 0 ? 2 : 0;
        if (ratio <= 1 && (!best || result->encoded.bytes.size() < best->encoded.bytes.size()))
            best = std::move(*result);
        return ratio;
    };

    Search search(encoder, progress, observe);
    double percent = std::clamp(100 * target.fraction, MinKgTarget, MaxKgTarget);
    for (int guess = 0; guess < 2; ++guess) {
        const auto found = search.withinError(percent);
        if (!found)
            return fail(found.error());
        if (!*found)
            break; // only the last family, if any, can come so close
        const Result<double> ratio = ratioOf((*found)->settings);
        if (!ratio)
            return fail(ratio.error());
        percent = std::clamp(percent / std::max(*ratio, 1e-3), MinKgTarget, MaxKgTarget);
    }
    // In larger families too, if the one chosen cannot keep to it.
    for (std::size_t family = search.family(); family < encoder.familyCount();
         family += 1 + encoder.familyCount() / 8) {
        const auto position =
            crossing([&](double fineness) { return ratioOf(encoder.settingsAt(family, fineness)); }, 1.0, Tolerance);
        if (!position)
            return fail(position.error());
        if (*position)
            return std::move(*best);
    }
    return unreachable(encoder, target, progress);
}

} // namespace

Result<TargetedEncoding> encodeToTarget(const FrameSource &source, TrialEncoder &encoder, bool keepOrder,
                                        const QualityTarget &target, const Progress &progress,
                                        const TrialObserver &observe)
{
    if (const auto checked = checkTarget(target); !checked)
        return fail(checked.error());
    if (const auto *vertex = std::get_if<MaxVertexError>(&target))
        return encodeWithinVertexError(source, encoder, keepOrder, *vertex, progress, observe);
    if (!std::holds_alternative<MaxBytes>(target))
        return encodeWithinError(source, encoder, keepOrder, target, progress, observe);
    const Result<Trial> trial = searchSettings(encoder, target, progress, observe);
    if (!trial)
        return fail(trial.error());
    return measured(source, encoder, {trial->settings, keepOrder}, progress.part(0.9, 1));
}

Result<TargetedEncoding> encodeToTarget(const FrameSource &source, CodecId codec, bool keepOrder,
                                        const QualityTarget &target, const Progress &progress,
                                        const TrialObserver &observe)
{
    // Refused before anything is analysed.
    if (const auto checked = checkTarget(target); !checked)
        return fail(checked.error());
    const auto encoder = prepareTrials(source, codec, progress.part(0, 0.2));
    if (!encoder)
        return fail(encoder.error());
    return encodeToTarget(source, **encoder, keepOrder, target, progress.part(0.2, 1), observe);
}

} // namespace model::codec
