// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/entropy/bitmixer.h"
#include "model/codec/entropy/countedinteger.h"

#include <array>
#include <cstdint>

namespace model::codec {

/// Which triangles are wound the other way round than the surface: as their neighbours, or as the last ones. Where
/// they are wound at random it costs one bit. FORMAT.md 12.2.
class TurnModel
{
public:
    /// Of a neighbour that is not known yet, or is not there.
    static constexpr unsigned Unknown = 2;

    /// \param neighbours  whether those across the gate, at the right and at the left are turned; or Unknown
    template <class Coder>
    bool code(Coder &coder, const std::array<unsigned, 3> &neighbours, bool wanted)
    {
        const std::array<CountedBit *, 3> models{
            &mBehind[neighbours[0]],
            &mAround[9 * neighbours[0] + 3 * neighbours[1] + neighbours[2]],
            &mLatest[mHistory],
        };
        const std::uint32_t bit = coder.decision(mMixer.mix(models, 0), wanted);
        mMixer.update(bit);
        for (CountedBit *model : models)
            model->update(bit, CountedMemory);
        mHistory = (2 * mHistory + bit) % mLatest.size();
        return bit != 0;
    }

private:
    std::array<CountedBit, 3> mBehind;
    std::array<CountedBit, 27> mAround;
    std::array<CountedBit, 16> mLatest;
    BitMixer<3, 1, FirstHaste> mMixer;
    std::size_t mHistory = 0;
};

} // namespace model::codec
