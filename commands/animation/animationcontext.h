// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/base/documentcontext.h"
#include "model/document/animationdocument.h"

namespace commands {

/// The way to change an animation.
class AnimationContext final : public DocumentContext<model::AnimationDocument>
{
public:
    explicit AnimationContext(model::AnimationDocument &document, QObject *parent = nullptr)
        : DocumentContext(document, parent)
    {}
};

} // namespace commands
