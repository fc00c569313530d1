// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/documents/documenttab.h"
#include "app/editor/documents/openterrain.h"

namespace views {
class GroundView;
class TerrainViewport;
} // namespace views

namespace editor {

/// A terrain in its viewport, or the map that stands for that without OpenGL.
class TerrainTab final : public DocumentTab
{
    Q_OBJECT

public:
    /// \param canDraw  false without sufficient OpenGL
    explicit TerrainTab(bool canDraw, QWidget *parent = nullptr);
    ~TerrainTab() override;

    OpenTerrain &document() { return static_cast<OpenTerrain &>(DocumentTab::document()); }
    const OpenTerrain &document() const { return static_cast<const OpenTerrain &>(DocumentTab::document()); }
    /// Null until it is opened, and without OpenGL; with another document after a reload.
    views::TerrainViewport *viewport() const { return mViewport; }
    /// Where tools work, with OpenGL or without; null while it is being opened.
    views::GroundView *ground() const { return mGround; }

signals:
    /// ground() is another one, or null: sent before the one before is destroyed.
    void groundChanged();

protected:
    QWidget *page() override;

private:
    void leaveGround();

    const bool mCanDraw;
    QWidget *mPage = nullptr;
    views::TerrainViewport *mViewport = nullptr;
    views::GroundView *mGround = nullptr;
};

} // namespace editor
