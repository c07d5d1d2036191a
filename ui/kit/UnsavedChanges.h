// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QCoreApplication>
#include <QString>

#include "ui/kit/ConfirmOverlay.h"

namespace ui::kit {

/// Collects the unsaved changes on the pages of a window, for one question wherever they would be lost.
class UnsavedChanges
{
    Q_DECLARE_TR_FUNCTIONS(UnsavedChanges)
public:
    /// @param page  has unsavedChanges(), which describes them in a sentence and is empty if there are none, and
    ///              discardChanges(); it must outlive this object
    template <class Page>
    void add(Page& page)
    {
        m_pages.push_back({[&page] { return page.unsavedChanges(); }, [&page] { page.discardChanges(); }});
    }

    /// Returns the descriptions of all unsaved changes. Empty if there are none.
    [[nodiscard]] QString what() const;
    /// Discards the changes of all pages.
    void discard() const;

    /// Returns the question whether to discard changes.
    /// @param what  describes them; may be empty
    /// @param owner  the name of the user who made them, if another user may answer; empty: they are the user's own
    [[nodiscard]] static ConfirmOverlay::Question question(const QString& what, const QString& owner,
                                                           std::function<void()> discard);
    /// Asks the question in a window, about changes that the user is about to leave on one page.
    static void ask(QWidget* window, const QString& what, std::function<void()> discard);

private:
    struct Page
    {
        std::function<QString()> what;
        std::function<void()> discard;
    };

    std::vector<Page> m_pages;
};

}  // namespace ui::kit
