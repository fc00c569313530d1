// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/entropy/bitmixer.h"
#include "model/codec/entropy/countedinteger.h"

#include <array>
#include <cstdint>
#include <vector>

namespace model::codec {

/// What both sides know of a vertex along the loop that may be the one of an S.
struct PlaceView
{
    std::uint8_t degree = 0, nearer = 0,
                 farther = 0;   ///< of it and of its neighbours along the loop, seen from the gate
    std::uint8_t gateEnd = 0;   ///< degree of the gate's end on that side
    std::uint8_t holeEdges = 0; ///< which of its two open edges are those of a hole: bits
    std::uint8_t left = 0;      ///< vertices that may still be meant, up to 3
};

/// Which vertex of the loop an S goes to: asked vertex by vertex, from the gate outwards. Mostly it is the second after
/// the gate, and one that wants triangles. FORMAT.md 12.5.
class PlaceModel
{
public:
    /// Edges after the edge that follows the gate, or before the gate: in this order they are asked for. The first on
    /// either side would be glued to the gate's neighbour.
    static constexpr std::array<std::int8_t, 26> Order{2,  3,  -2, 4,  -3, 5,  -4, 6,  7,   -5, 8,   -6, 9,
                                                       10, -7, 11, -8, 12, -9, 13, 14, -10, 15, -11, 16, -12};

    template <class Coder>
    bool code(Coder &coder, std::int32_t place, const PlaceView &view, bool wanted)
    {
        const bool isAfter = place > 0;
        const std::uint32_t side = isAfter ? 0 : 1;
        const std::uint32_t distance = std::uint32_t(isAfter ? place : -place);
        const std::uint32_t degree = capped(view.degree), nearer = capped(view.nearer), farther = capped(view.farther);
        const std::array<std::uint32_t, Inputs> contexts{
            contextHash({side, distance, view.left}),
            contextHash({side, distance, degree, view.holeEdges}),
            contextHash({side, degree, farther, view.holeEdges, view.left}),
            contextHash({side, std::min(distance, 3u), degree, nearer}),
            contextHash({degree, view.holeEdges, capped(view.gateEnd)}),
        };
        std::array<CountedBit *, Inputs> models;
        for (std::size_t i = 0; i < Inputs; ++i)
            models[i] = &mModels[(i << TableBits) + (contexts[i] >> (32 - TableBits))];
        const std::uint32_t bit = coder.decision(mMixer.mix(models, 2 * (std::min(distance, 4u) - 2) + side), wanted);
        mMixer.update(bit);
        for (CountedBit *model : models)
            model->update(bit, CountedMemory);
        return bit != 0;
    }

private:
    static constexpr std::size_t Inputs = 5;
    static constexpr unsigned TableBits = 14;

    static std::uint32_t capped(std::uint32_t degree) { return std::min(degree, 15u); }

    std::vector<CountedBit> mModels = std::vector<CountedBit>(Inputs << TableBits);
    BitMixer<Inputs, 6, FirstHaste> mMixer;
};

} // namespace model::codec
