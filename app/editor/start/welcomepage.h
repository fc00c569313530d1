// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/actions/actions.h"
#include "app/editor/start/settings.h"
#include "app/editor/start/thumbnails.h"

#include <QWidget>

class QGridLayout;
class QLabel;
class QToolButton;
class QVBoxLayout;

namespace editor {

/// What is seen while nothing is open: the ways to begin, the samples and the recent files, as pictures.
class WelcomePage final : public QWidget
{
    Q_OBJECT

public:
    WelcomePage(Actions &actions, const Settings &settings, QWidget *parent = nullptr);

    /// Shows what the settings now hold.
    void refresh();

signals:
    void openRequested(const QString &path);

protected:
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    struct Card
    {
        QString path;
        QString name;
    };

    QToolButton *makeCard(const Card &card);
    void fill(QGridLayout &grid, const std::vector<Card> &cards);
    void retranslate();
    int columns() const;

    const Settings &mSettings;
    Thumbnails mThumbnails;
    QWidget *mContent;
    QLabel *mSlogan;
    QLabel *mSamplesTitle;
    QLabel *mRecentTitle;
    QLabel *mHint;
    QGridLayout *mSamples;
    QGridLayout *mRecent;
    int mColumns = 0;
};

} // namespace editor
