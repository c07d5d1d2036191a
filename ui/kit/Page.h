// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QVBoxLayout;

namespace ui::kit {

class Actions;

/// A page beside the practice room: a back button and a title at the top, the content below.
class Page : public QWidget
{
    Q_OBJECT
public:
    Page(const Actions& actions, QWidget* parent);
    /// Sets the title. The page calls this again when the language changes.
    void setTitle(const QString& title);
    /// Sets the focus to the search field. Returns false if the page has none or is hidden.
    [[nodiscard]] virtual bool focusSearch() const;
    /// Goes back one step within the page. Returns false if there is none; the window then leaves the page.
    [[nodiscard]] virtual bool stepBack() { return false; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    /// Returns the layout for the content of the page.
    [[nodiscard]] QVBoxLayout* body() { return m_body; }
    /// Removes the note that a guest's work is not saved, on pages where everything is saved.
    void removeGuestSign();

private:
    QLabel* m_title;
    QVBoxLayout* m_body;
};

}  // namespace ui::kit
