// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/compressionsettings.h"

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace model {

/// The name of a field of a codec's settings and what it may hold, ends included.
template <class T>
struct SettingField
{
    std::string_view key; ///< as on the command line and in texts for machines
    T least;
    T most;

    /// False also for what is not a number.
    bool allows(T value) const { return value >= least && value <= most; }
};

/// A number, not a choice of words.
template <class Value>
inline constexpr bool IsNumberField = std::is_arithmetic_v<Value>;

template <class Settings, class Wanted>
concept SettingsOf = std::same_as<std::remove_const_t<Settings>, Wanted>;

// visitFields(settings, visit) calls visit(field, value) for each field, `value` a reference into `settings`. The one
// place that lists the fields: checks, texts, digests, the command line and the dialogs all go through it.

template <SettingsOf<DirectSettings> S, class Visit>
void visitFields(S &s, Visit &&visit)
{
    using D = DirectSettings;
    visit(SettingField<std::uint32_t>{"resolution", D::MinResolution, D::MaxResolution}, s.resolution);
    visit(SettingField<Predictor>{"predictor", Predictor::None, Predictor::Neighbours}, s.predictor);
    visit(SettingField<Entropy>{"entropy", Entropy::Deflate, Entropy::Range}, s.entropy);
}

template <SettingsOf<PcaSettings> S, class Visit>
void visitFields(S &s, Visit &&visit)
{
    using P = PcaSettings;
    visit(SettingField<std::uint32_t>{"basis", P::MinBasisSize, P::MaxBasisSize}, s.basisSize);
    visit(SettingField<double>{"resolution", P::MinResolution, P::MaxResolution}, s.resolution);
}

template <SettingsOf<CoddyacSettings> S, class Visit>
void visitFields(S &s, Visit &&visit)
{
    using C = CoddyacSettings;
    visit(SettingField<std::uint32_t>{"basis", C::MinBasisSize, C::MaxBasisSize}, s.basisSize);
    visit(SettingField<double>{"step", C::MinStep, C::MaxStep}, s.step);
    visit(SettingField<double>{"basis-step", C::MinBasisStep, C::MaxBasisStep}, s.basisStep);
}

template <SettingsOf<ReelSettings> S, class Visit>
void visitFields(S &s, Visit &&visit)
{
    using R = ReelSettings;
    visit(SettingField<double>{"step", R::MinStep, R::MaxStep}, s.step);
    visit(SettingField<std::uint32_t>{"basis", R::MinBasisSize, R::MaxBasisSize}, s.basisSize);
}

/// The fields of whichever codec it is.
template <class Variant, class Visit>
requires SettingsOf<Variant, CodecSettings>
void visitFields(Variant &method, Visit &&visit)
{
    std::visit([&](auto &settings) { visitFields(settings, visit); }, method);
}

/// The codec keeps the order of vertices and triangles whether or not it is asked to.
inline bool keepsOrderAnyway(CodecId codec)
{
    return codec == CodecId::Direct || codec == CodecId::Pca;
}

/// The codec's name as on the command line: "direct", "pca", "coddyac", "reel".
std::string_view codecKey(CodecId codec);
std::optional<CodecId> codecOfKey(std::string_view key);

/// A field's value as on the command line; numbers in their shortest exact form, independent of the locale.
std::string fieldText(std::uint32_t value);
std::string fieldText(double value);
std::string fieldText(Predictor value); ///< "none", "A", "B", "C", "N"
std::string fieldText(Entropy value);   ///< "deflate", "range"
/// The inverse; false leaves `value` as it was. Says nothing about ranges.
bool parseField(std::string_view text, std::uint32_t &value);
bool parseField(std::string_view text, double &value);
bool parseField(std::string_view text, Predictor &value);
bool parseField(std::string_view text, Entropy &value);

/// All of the settings as one line of words: "pca basis=20 resolution=10000", with "keep-order" at its end if they do.
std::string settingsText(const CompressionSettings &settings);
/// The inverse; fields that are not named have their defaults. Nothing for unknown words, or values out of range.
std::optional<CompressionSettings> settingsFromText(std::string_view text);

} // namespace model
