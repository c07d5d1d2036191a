// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/admin/PeopleModel.h"

#include "ui/kit/Theme.h"

namespace ui::admin {
void PeopleModel::setHeads(const QStringList& heads)
{
    m_heads = heads;
    emit headerDataChanged(Qt::Horizontal, 0, Columns - 1);
}

void PeopleModel::setRows(const QList<Row>& rows)
{
    beginResetModel();
    m_rows = rows;
    endResetModel();
}

int PeopleModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int PeopleModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : Columns;
}

QVariant PeopleModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const Row& row = m_rows[index.row()];
    const QString& words = row.words.at(static_cast<std::size_t>(index.column()));
    switch (role) {
    case Qt::DisplayRole:
        return words;
    case Qt::ToolTipRole:
        return kit::brokenIntoLines(words);
    case Id:
        return row.id;
    case SortBy:
        return index.column() == Name        ? row.familyName + u' ' + words + u' ' + row.words[Username]
               : index.column() == LastLogin ? row.lastLoginUtc
                                             : words;
    default:
        return {};
    }
}

QVariant PeopleModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Horizontal && role == Qt::DisplayRole)
        return m_heads.value(section);
    return {};
}

}  // namespace ui::admin
