// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "database/Person.h"
#include "ui/window/Tour.h"

class QStackedWidget;
class QWidget;

namespace ui::kit {
class Actions;
class MessageBar;
}  // namespace ui::kit

namespace ui::window {

/// Opens the pages of the window and knows the way back from each.
///
/// The login page locks the others: a page that is requested meanwhile opens after the login. During the tour it opens
/// after the tour.
class Navigation final : public QObject
{
    Q_OBJECT
public:
    struct Pages
    {
        QStackedWidget& stack;  ///< holds the others
        QWidget& room;
        QWidget& login;
        QWidget& lessons;
        QWidget& editor;
        QWidget& classes;
        QWidget& assign;
        QWidget& school;
        QWidget& score;
        QWidget& history;
        QWidget& help;  ///< lies over the pages; hidden when one is opened
    };

    Navigation(const Pages& pages, kit::Actions& actions, kit::MessageBar& messages, Tour& tour, QObject* parent);

    [[nodiscard]] QWidget* current() const;
    [[nodiscard]] bool isAt(const QWidget& page) const { return current() == &page; }
    [[nodiscard]] bool isInRoom() const { return isAt(m_pages.room); }
    [[nodiscard]] bool isAtLogin() const { return isAt(m_pages.login); }
    [[nodiscard]] bool isAtScore() const { return isAt(m_pages.score); }
    /// Returns the user's page: the one that is shown, or opens after the login or the tour.
    [[nodiscard]] const QWidget* userPage() const;

    void goTo(QWidget& page);
    void goToRoom() { goTo(m_pages.room); }
    /// Opens the page to which Esc leads, unless the present page itself can go a step back.
    void leavePage();
    /// Returns the page to which Esc leads from the present page.
    [[nodiscard]] QWidget& pageBehind() const;
    [[nodiscard]] bool isLessonsBehind() const { return &pageBehind() == &m_pages.lessons; }

    /// Opens the login page, which the user cannot leave before setMayLeaveLogin().
    void openLogin();
    void setMayLeaveLogin(bool may) { m_mayLeaveLogin = may; }
    [[nodiscard]] bool mayLeaveLogin() const { return m_mayLeaveLogin; }
    /// Opens the page that waits behind the login page.
    void leaveLogin();
    /// Sets the room as that page.
    void putRoomBehindLogin() { m_behindLogin = &m_pages.room; }

    void openLessons();
    void openClasses() { goTo(m_pages.classes); }
    /// Opens the page where a class gets its lessons.
    void openAssign() { goTo(m_pages.assign); }
    void openScore() { goTo(m_pages.score); }
    /// Opens the page of attempts. Esc leads back to the page of classes, or to the room.
    void openHistory();
    /// Opens the page of attempts without changing where Esc leads from there.
    void goBackToHistory() { goTo(m_pages.history); }
    /// Sets the page to which Esc leads from the score.
    void setBehindScore(QWidget& page) { m_behindScore = &page; }
    /// Opens the score of an earlier attempt. Esc leads back to the list where it was requested.
    /// @param askedFrom  page on which the attempt was requested; may be null
    void openOldScore(const QWidget* askedFrom);
    /// Forgets the ways back: another user comes.
    void forget();

    /// Does nothing on the login page.
    void beginTour(database::Role role);

signals:
    /// Emitted when a page is shown, also if it was shown before.
    void pageShown();
    /// Emitted when the page of lessons opens and needs its lessons.
    void lessonsRequested();
    /// Emitted when the page of the user's own attempts, or that of classes, shall open. Who reads them opens it.
    void attemptsRequested();
    void classesRequested();
    void tourEnded();

private:
    void showWayBack();
    void showTourPage(Tour::Where where);
    [[nodiscard]] QWidget& tourPage(Tour::Where where) const;

    Pages m_pages;
    kit::Actions& m_actions;
    kit::MessageBar& m_messages;
    Tour& m_tour;
    QWidget* m_beforeTour = nullptr;  ///< opens after the tour
    QWidget* m_behindScore;
    QWidget* m_behindHistory;
    QWidget* m_behindLogin;
    bool m_mayLeaveLogin = false;
};

}  // namespace ui::window
