// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/scene/comparison.h"
#include "views/scene/player.h"

#include <QDockWidget>
#include <QPointer>

class QAction;
class QActionGroup;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSpinBox;

namespace views {

class ErrorPanel;
class TimelineSlider;

/// The controls of a player: transport, ruler, loop range, rate. Frames are numbered from 1 for people.
///
/// Its actions have shortcuts and names ("playPause", "stop", "stepBack", ...) and are part of the widget:
/// `actions()` lists them, for menus and the shortcut editor; `action("playPause")` is one of them.
class TimelineDock final : public QDockWidget
{
    Q_OBJECT

public:
    explicit TimelineDock(QWidget *parent = nullptr);

    /// The player to control; null disables everything. A player that goes away is let go of.
    void setPlayer(Player *player);
    Player *player() const { return mPlayer; }
    /// What the frames lost of their original, plotted above the ruler; null: nothing. It measures player()'s frames.
    void setComparison(Comparison *comparison);
    /// As buttons beside the plot.
    void addErrorActions(const QList<QAction *> &actions);

    /// Null if there is no such name.
    QAction *action(const QString &name) const;

protected:
    void changeEvent(QEvent *event) override;

private:
    void makeActions();
    QAction *addAction(const char *name, const char *icon, const QList<QKeySequence> &shortcuts,
                       bool isCheckable = false);
    void makeWidgets();
    QWidget *makeButtons(const QList<const char *> &names);
    void retranslate();
    void showFrame();
    void showState();
    void setEnabledState();
    void setRangeEnd(bool isFirst);

    QPointer<Player> mPlayer;
    ErrorPanel *mErrors = nullptr;
    TimelineSlider *mSlider = nullptr;
    QSpinBox *mFrame = nullptr;
    QLabel *mTime = nullptr;
    QLabel *mRateLabel = nullptr;
    QDoubleSpinBox *mRate = nullptr;
    QComboBox *mPacing = nullptr;
    QActionGroup *mLoopModes = nullptr;
};

} // namespace views
