// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/animfile.h"

#include "model/animation/editedframes.h"
#include "model/animation/settingsfields.h"
#include "model/codec/container/progressivereader.h"
#include "model/io/failure.h"
#include "model/io/filebuffer.h"

#include <algorithm>
#include <numeric>

namespace model::io {

Result<std::shared_ptr<const codec::DecodedAnimation>> openAnim(const QString &path, const Progress &progress)
{
    Result<Bytes> bytes = readBytes(path, progress);
    if (!bytes)
        return fail(std::move(bytes.error()));
    const auto limits = codec::DecodeLimits::ofThisMachine(bytes->size());
    auto decoded = codec::decodeAnimation(std::move(*bytes), progress, limits);
    if (!decoded)
        return failIn(path, std::move(decoded.error()));
    return decoded;
}

Result<AnimPrefix> openAnimPrefix(const QString &path, std::uint64_t byteCount, const Progress &progress)
{
    const Result<Bytes> bytes = readBytes(path, progress);
    if (!bytes)
        return fail(bytes.error());
    const std::uint64_t count = std::min<std::uint64_t>(byteCount, bytes->size());
    codec::ProgressiveReader reader(codec::DecodeLimits::ofThisMachine(bytes->size()));
    if (auto read = reader.append(std::span(*bytes).first(std::size_t(count)), progress); !read)
        return failIn(path, std::move(read.error()));
    if (reader.isPlayable())
        return AnimPrefix{reader.animation(), reader.bandsInFile(), count,
                          std::max<std::uint64_t>(reader.leastBytes(), bytes->size())};
    // What else is there says how much is needed.
    while (!reader.isPlayable() && reader.bytesRead() < std::min<std::uint64_t>(reader.playableFrom(), bytes->size())) {
        const std::uint64_t more = std::min<std::uint64_t>(reader.playableFrom(), bytes->size()) - reader.bytesRead();
        const auto rest = std::span(*bytes).subspan(std::size_t(reader.bytesRead()), std::size_t(more));
        if (auto read = reader.append(rest, progress); !read)
            return failIn(path, std::move(read.error()));
    }
    return failIn(path, Error{ErrorCode::Truncated,
                              {std::to_string(reader.playableFrom()), std::to_string(count)},
                              {},
                              Error::None,
                              count});
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
