// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/animationcodec.h"

#include "model/base/memory.h"

#include "model/animation/settingsfields.h"
#include "model/codec/coddyac/coddyaccodec.h"
#include "model/codec/container/container.h"
#include "model/codec/container/syntax.h"
#include "model/codec/direct/directcodec.h"
#include "model/codec/pca/pcacodec.h"
#include "model/codec/reel/reelcodec.h"

namespace model::codec {

namespace {

Result<void> requireSetting(bool condition, std::string_view setting, double value, double min, double max)
{
    if (condition)
        return {};
    return fail(ErrorCode::BadSetting, std::string(setting), numberText(value),
                numberText(min) + " ... " + numberText(max));
}

Result<void> checkNameAndRate(const std::string &name, double frameRate)
{
    // Negated comparisons, so that NaN is refused.
    return requireSetting(frameRate >= MinFrameRate && frameRate <= MaxFrameRate, "frame rate", frameRate, MinFrameRate,
                          MaxFrameRate)
        .and_then([&] {
            return requireSetting(name.size() <= MaxNameLength, "name length", double(name.size()), 0, MaxNameLength);
        });
}

Result<void> checkSettings(const CompressionSettings &settings)
{
    Result<void> result;
    visitFields(settings.method, [&](const auto &field, const auto &value) {
        if (result && !field.allows(value))
            result = fail(ErrorCode::BadSetting, std::string(field.key), fieldText(value),
                          fieldText(field.least) + " ... " + fieldText(field.most));
    });
    return result;
}

} // namespace

Result<void> checkSource(const FrameSource &source)
{
    if (source.vertexCount() == 0)
        return fail(ErrorCode::NoVertices);
    if (source.frameCount() == 0)
        return fail(ErrorCode::NoFrames);
    const auto tooMany = [](std::string what, std::uint64_t count, std::uint64_t limit) {
        return fail(ErrorCode::LimitExceeded, std::move(what), std::to_string(count), std::to_string(limit));
    };
    if (source.vertexCount() > MaxVertices)
        return tooMany("vertices", source.vertexCount(), MaxVertices);
    if (source.connectivity().triangles.size() > MaxTriangles)
        return tooMany("triangles", source.connectivity().triangles.size(), MaxTriangles);
    if (source.frameCount() > MaxFrames)
        return tooMany("frames", source.frameCount(), MaxFrames);
    return {};
}

std::span<const CodecId> availableCodecs()
{
    static constexpr std::array Codecs{CodecId::Reel, CodecId::Pca, CodecId::Direct, CodecId::Coddyac};
    return Codecs;
}

Result<EncodedAnimation> encodeAnimation(const FrameSource &source, const CompressionSettings &settings,
                                         const Progress &progress)
{
    const Result<void> checked = checkSource(source).and_then([&] { return checkSettings(settings); }).and_then([&] {
        return checkNameAndRate(source.name(), source.frameRate());
    });
    if (!checked)
        return fail(checked.error());
    if (const auto *pca = std::get_if<PcaSettings>(&settings.method))
        return encodePca(source, *pca, progress);
    if (const auto *direct = std::get_if<DirectSettings>(&settings.method))
        return encodeDirect(source, *direct, progress);
    if (const auto *reel = std::get_if<ReelSettings>(&settings.method))
        return encodeReel(source, *reel, settings.keepOrder, progress);
    if (const auto *coddyac = std::get_if<CoddyacSettings>(&settings.method))
        return encodeCoddyac(source, *coddyac, settings.keepOrder, progress);
    return fail(ErrorCode::UnknownCodec, std::to_string(int(settings.codec())));
}

DecodeLimits DecodeLimits::ofThisMachine(std::uint64_t fileSize)
{
    return {std::max(DecodeLimits().bytesFor(fileSize), physicalMemory() / 2)};
}

Result<std::shared_ptr<const DecodedAnimation>> decodeAnimation(Bytes file, const Progress &progress,
                                                                const DecodeLimits &limits)
{
    const Result<Container> container = readContainer(file);
    if (!container)
        return fail(container.error());
    switch (CodecId(container->header.codec)) {
    case CodecId::Pca:
        return decodePca(std::move(file), *container, limits, progress);
    case CodecId::Direct:
        return decodeDirect(std::move(file), *container, limits, progress);
    case CodecId::Reel:
        return decodeReel(std::move(file), *container, limits, progress);
    case CodecId::Coddyac:
        return decodeCoddyac(std::move(file), *container, limits, progress);
    default:
        break;
    }
    return fail(Error{ErrorCode::UnknownCodec,
                      {std::to_string(container->header.codec)},
                      {},
                      Error::None,
                      container->chunks.front().offset});
}

Result<Bytes> withNameAndRate(const Bytes &file, const std::string &name, double frameRate)
{
    if (const auto checked = checkNameAndRate(name, frameRate); !checked)
        return fail(checked.error());
    const Result<Container> container = readContainer(file);
    if (!container)
        return fail(container.error());
    Header header = container->header;
    header.name = name;
    header.frameRate = frameRate;
    ContainerWriter writer(header);
    for (const Chunk &chunk : container->chunks)
        if (chunk.tag != HeaderTag && chunk.tag != EndTag)
            writer.chunk(chunk.tag, chunk.payload);
    return writer.finish();
}

Result<std::vector<ChunkInfo>> listChunks(std::span<const std::uint8_t> file)
{
    const Result<Container> container = readContainer(file);
    if (!container)
        return fail(container.error());
    std::vector<ChunkInfo> result;
    for (const Chunk &chunk : container->chunks)
        result.push_back({chunk.tag, chunk.size});
    return result;
}

} // namespace model::codec
