// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/admin/EraseQuestion.h"

#include <utility>

#include <QCoreApplication>

#include "ui/kit/ConfirmOverlay.h"

namespace ui::admin {

void askToErase(QWidget* window, const QString& person, std::function<void()> erase)
{
    kit::ConfirmOverlay::Question asked;
    //: %1: a person
    asked.text = QCoreApplication::translate("Admin", "Erase %1?").arg(person);
    asked.detail = QCoreApplication::translate(
        "Admin", "The names, the login and the comments by and about this person are removed. The "
                 "attempts and scores stay, under a pseudonym. This cannot be undone, and it does not "
                 "reach backups and exported files.");
    asked.discardText = QCoreApplication::translate("Admin", "Erase");
    asked.discard = std::move(erase);
    asked.stayText = QCoreApplication::translate("Admin", "&Keep the person");
    const QString name = QStringLiteral("eraseQuestion");
    delete window->findChild<kit::ConfirmOverlay*>(name, Qt::FindDirectChildrenOnly);
    (new kit::ConfirmOverlay(asked, window))->setObjectName(name);
}

}  // namespace ui::admin
