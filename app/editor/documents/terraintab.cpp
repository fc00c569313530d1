// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/documents/terraintab.h"

#include "views/terrain/noglterrainview.h"
#include "views/terrain/terrainviewport.h"

namespace editor {

TerrainTab::TerrainTab(bool canDraw, QWidget *parent)
    : DocumentTab(std::make_unique<OpenTerrain>(), parent)
    , mCanDraw(canDraw)
{
    connect(&document(), &Document::aboutToBeReplaced, this, &TerrainTab::leaveGround);
}

TerrainTab::~TerrainTab()
{
    leaveGround(); // the document goes before the widgets
    delete mViewport;
    disconnect(&document(), nullptr, this, nullptr);
}

QWidget *TerrainTab::page()
{
    if (mCanDraw) {
        if (mViewport)
            mViewport->setDocument(document().terrain());
        else
            mPage = mViewport = new views::TerrainViewport(document().terrain(), this);
        mGround = mViewport;
    } else if (!mPage) {
        auto *map = new views::NoGlTerrainView(document().terrain(), this);
        mPage = map;
        mGround = map;
    }
    emit groundChanged();
    return mPage;
}

/// The document goes. The viewport is kept for the next one: its context and its programs take long to make.
void TerrainTab::leaveGround()
{
    mGround = nullptr;
    emit groundChanged();
    if (mViewport)
        disconnect(&document().terrain(), nullptr, mViewport, nullptr);
    else
        delete std::exchange(mPage, nullptr);
}

} // namespace editor
