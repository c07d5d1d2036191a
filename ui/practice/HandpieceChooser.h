// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QWidget>

class QAction;
class QBoxLayout;

namespace ui::practice {

/// Shows the names of the handpieces side by side. A handpiece whose action is invisible is hidden.
class HandpieceChooser : public QWidget
{
    Q_OBJECT
public:
    /// @param actions  checkable and exclusive
    HandpieceChooser(const QList<QAction*>& actions, QWidget* parent);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    /// Lays the names out in a row, or in a column if a row is too narrow.
    void arrange();

    QBoxLayout* m_row;
};

}  // namespace ui::practice
