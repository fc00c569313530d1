// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/animationcodec.h"
#include "model/codec/container/container.h"
#include "model/codec/direct/meshwalk.h"
#include "model/codec/framestack.h"

#include <optional>

namespace model::codec {

// The `direct` codec, FORMAT.md 11; arguments and errors as encodeAnimation and decodeAnimation, which have checked the
// settings and the container.
Result<EncodedAnimation> encodeDirect(const FrameSource &source, const DirectSettings &settings,
                                      const Progress &progress);
Result<std::shared_ptr<const DecodedAnimation>> decodeDirect(Bytes file, const Container &container,
                                                             const DecodeLimits &limits, const Progress &progress);

/// An animation prepared for being encoded with many settings. Not thread-safe.
class DirectEncoder
{
public:
    /// \param source  outlives the encoder
    static Result<DirectEncoder> prepare(const FrameSource &source, const Progress &progress);

    Result<EncodedAnimation> encode(const DirectSettings &settings, const Progress &progress);
    const FrameStack &frames() const { return mFrames; }

private:
    DirectEncoder(const FrameSource &source, FrameStack frames, Bytes indices)
        : mSource(&source)
        , mFrames(std::move(frames))
        , mIndices(std::move(indices))
    {}

    const MeshWalk &walkFor(Predictor predictor);
    Result<std::vector<Bytes>> encodeGroups(const DirectSettings &settings, const Progress &progress);
    EncodedAnimation assembled(const DirectSettings &settings, const std::vector<Bytes> &groups) const;

    const FrameSource *mSource;
    FrameStack mFrames;
    Bytes mIndices;
    std::optional<MeshWalk> mGrowing, mInFileOrder; ///< once they are needed
};

} // namespace model::codec
