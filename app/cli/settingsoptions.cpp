// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/settingsoptions.h"

#include "model/animation/settingsfields.h"
#include "model/codec/animationcodec.h"

namespace cli {

namespace {

struct OptionText
{
    std::string_view key;
    const char *typeName;
    const char *description;
};

constexpr OptionText OptionTexts[] = {
    {"basis", "K", "Basis trajectories to keep: more is larger and more exact"},
    {"step", "D", "Rounding step of the coefficients, relative"},
    {"basis-step", "D", "Quantisation step of the basis"},
    {"resolution", "R", "Steps per unit of length (pca), cells along the longest side (direct)"},
    {"predictor", "none|A|B|C|N", "A frame is predicted from nothing, 1, 2, 3 frames, or neighbours too"},
    {"entropy", "deflate|range", "How numbers are packed"},
};

/// Calls visit(codec, field, its default) for each field of each codec that there is.
template <class Visit>
void visitAllFields(Visit &&visit)
{
    for (const model::CodecId codec : model::codec::availableCodecs()) {
        model::CodecSettings method = model::defaultSettings(codec);
        model::visitFields(method, [&](const auto &field, const auto &value) { visit(codec, field, value); });
    }
}

std::string codecList(std::string_view separator)
{
    std::string list;
    for (const model::CodecId codec : model::codec::availableCodecs())
        list.append(list.empty() ? "" : separator).append(model::codecKey(codec));
    return list;
}

/// "pca 20, reel 0": the codecs that have the field, with their defaults. Empty if none has.
std::string defaultsOf(std::string_view key)
{
    std::string list;
    visitAllFields([&](model::CodecId codec, const auto &field, const auto &value) {
        if (field.key == key)
            list.append(list.empty() ? "" : ", ")
                .append(model::codecKey(codec))
                .append(" ")
                .append(model::fieldText(value));
    });
    return list;
}

std::string optionsOf(model::CodecSettings method)
{
    std::string list;
    model::visitFields(
        method, [&](const auto &field, const auto &) { list.append(list.empty() ? "--" : ", --").append(field.key); });
    return list;
}

template <class Field, class Value>
model::Result<void> takeField(const Field &field, Value &value, const std::string &text)
{
    Value read = value;
    if (!model::parseField(text, read) || !field.allows(read))
        return model::fail(model::ErrorCode::BadSetting, "--" + std::string(field.key), text,
                           model::fieldText(field.least) + " ... " + model::fieldText(field.most));
    value = read;
    return {};
}

} // namespace

void SettingsOptions::addTo(CLI::App &command)
{
    mCodec = model::codecKey(model::CompressionSettings().codec());
    command.add_option("--codec", mCodec, "How to encode")->type_name(codecList("|"))->capture_default_str();
    for (const OptionText &text : OptionTexts) {
        const std::string defaults = defaultsOf(text.key);
        if (defaults.empty())
            continue;
        command
            .add_option("--" + std::string(text.key), mGiven[std::string(text.key)],
                        std::string(text.description) + " [" + defaults + "]")
            ->type_name(text.typeName);
    }
    command.add_flag("--keep-order", mKeepOrder, "Keep the order of vertices and triangles, whatever the codec");

    std::vector<CLI::Option *> targets;
    const auto addTarget = [&](const char *name, const char *typeName, const char *description, auto make) {
        targets.push_back(command
                              .add_option_function<double>(
                                  name,
                                  [this, name, make](const double &value) {
                                      mTarget = make(value);
                                      mTargetOption = name;
                                  },
                                  description)
                              ->type_name(typeName));
    };
    addTarget("--quality", "Q", "Search settings for this quality: 0 (KG error 10 %) ... 1 (0.05 %)",
              [](double value) { return model::QualityTarget(model::Quality{value}); });
    addTarget("--max-kg-error", "P", "Search settings for the smallest file with at most this KG error, per cent",
              [](double value) { return model::QualityTarget(model::MaxKgError{value}); });
    addTarget("--max-vertex-error", "E",
              "Search settings: no vertex is off by more than this fraction of the box's diagonal",
              [](double value) { return model::QualityTarget(model::MaxVertexError{value}); });
    targets.push_back(command
                          .add_option_function<std::uint64_t>(
                              "--max-bytes",
                              [this](const std::uint64_t &bytes) {
                                  mTarget = model::MaxBytes{bytes};
                                  mTargetOption = "--max-bytes";
                              },
                              "Search settings for the smallest error in a file of at most this size")
                          ->type_name("N"));
    for (CLI::Option *option : targets)
        for (CLI::Option *other : targets)
            if (option != other)
                option->excludes(other);
}

model::Result<model::CompressionSettings> SettingsOptions::settings() const
{
    const std::optional<model::CodecId> codec = model::codecOfKey(mCodec);
    const auto codecs = model::codec::availableCodecs();
    if (!codec || std::find(codecs.begin(), codecs.end(), *codec) == codecs.end())
        return model::fail(model::ErrorCode::BadSetting, "--codec", mCodec, codecList(", "));
    model::CompressionSettings settings{model::defaultSettings(*codec), mKeepOrder};
    if (mTarget)
        for (const auto &[key, text] : mGiven)
            if (text)
                return model::fail(model::ErrorCode::BadSetting, "--" + key, "used with " + mTargetOption,
                                   "one of the two");
    auto left = mGiven;
    model::Result<void> taken;
    model::visitFields(settings.method, [&](const auto &field, auto &value) {
        const auto given = left.find(field.key);
        if (given == left.end())
            return;
        if (taken && given->second)
            taken = takeField(field, value, *given->second);
        left.erase(given);
    });
    if (!taken)
        return model::fail(taken.error());
    for (const auto &[key, text] : left)
        if (text)
            return model::fail(model::ErrorCode::BadSetting, "--" + key,
                               "used with --codec " + std::string(model::codecKey(*codec)), optionsOf(settings.method));
    return settings;
}

} // namespace cli
