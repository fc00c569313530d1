// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/start/settings.h"

#include <QPalette>

namespace editor {

/// Gives the program its style and the colours of a theme; windows that are open follow. System is light or dark as
/// the palette was that the platform came with.
void applyTheme(Theme theme);

QPalette lightPalette();
QPalette darkPalette();

} // namespace editor
