// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/entropy/bitmixer.h"
#include "model/codec/entropy/integercoder.h"

#include <vector>

namespace model::codec {

/// A size as one of 16 classes.
inline std::uint32_t sizeClass(std::uint64_t magnitude)
{
    return std::min(sizeContext(magnitude), 15u);
}

/// The models of one kind of signed integer, of less than 2^MaxClass in magnitude, each decision mixed from several
/// contexts. FORMAT.md 4.5.
///
/// An integer is coded as the number of bits of its magnitude (its class, one decision for each), the sign, the bit
/// below the leading one, one more that has models of its own, and the rest, where nothing can be learned.
template <std::size_t Inputs>
class MixedIntegerModel
{
public:
    using Contexts = std::array<std::uint32_t, Inputs>;
    static constexpr std::uint32_t ContextCount = 512;
    static constexpr unsigned MaxClass = 56;

    /// \param contexts  each below ContextCount: how large the integer is expected to be
    /// \param sign      below 32
    template <class Coder>
    std::int64_t code(Coder &coder, const Contexts &contexts, std::uint32_t sign, std::int64_t value = 0)
    {
        const std::uint64_t magnitude = value < 0 ? 0 - std::uint64_t(value) : std::uint64_t(value);
        const unsigned wanted = unsigned(std::bit_width(magnitude));
        unsigned bits = 0;
        while (bits < MaxClass && isTrue(coder, contexts, bits, wanted > bits))
            ++bits;
        if (bits == 0)
            return 0;
        const bool negative = coder.bit(mSigns[sign], value < 0) != 0;
        std::uint64_t result = 1;
        unsigned left = bits - 1;
        if (left > 0) {
            --left;
            result = 2 * result + isTrue(coder, contexts, MaxClass + bits, (magnitude >> left) & 1);
        }
        if (left > 0) {
            --left;
            result = 2 * result + coder.bit(mSecond[bits][result & 1], std::uint32_t(magnitude >> left) & 1);
        }
        while (left > 0) {
            const unsigned count = std::min(left, MaxDirectBits);
            left -= count;
            result = result << count | coder.direct(count, std::uint32_t(magnitude >> left) & ((1u << count) - 1));
        }
        return negative ? -std::int64_t(result) : std::int64_t(result);
    }

private:
    static constexpr std::size_t Nodes = 2 * MaxClass + 1;
    /// Decisions after which a context forgets the older ones.
    static constexpr unsigned Memory = 255;

    template <class Coder>
    bool isTrue(Coder &coder, const Contexts &contexts, std::size_t node, bool wanted)
    {
        std::array<CountedBit *, Inputs> models;
        for (std::size_t i = 0; i < Inputs; ++i)
            models[i] = &mModels[(i * ContextCount + contexts[i]) * Nodes + node];
        const std::uint32_t bit = coder.decision(mMixer.mix(models, node), wanted);
        mMixer.update(bit);
        for (CountedBit *model : models)
            model->update(bit, Memory);
        return bit != 0;
    }

    std::vector<CountedBit> mModels = std::vector<CountedBit>(Inputs * ContextCount * Nodes);
    BitMixer<Inputs, Nodes> mMixer;
    std::array<AdaptiveBit, 32> mSigns;
    std::array<std::array<AdaptiveBit, 2>, MaxClass + 1> mSecond;
};

} // namespace model::codec
