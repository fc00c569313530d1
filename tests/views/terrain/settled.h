// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/terrain/terrainviewport.h"

#include <QImage>
#include <QTest>

namespace tests {

/// The exact picture of what the document now holds: a viewport draws in steps.
inline QImage settled(views::TerrainViewport &viewport)
{
    constexpr int LongestWait = 60000; // milliseconds
    if (!QTest::qWaitFor([&] { return !viewport.isLoading(); }, LongestWait))
        qWarning("the picture is not done");
    return viewport.grabFramebuffer();
}

} // namespace tests
