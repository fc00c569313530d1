// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/terrain/groundinteraction.h"

#include <vector>

namespace views {

/// Several interactions on the ground of one view: one of them works, the lines of all are seen.
class SharedGround final : public GroundInteraction
{
public:
    /// Takes the view's events from now on. \param parts  at least one, the first one works; not owned
    SharedGround(GroundView &view, std::vector<GroundInteraction *> parts);
    ~SharedGround() override;

    /// Another one works from now on. What the one before was doing is cancelled. Precondition: it is one of the parts.
    void choose(GroundInteraction &part);

    bool isActive() const override { return mChosen->isActive(); }
    bool press(const GroundEvent &event) override { return mChosen->press(event); }
    void move(const GroundEvent &event) override { mChosen->move(event); }
    void release(const GroundEvent &event) override { mChosen->release(event); }
    void cancel() override { mChosen->cancel(); }
    void hover(const GroundEvent &event) override { mChosen->hover(event); }
    void leave() override { mChosen->leave(); }
    bool wheel(const GroundEvent &event, double notches) override { return mChosen->wheel(event, notches); }
    bool keyPress(const QKeyEvent &event) override { return mChosen->keyPress(event); }
    bool keyRelease(const QKeyEvent &event) override { return mChosen->keyRelease(event); }
    std::vector<GroundLine> lines() const override;

private:
    GroundView &mView;
    const std::vector<GroundInteraction *> mParts;
    GroundInteraction *mChosen;
};

} // namespace views
