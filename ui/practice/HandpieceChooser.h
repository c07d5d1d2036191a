// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QWidget>

class QAction;
class QBoxLayout;

namespace ui::practice {

/// The handpieces side by side, by name. One that is not at hand (its action is invisible) takes no room.
class HandpieceChooser : public QWidget
{
    Q_OBJECT
public:
    /// @param actions  checkable and exclusive
    HandpieceChooser(const QList<QAction*>& actions, QWidget* parent);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    /// Side by side, or one below the other where their names are too long for that.
    void arrange();

    QBoxLayout* m_row;
};

}  // namespace ui::practice
