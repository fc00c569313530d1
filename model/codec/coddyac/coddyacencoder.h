// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/animationcodec.h"
#include "model/codec/coddyac/coddyacquantizer.h"

namespace model::codec {

/// An animation prepared for `coddyac`: what does not depend on the steps is done once.
class CoddyacEncoder
{
public:
    /// \param source        outlives the result
    /// \param trajectories  basis size up to which it can encode
    /// \error NonFinite, LimitExceeded, OutOfMemory, Cancelled
    static Result<CoddyacEncoder> prepare(const FrameSource &source, std::size_t trajectories,
                                          const Progress &progress);

    /// How many trajectories there are.
    std::size_t basisSize() const { return mComponents.count(); }
    const FrameStack &frames() const { return mFrames; }

    /// The file. \param squaredError  as QuantizedPca::squaredError
    /// \error LimitExceeded, Cancelled
    Result<EncodedAnimation> encode(const CoddyacSettings &settings, bool keepOrder, double &squaredError,
                                    const Progress &progress) const;

private:
    CoddyacEncoder(const FrameSource &source, FrameStack frames, PrincipalComponents components,
                   std::vector<double> norms, EncodedConnectivity connectivity)
        : mSource(&source)
        , mFrames(std::move(frames))
        , mComponents(std::move(components))
        , mNorms(std::move(norms))
        , mConnectivity(std::move(connectivity))
    {}

    const FrameSource *mSource;
    FrameStack mFrames;
    PrincipalComponents mComponents;
    std::vector<double> mNorms;
    EncodedConnectivity mConnectivity;
};

} // namespace model::codec
