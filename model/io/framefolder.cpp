// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/framefolder.h"

#include "model/base/outofmemory.h"
#include "model/base/parallel.h"
#include "model/io/animationreader.h"
#include "model/io/failure.h"
#include "model/io/filebuffer.h"
#include "model/io/firsterror.h"
#include "model/io/meshfile.h"
#include "model/io/positionmemory.h"
#include "model/io/workspaces.h"

#include <atomic>

#include <QDir>

namespace model::io {

namespace {

struct Workspace
{
    FileBuffer file;
    FirstFrame::Scratch scratch;
};

} // namespace

bool isNaturallyLess(const QString &a, const QString &b)
{
    qsizetype i = 0, j = 0;
    while (i < a.size() && j < b.size()) {
        if (!a[i].isDigit() || !b[j].isDigit()) {
            const QChar x = a[i++].toCaseFolded(), y = b[j++].toCaseFolded();
            if (x != y)
                return x < y;
            continue;
        }
        const auto run = [](const QString &text, qsizetype &from) {
            while (from < text.size() && text[from].digitValue() == 0)
                ++from;
            const qsizetype begin = from;
            while (from < text.size() && text[from].isDigit())
                ++from;
            return QStringView(text).mid(begin, from - begin);
        };
        const QStringView x = run(a, i), y = run(b, j);
        if (x.size() != y.size())
            return x.size() < y.size();
        if (const int order = x.compare(y))
            return order < 0;
    }
    if (a.size() - i != b.size() - j)
        return a.size() - i < b.size() - j;
    return a < b;
}

Result<QStringList> frameFilesIn(const QString &folder)
{
    const QFileInfo info(folder);
    if (!info.exists())
        return failIn(folder, ErrorCode::NotFound);
    if (!info.isDir())
        return failIn(folder, ErrorCode::CannotOpen, QT_TRANSLATE_NOOP("ErrorText", "it is not a folder"));
    if (!info.isReadable())
        return failIn(folder, ErrorCode::CannotOpen, QT_TRANSLATE_NOOP("ErrorText", "no permission to read it"));

    const QDir directory(folder);
    std::vector<QStringList> files(std::size_t(meshEndings().size()));
    for (const QString &name : directory.entryList(QDir::Files, QDir::Unsorted))
        if (const auto kind = meshKindOf(name))
            files[std::size_t(*kind)] << name;
    QStringList &most = *std::max_element(
        files.begin(), files.end(), [](const QStringList &a, const QStringList &b) { return a.size() < b.size(); });
    if (most.isEmpty())
        return failIn(folder, ErrorCode::NoFrames, meshEndings().join(QStringLiteral(", ")).toStdString());
    std::sort(most.begin(), most.end(), isNaturallyLess);
    for (QString &name : most)
        name = directory.filePath(name);
    return most;
}

Result<std::shared_ptr<const Sequence>> readFrames(const QStringList &files, double frameRate, std::string name,
                                                   const Progress &progress)
{
    Workspaces<Workspace> workspaces;
    const MeshKind kind = *meshKindOf(files.front());
    const std::string firstFile = files.front().toStdString();

    Result<FirstFrame> first = [&]() -> Result<FirstFrame> {
        const auto workspace = workspaces.take();
        const auto bytes = workspace->file.load(files.front(), progress);
        if (!bytes)
            return fail(bytes.error());
        auto frame = FirstFrame::parse(kind, *bytes, firstFile, progress);
        return frame ? std::move(frame) : failIn(files.front(), std::move(frame.error()));
    }();
    if (!first)
        return fail(std::move(first.error()));

    const std::size_t vertexCount = first->connectivity().vertexCount, frameCount = std::size_t(files.size());
    Result<std::vector<Vec3f>> positions = positionMemory(vertexCount, frameCount);
    if (!positions)
        return fail(std::move(positions.error()));
    std::copy(first->mesh().positions.begin(), first->mesh().positions.end(), positions->begin());

    FirstError firstError;
    std::atomic<std::size_t> done = 1;
    parallelFor(frameCount - 1, [&](std::size_t i) {
        const std::size_t frame = i + 1;
        if (firstError.isBefore(frame))
            return;
        const QString &file = files[qsizetype(frame)];
        const auto read = [&]() -> Result<void> {
            const auto workspace = workspaces.take();
            const auto bytes = workspace->file.load(file, progress);
            if (!bytes)
                return fail(bytes.error());
            return first->parseNext(*bytes, std::span(*positions).subspan(frame * vertexCount, vertexCount),
                                    workspace->scratch, progress);
        };
        if (Result<void> result = catchBadAlloc(read); !result)
            return firstError.set(frame, std::move(result.error()).in(file.toStdString()));
        progress.report(double(++done) / double(frameCount));
    });
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    if (firstError)
        return fail(firstError.take());
    return std::make_shared<const Sequence>(first->takeMesh().connectivity, std::move(*positions), frameRate,
                                            std::move(name));
}

} // namespace model::io
