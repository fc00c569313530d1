// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/inspect/parttable.h"

#include "views/inspect/numbers.h"
#include "views/inspect/problems.h"

#include <QLocale>

namespace views {

namespace {

const QList<const char *> &titles(PartKind kind)
{
    static const QList<const char *> components{
        QT_TRANSLATE_NOOP("views::PartTable", "No."),   QT_TRANSLATE_NOOP("views::PartTable", "Vertices"),
        QT_TRANSLATE_NOOP("views::PartTable", "Edges"), QT_TRANSLATE_NOOP("views::PartTable", "Faces"),
        QT_TRANSLATE_NOOP("views::PartTable", "Euler"), QT_TRANSLATE_NOOP("views::PartTable", "Genus"),
        QT_TRANSLATE_NOOP("views::PartTable", "Holes"), QT_TRANSLATE_NOOP("views::PartTable", "Orientable"),
        QT_TRANSLATE_NOOP("views::PartTable", "Area"),  QT_TRANSLATE_NOOP("views::PartTable", "Volume"),
    };
    static const QList<const char *> holes{
        QT_TRANSLATE_NOOP("views::PartTable", "No."),   QT_TRANSLATE_NOOP("views::PartTable", "Component"),
        QT_TRANSLATE_NOOP("views::PartTable", "Edges"), QT_TRANSLATE_NOOP("views::PartTable", "Length"),
        QT_TRANSLATE_NOOP("views::PartTable", "Area"),
    };
    static const QList<const char *> handles{
        QT_TRANSLATE_NOOP("views::PartTable", "No."),
        QT_TRANSLATE_NOOP("views::PartTable", "Component"),
        QT_TRANSLATE_NOOP("views::PartTable", "Short Loop"),
        QT_TRANSLATE_NOOP("views::PartTable", "Long Loop"),
    };
    static const QList<const char *> problems{
        QT_TRANSLATE_NOOP("views::PartTable", "Problem"),
        QT_TRANSLATE_NOOP("views::PartTable", "Where"),
    };
    switch (kind) {
    case PartKind::Component:
        return components;
    case PartKind::Hole:
        return holes;
    case PartKind::Handle:
        return handles;
    case PartKind::Problem:
        break;
    }
    return problems;
}

template <class T>
QVariant orNothing(const std::optional<T> &value)
{
    return value ? QVariant::fromValue(*value) : QVariant();
}

} // namespace

PartTable::PartTable(PartKind kind, QObject *parent)
    : QAbstractTableModel(parent)
    , mKind(kind)
{}

void PartTable::setInspection(Inspection *inspection)
{
    if (mInspection)
        mInspection->disconnect(this);
    mInspection = inspection;
    if (inspection) {
        connect(inspection, &Inspection::meshChanged, this, &PartTable::refill);
        connect(inspection, &Inspection::found, this, [this] {
            if (mRows != int(mInspection->countOf(mKind)))
                refill();
        });
    }
    refill();
}

void PartTable::refill()
{
    beginResetModel();
    mRows = mInspection ? int(mInspection->countOf(mKind)) : 0;
    endResetModel();
}

void PartTable::retranslate()
{
    emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
    if (mRows > 0)
        emit dataChanged(index(0, 0), index(mRows - 1, columnCount() - 1));
}

int PartTable::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : mRows;
}

int PartTable::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : int(titles(mKind).size());
}

QVariant PartTable::value(std::uint32_t row, int column) const
{
    switch (mKind) {
    case PartKind::Component: {
        const model::ComponentReport &part = mInspection->report()->components[row];
        const QVariant values[] = {row,
                                   part.vertices,
                                   part.edges,
                                   part.faces,
                                   qlonglong(part.euler()),
                                   orNothing(part.genus),
                                   part.boundaryLoops,
                                   part.isOrientable,
                                   part.area,
                                   orNothing(part.volume)};
        return values[column];
    }
    case PartKind::Hole: {
        const model::HoleReport &hole = mInspection->report()->holes[row];
        const QVariant values[] = {row, hole.component, uint(hole.loop.sides.size()), hole.length, hole.area};
        return values[column];
    }
    case PartKind::Handle: {
        const model::HandleReport &handle = (*mInspection->handles())[row];
        const QVariant values[] = {row, handle.component, handle.loops[0].length, handle.loops[1].length};
        return values[column];
    }
    case PartKind::Problem:
        break;
    }
    const Problem &problem = mInspection->problems()[row];
    return column == 0 ? problemTitle(problem.kind) : problemPlace(problem.kind, problem.ids);
}

QVariant PartTable::data(const QModelIndex &index, int role) const
{
    if (!mInspection || !index.isValid() || index.row() >= int(mInspection->countOf(mKind)))
        return {};
    const bool isText = mKind == PartKind::Problem;
    if (role == Qt::TextAlignmentRole)
        return QVariant(isText ? Qt::AlignLeft | Qt::AlignVCenter : Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole && role != SortRole && role != PlainRole)
        return {};
    const QVariant found = value(std::uint32_t(index.row()), index.column());
    if (role == SortRole)
        return isText && index.column() == 1 ? QVariant(index.row()) : found;
    if (!found.isValid())
        return role == PlainRole ? QString() : QStringLiteral("–");
    switch (found.typeId()) {
    case QMetaType::Bool:
        if (role == PlainRole)
            return found.toBool() ? QStringLiteral("true") : QStringLiteral("false");
        return found.toBool() ? tr("yes") : tr("no");
    case QMetaType::Double:
        return role == PlainRole ? QString::number(found.toDouble(), 'g', 9) : shortNumber(found.toDouble());
    case QMetaType::QString:
        return found;
    default:
        return role == PlainRole ? QString::number(found.toLongLong()) : QLocale().toString(found.toLongLong());
    }
}

QString PartTable::title(int column) const
{
    return tr(titles(mKind)[column]);
}

QVariant PartTable::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= columnCount())
        return {};
    if (role == Qt::DisplayRole)
        return title(section);
    if (role == Qt::ToolTipRole && mKind == PartKind::Component && section == 5)
        return tr("The number of handles; of a one-sided component that of its cross-caps");
    if (role == Qt::ToolTipRole && mKind == PartKind::Component && section == 4)
        return tr("Vertices − edges + faces");
    if (role == Qt::ToolTipRole && mKind == PartKind::Hole && section == 4)
        return tr("Of a flat lid that would close the hole");
    return {};
}

} // namespace views
