// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <QAbstractTableModel>
#include <QList>
#include <QStringList>

namespace ui::admin {

/// Everybody of the school in words, a row each. A school has thousands, and all come at once.
class PeopleModel final : public QAbstractTableModel
{
    Q_OBJECT
public:
    enum Column { Name, Username, Role, Classes, LastLogin, State, Columns };
    /// The number of whose row it is, and what rows are sorted by.
    enum DataRole { Id = Qt::UserRole + 1, SortBy };

    struct Row
    {
        qint64 id = 0;
        std::array<QString, Columns> words;
        QString familyName;
        QString lastLoginUtc;
    };

    explicit PeopleModel(QObject* parent) : QAbstractTableModel(parent) {}

    void setHeads(const QStringList& heads);
    void setRows(const QList<Row>& rows);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QStringList m_heads;
    QList<Row> m_rows;
};

}  // namespace ui::admin
