// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/settingsfields.h"
#include "model/codec/ratecontrol.h"
#include "tests/bench/comparison/contender.h"
#include "tests/bench/comparison/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace bench {

using namespace model;
using namespace model::codec;

namespace {

/// The settings without the codec's name, numbers as long as tells them apart.
std::string shortText(const CodecSettings &settings)
{
    std::string text;
    visitFields(settings, [&](const auto &field, const auto &value) {
        text += (text.empty() ? "" : " ") + std::string(field.key) + '=';
        if constexpr (std::is_floating_point_v<std::decay_t<decltype(value)>>) {
            std::array<char, 32> buffer;
            std::snprintf(buffer.data(), buffer.size(), "%.4g", value);
            text += buffer.data();
        } else {
            text += fieldText(value);
        }
    });
    return text;
}

/// Encodes with the settings given, decodes, and measures.
Measurement measured(const Subject &subject, const CompressionSettings &settings)
{
    Measurement row;
    row.codec = codecKey(settings.codec());
    row.setting = shortText(settings.method);
    EncodedAnimation encoded;
    row.encodeSeconds = secondsOf([&] { encoded = *encodeAnimation(*subject.animation, settings); });
    std::shared_ptr<const DecodedAnimation> decoded;
    std::vector<Vec3f> frame(subject.animation->vertexCount());
    row.decodeSeconds = secondsOf([&] {
        decoded = *decodeAnimation(encoded.bytes);
        for (std::uint32_t f = 0; f < decoded->frameCount(); ++f)
            decoded->positions(f, frame);
    });
    row.bytes = encoded.bytes.size();
    row.kgErrorPercent = compareAnimations(*subject.animation, *decoded, encoded.permutation)->kgErrorPercent;
    return row;
}

class Predicting final : public Contender
{
public:
    explicit Predicting(CodecId codec)
        : mCodec(codec)
    {}

    std::vector<Measurement> reach(const Subject &subject, double percent) override
    {
        Result<TargetedEncoding> found;
        const double seconds =
            secondsOf([&] { found = encodeToTarget(*subject.animation, mCodec, false, MaxKgError{percent}); });
        if (!found)
            return {};
        Measurement row = measured(subject, found->settings);
        row.searchSeconds = seconds;
        return {row};
    }

private:
    const CodecId mCodec;
};

class Direct final : public Contender
{
public:
    std::vector<Measurement> reach(const Subject &subject, double percent) override
    {
        const auto resolution = directResolution(subject, percent);
        if (!resolution)
            return {};
        std::vector<Measurement> rows;
        for (int predictor = int(Predictor::None); predictor <= int(Predictor::Neighbours); ++predictor)
            for (const Entropy entropy : {Entropy::Deflate, Entropy::Range}) {
                rows.push_back(measured(subject, {DirectSettings{*resolution, Predictor(predictor), entropy}}));
                rows.back().codec += ' ' + fieldText(Predictor(predictor)) + ' ' + fieldText(entropy);
                rows.back().setting = "resolution=" + fieldText(*resolution);
            }
        return rows;
    }
};

} // namespace

std::optional<std::uint32_t> directResolution(const Subject &subject, double percent)
{
    static std::map<std::pair<std::string, double>, std::optional<std::uint32_t>> known;
    const auto [entry, isNew] = known.try_emplace({subject.name, percent});
    if (!isNew)
        return entry->second;
    const auto encoder = *prepareTrials(*subject.animation, CodecId::Direct, Progress());
    std::uint32_t coarse = DirectSettings::MinResolution, fine = DirectSettings::MaxResolution;
    const auto isWithin = [&](std::uint32_t resolution) {
        return **encoder->quickKgError(DirectSettings{resolution}, Progress()) <= percent * 0.9999;
    };
    if (!isWithin(fine))
        return {};
    while (fine - coarse > coarse / 1000 + 1) {
        const auto middle = std::clamp(std::uint32_t(std::sqrt(double(coarse) * fine)), coarse + 1, fine - 1);
        (isWithin(middle) ? fine : coarse) = middle;
    }
    return entry->second = fine;
}

std::unique_ptr<Contender> makePredicting(CodecId codec)
{
    return std::make_unique<Predicting>(codec);
}

std::unique_ptr<Contender> makeDirect()
{
    return std::make_unique<Direct>();
}

} // namespace bench
