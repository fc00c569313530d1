// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace views {

enum class DrawMode : std::uint8_t { Shaded, ShadedWireframe, Wireframe, Points };

} // namespace views
