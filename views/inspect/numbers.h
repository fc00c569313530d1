// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>

namespace views {

/// Four significant digits, in the interface's language.
inline QString shortNumber(double value)
{
    return QLocale().toString(value, 'g', 4);
}

} // namespace views
