// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/animfile.h"

#include "model/animation/editedframes.h"
#include "model/animation/settingsfields.h"
#include "model/io/failure.h"
#include "model/io/filebuffer.h"

#include <numeric>

namespace model::io {

Result<std::shared_ptr<const codec::DecodedAnimation>> openAnim(const QString &path, const Progress &progress)
{
    Result<Bytes> bytes = readBytes(path, progress);
    if (!bytes)
        return fail(std::move(bytes.error()));
    auto decoded = codec::decodeAnimation(std::move(*bytes), progress);
    if (!decoded)
        return failIn(path, std::move(decoded.error()));
    return decoded;
}

Result<Bytes> readBytes(const QString &path, const Progress &progress)
{
    FileBuffer buffer;
    const auto text = buffer.load(path, progress);
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
