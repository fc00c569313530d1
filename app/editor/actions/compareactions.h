// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/actions/actions.h"
#include "model/base/error.h"

#include <QObject>

namespace views {
class Comparison;
class LogModel;
} // namespace views

namespace editor {

class Settings;
class Workspace;

/// Comparing the present animation with its original, and how the error is coloured. A new tab is coloured as the one
/// before.
class CompareActions final : public QObject
{
    Q_OBJECT

public:
    CompareActions(Actions &actions, Workspace &workspace, const Settings &settings, views::LogModel &log,
                   QWidget &window);

private:
    void ask();
    /// Follows the present tab.
    void follow();
    void update();
    void failed(const QString &name, const model::Error &error);
    /// Null while no animation is open.
    views::Comparison *comparison() const;

    Actions &mActions;
    Workspace &mWorkspace;
    const Settings &mSettings;
    views::LogModel &mLog;
    QWidget &mWindow;
};

} // namespace editor
