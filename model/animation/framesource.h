// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/trianglemesh.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace model {

/// An animation: V vertices over F frames with one connectivity. Immutable, hence shared freely between threads; a
/// frame is made when it is asked for. Implemented by Sequence (all positions in memory), EditedFrames (another
/// source seen through a time map and a placement), codec::DecodedAnimation (an opened `.anim`).
class FrameSource
{
public:
    virtual ~FrameSource() = default;

    virtual std::uint32_t frameCount() const = 0;
    virtual const Connectivity &connectivity() const = 0;
    std::uint32_t vertexCount() const { return connectivity().vertexCount; }

    /// Writes the positions of one frame.
    /// \param frame  below frameCount()
    /// \param out    #V
    /// Any thread, any order, several at once.
    virtual void positions(std::uint32_t frame, std::span<Vec3f> out) const = 0;

    /// Frames per second, above zero.
    virtual double frameRate() const = 0;
    /// UTF-8; may be empty.
    virtual const std::string &name() const = 0;

    /// A digest of connectivity and positions, not of name and rate. Equal digests: equal content. Equal content gives
    /// equal digests when it was made in the same way (from the same positions, the same file, the same edits of the
    /// same source). Holds within one program run. Cheap from the second call on; any thread.
    virtual std::uint64_t digest() const = 0;
    /// Bytes that this source holds in memory, those of a source below it included.
    virtual std::size_t memoryBytes() const = 0;

    std::vector<Vec3f> frame(std::uint32_t index) const
    {
        std::vector<Vec3f> result(vertexCount());
        positions(index, result);
        return result;
    }
};

using FrameSourcePtr = std::shared_ptr<const FrameSource>;

} // namespace model
