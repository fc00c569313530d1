// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/settings.h"

class QMainWindow;

namespace editor {

/// Gives the window the size, place, docks and toolbars of the last session; a sensible size on the screen if there is
/// none, or nothing usable. Call when all docks and toolbars are there.
void restoreWindow(QMainWindow &window, const Settings &settings);
void saveWindow(const QMainWindow &window, Settings &settings);

} // namespace editor
