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

/// Opens the pages of the window, and opens the previous page when the user leaves one.
///
/// A page that is requested while the user must log in opens after the login. A page that is requested during the tour
/// opens after the tour.
class Navigation final : public QObject
{
    Q_OBJECT
public:
    struct Pages
    {
        QStackedWidget& stack;  ///< contains the other pages
        QWidget& room;
        QWidget& login;
        QWidget& lessons;
        QWidget& editor;
        QWidget& classes;
        QWidget& assign;
        QWidget& school;
        QWidget& score;
        QWidget& history;
        QWidget& help;  ///< overlay over the pages; hidden when a page is opened
    };

    Navigation(const Pages& pages, kit::Actions& actions, kit::MessageBar& messages, Tour& tour, QObject* parent);

    [[nodiscard]] QWidget* current() const;
    [[nodiscard]] bool isAt(const QWidget& page) const { return current() == &page; }
    [[nodiscard]] bool isInRoom() const { return isAt(m_pages.room); }
    [[nodiscard]] bool isAtLogin() const { return isAt(m_pages.login); }
    [[nodiscard]] bool isAtScore() const { return isAt(m_pages.score); }
    /// Returns the page that is shown or, during the login or the tour, the page that opens afterwards.
    [[nodiscard]] const QWidget* userPage() const;

    void goTo(QWidget& page);
    void goToRoom() { goTo(m_pages.room); }
    /// Goes back one step within the present page. If that is not possible, opens pageBehind().
    void leavePage();
    /// Returns the page that Esc opens from the present page.
    [[nodiscard]] QWidget& pageBehind() const;
    [[nodiscard]] bool isLessonsBehind() const { return &pageBehind() == &m_pages.lessons; }

    /// Opens the login page, which the user cannot leave before setMayLeaveLogin().
    void openLogin();
    void setMayLeaveLogin(bool may) { m_mayLeaveLogin = may; }
    [[nodiscard]] bool mayLeaveLogin() const { return m_mayLeaveLogin; }
    /// Opens the page that waits behind the login page.
    void leaveLogin();
    /// Sets the practice room as the page that waits behind the login page.
    void putRoomBehindLogin() { m_behindLogin = &m_pages.room; }

    void openLessons();
    void openClasses() { goTo(m_pages.classes); }
    /// Opens the page where lessons are assigned to a class.
    void openAssign() { goTo(m_pages.assign); }
    void openScore() { goTo(m_pages.score); }
    /// Opens the page of attempts. Esc then opens the page of classes or the practice room.
    void openHistory();
    /// Opens the page of attempts, and does not change which page Esc opens from there.
    void goBackToHistory() { goTo(m_pages.history); }
    /// Sets the page that Esc opens from the score page.
    void setBehindScore(QWidget& page) { m_behindScore = &page; }
    /// Opens the score of an earlier attempt. Esc then opens the list where the attempt was requested.
    /// @param askedFrom  page on which the attempt was requested; may be null
    void openOldScore(const QWidget* askedFrom);
    /// Resets which pages Esc and the login open to the practice room. Call it when another user logs in.
    void forget();

    /// Starts the tour. Does nothing on the login page or while the tour is shown.
    void beginTour(database::Role role);

signals:
    /// Emitted when a page is opened, even if it was the present page already.
    void pageShown();
    /// Emitted when the page of lessons opens and needs its lessons.
    void lessonsRequested();
    /// Emitted when the user requests the page of their own attempts or the page of classes. The receiver reads the
    /// data and opens the page.
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
    QWidget* m_beforeTour = nullptr;  ///< page that opens after the tour
    QWidget* m_behindScore;
    QWidget* m_behindHistory;
    QWidget* m_behindLogin;
    bool m_mayLeaveLogin = false;
};

}  // namespace ui::window
