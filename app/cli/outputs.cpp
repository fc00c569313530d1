// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/outputs.h"

#include "model/io/failure.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>

namespace cli {

namespace {

/// Equal for two paths of one file, also if it does not exist yet.
QString identityOf(const std::string &path)
{
    const QFileInfo info(fromUtf8(path));
    const QString known = info.canonicalFilePath();
    if (!known.isEmpty())
        return known;
    const QString folder = QFileInfo(info.absolutePath()).canonicalFilePath();
    return QDir::cleanPath(folder + QLatin1Char('/') + info.fileName());
}

model::Result<void> checkPlace(const Output &output)
{
    if (output.isFolder) // made if it is missing, and looked at by who writes into it
        return {};
    const QString path = fromUtf8(output.path);
    const QFileInfo file(path);
    if (file.exists() && !file.isFile())
        return model::io::failIn(path, model::ErrorCode::CannotWrite, "it is not an ordinary file");
    const QFileInfo folder(file.absolutePath());
    if (!folder.isDir())
        return model::io::failIn(path, model::ErrorCode::CannotOpen, "its folder does not exist");
    if (!folder.isWritable())
        return model::io::failIn(path, model::ErrorCode::CannotOpen, "its folder cannot be written to");
    return {};
}

} // namespace

model::Result<void> checkOutputs(const std::vector<Output> &outputs, const std::vector<std::string> &inputs)
{
    std::vector<QString> taken;
    for (const std::string &input : inputs)
        if (!input.empty())
            taken.push_back(identityOf(input));
    const std::size_t inputCount = taken.size();
    for (const Output &output : outputs) {
        if (output.path.empty())
            continue;
        const QString identity = identityOf(output.path);
        const auto same = std::find(taken.begin(), taken.end(), identity);
        if (same != taken.end())
            return model::fail(model::ErrorCode::BadSetting, output.option, output.path,
                               output.isFolder                                     ? "a folder that is not the input"
                               : same < taken.begin() + std::ptrdiff_t(inputCount) ? "a file that is not an input"
                                                                                   : "a file of its own");
        taken.push_back(identity);
        if (auto checked = checkPlace(output); !checked)
            return checked;
    }
    return {};
}

QString endingOf(const std::string &path)
{
    return QFileInfo(fromUtf8(path)).suffix().toLower();
}

RemoveUnlessKept::RemoveUnlessKept(const std::string &path)
    : mPath(path.empty() || QFileInfo::exists(fromUtf8(path)) ? QString() : fromUtf8(path))
{}

RemoveUnlessKept::~RemoveUnlessKept()
{
    if (!mPath.isEmpty())
        QFile::remove(mPath);
}

} // namespace cli
