// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/base/changevalue.h"
#include "model/document/animationdocument.h"

namespace commands {

template <auto Getter, auto Setter>
using ChangeAnimation = ChangeValue<model::AnimationDocument, Getter, Setter>;

using ChangeTiming = ChangeAnimation<&model::AnimationDocument::timing, &model::AnimationDocument::setTiming>;
using ChangePlacement = ChangeAnimation<&model::AnimationDocument::placement, &model::AnimationDocument::setPlacement>;
using ChangeName = ChangeAnimation<&model::AnimationDocument::name, &model::AnimationDocument::setName>;
using ChangeCompression =
    ChangeAnimation<&model::AnimationDocument::compression, &model::AnimationDocument::setCompression>;

} // namespace commands
