// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>

namespace ui::kit {
class Actions;
}

namespace ui::window {

/// The menu that opens below the name of the user.
class AccountMenu final : public QMenu
{
    Q_OBJECT
public:
    AccountMenu(const kit::Actions& actions, QWidget* parent);

signals:
    void passwordRequested();
};

}  // namespace ui::window
