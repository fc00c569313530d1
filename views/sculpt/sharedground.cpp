// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/sculpt/sharedground.h"

#include <iterator>

namespace views {

SharedGround::SharedGround(GroundView &view, std::vector<GroundInteraction *> parts)
    : mView(view)
    , mParts(std::move(parts))
    , mChosen(mParts.front())
{
    mView.setInteraction(this);
}

SharedGround::~SharedGround()
{
    mView.setInteraction(nullptr);
}

void SharedGround::choose(GroundInteraction &part)
{
    if (&part == mChosen)
        return;
    mView.setInteraction(nullptr); // cancels what goes on
    mChosen->leave();
    mChosen = &part;
    mView.setInteraction(this);
}

std::vector<GroundLine> SharedGround::lines() const
{
    std::vector<GroundLine> all;
    for (const GroundInteraction *const part : mParts) {
        std::vector<GroundLine> lines = part->lines();
        all.insert(all.end(), std::move_iterator(lines.begin()), std::move_iterator(lines.end()));
    }
    return all;
}

} // namespace views
