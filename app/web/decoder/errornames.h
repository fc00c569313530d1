// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"

namespace web {

/// The name of an error that decoding can end with, as model/base/error.h spells it: the page has texts for these
/// (app/web/player/texts.ts). "UnknownError" for any other.
const char *nameOf(model::ErrorCode code);

} // namespace web
