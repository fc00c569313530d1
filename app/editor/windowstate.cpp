// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/windowstate.h"

#include <QGuiApplication>
#include <QMainWindow>
#include <QScreen>

namespace editor {

namespace {

// Raised when docks or toolbars come or go, so that an old layout does not hide the new ones.
constexpr int StateVersion = 1;
constexpr QSize DefaultSize(1280, 820);

} // namespace

void restoreWindow(QMainWindow &window, const Settings &settings)
{
    if (!window.restoreGeometry(settings.windowGeometry())) {
        const QRect free = window.screen()->availableGeometry();
        window.resize(DefaultSize.boundedTo(free.size()));
        window.move(free.center() - window.rect().center());
    }
    window.restoreState(settings.windowState(), StateVersion);
}

void saveWindow(const QMainWindow &window, Settings &settings)
{
    settings.setWindow(window.saveGeometry(), window.saveState(StateVersion));
}

} // namespace editor
