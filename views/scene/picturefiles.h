// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/error.h"
#include "model/base/progress.h"
#include "model/mesh/camera.h"
#include "views/scene/framedata.h"

#include <QImage>
#include <QString>

#include <functional>
#include <optional>
#include <vector>

namespace views {

/// Writes a picture as PNG through io::SaveFile: all or nothing. \error CannotOpen, CannotWrite, OutOfMemory,
/// Cancelled
model::Result<void> savePng(const QString &path, const QImage &picture, const model::Progress &progress);

/// Draws a frame; called in a worker; nothing if the work was cancelled meanwhile, a null image if there is not enough
/// memory for it.
using DrawFrame = std::function<std::optional<QImage>(const FrameDataPtr &, const model::Progress &)>;

/// Draws a scene from somewhere; else the same.
using DrawView = std::function<std::optional<QImage>(QSize, const model::OrbitCamera &, const model::Progress &)>;
/// Draws the picture with a number, counted from 0; else the same.
using DrawPicture = std::function<std::optional<QImage>(std::size_t, const model::Progress &)>;

/// Writes FOLDER/frame_0001.png and so on, `count` of them. Makes the folder if need be; on an error or a cancel
/// removes what it wrote, and only that. \error CannotOpen, CannotWrite, OutOfMemory, Cancelled
model::Result<void> savePictures(const QString &folder, std::size_t count, const DrawPicture &draw,
                                 const model::Progress &progress);

/// The same, one for each of `order`. \param order  frames in the order of the pictures; each below
/// source->frameCount()
model::Result<void> savePictures(const QString &folder, const model::FrameSourcePtr &source,
                                 const std::vector<std::uint32_t> &order, const DrawFrame &draw,
                                 const model::Progress &progress);

} // namespace views
