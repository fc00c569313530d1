// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/inspect/inspection.h"

#include <QList>
#include <QObject>

class QDockWidget;
class QMainWindow;

namespace views {
class InspectorDock;
} // namespace views

namespace editor {

class Actions;
class FileActions;
class Settings;
class Workspace;

/// What the editor shows of meshes beside their tabs: the inspector's lists, and more views of the mesh, docked. They
/// follow the present tab. Makes meshes of the frames of animations.
class Inspector final : public QObject
{
    Q_OBJECT

public:
    Inspector(Actions &actions, FileActions &files, Workspace &workspace, Settings &settings, QMainWindow &window);

    views::InspectorDock &dock() const { return *mDock; }
    /// Empty until they are shown for the first time.
    const QList<QDockWidget *> &views() const { return mViews; }
    void retranslate();

private:
    void follow();
    void fill(QDockWidget &dock);
    void inspectFrame();
    void saveReport();
    views::Inspection *inspection() const;

    Actions &mActions;
    FileActions &mFiles;
    Workspace &mWorkspace;
    Settings &mSettings;
    QMainWindow &mWindow;
    views::InspectorDock *mDock;
    QList<QDockWidget *> mViews;
    views::Job mSaving;
};

} // namespace editor
