// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/dialogs/exportdialog.h"

#include "model/animation/editedframes.h"
#include "model/io/errortext.h"
#include "views/dialogs/inputline.h"
#include "views/dialogs/jobpanel.h"
#include "views/dialogs/numberfield.h"
#include "views/dialogs/showinfolder.h"

#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

namespace views {

ExportDialog::ExportDialog(const QString &title, QWidget *parent)
    : QDialog(parent)
    , mForm(new QFormLayout)
    , mMessage(new HintLabel(this))
    , mExport(new QPushButton(tr("&Export"), this))
    , mShowInFolder(new QPushButton(tr("Show in Folde&r"), this))
{
    setWindowTitle(title);
    setMinimumWidth(560);
    mMessage->setObjectName(QStringLiteral("message"));
    mMessage->setWordWrap(true);
    mMessage->setMinimumHeight(2 * fontMetrics().height()); // coming and going must not resize the dialog
    mMessage->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    mPanel = new JobPanel(mJob, this);
    mPanel->setActivity(tr("Writing…"));
    mExport->setObjectName(QStringLiteral("export"));
    mExport->setDefault(true);
    mShowInFolder->setObjectName(QStringLiteral("showInFolder"));
    mShowInFolder->setAutoDefault(false);
    mShowInFolder->hide();
    auto *close = new QPushButton(tr("Close"), this);
    close->setAutoDefault(false);

    auto *buttons = new QHBoxLayout;
    buttons->addWidget(mShowInFolder);
    buttons->addStretch(1);
    buttons->addWidget(mExport);
    buttons->addWidget(close);
    auto *column = new QVBoxLayout(this);
    column->addLayout(mForm);
    column->addWidget(mMessage);
    column->addStretch(1);
    column->addWidget(mPanel);
    column->addLayout(buttons);

    connect(mExport, &QPushButton::clicked, this, &ExportDialog::start);
    connect(mShowInFolder, &QPushButton::clicked, this, [this] { showInFolder(mWritten); });
    connect(close, &QPushButton::clicked, this, &ExportDialog::reject);
    connect(&mJob, &Job::runningChanged, this, &ExportDialog::refresh);
}

void ExportDialog::refresh()
{
    const QString reason = problem();
    mExport->setEnabled(reason.isEmpty() && !isExporting());
    mExport->setToolTip(reason);
    for (int row = 0; row < mForm->rowCount(); ++row)
        if (QLayoutItem *field = mForm->itemAt(row, QFormLayout::FieldRole); field && field->widget())
            field->widget()->setEnabled(!isExporting());
    mMessage->showHint(!reason.isEmpty() ? reason : consequence());
    mShowInFolder->hide();
}

void ExportDialog::start()
{
    if (isExporting() || !problem().isEmpty() || !mayReplace())
        return;
    mWritten = outputPath();
    mJob.start(work(), [this](const model::Result<void> &outcome) { showOutcome(outcome); });
}

void ExportDialog::showOutcome(const model::Result<void> &outcome)
{
    if (outcome) {
        refresh();
        mMessage->showHint(tr("Written: %1").arg(QDir::toNativeSeparators(mWritten)));
        mShowInFolder->show();
    } else if (outcome.error().code == model::ErrorCode::Cancelled) {
        mMessage->showHint(tr("Cancelled. Nothing was left behind."));
    } else {
        mMessage->showRefusal(model::io::errorText(outcome.error()));
    }
}

bool ExportDialog::mayReplace()
{
    const QStringList files = filesToReplace();
    if (files.isEmpty())
        return true;
    QStringList names;
    for (const QString &file : files)
        names << QFileInfo(file).fileName();
    QMessageBox question(QMessageBox::Question, windowTitle(),
                         tr("Already there: %1. Replace?").arg(names.join(QStringLiteral(", "))), QMessageBox::Cancel,
                         this);
    const QPushButton *replace = question.addButton(tr("Replace"), QMessageBox::AcceptRole);
    question.setDefaultButton(QMessageBox::Cancel);
    question.exec();
    return question.clickedButton() == replace;
}

void ExportDialog::reject()
{
    if (isExporting())
        mJob.cancel();
    QDialog::reject();
}

FrameRangeFields::FrameRangeFields(QFormLayout &form, std::uint32_t frameCount, std::uint32_t first, std::uint32_t last,
                                   QObject *parent)
    : QObject(parent)
    , mFirst(new NumberField(tr("First frame"), {1, double(frameCount), 0}))
    , mLast(new NumberField(tr("Last frame"), {1, double(frameCount), 0}))
{
    mFirst->setObjectName(QStringLiteral("first"));
    mLast->setObjectName(QStringLiteral("last"));
    mFirst->setValue(double(first) + 1);
    mLast->setValue(double(last) + 1);
    form.addRow(tr("F&irst frame:"), mFirst);
    form.addRow(tr("&Last frame:"), mLast);
    connect(mFirst, &NumberField::changed, this, &FrameRangeFields::changed);
    connect(mLast, &NumberField::changed, this, &FrameRangeFields::changed);
}

QString FrameRangeFields::problem() const
{
    for (const NumberField *field : {mFirst, mLast})
        if (!field->value())
            return field->problem();
    return first() > last() ? tr("The first frame must not come after the last.") : QString();
}

std::uint32_t FrameRangeFields::first() const
{
    return std::uint32_t(mFirst->value().value_or(1)) - 1;
}

std::uint32_t FrameRangeFields::last() const
{
    return std::uint32_t(mLast->value().value_or(1)) - 1;
}

model::FrameSourcePtr FrameRangeFields::applyTo(const model::FrameSourcePtr &frames) const
{
    if (count() == frames->frameCount())
        return frames;
    const auto map = model::TimeMap::identity(frames->frameCount()).trimmed(first(), last());
    return std::make_shared<model::EditedFrames>(frames, map, model::Similarity(), frames->frameRate(), frames->name());
}

} // namespace views
