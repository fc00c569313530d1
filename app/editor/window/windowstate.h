// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/start/settings.h"

class QMainWindow;

namespace editor {

/// Gives the window the size and place of the last session; a sensible size on the screen if there is none, or nothing
/// usable. Its docks and toolbars are those of DockLayouts.
void restoreWindow(QMainWindow &window, const Settings &settings);
void saveWindow(const QMainWindow &window, Settings &settings);

} // namespace editor
