// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/scene/comparison.h"

#include <QPointer>
#include <QWidget>

class QComboBox;
class QLabel;
class QProgressBar;
class QToolButton;

namespace views {

class ErrorPlot;
class FlowLayout;
class TimelineSlider;

/// The part of the timeline that shows what the frames lost of their original: a plot above the ruler, the worst frame,
/// and how far the measuring is. Hidden while nothing is compared.
class ErrorPanel final : public QWidget
{
    Q_OBJECT

public:
    enum Curve { KgError, LargestVertexError };

    ErrorPanel(const TimelineSlider &slider, QWidget *parent = nullptr);

    /// Both null: nothing to show.
    void setComparison(Comparison *comparison, Player *player);

    /// There are errors of the present frames.
    bool hasErrors() const { return mComparison && mComparison->result(); }
    /// Shows the frame with the largest value of the curve. Precondition: hasErrors().
    void goToWorstFrame();
    /// As a button in the panel.
    void addAction(QAction *action);
    void retranslate();

signals:
    void stateChanged();

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void follow();
    void wrapHeader();
    void showProgress();
    void showFrame();
    std::vector<double> values() const;
    std::uint32_t worstFrame() const;

    QPointer<Comparison> mComparison;
    QPointer<Player> mPlayer;
    int mWorst = 1; ///< the worst frame of the curve, from 1
    QComboBox *mCurve;
    QLabel *mValues;
    QLabel *mMessage;
    QWidget *mButtons;
    QWidget *mHeader; ///< curve, worst frame and buttons
    FlowLayout *mHeaderLayout;
    QWidget *mMeasuringRow; ///< in its place while it measures
    QLabel *mMeasuring;
    QProgressBar *mProgress;
    QToolButton *mCancel;
    ErrorPlot *mPlot;
};

} // namespace views
