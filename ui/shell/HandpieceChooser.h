// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QWidget>

class QAction;

namespace ui::shell {

/// The handpieces side by side, by name. One that is not at hand (its action is invisible) takes no room.
class HandpieceChooser : public QWidget
{
    Q_OBJECT
public:
    /// @param actions  checkable and exclusive
    HandpieceChooser(const QList<QAction*>& actions, QWidget* parent);
};

}  // namespace ui::shell
