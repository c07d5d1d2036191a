// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/Navigation.h"

#include <QStackedWidget>

#include "ui/kit/Actions.h"
#include "ui/kit/MessageBar.h"
#include "ui/kit/Page.h"

namespace ui::window {

using kit::MessageBar;

Navigation::Navigation(const Pages& pages, kit::Actions& actions, kit::MessageBar& messages, Tour& tour,
                       QObject* parent)
    : QObject(parent), m_pages(pages), m_actions(actions), m_messages(messages), m_tour(tour),
      m_behindScore(&pages.room), m_behindHistory(&pages.room), m_behindLogin(&pages.room)
{
    connect(&m_tour, &Tour::pageRequested, this, &Navigation::showTourPage);
    connect(&m_tour, &Tour::ended, this, [this] {
        goTo(m_beforeTour != nullptr ? *m_beforeTour : m_pages.room);
        emit tourEnded();
    });
}

QWidget* Navigation::current() const
{
    return m_pages.stack.currentWidget();
}

const QWidget* Navigation::userPage() const
{
    return isAtLogin() ? m_behindLogin : m_tour.isVisible() ? m_beforeTour : current();
}

void Navigation::goTo(QWidget& page)
{
    const bool isLogin = &page == &m_pages.login;
    if (isAtLogin() && !isLogin && !m_mayLeaveLogin) {
        m_behindLogin = &page;
        return;
    }
    if (m_tour.isVisible() && !isLogin && &page != &tourPage(m_tour.where())) {
        m_beforeTour = &page;
        return;
    }
    if (m_tour.isVisible() && isAt(page))
        return;
    m_pages.help.hide();
    if (isLogin)
        m_tour.breakOff();
    if (&page != &m_pages.room)
        m_messages.withdraw(MessageBar::Topic::Lesson);
    if (!isAt(page))
        m_messages.withdraw(MessageBar::Topic::Page);
    if (&page == &m_pages.lessons)
        m_messages.withdraw(MessageBar::Topic::ResumableAttempt);  // the page of lessons shows the offer in a card
    m_pages.stack.setCurrentWidget(&page);
    showWayBack();
    emit pageShown();
}

QWidget& Navigation::pageBehind() const
{
    if (isAt(m_pages.editor))
        return m_pages.lessons;
    if (isAt(m_pages.assign))
        return m_pages.classes;
    if (isAt(m_pages.score))
        return *m_behindScore;
    return isAt(m_pages.history) ? *m_behindHistory : m_pages.room;
}

/// Updates the text of the action `back`, which names the page that it opens.
void Navigation::showWayBack()
{
    const QWidget* const behind = &pageBehind();
    m_actions.showWayBack(behind == &m_pages.history   ? kit::Actions::Back::Attempts
                          : behind == &m_pages.classes ? kit::Actions::Back::Class
                          : behind == &m_pages.lessons ? kit::Actions::Back::Lessons
                                                       : kit::Actions::Back::Tooth);
}

void Navigation::leavePage()
{
    if (auto* page = qobject_cast<kit::Page*>(current()); page != nullptr && page->stepBack())
        return;
    if (isLessonsBehind())
        openLessons();
    else
        goTo(pageBehind());
}

void Navigation::openLogin()
{
    if (!isAtLogin())
        m_behindLogin = current();
    m_mayLeaveLogin = false;
    goTo(m_pages.login);
}

void Navigation::leaveLogin()
{
    goTo(*m_behindLogin);
}

void Navigation::openLessons()
{
    emit lessonsRequested();
    goTo(m_pages.lessons);
}

void Navigation::openHistory()
{
    if (!isAt(m_pages.history))
        m_behindHistory = isAt(m_pages.classes) ? &m_pages.classes : &m_pages.room;
    goTo(m_pages.history);
}

void Navigation::openOldScore(const QWidget* askedFrom)
{
    m_behindScore = &m_pages.room;
    for (QWidget* list : {&m_pages.history, &m_pages.lessons, &m_pages.classes})
        if (askedFrom == list || isAt(*list))
            m_behindScore = list;
    goTo(m_pages.score);
}

void Navigation::forget()
{
    m_behindLogin = m_behindScore = m_behindHistory = &m_pages.room;
}

void Navigation::beginTour(database::Role role)
{
    if (isAtLogin() || m_tour.isVisible())
        return;
    m_pages.help.hide();
    m_beforeTour = current();
    m_tour.begin(role);
}

void Navigation::showTourPage(Tour::Where where)
{
    QWidget& page = tourPage(where);
    if (isAt(page))
        return;
    if (&page == &m_pages.lessons)
        emit lessonsRequested();
    else if (&page == &m_pages.classes)
        emit classesRequested();
    goTo(page);
}

QWidget& Navigation::tourPage(Tour::Where where) const
{
    switch (where) {
    case Tour::Where::Lessons:
        return m_pages.lessons;
    case Tour::Where::Classes:
        return m_pages.classes;
    case Tour::Where::School:
        return m_pages.school;
    case Tour::Where::Room:
        break;
    }
    return m_pages.room;
}

}  // namespace ui::window
