// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"

#include <QString>

namespace model::io {

/// The error as a sentence or two for a person, in the interface's language: what, where (file, line or byte), and what
/// to do about it where that is known. English without a translator installed, as the command line uses it.
QString errorText(const Error &error);

} // namespace model::io
