// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

namespace model {

/// Other frames, or the same at another rate: number, order or rate may differ.
struct TimingChanged
{};
/// Every position moved.
struct PlacementChanged
{};
struct NameChanged
{};
struct CompressionChanged
{};

/// What changed in an AnimationDocument; sent after the change. Views std::visit it, so that a new kind breaks the
/// build of every view that forgot it.
using AnimationChange = std::variant<TimingChanged, PlacementChanged, NameChanged, CompressionChanged>;

} // namespace model
