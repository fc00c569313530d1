// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/documents/terraintab.h"

#include "views/terrain/noglterrainview.h"
#include "views/terrain/terrainviewport.h"

namespace editor {

TerrainTab::TerrainTab(bool canDraw, QWidget *parent)
    : DocumentTab(std::make_unique<OpenTerrain>(), parent)
    , mCanDraw(canDraw)
{
    connect(&document(), &Document::aboutToBeReplaced, this, &TerrainTab::letGo);
}

TerrainTab::~TerrainTab()
{
    letGo(); // the document goes before the widgets
    disconnect(&document(), nullptr, this, nullptr);
}

QWidget *TerrainTab::page()
{
    if (mPage)
        return mPage;
    if (mCanDraw) {
        mPage = mViewport = new views::TerrainViewport(document().terrain(), this);
        mGround = mViewport;
        if (mCamera)
            mViewport->setCamera(*mCamera);
    } else {
        auto *map = new views::NoGlTerrainView(document().terrain(), this);
        mPage = map;
        mGround = map;
    }
    emit groundChanged();
    return mPage;
}

void TerrainTab::letGo()
{
    if (mViewport)
        mCamera = mViewport->camera();
    QWidget *page = std::exchange(mPage, nullptr);
    mViewport = nullptr;
    mGround = nullptr;
    emit groundChanged();
    delete page;
}

} // namespace editor
