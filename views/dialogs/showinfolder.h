// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace views {

/// Opens the file manager: on `path` if it is a folder, else on the folder that holds it.
void showInFolder(const QString &path);

} // namespace views
