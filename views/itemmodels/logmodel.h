// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QDateTime>
#include <QString>

#include <deque>

namespace views {

enum class LogLevel { Info, Warning, Error };

/// What happened in this session, oldest first: a row for each message, columns time, level, text. Keeps the newest
/// MaxRows. GUI thread only; addFromAnyThread() may be called from others.
class LogModel final : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Time, Level, Text, ColumnCount };
    static constexpr int MaxRows = 5000;

    explicit LogModel(QObject *parent = nullptr);

    void add(LogLevel level, const QString &text);
    void addFromAnyThread(LogLevel level, const QString &text);
    void clear();
    LogLevel level(int row) const { return mEntries[std::size_t(row)].level; }
    QString text(int row) const { return mEntries[std::size_t(row)].text; }
    /// The rows as lines of text, with date, for the clipboard and a report.
    QString asText(const QList<int> &rows) const;

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    struct Entry
    {
        QDateTime time;
        LogLevel level;
        QString text;
    };

    static QString levelName(LogLevel level);

    std::deque<Entry> mEntries;
};

} // namespace views
