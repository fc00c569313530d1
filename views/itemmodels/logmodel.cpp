// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/itemmodels/logmodel.h"

#include "views/widgets/icons.h"

namespace views {

LogModel::LogModel(QObject *parent)
    : QAbstractTableModel(parent)
{}

void LogModel::add(LogLevel level, const QString &text)
{
    if (mEntries.size() == MaxRows) {
        beginRemoveRows({}, 0, 0);
        mEntries.pop_front();
        endRemoveRows();
    }
    const int row = int(mEntries.size());
    beginInsertRows({}, row, row);
    mEntries.push_back({QDateTime::currentDateTime(), level, text});
    endInsertRows();
}

void LogModel::addFromAnyThread(LogLevel level, const QString &text)
{
    QMetaObject::invokeMethod(
        this, [this, level, text] { add(level, text); }, Qt::QueuedConnection);
}

void LogModel::clear()
{
    beginResetModel();
    mEntries.clear();
    endResetModel();
}

QString LogModel::asText(const QList<int> &rows) const
{
    QString result;
    for (const int row : rows) {
        const Entry &entry = mEntries[std::size_t(row)];
        result += QStringLiteral("%1 %2 %3\n")
                      .arg(entry.time.toString(Qt::ISODateWithMs), levelName(entry.level), entry.text);
    }
    return result;
}

int LogModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : int(mEntries.size());
}

int LogModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant LogModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const Entry &entry = mEntries[std::size_t(index.row())];
    if (role == Qt::DecorationRole && index.column() == Level) {
        switch (entry.level) {
        case LogLevel::Info:
            return icon(QStringLiteral("info"));
        case LogLevel::Warning:
            return icon(QStringLiteral("warning"));
        case LogLevel::Error:
            return icon(QStringLiteral("error"));
        }
    }
    if (role == Qt::ToolTipRole)
        return entry.text;
    if (role == Qt::DisplayRole) {
        switch (index.column()) {
        case Time:
            return entry.time.toString(QStringLiteral("HH:mm:ss"));
        case Level:
            return levelName(entry.level);
        case Text:
            return entry.text;
        }
    }
    return {};
}

QVariant LogModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Time:
        return tr("Time");
    case Level:
        return tr("Kind");
    case Text:
        return tr("Message");
    }
    return {};
}

QString LogModel::levelName(LogLevel level)
{
    switch (level) {
    case LogLevel::Info:
        return tr("Note");
    case LogLevel::Warning:
        return tr("Warning");
    case LogLevel::Error:
        return tr("Error");
    }
    return {};
}

} // namespace views
