// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/animationcodec.h"
#include "model/codec/container/container.h"
#include "model/codec/direct/framecoder.h"
#include "model/codec/direct/grid.h"

#include <mutex>

namespace model::codec {

/// An opened animation of quantised frames in groups. FORMAT.md 11. A frame is decoded when it is asked for: the next
/// one costs one frame, any other at most a group; the groups in use are kept.
class DirectAnimation final : public DecodedAnimation
{
public:
    /// What the file says before the first frame is decoded.
    struct Parts
    {
        Header header;
        DirectSettings settings;
        CellGrid grid;
        std::uint32_t framesPerGroup = 1;
        Connectivity connectivity;
        std::vector<std::span<const std::uint8_t>> groups; ///< a stream each; views of `file`
        Bytes file;
        std::uint64_t digest = 0;
    };

    explicit DirectAnimation(Parts parts);
    ~DirectAnimation() override;

    /// Decodes the first frame, on which the others depend. Once, before anything else is asked for.
    /// \returns false if its stream is corrupt
    bool decodeFirstFrame();

    std::uint32_t frameCount() const override { return mParts.header.frameCount; }
    const Connectivity &connectivity() const override { return mParts.connectivity; }
    void positions(std::uint32_t frame, std::span<Vec3f> out) const override;
    double frameRate() const override { return mParts.header.frameRate; }
    const std::string &name() const override { return mParts.header.name; }
    std::uint64_t digest() const override { return mParts.digest; }
    std::size_t memoryBytes() const override;

    const CompressionSettings &settings() const override { return mSettings; }
    const std::string &creator() const override { return mParts.header.creator; }
    std::uint32_t basisSize() const override { return 0; }
    std::uint64_t encodedBytes() const override { return mParts.file.size(); }
    const Bytes &encoded() const override { return mParts.file; }
    Result<void> check(const Progress &progress) const override;

    /// Bytes that an animation of this size holds at most, with one frame of it, its file not counted; for refusing a
    /// hostile file in time.
    static std::uint64_t neededBytes(const Header &header, Entropy entropy, std::uint32_t framesPerGroup);

private:
    class OpenGroup;

    std::shared_ptr<OpenGroup> openGroup(std::uint32_t index) const;
    std::uint32_t framesInGroup(std::uint32_t index) const;
    std::unique_ptr<FrameDecoder> makeDecoder(std::uint32_t group) const;

    const Parts mParts;
    const CompressionSettings mSettings;
    const FrameShape mShape;
    const MeshWalk mWalk;
    std::vector<Cell> mFirst; ///< the first frame

    mutable std::mutex mMutex;                                     ///< of the line below
    mutable std::vector<std::shared_ptr<OpenGroup>> mRecentGroups; ///< in use lately, newest last
};

} // namespace model::codec
