// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/settingsfields.h"

#include "model/base/numbertext.h"

#include <array>
#include <charconv>
#include <system_error>

namespace model {

namespace {

constexpr std::array CodecKeys{
    std::pair{CodecId::Direct, std::string_view("direct")}, std::pair{CodecId::Pca, std::string_view("pca")},
    std::pair{CodecId::Coddyac, std::string_view("coddyac")}, std::pair{CodecId::Reel, std::string_view("reel")}};
constexpr std::array PredictorKeys{
    std::pair{Predictor::None, std::string_view("none")}, std::pair{Predictor::Still, std::string_view("A")},
    std::pair{Predictor::Steady, std::string_view("B")}, std::pair{Predictor::Accelerating, std::string_view("C")},
    std::pair{Predictor::Neighbours, std::string_view("N")}};
constexpr std::array EntropyKeys{std::pair{Entropy::Deflate, std::string_view("deflate")},
                                 std::pair{Entropy::Range, std::string_view("range")}};
constexpr std::string_view KeepOrderKey = "keep-order";

template <class Table, class Value>
std::string_view keyOf(const Table &table, Value value)
{
    for (const auto &[known, key] : table)
        if (known == value)
            return key;
    return {};
}

char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
}

bool isSameWord(std::string_view a, std::string_view b)
{
    if (a.size() != b.size())
        return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (lower(a[i]) != lower(b[i]))
            return false;
    return true;
}

template <class Table, class Value>
bool takeKey(const Table &table, std::string_view text, Value &value)
{
    for (const auto &[known, key] : table)
        if (isSameWord(key, text))
            return value = known, true;
    return false;
}

template <class Number>
bool takeNumber(std::string_view text, Number &value)
{
    Number read{};
    const char *end = text.data() + text.size();
    const auto [at, error] = std::from_chars(text.data(), end, read);
    if (error != std::errc() || at != end)
        return false;
    return value = read, true;
}

/// Cuts the first word off.
std::string_view takeWord(std::string_view &rest)
{
    const std::size_t end = std::min(rest.find(' '), rest.size());
    const std::string_view word = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return word;
}

/// Takes "key=value" into the field of that key.
bool takeAssignment(std::string_view word, CodecSettings &method)
{
    const std::size_t equals = word.find('=');
    if (equals == word.npos)
        return false;
    bool taken = false;
    visitFields(method, [&](const auto &field, auto &value) {
        auto read = value;
        if (field.key != word.substr(0, equals) || !parseField(word.substr(equals + 1), read) || !field.allows(read))
            return;
        value = read;
        taken = true;
    });
    return taken;
}

} // namespace

std::string_view codecKey(CodecId codec)
{
    return keyOf(CodecKeys, codec);
}

std::optional<CodecId> codecOfKey(std::string_view key)
{
    CodecId codec{};
    return takeKey(CodecKeys, key, codec) ? std::optional(codec) : std::nullopt;
}

std::string fieldText(std::uint32_t value)
{
    return numberText(value);
}

std::string fieldText(double value)
{
    return numberText(value);
}

std::string fieldText(Predictor value)
{
    return std::string(keyOf(PredictorKeys, value));
}

std::string fieldText(Entropy value)
{
    return std::string(keyOf(EntropyKeys, value));
}

bool parseField(std::string_view text, std::uint32_t &value)
{
    return takeNumber(text, value);
}

bool parseField(std::string_view text, double &value)
{
    return takeNumber(text, value);
}

bool parseField(std::string_view text, Predictor &value)
{
    return takeKey(PredictorKeys, text, value);
}

bool parseField(std::string_view text, Entropy &value)
{
    return takeKey(EntropyKeys, text, value);
}

std::string settingsText(const CompressionSettings &settings)
{
    std::string text(codecKey(settings.codec()));
    visitFields(settings.method, [&](const auto &field, const auto &value) {
        text.append(" ").append(field.key).append("=").append(fieldText(value));
    });
    if (settings.keepOrder)
        text.append(" ").append(KeepOrderKey);
    return text;
}

std::optional<CompressionSettings> settingsFromText(std::string_view text)
{
    const std::optional<CodecId> codec = codecOfKey(takeWord(text));
    if (!codec)
        return std::nullopt;
    CompressionSettings settings{defaultSettings(*codec)};
    while (!text.empty()) {
        const std::string_view word = takeWord(text);
        if (word == KeepOrderKey)
            settings.keepOrder = true;
        else if (!takeAssignment(word, settings.method))
            return std::nullopt;
    }
    return settings;
}

} // namespace model
