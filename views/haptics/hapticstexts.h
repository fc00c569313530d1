// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/haptics/hid/catalog.h"
#include "model/haptics/servo/servocore.h"

#include <QString>

/// What people read about haptics.
namespace views {

/// "Granular (default)"
QString titleOf(model::haptics::LawKind law);
QString hintOf(model::haptics::LawKind law);
/// "SpaceNavigator (no permission)"
QString titleOf(const model::haptics::FoundDevice &device);
/// What to know before one chooses it: that it has no force, that it is experimental, what gives the permission.
QString hintOf(const model::haptics::FoundDevice &device);
/// What the forces do now, and why there are none. \param device  null: none is open
QString stateText(const model::haptics::Capabilities *device, const model::haptics::ServoSample &sample);

} // namespace views
