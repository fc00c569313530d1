// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/documents/documentkind.h"
#include "app/editor/start/settings.h"

#include <QByteArray>

#include <map>
#include <optional>
#include <vector>

class QDockWidget;
class QMainWindow;

namespace editor {

/// Which docks go with which kind of document, and how the user has arranged docks and toolbars for each kind.
class DockLayouts
{
public:
    DockLayouts(QMainWindow &window, Settings &settings);

    /// \param kind      nothing: it goes with all
    /// \param isHidden  until the user asks for it
    void add(QDockWidget &dock, std::optional<DocumentKind> kind, bool isHidden = false);
    /// All docks and toolbars are there: takes their places as the first ones, then those of the last session.
    void restore(DocumentKind kind);
    /// Shows the docks of this kind where they were when it was shown last.
    void show(DocumentKind kind);
    void save();

private:
    struct Dock
    {
        QDockWidget *dock;
        std::optional<DocumentKind> kind;
        bool isHidden;
    };

    void arrange(DocumentKind kind);
    void apply();

    QMainWindow &mWindow;
    Settings &mSettings;
    std::vector<Dock> mDocks;
    std::map<DocumentKind, QByteArray> mStates;
    DocumentKind mShown = DocumentKind::Animation;
};

} // namespace editor
