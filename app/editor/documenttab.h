// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/document.h"

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;
class QStackedLayout;

namespace views {
class AnimationViewport;
class ErrorColoring;
} // namespace views

namespace editor {

/// A tab's page: how far the opening is, then the viewport, or what stands for it without OpenGL.
class DocumentTab final : public QWidget
{
    Q_OBJECT

public:
    /// \param canDraw  false without sufficient OpenGL: everything but the picture works then
    explicit DocumentTab(bool canDraw, QWidget *parent = nullptr);

    Document &document() { return mDocument; }
    const Document &document() const { return mDocument; }
    /// Null while it is being opened, and without OpenGL.
    views::AnimationViewport *viewport() const { return mViewport; }
    /// What the picture is coloured by, with OpenGL or without; null while it is being opened.
    views::ErrorColoring *errorColoring() const { return mErrorColoring; }

protected:
    void changeEvent(QEvent *event) override;

private:
    QWidget *makeOpeningPage();
    void showDocument();
    void retranslate();

    const bool mCanDraw;
    Document mDocument;
    QStackedLayout *mPages;
    QLabel *mOpeningTitle = nullptr;
    QProgressBar *mOpeningBar = nullptr;
    QPushButton *mCancel = nullptr;
    views::AnimationViewport *mViewport = nullptr;
    views::ErrorColoring *mErrorColoring = nullptr;
};

} // namespace editor
