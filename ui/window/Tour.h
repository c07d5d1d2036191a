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

/// An overlay that shows a new user the program in some steps. Each step is a card beside a control of the window, and
/// the rest of the window is dimmed. Right and Enter show the next step, Left the previous one, and Esc ends the tour.
class Tour final : public QWidget
{
    Q_OBJECT
public:
    /// The pages on which steps are shown.
    enum class Where { Room, Lessons, Classes, School };
    struct Pages
    {
        QWidget& room;
        QWidget& lessons;
        QWidget& classes;
        QWidget& school;
    };

    /// @param pages  the pages that contain the controls
    Tour(const kit::Actions& actions, const Pages& pages, QWidget* parent);

    /// Starts the tour for a role at its first step. Leaves out steps whose control does not exist.
    void begin(database::Role role);
    void next();
    void previous();
    /// Ends the tour at any step and emits ended().
    void end();
    /// Hides the tour without ended(), because the window is locked. The user has not seen it to its end.
    void breakOff();

    [[nodiscard]] int steps() const { return static_cast<int>(m_steps.size()); }
    [[nodiscard]] int step() const { return m_step; }
    /// Returns the page of the present step.
    [[nodiscard]] Where where() const
    {
        return m_steps.empty() ? Where::Room : m_steps.at(static_cast<std::size_t>(m_step)).where;
    }
    /// Returns the control that is highlighted, or null.
    [[nodiscard]] QWidget* target() const;

signals:
    /// Emitted when a step begins. The receiver opens the page of the step.
    void pageRequested(Tour::Where where);
    /// Emitted when the user has seen the tour to its end or skipped it.
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
    QRect m_lit;  ///< rectangle of the target, in this widget's coordinates
    QFrame* m_card;
    QLabel* m_title;
    QLabel* m_words;
    QLabel* m_count;
    QPushButton* m_skip;
    QPushButton* m_back;
    QPushButton* m_next;
};

}  // namespace ui::window
