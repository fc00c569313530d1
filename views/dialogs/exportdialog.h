// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/animation/framesource.h"
#include "views/jobs/job.h"

#include <QDialog>

#include <optional>

class QFormLayout;
class QPushButton;

namespace views {

class HintLabel;
class JobPanel;
class NumberField;

/// What the export dialogs have in common: a form, a line for what will be written or why it cannot be, progress with
/// Cancel, and Show in Folder once it is done. Writes in the background.
class ExportDialog : public QDialog
{
    Q_OBJECT

public:
    void reject() override;
    bool isExporting() const { return mJob.isRunning(); }

protected:
    explicit ExportDialog(const QString &title, QWidget *parent);

    QFormLayout &form() { return *mForm; }

    /// To be called when a field changed.
    void refresh();

    /// Why it cannot be done, as a sentence; empty if it can.
    virtual QString problem() const = 0;
    /// What will be written. Called only without a problem.
    virtual QString consequence() const { return {}; }
    /// Files that exist and would be replaced; asked about.
    virtual QStringList filesToReplace() const { return {}; }
    /// What Show in Folder shows.
    virtual QString outputPath() const = 0;
    /// The work, which owns what it uses, and leaves nothing behind on an error or a cancel. GUI thread.
    using Work = std::function<model::Result<void>(const model::Progress &)>;
    virtual Work work() = 0;

private:
    void start();
    void showOutcome(const model::Result<void> &outcome);
    bool mayReplace();

    QFormLayout *mForm;
    HintLabel *mMessage;
    QPushButton *mExport;
    QPushButton *mShowInFolder;
    QString mWritten; ///< by the last export; empty before
    Job mJob;
    JobPanel *mPanel;
};

/// The rows of a form for the first and the last frame to export, counted from 1.
class FrameRangeFields final : public QObject
{
    Q_OBJECT

public:
    /// \param first, last  proposed, 0-based
    FrameRangeFields(QFormLayout &form, std::uint32_t frameCount, std::uint32_t first, std::uint32_t last,
                     QObject *parent);

    QString problem() const;
    /// 0-based. Preconditions of these: no problem.
    std::uint32_t first() const;
    std::uint32_t last() const;
    std::uint32_t count() const { return last() - first() + 1; }
    /// `frames` without those outside.
    model::FrameSourcePtr applyTo(const model::FrameSourcePtr &frames) const;

signals:
    void changed();

private:
    NumberField *mFirst;
    NumberField *mLast;
};

} // namespace views
