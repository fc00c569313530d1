// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/animation/changes.h"

namespace commands {

/// Moves and scales the animation into the cube (-1,-1,-1)..(1,1,1), or back to the coordinates of its source.
class NormaliseAnimation final : public ChangePlacement
{
public:
    /// \param placement  takes the place of the present one; it does not add to it. Counted from the source, as
    ///                   model::normalisingPlacement(*document.frames(), mode) returns it. So normalising again changes
    ///                   nothing, another mode does not depend on the one before, and the identity takes back every
    ///                   normalisation. Scale above zero.
    NormaliseAnimation(model::AnimationDocument &document, const model::Similarity &placement);
};

} // namespace commands
