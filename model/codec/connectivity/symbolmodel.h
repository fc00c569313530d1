// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/codec/entropy/countedinteger.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace model::codec {

/// How the next triangle meets what is there: at neither of its free edges and with a new vertex (C) or a known one
/// (S), at the right one (R), the left one (L) or both (E).
enum class Clers : std::uint8_t { C, S, R, L, E };

/// What both sides know when a symbol is coded, apart from the symbols before.
struct GateView
{
    // How many triangles there are so far at the vertices along the loop: before, left, right, after, beyond; the gate
    // goes from left to right. And at the vertex behind the gate, 0 if there is none.
    std::uint8_t before = 0, left = 0, right = 0, after = 0, beyond = 0, behind = 0;
    std::uint8_t loop = 0; ///< edges of the loop: 2, 3, or 4 for more
    /// Which edges of the loop are those of a hole, from that before the gate to the third after it: bits.
    std::uint8_t holeEdges = 0;
};

/// The contexts of the symbols and their coding, the same for both directions. FORMAT.md 12.4.
/// The pivot of the walk is the right vertex: what decides between C and R is whether it has all its triangles. So each
/// context holds the number it has; the README says what the others gave.
class SymbolModel
{
public:
    template <class Coder>
    Clers code(Coder &coder, const GateView &gate, Clers wanted)
    {
        const Clers symbol = decide(coder, gate, wanted);
        mHistory = (mHistory * 5 + std::uint32_t(symbol)) % HistoryStates;
        if (symbol == Clers::R) {
            mClosedBefore = mClosed;
            mClosed = capped(gate.right + 1u);
        }
        return symbol;
    }

private:
    enum Question : std::uint32_t { IsC, IsRightGlued, IsLeftGlued, IsL };
    static constexpr std::uint32_t Questions = 4;
    static constexpr std::size_t Inputs = 7;
    static constexpr unsigned TableBits = 16;
    static constexpr std::uint32_t HistoryStates = 5 * 5 * 5 * 5 * 5 * 5;
    static constexpr std::uint32_t ShortHistory = 5 * 5 * 5;

    static std::uint32_t capped(std::uint32_t degree) { return std::min(degree, 15u); }

    template <class Coder>
    Clers decide(Coder &coder, const GateView &gate, Clers wanted)
    {
        const Contexts contexts = contextsOf(gate);
        if (isTrue(coder, IsC, contexts, gate.loop, wanted == Clers::C))
            return Clers::C;
        if (gate.loop < 3)
            return Clers::S; // glued to the other edge, the triangle would have a vertex twice
        if (!isTrue(coder, IsRightGlued, contexts, gate.loop, wanted == Clers::R || wanted == Clers::E))
            return isTrue(coder, IsL, contexts, gate.loop, wanted == Clers::L) ? Clers::L : Clers::S;
        if (gate.loop > 3)
            return Clers::R;
        return isTrue(coder, IsLeftGlued, contexts, gate.loop, wanted == Clers::E) ? Clers::E : Clers::R;
    }

    using Contexts = std::array<std::uint32_t, Inputs>;

    Contexts contextsOf(const GateView &gate) const
    {
        const std::uint32_t right = std::min<std::uint32_t>(gate.right, 20);
        const std::uint32_t left = capped(gate.left), after = capped(gate.after), before = capped(gate.before);
        const std::uint32_t beyond = capped(gate.beyond), behind = capped(gate.behind);
        return {
            contextHash({right, left}),
            contextHash({right, gate.holeEdges}),
            contextHash({right, mClosed, mClosedBefore}),
            contextHash({right, after, beyond, left}),
            contextHash({right, left, after, before, behind}),
            contextHash({right, mHistory, after}),
            contextHash({right, mHistory % ShortHistory}),
        };
    }

    template <class Coder>
    bool isTrue(Coder &coder, Question question, const Contexts &contexts, std::uint32_t loop, bool wanted)
    {
        std::array<CountedBit *, Inputs> models;
        for (std::size_t i = 0; i < Inputs; ++i) {
            const std::uint32_t place = (contexts[i] + question) * 0x9e3779b1u >> (32 - TableBits);
            models[i] = &mModels[(i << TableBits) + place];
        }
        const std::uint32_t bit = coder.decision(mMixer.mix(models, question * 3 + (loop - 2)), wanted);
        mMixer.update(bit);
        for (CountedBit *model : models)
            model->update(bit, CountedMemory);
        return bit != 0;
    }

    std::vector<CountedBit> mModels = std::vector<CountedBit>(Inputs << TableBits);
    BitMixer<Inputs, Questions * 3, FirstHaste> mMixer;
    std::uint32_t mHistory = 0;
    std::uint32_t mClosed = 0, mClosedBefore = 0; ///< triangles of the two vertices that R completed last
};

} // namespace model::codec
