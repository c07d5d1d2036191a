// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QVBoxLayout;

namespace ui::kit {

class Actions;

/// A page beside the practice room: a way back and a title at the top, its content beneath.
class Page : public QWidget
{
    Q_OBJECT
public:
    Page(const Actions& actions, QWidget* parent);
    /// Said again by the page in every language.
    void setTitle(const QString& title);
    /// Puts the cursor into the search field. False if the page has none, or is not shown.
    [[nodiscard]] virtual bool focusSearch() const;
    /// Goes back within the page. False if the page itself is to be left.
    [[nodiscard]] virtual bool stepBack() { return false; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    /// Where a page puts its content.
    [[nodiscard]] QVBoxLayout* body() { return m_body; }
    /// What is done on this page is kept, whoever does it.
    void removeGuestSign();

private:
    QLabel* m_title;
    QVBoxLayout* m_body;
};

}  // namespace ui::kit
