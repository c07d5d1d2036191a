// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/admin/PeopleModel.h"

#include <algorithm>
#include <numeric>

#include "ui/shell/Theme.h"

namespace ui::admin {
namespace {

constexpr qsizetype kMeasured = 16;
constexpr char16_t kFirstWide = 0x1100;  ///< from here on letters are about as wide as high

qsizetype lettersOf(const QString& words)
{
    return words.size() +
           std::count_if(words.begin(), words.end(), [](QChar one) { return one.unicode() >= kFirstWide; });
}

}  // namespace

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

QList<QModelIndex> PeopleModel::longest(int column) const
{
    const auto place = static_cast<std::size_t>(column);
    QList<qsizetype> letters;
    for (const Row& row : m_rows)
        letters << lettersOf(row.words.at(place));
    QList<int> rows(m_rows.size());
    std::iota(rows.begin(), rows.end(), 0);
    const auto last = rows.begin() + std::min(kMeasured, rows.size());
    std::partial_sort(rows.begin(), last, rows.end(), [&](int a, int b) { return letters[a] > letters[b]; });
    QList<QModelIndex> found;
    std::transform(rows.begin(), last, std::back_inserter(found), [&](int row) { return index(row, column); });
    return found;
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
        return shell::brokenIntoLines(words);
    case Id:
        return row.id;
    case SortBy:
        return index.column() == Name        ? row.familyName + u' ' + words
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
