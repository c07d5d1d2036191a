// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/admin/PeopleModel.h"

#include <algorithm>
#include <numeric>

#include <QHash>

#include "ui/shell/Theme.h"

namespace ui::admin {
namespace {

constexpr qsizetype kMeasured = 16;

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

QList<QModelIndex> PeopleModel::widest(int column, const QFontMetricsF& letters) const
{
    // To measure a word takes some hundred times as long as to look up its letters.
    QHash<QChar, double> known;
    const auto widthOf = [&](QChar letter) {
        auto found = known.constFind(letter);
        if (found == known.constEnd())
            found = known.insert(letter, letters.horizontalAdvance(letter));
        return *found;
    };
    QList<double> widthPx;
    for (const Row& row : m_rows) {
        const QString& words = row.words.at(static_cast<std::size_t>(column));
        widthPx << std::accumulate(words.begin(), words.end(), 0.0,
                                   [&](double sum, QChar letter) { return sum + widthOf(letter); });
    }
    QList<int> rows(m_rows.size());
    std::iota(rows.begin(), rows.end(), 0);
    const auto last = rows.begin() + std::min(kMeasured, rows.size());
    std::partial_sort(rows.begin(), last, rows.end(), [&](int a, int b) { return widthPx[a] > widthPx[b]; });
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
