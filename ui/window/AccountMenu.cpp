// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/AccountMenu.h"

#include "ui/kit/Actions.h"
#include "ui/kit/LanguageMenu.h"
#include "ui/text/EveryLanguage.h"

namespace ui::window {

AccountMenu::AccountMenu(const kit::Actions& actions, QWidget* parent) : QMenu(parent)
{
    setObjectName(QStringLiteral("accountMenu"));
    // The icons are drawn for the dark bars of the practice room.
    for (QAction* action : {actions.lock, actions.presets, actions.settings})
        action->setIconVisibleInMenu(false);
    addAction(actions.lock);
    QAction* password = addAction(QString());
    password->setObjectName(QStringLiteral("ownPassword"));
    connect(password, &QAction::triggered, this, &AccountMenu::passwordRequested);
    addSeparator();
    addMenu(new kit::LanguageMenu(this));
    addAction(actions.presets);
    addAction(actions.settings);
    text::bindTranslation(this, [this, password] {
        setAccessibleName(tr("My account"));
        password->setText(tr("Change my password …"));
    });
}

}  // namespace ui::window
