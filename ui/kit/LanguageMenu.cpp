// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/LanguageMenu.h"

#include <QActionGroup>

#include "ui/kit/AppSettings.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Language.h"

namespace ui::kit {
namespace {

const QString kLanguage = QStringLiteral("window/language");

}  // namespace

LanguageMenu::LanguageMenu(QWidget* parent) : QMenu(parent)
{
    setObjectName(QStringLiteral("languages"));
    auto* one = new QActionGroup(this);
    for (const QString& code : text::Language::available()) {
        QAction* action = addAction(text::Language::nameOf(code));
        action->setCheckable(true);
        action->setData(code);
        one->addAction(action);
        // Queued until the menu has closed, because the texts of all windows change.
        connect(
            action, &QAction::triggered, this, [code] { choose(code); }, Qt::QueuedConnection);
    }
    text::bindTranslation(this, [this] {
        setTitle(tr("Language"));
        setAccessibleName(title());
        for (QAction* action : actions())
            action->setChecked(action->data().toString() == text::Language::current());
    });
}

void LanguageMenu::choose(const QString& code)
{
    memory().setValue(kLanguage, code);
    text::Language::choose(code);
}

QString LanguageMenu::remembered()
{
    const QString code = memory().value(kLanguage).toString();
    return text::Language::isAvailable(code) ? code : QString();
}

}  // namespace ui::kit
