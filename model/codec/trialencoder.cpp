// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/trialencoder.h"

#include "model/codec/coddyac/coddyaccodec.h"
#include "model/codec/direct/directtrials.h"
#include "model/codec/pca/pcacodec.h"
#include "model/codec/reel/reelcodec.h"

namespace model::codec {

Result<std::unique_ptr<TrialEncoder>> prepareTrials(const FrameSource &source, CodecId codec, const Progress &progress)
{
    if (const auto checked = checkSource(source); !checked)
        return fail(checked.error());
    switch (codec) {
    case CodecId::Direct:
        return prepareDirectTrials(source, progress);
    case CodecId::Pca:
        return preparePcaTrials(source, progress);
    case CodecId::Reel:
        return prepareReelTrials(source, progress);
    case CodecId::Coddyac:
        return prepareCoddyacTrials(source, progress);
    default:
        return fail(ErrorCode::UnknownCodec, std::to_string(int(codec)));
    }
}

} // namespace model::codec
