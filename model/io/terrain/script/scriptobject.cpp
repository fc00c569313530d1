// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/terrain/script/scriptobject.h"

#include <QJsonDocument>

#include <cmath>

namespace model::io {

namespace {

std::string textOf(const QJsonValue &value)
{
    if (value.isUndefined())
        return "nothing";
    constexpr qsizetype Longest = 60;
    QByteArray text = QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact);
    text = text.mid(1, text.size() - 2);
    return (text.size() > Longest ? text.left(Longest) + "..." : text).toStdString();
}

std::string rangeText(double least, double most)
{
    const auto number = [](double value) { return QString::number(value, 'g', 10).toStdString(); };
    if (std::isinf(least) && std::isinf(most))
        return "a number";
    if (std::isinf(most))
        return number(least) + " or more";
    if (std::isinf(least))
        return number(most) + " or less";
    return number(least) + " ... " + number(most);
}

} // namespace

void ScriptErrors::report(const std::string &path, const QJsonValue &value, std::string allowed)
{
    report(fail(ErrorCode::BadSetting, path.empty() ? "script" : path, textOf(value), std::move(allowed)).value());
}

ScriptObject::ScriptObject(const QJsonValue &value, std::string path, ScriptErrors &errors)
    : mObject(value.toObject())
    , mPath(std::move(path))
    , mErrors(errors)
{
    if (!value.isObject())
        mErrors.report(mPath, value, "an object");
}

QJsonValue ScriptObject::take(const char *key)
{
    const QLatin1String name(key);
    mTaken.insert(name);
    return mObject.value(name);
}

double ScriptObject::number(const char *key, double otherwise, double least, double most)
{
    const QJsonValue value = take(key);
    if (value.isUndefined())
        return otherwise;
    const double number = value.toDouble();
    if (!value.isDouble() || !(number >= least && number <= most)) {
        mErrors.report(pathOf(key), value, rangeText(least, most));
        return otherwise;
    }
    return number;
}

std::optional<double> ScriptObject::optionalNumber(const char *key)
{
    if (!has(key))
        return std::nullopt;
    return number(key, 0);
}

std::uint32_t ScriptObject::count(const char *key, std::uint32_t otherwise, std::uint32_t least, std::uint32_t most)
{
    const double value = number(key, otherwise, least, most);
    if (value != std::floor(value))
        mErrors.report(pathOf(key), value, "a whole number");
    return std::uint32_t(value);
}

bool ScriptObject::flag(const char *key, bool otherwise)
{
    const QJsonValue value = take(key);
    if (!value.isBool() && !value.isUndefined())
        mErrors.report(pathOf(key), value, "true or false");
    return value.toBool(otherwise);
}

std::string ScriptObject::text(const char *key, const std::string &otherwise)
{
    const QJsonValue value = take(key);
    if (!value.isString() && !value.isUndefined())
        mErrors.report(pathOf(key), value, "a text");
    return value.isString() ? value.toString().toStdString() : otherwise;
}

std::size_t ScriptObject::choice(const char *key, std::size_t otherwise, const std::vector<const char *> &names)
{
    const QJsonValue value = take(key);
    if (value.isUndefined())
        return otherwise;
    std::string allowed;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (value.isString() && value.toString() == QLatin1String(names[i]))
            return i;
        allowed += (i ? ", " : "") + std::string(names[i]);
    }
    mErrors.report(pathOf(key), value, allowed);
    return otherwise;
}

std::vector<double> ScriptObject::numbers(const char *key, std::size_t size, std::vector<double> otherwise)
{
    const QJsonValue value = take(key);
    if (value.isUndefined())
        return otherwise;
    const QJsonArray list = value.toArray();
    std::vector<double> numbers;
    for (const QJsonValue &number : list)
        if (number.isDouble())
            numbers.push_back(number.toDouble());
    if (numbers.size() != size || std::size_t(list.size()) != size) {
        mErrors.report(pathOf(key), value, "a list of " + std::to_string(size) + " numbers");
        return otherwise;
    }
    return numbers;
}

ScriptObject ScriptObject::object(const char *key)
{
    const QJsonValue value = take(key);
    return ScriptObject(value.isUndefined() ? QJsonValue(QJsonObject()) : value, pathOf(key), mErrors);
}

void ScriptObject::finish()
{
    for (auto it = mObject.begin(); it != mObject.end(); ++it)
        if (!mTaken.contains(it.key()))
            return mErrors.report(pathOf(it.key().toUtf8().constData()), it.value(),
                                  "nothing: there is no such key here");
}

} // namespace model::io
