// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace editor {

/// What names of frames of one animation have in common: "/walk/cow_003.obj" and "/walk/cow_12.obj" both give
/// "/walk/cow_#.obj". Empty for a name without a number.
QString framePatternOf(const QString &path);

/// The files beside `path`, and itself, whose names differ from its own in the number alone; 1 if there is no other.
int alikeFileCount(const QString &path);

} // namespace editor
