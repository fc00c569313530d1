// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/jobs/job.h"

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace views {

/// Progress bar, time left and Cancel for a job; empty but as tall while nothing runs, so that a dialog does not jump.
class JobPanel final : public QWidget
{
    Q_OBJECT

public:
    explicit JobPanel(Job &job, QWidget *parent = nullptr);

    /// What is being done, as "Encoding…".
    void setActivity(const QString &text);

private:
    void showRunning(bool running);
    void showProgress();

    Job &mJob;
    QLabel *mActivity;
    QProgressBar *mBar;
    QLabel *mTimeLeft;
    QPushButton *mCancel;
};

} // namespace views
