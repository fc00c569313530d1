// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/sculpt/strokecontroller.h"

#include <QObject>

class QLabel;
class QStatusBar;

namespace editor {

class MeshTab;
class OpenTerrain;
class Workspace;

/// The status bar: what the mouse does at the left, the size of the present document at the right.
class StatusPanel final : public QObject
{
    Q_OBJECT

public:
    StatusPanel(QStatusBar &bar, Workspace &workspace);
    void retranslate() { update(); }
    /// What lies under the pointer on a terrain; nothing beside it.
    void showReading(const std::optional<views::GroundReading> &reading);
    /// Something that happened, for a few seconds.
    void showMessage(const QString &text);

private:
    QString readingText() const;

    void follow();
    void update();
    void showTerrain(const OpenTerrain &document);
    void showMesh(const MeshTab &tab);

    QStatusBar &mBar;
    Workspace &mWorkspace;
    QLabel *mHint;
    QLabel *mNumbers;
    std::optional<views::GroundReading> mReading;
    QMetaObject::Connection mChanges;
};

} // namespace editor
