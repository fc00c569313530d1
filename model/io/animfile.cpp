// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/animfile.h"

#include "model/animation/editedframes.h"
#include "model/animation/settingsfields.h"
#include "model/io/failure.h"
#include "model/io/filebuffer.h"

#include <numeric>

#include <QFileInfo>
#include <QSaveFile>

namespace model::io {

Result<std::shared_ptr<const codec::DecodedAnimation>> openAnim(const QString &path, const Progress &progress)
{
    Result<Bytes> bytes = readBytes(path);
    if (!bytes)
        return fail(std::move(bytes.error()));
    auto decoded = codec::decodeAnimation(std::move(*bytes), progress);
    if (!decoded)
        return failIn(path, std::move(decoded.error()));
    return decoded;
}

Result<void> saveBytes(const QString &path, std::span<const std::uint8_t> bytes)
{
    QSaveFile file(path);
    if (auto opened = openForSaving(file); !opened)
        return opened;
    if (file.write(reinterpret_cast<const char *>(bytes.data()), qint64(bytes.size())) != qint64(bytes.size()) ||
        !file.commit())
        return failIn(file, ErrorCode::CannotWrite);
    return {};
}

Result<void> openForSaving(QSaveFile &file)
{
    const QFileInfo info(file.fileName());
    if (info.isDir())
        return failIn(file.fileName(), ErrorCode::CannotOpen, QT_TRANSLATE_NOOP("ErrorText", "it is a folder"));
    if (info.exists() && !info.isFile())
        return failIn(file.fileName(), ErrorCode::CannotOpen,
                      QT_TRANSLATE_NOOP("ErrorText", "it is not an ordinary file"));
    if (!file.open(QIODevice::WriteOnly))
        return failIn(file, ErrorCode::CannotOpen);
    return {};
}

Result<Bytes> readBytes(const QString &path)
{
    FileBuffer buffer;
    const auto text = buffer.load(path);
    if (!text)
        return fail(text.error());
    return Bytes(text->begin(), text->end());
}

namespace {

/// A file of these settings is what the wanted ones would make; a kept order does not hurt who did not ask for it.
bool isMadeWith(const CompressionSettings &made, const CompressionSettings &wanted)
{
    return made.method == wanted.method && (made.keepOrder || !wanted.keepOrder || keepsOrderAnyway(made.codec()));
}

} // namespace

Result<codec::EncodedAnimation> encodeEdited(const FrameSource &frames, const CompressionSettings &settings,
                                             const Progress &progress)
{
    const auto *const edited = dynamic_cast<const EditedFrames *>(&frames);
    const auto *const decoded = edited && edited->keepsFrames()
                                    ? dynamic_cast<const codec::DecodedAnimation *>(edited->source().get())
                                    : nullptr;
    if (!decoded || !isMadeWith(decoded->settings(), settings))
        return codec::encodeAnimation(frames, settings, progress);
    Result<Bytes> bytes = codec::withNameAndRate(decoded->encoded(), frames.name(), frames.frameRate());
    if (!bytes)
        return fail(std::move(bytes.error()));
    codec::EncodedAnimation result{std::move(*bytes), std::vector<std::uint32_t>(frames.vertexCount())};
    std::iota(result.permutation.begin(), result.permutation.end(), 0u);
    return result;
}

} // namespace model::io
