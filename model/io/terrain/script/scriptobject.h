// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"

#include <QJsonArray>
#include <QJsonObject>

#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace model::io {

/// The first thing wrong with a script. What is read after it does not count.
class ScriptErrors
{
public:
    /// `path` leads to the value from the top, as "steps[2].tool.radius".
    void report(const std::string &path, const QJsonValue &value, std::string allowed);
    void report(Error error)
    {
        if (!mFirst)
            mFirst = std::move(error);
    }
    bool isEmpty() const { return !mFirst; }
    /// Precondition: !isEmpty().
    Error first() const { return *mFirst; }

private:
    std::optional<Error> mFirst;
};

/// An object of a script: reads its keys by type and range, and in the end says which ones nobody asked for.
class ScriptObject
{
public:
    static constexpr double NoLimit = std::numeric_limits<double>::infinity();

    ScriptObject(const QJsonValue &value, std::string path, ScriptErrors &errors);

    const std::string &path() const { return mPath; }
    std::string pathOf(const char *key) const { return mPath.empty() ? key : mPath + '.' + key; }
    ScriptErrors &errors() const { return mErrors; }

    bool has(const char *key) const { return mObject.contains(QLatin1String(key)); }
    bool isNumber(const char *key) const { return mObject.value(QLatin1String(key)).isDouble(); }
    double number(const char *key, double otherwise, double least = -NoLimit, double most = NoLimit);
    std::optional<double> optionalNumber(const char *key);
    std::uint32_t count(const char *key, std::uint32_t otherwise, std::uint32_t least, std::uint32_t most);
    bool flag(const char *key, bool otherwise);
    std::string text(const char *key, const std::string &otherwise = {});
    /// One of `names`; its index.
    std::size_t choice(const char *key, std::size_t otherwise, const std::vector<const char *> &names);
    /// `size` numbers.
    std::vector<double> numbers(const char *key, std::size_t size, std::vector<double> otherwise);
    ScriptObject object(const char *key);
    /// Calls `visit(value, its path)` for each value of a list.
    template <class Visit>
    void forEach(const char *key, Visit visit)
    {
        const QJsonValue value = take(key);
        if (!value.isArray() && !value.isUndefined())
            return mErrors.report(pathOf(key), value, "a list");
        const QJsonArray list = value.toArray();
        for (qsizetype i = 0; i < list.size(); ++i)
            visit(list[i], pathOf(key) + '[' + std::to_string(i) + ']');
    }
    QJsonValue take(const char *key);
    /// Keys that were not asked for are errors: a misspelt one would be a setting that does nothing.
    void finish();

private:
    QJsonObject mObject;
    std::string mPath;
    ScriptErrors &mErrors;
    std::set<QString> mTaken;
};

} // namespace model::io
