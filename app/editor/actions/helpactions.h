// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/actions/actions.h"
#include "app/editor/start/settings.h"

#include <QObject>

namespace editor {

/// Settings and Help: the shortcut editor, the list of shortcuts, licences, About.
class HelpActions final : public QObject
{
    Q_OBJECT

public:
    HelpActions(Actions &actions, Settings &settings, QWidget &window);

private:
    void configureShortcuts();
    void listShortcuts();
    void showLicences();
    void showAbout();

    Actions &mActions;
    Settings &mSettings;
    QWidget &mWindow;
};

} // namespace editor
