// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/documents/documenttab.h"
#include "app/editor/documents/openmesh.h"

namespace views {
class MeshView;
}

namespace editor {

/// A mesh in a view of its own; without OpenGL the lists of the inspector alone say what it is.
class MeshTab final : public DocumentTab
{
    Q_OBJECT

public:
    /// \param canDraw  false without sufficient OpenGL
    explicit MeshTab(bool canDraw, QWidget *parent = nullptr);

    OpenMesh &document() { return static_cast<OpenMesh &>(DocumentTab::document()); }
    const OpenMesh &document() const { return static_cast<const OpenMesh &>(DocumentTab::document()); }
    /// Null while it is being opened, and without OpenGL.
    views::MeshView *view() const { return mView; }

protected:
    QWidget *page() override;
    void changeEvent(QEvent *event) override;

private:
    void retranslate();

    const bool mCanDraw;
    QWidget *mPage = nullptr;
    views::MeshView *mView = nullptr;
    QLabel *mMessage = nullptr; ///< in place of the view
};

} // namespace editor
