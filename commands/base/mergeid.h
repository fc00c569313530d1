// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace commands {

/// Commands of one kind have one number; those of kinds that never merge need none.
enum class MergeId : int { SetCompression = 1, SetFrameRate, EditMaterial };

/// One drag, one run of a spin box, one stay in a dialog. Commands of one kind and one gesture become one undo step.
/// EditContext::newGesture() gives numbers; 0 is no gesture: such a command never merges.
using GestureId = std::uint64_t;
constexpr GestureId NoGesture = 0;

} // namespace commands
