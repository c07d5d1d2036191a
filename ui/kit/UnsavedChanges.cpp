// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/UnsavedChanges.h"

#include <utility>

#include <QStringList>

namespace ui::kit {

QString UnsavedChanges::what() const
{
    QStringList sentences;
    for (const Page& page : m_pages)
        if (const QString words = page.what(); !words.isEmpty())
            sentences << words;
    return sentences.join(u'\n');
}

void UnsavedChanges::discard() const
{
    for (const Page& page : m_pages)
        page.discard();
}

ConfirmOverlay::Question UnsavedChanges::question(const QString& what, const QString& owner,
                                                  std::function<void()> discard)
{
    ConfirmOverlay::Question asked;
    //: %1: a user
    asked.text =
        owner.isEmpty() ? tr("Discard your unsaved changes?") : tr("Discard the unsaved changes of %1?").arg(owner);
    asked.detail = what;
    asked.stayText = tr("&Keep editing");
    asked.discard = std::move(discard);
    return asked;
}

void UnsavedChanges::ask(QWidget* window, const QString& what, std::function<void()> discard)
{
    const QString name = QStringLiteral("unsavedQuestion");
    delete window->findChild<ConfirmOverlay*>(name, Qt::FindDirectChildrenOnly);
    (new ConfirmOverlay(question(what, {}, std::move(discard)), window))->setObjectName(name);
}

}  // namespace ui::kit
