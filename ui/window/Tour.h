// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QPointer>
#include <QWidget>

#include "database/Permissions.h"

class QAction;
class QFrame;
class QLabel;
class QPushButton;

namespace ui::kit {
class Actions;
}

namespace ui::window {

/// Shows who is new here round: some steps, each a card beside a control of the window that is lit while the rest is
/// dimmed. It lies over the window and keeps the keys: Right, Left, Enter, and Esc, which ends it.
class Tour final : public QWidget
{
    Q_OBJECT
public:
    /// The pages where its steps are.
    enum class Where { Room, Lessons, Classes, School };
    struct Pages
    {
        QWidget& room;
        QWidget& lessons;
        QWidget& classes;
        QWidget& school;
    };

    /// @param pages  where controls are looked for
    Tour(const kit::Actions& actions, const Pages& pages, QWidget* parent);

    /// From its first step, as it is for this role. Steps whose control is not there are left out.
    void begin(database::Role role);
    void next();
    void previous();
    /// Ends it, wherever it is.
    void end();
    /// Puts it away without having been seen to its end: the place is locked.
    void breakOff();

    [[nodiscard]] int steps() const { return static_cast<int>(m_steps.size()); }
    [[nodiscard]] int step() const { return m_step; }
    /// The page of the step it is at.
    [[nodiscard]] Where where() const
    {
        return m_steps.empty() ? Where::Room : m_steps.at(static_cast<std::size_t>(m_step)).where;
    }
    /// That is lit; null while none is.
    [[nodiscard]] QWidget* target() const;

signals:
    /// The next step is on this page.
    void pageRequested(Tour::Where where);
    /// It was seen, or skipped.
    void ended();

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    bool focusNextPrevChild(bool next) override;

private:
    struct Step
    {
        Where where;
        QPointer<QWidget> target;
        const char* title;
        const char* words;
    };
    void add(Where where, QWidget* target, const char* title, const char* words);
    void add(Where where, QAction* action, const char* title, const char* words);
    void addDrilling(const char* title);
    [[nodiscard]] const QWidget& page(Where where) const;
    void show(int step);
    void retranslateUi();
    void place();

    const kit::Actions& m_actions;
    Pages m_pages;
    std::vector<Step> m_steps;
    int m_step = 0;
    QRect m_lit;  ///< of the target, in this widget
    QFrame* m_card;
    QLabel* m_title;
    QLabel* m_words;
    QLabel* m_count;
    QPushButton* m_skip;
    QPushButton* m_back;
    QPushButton* m_next;
};

}  // namespace ui::window
