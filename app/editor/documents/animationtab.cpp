// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/documents/animationtab.h"

#include "views/viewport/animationviewport.h"
#include "views/viewport/noglview.h"

namespace editor {

AnimationTab::AnimationTab(bool canDraw, QWidget *parent)
    : DocumentTab(std::make_unique<OpenAnimation>(), parent)
    , mCanDraw(canDraw)
{}

QWidget *AnimationTab::page()
{
    if (mPage)
        return mPage;
    if (mCanDraw) {
        mPage = mViewport = new views::AnimationViewport(document().player(), this);
        mErrorColoring = mViewport;
    } else {
        auto *view = new views::NoGlView(document().player(), this);
        mPage = view;
        mErrorColoring = view;
    }
    mErrorColoring->setComparison(&document().comparison());
    return mPage;
}

} // namespace editor
