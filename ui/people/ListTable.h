// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>

namespace ui::people {

/// A table of a page: sorts by its headings, and keeps the arrow keys to itself, whatever else they are keys of.
/// Tab leaves it.
class ListTable final : public QTableView
{
    Q_OBJECT
public:
    explicit ListTable(QWidget* parent);

protected:
    bool event(QEvent* event) override;
};

}  // namespace ui::people
