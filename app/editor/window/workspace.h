// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/widgets/messagebar.h"

#include <QWidget>

#include <vector>

class QStackedWidget;
class QTabWidget;

namespace editor {

class AnimationTab;
class DocumentTab;
class MeshTab;
class TerrainTab;

/// The middle of the window: open documents as tabs, or the welcome page while there is none, with messages above.
class Workspace final : public QWidget
{
    Q_OBJECT

public:
    /// \param welcome  shown while no tab is; becomes a child
    explicit Workspace(QWidget *welcome, QWidget *parent = nullptr);

    /// Takes the tab and shows it.
    void add(DocumentTab *tab);
    /// Destroys the tab at the next turn of the event loop; it is out of sight and out of tabs() at once.
    void remove(DocumentTab &tab);
    void activate(DocumentTab &tab);
    /// Shows the tab `offset` places further, round the end.
    void showNeighbour(int offset);

    /// Null while the welcome page is shown.
    DocumentTab *current() const;
    // The same if it is of this kind.
    AnimationTab *currentAnimation() const;
    TerrainTab *currentTerrain() const;
    MeshTab *currentMesh() const;
    /// From left to right.
    std::vector<DocumentTab *> tabs() const;

    views::MessageBar &messages() { return *mMessages; }

signals:
    void currentChanged();
    /// What current() shows in its tab changed.
    void currentStateChanged();
    void closeRequested(editor::DocumentTab &tab);

protected:
    void changeEvent(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void showState(DocumentTab &tab);
    void retranslate();
    DocumentTab *at(int index) const;

    views::MessageBar *mMessages;
    QStackedWidget *mStack;
    QTabWidget *mTabs;
};

} // namespace editor
