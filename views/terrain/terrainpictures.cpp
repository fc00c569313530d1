// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/terrain/terrainpictures.h"

#include "views/jobs/guicall.h"
#include "views/terrain/terrainviewport.h"

#include <QPointer>

namespace views {

DrawView drawingOf(TerrainViewport &shown)
{
    return [viewport = QPointer<TerrainViewport>(&shown)](QSize size, const model::OrbitCamera &camera,
                                                          const model::Progress &progress) -> std::optional<QImage> {
        const auto begin = [viewport, size, camera] { return viewport && viewport->beginPicture(size, camera); };
        const std::optional<bool> canDraw = callInGui(progress, begin);
        if (!canDraw)
            return std::nullopt;
        if (!*canDraw)
            return QImage();
        for (bool isDone = false; !isDone;) {
            const auto step = callInGui(progress, [viewport] { return !viewport || viewport->stepPicture(); });
            if (!step)
                return std::nullopt;
            isDone = *step;
        }
        return callInGui(progress, [viewport] { return viewport ? viewport->takePicture() : QImage(); });
    };
}

} // namespace views
