// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>

namespace ui::kit {

/// A table that is sorted by its headings and handles the arrow keys itself, whatever shortcuts they are elsewhere. Alt
/// with an arrow key sorts: left and right select the neighbouring column, up and down the ascending or descending
/// order. The accessible description contains the sort order. Tab leaves the table.
class ListTable final : public QTableView
{
    Q_OBJECT
public:
    explicit ListTable(QWidget* parent);

    void setModel(QAbstractItemModel* model) override;

    /// Returns whether a row is being activated by Enter or the space bar, not by the pointer.
    [[nodiscard]] bool isByKey() const { return m_isByKey; }

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    /// @param columns  number of visible headings to move by
    void sortBeside(int columns);
    void describeSorting();

    bool m_isByKey = false;
};

}  // namespace ui::kit
