// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/jobpanel.h"

#include "views/dialogs/quantitytext.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include <cmath>

namespace views {

namespace {
constexpr int BarSteps = 1000;
} // namespace

JobPanel::JobPanel(Job &job, QWidget *parent)
    : QWidget(parent)
    , mJob(job)
    , mActivity(new QLabel(this))
    , mBar(new QProgressBar(this))
    , mTimeLeft(new QLabel(this))
    , mCancel(new QPushButton(tr("Cancel"), this))
{
    mBar->setRange(0, BarSteps);
    mBar->setAccessibleName(tr("Progress"));
    mTimeLeft->setMinimumWidth(fontMetrics().horizontalAdvance(tr("about %1 left").arg(durationText(3599))));
    mCancel->setObjectName(QStringLiteral("cancelJob"));
    mCancel->setAutoDefault(false);
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(mActivity);
    row->addWidget(mBar, 1);
    row->addWidget(mTimeLeft);
    row->addWidget(mCancel);
    for (QWidget *part : {static_cast<QWidget *>(mActivity), static_cast<QWidget *>(mBar),
                          static_cast<QWidget *>(mTimeLeft), static_cast<QWidget *>(mCancel)}) {
        QSizePolicy policy = part->sizePolicy();
        policy.setRetainSizeWhenHidden(true);
        part->setSizePolicy(policy);
    }
    connect(&mJob, &Job::runningChanged, this, &JobPanel::showRunning);
    connect(&mJob, &Job::progressed, this, &JobPanel::showProgress);
    connect(mCancel, &QPushButton::clicked, this, [this] {
        mCancel->setEnabled(false);
        mTimeLeft->setText(tr("Stopping…"));
        mJob.cancel();
    });
    showRunning(mJob.isRunning());
}

void JobPanel::setActivity(const QString &text)
{
    mActivity->setText(text);
}

void JobPanel::showRunning(bool running)
{
    for (QWidget *part : {static_cast<QWidget *>(mActivity), static_cast<QWidget *>(mBar),
                          static_cast<QWidget *>(mTimeLeft), static_cast<QWidget *>(mCancel)})
        part->setVisible(running);
    mCancel->setEnabled(true);
    mTimeLeft->clear();
    showProgress();
}

void JobPanel::showProgress()
{
    mBar->setValue(int(mJob.fraction() * BarSteps));
    if (!mCancel->isEnabled())
        return;
    const std::optional<double> seconds = mJob.secondsLeft();
    if (!seconds)
        mTimeLeft->clear();
    else if (*seconds < 1)
        mTimeLeft->setText(tr("almost done"));
    else
        mTimeLeft->setText(tr("about %1 left").arg(durationText(std::ceil(*seconds)))); // tenths would flicker
}

} // namespace views
