// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/actions/actions.h"
#include "app/editor/start/settings.h"

#include <QObject>

namespace editor {

/// Gives the actions the keys that the user chose.
void applyShortcuts(const Actions &actions, const Settings &settings);

/// The entries other than `except` that have one of these keys.
std::vector<const Actions::Entry *> entriesWithKey(const Actions &actions, const QKeySequence &key,
                                                   const Actions::Entry *except);

/// "Ctrl+Y, Ctrl+Shift+Z", in the interface's language.
QString shortcutText(const QList<QKeySequence> &shortcuts);

} // namespace editor
