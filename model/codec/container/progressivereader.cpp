// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/container/progressivereader.h"

#include "model/codec/container/memorylimit.h"
#include "model/codec/reel/reeldecoder.h"

#include <algorithm>

namespace model::codec {

namespace {

// In the order of ProgressiveReader::Part.
constexpr std::array PartTags{ReelParametersTag, ReelConnectivityTag, ReelOrderTag,
                              ReelClustersTag,   ReelShapeTag,        ReelBandsTag};

// Of a payload that has not come; keeps sums from overflowing.
constexpr std::uint64_t MaxBelievedLength = std::uint64_t(1) << 62;

} // namespace

ProgressiveReader::ProgressiveReader(const DecodeLimits &limits)
    : mLimits(limits)
{}

ProgressiveReader::~ProgressiveReader() = default;

bool ProgressiveReader::isReel() const
{
    return header() && header()->codec == std::uint8_t(CodecId::Reel);
}

bool ProgressiveReader::isPlayable() const
{
    return !mError && (mComplete || (mReel && mReel->hasShape()));
}

std::uint64_t ProgressiveReader::playableFrom() const
{
    if (mComplete && !mComplete->prefixBytes().empty())
        return mComplete->prefixBytes().front();
    if (!isReel())
        return leastBytes();
    std::uint64_t end = 0;
    bool allThere = true;
    for (const Part part : {Parameters, Triangles, Shape}) {
        allThere = allThere && has(part);
        if (has(part))
            end = std::max(end, chunk(part).offset + chunk(part).payload.size() + CrcLength);
    }
    if (allThere)
        return end;
    const std::optional<CutChunk> cut = mFile.cut();
    return cut ? cut->offset + std::min(cut->length, MaxBelievedLength) + CrcLength : mBytesRead + 1;
}

std::uint32_t ProgressiveReader::bandCount() const
{
    return !isReel() ? 0 : mComplete ? mComplete->basisSize() : mReel ? mReel->bandCount() : 0;
}

std::uint32_t ProgressiveReader::bandsInFile() const
{
    return !isReel() ? 0 : mComplete ? mComplete->basisSize() : mReel ? mReel->parameters().basisSize : 0;
}

Result<void> ProgressiveReader::append(std::span<const std::uint8_t> piece, const Progress &progress)
{
    if (mError)
        return fail(*mError);
    Result<void> result = read(piece, progress);
    if (!result)
        mError = result.error();
    return result;
}

Result<void> ProgressiveReader::read(std::span<const std::uint8_t> piece, const Progress &progress)
{
    if (mComplete && !piece.empty())
        return fail(Error{ErrorCode::TrailingBytes, {std::to_string(piece.size())}, {}, Error::None, mBytesRead});
    if (mComplete)
        return {};
    mBytesRead += piece.size();
    if (const auto taken = mFile.append(piece); !taken)
        return taken;
    if (!header())
        return {};
    const std::span<const CodecId> codecs = availableCodecs();
    if (std::find(codecs.begin(), codecs.end(), CodecId(header()->codec)) == codecs.end())
        return fail(
            Error{ErrorCode::UnknownCodec, {std::to_string(header()->codec)}, {}, Error::None, mFile.chunk(0).offset});
    if (isReel()) {
        if (const auto sorted = sortChunks(); !sorted)
            return sorted;
        if (const auto decoded = readReel(progress); !decoded)
            return decoded;
    }
    if (mFile.isComplete()) {
        auto completed = complete(progress);
        if (!completed)
            return fail(std::move(completed).error());
        mComplete = std::move(*completed);
        mShown.reset();
        mReel.reset();
    }
    return {};
}

Result<void> ProgressiveReader::sortChunks()
{
    for (; mSorted < mFile.chunkCount(); ++mSorted) {
        const Chunk chunk = mFile.chunk(mSorted);
        const auto tag = std::find(PartTags.begin(), PartTags.end(), chunk.tag);
        if (tag == PartTags.end())
            continue;
        std::optional<std::size_t> &part = mParts[std::size_t(tag - PartTags.begin())];
        if (part)
            return fail(Error{ErrorCode::DuplicateChunk, {chunk.tag}, {}, Error::None, chunk.offset});
        part = mSorted;
    }
    return {};
}

Result<void> ProgressiveReader::readReel(const Progress &progress)
{
    if (!mReel && has(Parameters)) {
        mReel = std::make_unique<ReelDecoder>(*header());
        if (const auto read = mReel->readParameters(chunk(Parameters)); !read)
            return read;
    }
    if (mReel && !mHasConnectivity && has(Triangles))
        if (const auto read = readConnectivity(progress.part(0, 0.3)); !read)
            return read;
    if (!mHasConnectivity)
        return {};
    if (!mReel->hasOrder() && has(Order))
        if (const auto read = mReel->readOrder(chunk(Order)); !read)
            return read;
    if (!mHasClusters && has(ClusterLabels)) {
        if (const auto read = mReel->readClusters(chunk(ClusterLabels)); !read)
            return read;
        mHasClusters = true;
    }
    if (!mReel->hasShape() && has(Shape))
        if (const auto read = mReel->readShape(chunk(Shape), progress.part(0.3, 0.4)); !read)
            return read;
    if (!mReel->hasShape())
        return {};
    if (has(Bands)) {
        const Chunk bands = chunk(Bands);
        return mReel->readBands(bands.payload, bands.offset, true, progress.part(0.4, 1));
    }
    const std::optional<CutChunk> cut = mFile.cut();
    return cut && cut->tag == ReelBandsTag ? mReel->readBands(cut->payload, cut->offset, false, progress.part(0.4, 1))
                                           : Result<void>();
}

Result<void> ProgressiveReader::readConnectivity(const Progress &progress)
{
    // The limit grows with the bytes, but what is shown must not depend on when it was tried: while more may come, the
    // connectivity has the memory that its own chunk allows.
    const bool mayGrow = mLimits.memoryBytes == 0 && !mFile.isComplete();
    if (mayGrow && mWaitsForEnd)
        return {};
    const Chunk triangles = chunk(Triangles);
    const std::uint64_t limit = mLimits.bytesFor(mBytesRead);
    if (const auto enough = requireMemory(mFile.chunk(0), mReel->neededBytes() + mBytesRead, limit); !enough)
        return mayGrow ? Result<void>() : enough;
    const std::uint64_t end = triangles.offset + triangles.payload.size();
    const std::uint64_t bytes = mayGrow ? end : mBytesRead;
    const auto read = mReel->readConnectivity(triangles, mLimits.bytesFor(bytes) - bytes - WorkingMemory, progress);
    mWaitsForEnd = mayGrow && !read && read.error().code == ErrorCode::LimitExceeded;
    if (mWaitsForEnd)
        return {};
    mHasConnectivity = read.has_value();
    return read;
}

Result<std::shared_ptr<const DecodedAnimation>> ProgressiveReader::complete(const Progress &progress)
{
    if (!isReel())
        return decodeAnimation(mFile.takeFile(), progress, mLimits);
    for (const Part part : {Parameters, Triangles, Shape, Bands})
        if (!has(part))
            return fail(Error{ErrorCode::MissingChunk,
                              {std::string(PartTags[part])},
                              {},
                              Error::None,
                              mFile.chunk(mFile.chunkCount() - 1).offset});
    Container container{*header(), {}};
    for (std::size_t i = 0; i < mFile.chunkCount(); ++i)
        container.chunks.push_back(mFile.chunk(i));
    return mReel->animation(mFile.takeFile(), container);
}

std::shared_ptr<const DecodedAnimation> ProgressiveReader::animation()
{
    if (!isPlayable())
        return nullptr;
    if (mComplete)
        return mComplete;
    if (!mShown || mShown->basisSize() != bandCount() || mShown->settings().keepOrder != mReel->hasOrder() ||
        mShownIsWhole != has(Bands)) {
        Bytes file = fileSoFar();
        const Result<Container> container = readContainer(file); // our own, just written
        mShown = mReel->animation(std::move(file), *container);
        mShownIsWhole = has(Bands);
    }
    return mShown;
}

Bytes ProgressiveReader::fileSoFar() const
{
    ContainerWriter writer(*header());
    writer.chunk(ReelParametersTag, mReel->parametersSoFar());
    for (const Part part : {Triangles, Order, ClusterLabels, Shape})
        if (has(part))
            writer.chunk(PartTags[part], chunk(part).payload);
    const std::optional<CutChunk> cut = mFile.cut();
    if (has(Bands))
        writer.chunk(ReelBandsTag, chunk(Bands).payload);
    else if (cut && cut->tag == ReelBandsTag)
        writer.chunk(ReelBandsTag, mReel->bandsSoFar(cut->payload));
    else
        writer.chunk(ReelBandsTag, mReel->bandsSoFar({}));
    return writer.finish();
}

} // namespace model::codec
