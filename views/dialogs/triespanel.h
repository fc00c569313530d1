// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/dialogs/encoding.h"

#include <QWidget>

#include <vector>

class QLabel;
class QPushButton;
class QTableWidget;

namespace views {

/// The encodings made so far, one a row, so that they can be compared, with the whole of the selected one below.
class TriesPanel final : public QWidget
{
    Q_OBJECT

public:
    explicit TriesPanel(QWidget *parent = nullptr);

    /// Appends a row and selects it.
    void add(const EncodingReport &report);
    void clear();
    bool isEmpty() const { return mTries.empty(); }
    /// True if `path` is as the newest try to it left it.
    bool hasWritten(const QString &path) const;

signals:
    /// \param original  what the file was made of
    void openRequested(const QString &path, const views::OriginalPtr &original);
    void encodeAgainRequested();

private:
    /// Row of the try that `path` holds now; -1 if there is none.
    int newestFor(const QString &path) const;
    void showSelected();

    struct Try
    {
        EncodingReport report;
        qint64 writtenAt; ///< the file's time stamp, ms since 1970
    };
    std::vector<Try> mTries;
    QTableWidget *mTable;
    QLabel *mSummary;
    QPushButton *mOpen;
    QPushButton *mShowInFolder;
};

} // namespace views
