// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/force/contact.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

namespace model::haptics {

/// What a law remembers from step to step. Plain, so that the servo can ask a law twice about one moment: with the old
/// snapshot and with the new.
struct LawMemory
{
    bool isTouching = false;
    Vec3d rest;        ///< where the material has come to rest against the tool
    double travel = 0; ///< metres that the material has given way
    double grains = 0; ///< how much of the grains is felt, 0 ... 1: nothing at rest
};

/// How ground becomes force. A law has no state of its own. Called 1000 times a second: no allocation, no lock.
/// Whatever it returns, the safety gate has the last word.
class ForceLaw
{
public:
    virtual ~ForceLaw() = default;
    /// The force on the hand, N, x east, y north, z up.
    virtual Vec3d force(const Contact &contact, const Feel &feel, LawMemory &memory) const = 0;
};

/// Numbers and names are part of the recording format.
enum class LawKind : std::uint8_t { Granular = 1, Reference2009 = 2, Reference2009AlongMotion = 3 };
inline constexpr LawKind EveryLaw[] = {LawKind::Granular, LawKind::Reference2009, LawKind::Reference2009AlongMotion};

/// "granular", "2009", "2009-along-motion"
const char *nameOf(LawKind kind);
std::optional<LawKind> lawNamed(std::string_view name);
std::unique_ptr<ForceLaw> makeLaw(LawKind kind);

} // namespace model::haptics
