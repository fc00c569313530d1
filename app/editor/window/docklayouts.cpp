// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/window/docklayouts.h"

#include <QDockWidget>
#include <QMainWindow>

namespace editor {

namespace {

// Raised when docks or toolbars come or go, so that an old layout does not hide the new ones.
constexpr int StateVersion = 4;

} // namespace

DockLayouts::DockLayouts(QMainWindow &window, Settings &settings)
    : mWindow(window)
    , mSettings(settings)
{}

void DockLayouts::add(QDockWidget &dock, std::optional<DocumentKind> kind, bool isHidden)
{
    mDocks.push_back({&dock, kind, isHidden});
}

void DockLayouts::restore(DocumentKind kind)
{
    for (const DocumentKind each : EveryDocumentKind) {
        arrange(each);
        mStates[each] = mWindow.saveState(StateVersion);
        if (const QByteArray stored = mSettings.windowState(nameOf(each)); !stored.isEmpty())
            mStates[each] = stored;
    }
    mShown = kind;
    apply();
}

void DockLayouts::show(DocumentKind kind)
{
    if (kind == mShown)
        return;
    mStates[mShown] = mWindow.saveState(StateVersion);
    mShown = kind;
    apply();
}

void DockLayouts::save()
{
    mStates[mShown] = mWindow.saveState(StateVersion);
    for (const auto &[kind, state] : mStates)
        mSettings.setWindowState(nameOf(kind), state);
}

/// The first layout of a kind.
void DockLayouts::arrange(DocumentKind kind)
{
    for (const Dock &entry : mDocks)
        entry.dock->setVisible(entry.kind.value_or(kind) == kind && !entry.isHidden);
}

void DockLayouts::apply()
{
    if (!mWindow.restoreState(mStates[mShown], StateVersion))
        arrange(mShown); // of another version, or no layout at all
    for (const Dock &entry : mDocks) {
        const bool fits = entry.kind.value_or(mShown) == mShown;
        entry.dock->toggleViewAction()->setVisible(fits);
        if (!fits)
            entry.dock->hide();
    }
}

} // namespace editor
