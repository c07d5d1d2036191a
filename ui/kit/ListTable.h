// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>

namespace ui::kit {

/// A table of a page: sorts by its headings, and keeps the arrow keys to itself, whatever else they are keys of; with
/// Alt they sort: to the sides by the column beside, up and down from the least or the most. What it is sorted by is
/// its description. Tab leaves it.
class ListTable final : public QTableView
{
    Q_OBJECT
public:
    explicit ListTable(QWidget* parent);

    void setModel(QAbstractItemModel* model) override;

    /// Enter or the space bar, not the pointer, is opening a row just now.
    [[nodiscard]] bool isByKey() const { return m_isByKey; }

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    /// @param columns  further along the headings that are seen
    void sortBeside(int columns);
    void describeSorting();

    bool m_isByKey = false;
};

}  // namespace ui::kit
