// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/codec/reel/residualmodel.h"

namespace model::codec {

const std::array<float, 4097> DecisionCost::Bits = [] {
    std::array<float, 4097> bits{};
    for (std::size_t i = 1; i < bits.size(); ++i)
        bits[i] = -std::log2(float(i) / 4096);
    bits[0] = -std::log2(0.25f / 4096);
    return bits;
}();

} // namespace model::codec
