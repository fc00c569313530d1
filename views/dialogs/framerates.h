// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/dialogs/numberfield.h"

namespace views {

/// Frame rates that a person may give an animation: from a time lapse to a high-speed camera.
inline constexpr NumberRange FrameRates{0.1, 1000, 3};

} // namespace views
