// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/inspect/inspection.h"

#include <QAbstractTableModel>
#include <QPointer>

namespace views {

/// One of the lists of an inspection: a row for each component, hole, handle or problem.
class PartTable final : public QAbstractTableModel
{
    Q_OBJECT

public:
    /// The value that a column is sorted by: a number or a text.
    static constexpr int SortRole = Qt::UserRole;
    /// The text for files and the clipboard: numbers as in C.
    static constexpr int PlainRole = Qt::UserRole + 1;

    explicit PartTable(PartKind kind, QObject *parent = nullptr);

    void setInspection(Inspection *inspection);
    PartKind kind() const { return mKind; }
    /// In the language of now.
    void retranslate();

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QVariant value(std::uint32_t row, int column) const;
    QString title(int column) const;
    void refill();

    const PartKind mKind;
    QPointer<Inspection> mInspection;
    int mRows = 0;
};

} // namespace views
