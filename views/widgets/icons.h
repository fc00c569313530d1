// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QString>

namespace views {

/// One of our own icons, `:/icons/NAME.svg`. Drawn when it is painted, in the palette's colours (`currentColor` becomes
/// the text's, `accent` the highlight's), so that a change of theme, a disabled action and any resolution need nothing
/// from the caller. Null if there is no such icon.
QIcon icon(const QString &name);

/// The program's own icon, in its own colours.
QIcon applicationIcon();

} // namespace views
