// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <QAbstractTableModel>
#include <QList>
#include <QStringList>

namespace ui::admin {

/// A table of all people in the school as text, one row per person. It may have thousands of rows; all are set at once.
class PeopleModel final : public QAbstractTableModel
{
    Q_OBJECT
public:
    enum Column { Name, Username, Role, Classes, LastLogin, State, Columns };
    /// The id of a row's person, and the key by which rows are sorted.
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
