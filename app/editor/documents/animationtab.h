// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/documents/documenttab.h"
#include "app/editor/documents/openanimation.h"

namespace views {
class AnimationViewport;
class ErrorColoring;
} // namespace views

namespace editor {

/// An animation in its viewport, or what stands for that without OpenGL.
class AnimationTab final : public DocumentTab
{
    Q_OBJECT

public:
    /// \param canDraw  false without sufficient OpenGL: everything but the picture works then
    explicit AnimationTab(bool canDraw, QWidget *parent = nullptr);

    OpenAnimation &document() { return static_cast<OpenAnimation &>(DocumentTab::document()); }
    const OpenAnimation &document() const { return static_cast<const OpenAnimation &>(DocumentTab::document()); }
    /// Null while it is being opened, and without OpenGL.
    views::AnimationViewport *viewport() const { return mViewport; }
    /// What the picture is coloured by, with OpenGL or without; null while it is being opened.
    views::ErrorColoring *errorColoring() const { return mErrorColoring; }

protected:
    QWidget *page() override;

private:
    const bool mCanDraw;
    QWidget *mPage = nullptr;
    views::AnimationViewport *mViewport = nullptr;
    views::ErrorColoring *mErrorColoring = nullptr;
};

} // namespace editor
