// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/direct/directanimation.h"

#include "model/base/parallel.h"

#include <atomic>

namespace model::codec {

namespace {

// Two: one that plays, and one for whoever looks elsewhere at the same time (a thumbnail, an export).
constexpr std::size_t MostOpenGroups = 2;
// A group is kept whole, so that going backward is quick too, unless it is larger than this.
constexpr std::uint64_t MostGroupBytes = 16u << 20;
// Frames that are needed to decode the next one, and that one.
constexpr std::uint32_t LeastFramesKept = 4;

std::uint32_t framesKept(std::uint64_t vertices, std::uint32_t framesPerGroup)
{
    const bool isSmall = framesPerGroup * vertices * sizeof(Cell) <= MostGroupBytes;
    return isSmall ? framesPerGroup : std::min(framesPerGroup, LeastFramesKept);
}

MeshWalk walkOf(const Connectivity &connectivity, Predictor predictor)
{
    return {connectivity, predictor == Predictor::Neighbours ? MeshWalk::Order::Growing : MeshWalk::Order::File};
}

} // namespace

/// A group that is being decoded, with its latest frames.
class DirectAnimation::OpenGroup
{
public:
    OpenGroup(const DirectAnimation &animation, std::uint32_t index, std::uint32_t kept)
        : mAnimation(animation)
        , mIndex(index)
        , mFrames(kept)
        , mDecoder(animation.makeDecoder(index))
    {}

    std::uint32_t index() const { return mIndex; }

    /// Calls `use` with a frame, counted from the group's first one. After a corrupt stream's error, that frame and
    /// those after it look like the last one that could be decoded.
    template <class Use>
    void withFrame(std::uint32_t frame, Use &&use)
    {
        const std::lock_guard lock(mMutex);
        if (frame + mFrames.size() < mDecoded) {
            mDecoder = mAnimation.makeDecoder(mIndex);
            mDecoded = 0;
        }
        while (mDecoded <= frame)
            decodeNext();
        use(std::span<const Cell>(mFrames[frame % mFrames.size()]));
    }

    /// Decodes the group to its end. \returns false if the stream is corrupt
    bool isWhole(std::uint32_t frames, const Progress &progress)
    {
        while (mDecoded < frames && !mIsCorrupt && !progress.isCancelled())
            decodeNext();
        return progress.isCancelled() || (!mIsCorrupt && mDecoder->isAtEnd());
    }

private:
    std::span<const Cell> before(std::uint32_t count) const
    {
        return mDecoded >= count ? std::span<const Cell>(mFrames[(mDecoded - count) % mFrames.size()])
                                 : std::span<const Cell>();
    }

    void decodeNext()
    {
        std::vector<Cell> &now = mFrames[mDecoded % mFrames.size()];
        now.resize(mAnimation.vertexCount());
        const std::span<const Cell> last = before(1);
        if (mIsCorrupt)
            std::copy(last.begin(), last.end(), now.begin());
        else
            mIsCorrupt = !mDecoder->next(last, before(2), before(3), now);
        ++mDecoded;
    }

    const DirectAnimation &mAnimation;
    const std::uint32_t mIndex;
    std::mutex mMutex;                      ///< of all below
    std::vector<std::vector<Cell>> mFrames; ///< a ring
    std::unique_ptr<FrameDecoder> mDecoder;
    std::uint32_t mDecoded = 0;
    bool mIsCorrupt = false;
};

DirectAnimation::DirectAnimation(Parts parts)
    : mParts(std::move(parts))
    , mSettings{mParts.settings}
    , mShape{mParts.settings.resolution, mParts.settings.predictor, mParts.settings.entropy}
    , mWalk(walkOf(mParts.connectivity, mShape.predictor))
{}

DirectAnimation::~DirectAnimation() = default;

bool DirectAnimation::decodeFirstFrame()
{
    std::vector<Cell> first(vertexCount());
    const bool isGood = makeDecoder(0)->next({}, {}, {}, first);
    mFirst = std::move(first);
    return isGood;
}

std::unique_ptr<FrameDecoder> DirectAnimation::makeDecoder(std::uint32_t group) const
{
    const std::span<const Cell> reference = group > 0 ? std::span<const Cell>(mFirst) : std::span<const Cell>();
    return std::make_unique<FrameDecoder>(mShape, mWalk, reference, mParts.groups[group]);
}

std::shared_ptr<DirectAnimation::OpenGroup> DirectAnimation::openGroup(std::uint32_t index) const
{
    const std::lock_guard lock(mMutex);
    const auto known = std::find_if(mRecentGroups.begin(), mRecentGroups.end(),
                                    [&](const auto &group) { return group->index() == index; });
    if (known != mRecentGroups.end()) {
        std::rotate(known, known + 1, mRecentGroups.end());
    } else {
        if (mRecentGroups.size() == MostOpenGroups)
            mRecentGroups.erase(mRecentGroups.begin());
        mRecentGroups.push_back(
            std::make_shared<OpenGroup>(*this, index, framesKept(vertexCount(), mParts.framesPerGroup)));
    }
    return mRecentGroups.back();
}

void DirectAnimation::positions(std::uint32_t frame, std::span<Vec3f> out) const
{
    const auto write = [&](std::span<const Cell> cells) {
        for (std::size_t v = 0; v < out.size(); ++v)
            out[v] = mParts.grid.middleOf(cells[v]);
    };
    if (frame == 0)
        write(mFirst);
    else
        openGroup(frame / mParts.framesPerGroup)->withFrame(frame % mParts.framesPerGroup, write);
}

std::uint32_t DirectAnimation::framesInGroup(std::uint32_t index) const
{
    return std::min(mParts.framesPerGroup, frameCount() - index * mParts.framesPerGroup);
}

Result<void> DirectAnimation::check(const Progress &progress) const
{
    std::atomic<std::size_t> done = 0;
    std::atomic<std::size_t> firstBad = mParts.groups.size();
    parallelFor(mParts.groups.size(), [&](std::size_t i) {
        OpenGroup group(*this, std::uint32_t(i), LeastFramesKept);
        if (!group.isWhole(framesInGroup(std::uint32_t(i)), progress)) {
            std::size_t known = firstBad;
            while (i < known && !firstBad.compare_exchange_weak(known, i)) {
            }
        }
        progress.report(double(++done) / double(mParts.groups.size()));
    });
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    if (firstBad < mParts.groups.size())
        return fail(Error{ErrorCode::CorruptStream,
                          {"frames"},
                          {},
                          Error::None,
                          std::uint64_t(mParts.groups[firstBad].data() - mParts.file.data())});
    return {};
}

std::size_t DirectAnimation::memoryBytes() const
{
    return neededBytes(mParts.header, mShape.entropy, mParts.framesPerGroup) + mParts.file.capacity() -
           MeshWalk::neededBytes(vertexCount(), mParts.connectivity.triangles.size()) + mWalk.memoryBytes();
}

std::uint64_t DirectAnimation::neededBytes(const Header &header, Entropy entropy, std::uint32_t framesPerGroup)
{
    const std::uint64_t vertices = header.vertexCount;
    const std::uint64_t frame = vertices * sizeof(Cell);
    const std::uint64_t group = framesKept(vertices, framesPerGroup) * (frame + sizeof(std::vector<Cell>)) +
                                sizeof(OpenGroup) + FrameDecoder::neededBytes(entropy, vertices);
    return sizeof(DirectAnimation) + std::uint64_t(header.triangleCount) * sizeof(Triangle) +
           MeshWalk::neededBytes(vertices, header.triangleCount) + frame + vertices * sizeof(Vec3f) +
           MostOpenGroups * group + (header.frameCount / framesPerGroup + 1) * sizeof(std::span<const std::uint8_t>);
}

} // namespace model::codec
