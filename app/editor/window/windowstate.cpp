// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/window/windowstate.h"

#include <QGuiApplication>
#include <QMainWindow>
#include <QScreen>

namespace editor {

namespace {

constexpr QSize DefaultSize(1280, 820);

} // namespace

void restoreWindow(QMainWindow &window, const Settings &settings)
{
    if (!window.restoreGeometry(settings.windowGeometry())) {
        const QRect free = window.screen()->availableGeometry();
        window.resize(DefaultSize.boundedTo(free.size()));
        window.move(free.center() - window.rect().center());
    }
}

void saveWindow(const QMainWindow &window, Settings &settings)
{
    settings.setWindowGeometry(window.saveGeometry());
}

} // namespace editor
