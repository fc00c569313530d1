// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/bitmixer.h"
#include "model/codec/rangecoder.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace model::codec {

/// How the next triangle meets what is there: at neither of its free edges and with a new vertex (C) or a known one
/// (S), at the right one (R), the left one (L) or both (E).
enum class Clers : std::uint8_t { C, S, R, L, E };

/// What both sides know when a symbol is coded.
struct GateView
{
    // Triangles so far at the vertices along the loop: ... before, left, right, after ...; gate between left and right.
    std::uint32_t before = 0, left = 0, right = 0, after = 0;
    std::uint32_t behind = 0; ///< at the vertex behind the gate
    std::uint32_t loop = 0;   ///< edges of the loop: 2, 3, or 4 for more
};

/// The contexts of the symbols and their coding; the same for both directions.
class SymbolModel
{
public:
    template <class Coder>
    Clers code(Coder &coder, const GateView &gate, Clers wanted)
    {
        const Clers symbol = decide(coder, gate, wanted);
        mHistory = (mHistory * 5 + std::uint32_t(symbol)) % HistoryStates;
        return symbol;
    }

private:
    static constexpr std::uint32_t HistoryStates = 5 * 5 * 5 * 5;

    template <class Coder>
    Clers decide(Coder &coder, const GateView &gate, Clers wanted)
    {
        if (isYes(coder, gate, 0, wanted == Clers::C))
            return Clers::C;
        if (gate.loop < 3)
            return Clers::S; // an edge glued to the other one would leave a triangle with a repeated vertex
        if (isYes(coder, gate, 1, wanted == Clers::R || wanted == Clers::E))
            return gate.loop == 3 && isYes(coder, gate, 2, wanted == Clers::E) ? Clers::E : Clers::R;
        return isYes(coder, gate, 3, wanted == Clers::L) ? Clers::L : Clers::S;
    }

    static constexpr std::size_t Inputs = 5;
    static constexpr std::size_t Size = 4 * 8192;

    template <class Coder>
    bool isYes(Coder &coder, const GateView &g, unsigned question, bool wanted)
    {
        const auto cap = [](std::uint32_t value, std::uint32_t most) { return std::min(value, most); };
        const std::uint32_t contexts[Inputs] = {
            cap(g.right, 15) * 8 + cap(g.left, 7),
            cap(g.right, 11) * 128 + cap(g.after, 11) * 8 + cap(g.before, 7),
            cap(g.right, 11) * 625 + mHistory,
            cap(g.right, 11) * 125 + mHistory % 125,
            cap(g.right, 11) * 144 + cap(g.left, 11) * 12 + cap(g.behind, 11),
        };
        std::array<CountedBit *, Inputs> bits;
        for (std::size_t i = 0; i < Inputs; ++i)
            bits[i] = &mBits[i * Size + question * 8192 + contexts[i]];
        const std::size_t set = question * 3 + (g.loop == 4 ? 2 : g.loop == 3 ? 1 : 0);
        const std::uint32_t p = mMixer.mix(bits, set);
        const std::uint32_t bit = coder.decision(p, wanted);
        mMixer.update(bit);
        for (CountedBit *b : bits)
            b->update(bit, 255);
        return bit;
    }

    std::vector<CountedBit> mBits = std::vector<CountedBit>(Inputs * Size);
    BitMixer<Inputs, 12> mMixer;
    std::uint32_t mHistory = 0;
};

} // namespace model::codec
