// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/ResumeOffer.h"

#include <QApplication>

#include "ui/catalog/LessonsPage.h"
#include "ui/text/Texts.h"
#include "ui/window/Navigation.h"
#include "ui/window/UnsavedWork.h"

namespace ui::window {

using catalog::LessonsPage;
using kit::MessageBar;

ResumeOffer::ResumeOffer(MessageBar& messages, LessonsPage& lessons, Navigation& navigation, UnsavedWork& unsaved)
    : QObject(&lessons), m_messages(messages), m_lessons(lessons), m_navigation(navigation), m_unsaved(unsaved)
{
    connect(&m_lessons, &LessonsPage::resumeRequested, this, &ResumeOffer::resume);
    connect(&m_lessons, &LessonsPage::discardRequested, this, &ResumeOffer::discard);
}

void ResumeOffer::offer(const std::function<QString()>& title, const QDateTime& begun, bool isExam)
{
    m_isExam = isExam;
    m_lessons.setUnfinished(title, begun);
    m_message = [this, title, begun] {
        MessageBar::Message offer;
        offer.kind = MessageBar::Kind::Warning;
        offer.topic = MessageBar::Topic::ResumableAttempt;
        //: %1: "Tooth 36", "Practice block: line"; %2: a time of today, or a day and a time
        offer.sentence = tr("%1: an attempt of %2 was not finished.").arg(title(), text::shortWhen(begun));
        offer.actionText = tr("Resume");
        offer.action = [this] { resume(); };
        offer.declining = {tr("Discard"), [this] { discard(); }};
        return offer;
    };
    show();
}

void ResumeOffer::show()
{
    m_messages.withdraw(MessageBar::Topic::ResumableAttempt);
    if (!m_navigation.isAt(m_lessons))
        m_messages.say(m_message);
}

void ResumeOffer::resume()
{
    m_navigation.goToRoom();
    m_unsaved.leaveWork([this] {
        forget();
        emit resumeRequested();
    });
}

void ResumeOffer::discard()
{
    // The second click of a double-click must not discard the next offer, which may already be shown in the same place.
    if (m_sinceDiscard.isValid() && !m_sinceDiscard.hasExpired(2 * QApplication::doubleClickInterval())) {
        show();
        return;
    }
    if (m_isExam) {
        askToDiscardExam();
        return;
    }
    m_sinceDiscard.start();
    forget();
    emit discardRequested();
}

void ResumeOffer::askToDiscardExam()
{
    show();  // the offer stays if the user cancels
    m_unsaved.ask("unfinishedQuestion", {tr("This exam would be discarded without a score."),
                                         tr("It still counts as an attempt. You can restore it right afterwards."),
                                         tr("&Continue it"), [this] { resume(); },
                                         [this] {
                                             m_sinceDiscard.start();
                                             forget();
                                             emit discardRequested();
                                         }});
}

void ResumeOffer::forget()
{
    m_messages.withdraw(MessageBar::Topic::ResumableAttempt);
    m_lessons.setUnfinished({}, {});
}

void ResumeOffer::offerToRestore(const std::function<void()>& restore)
{
    m_messages.say([restore] {
        return MessageBar::Message{MessageBar::Kind::Warning,
                                   tr("The attempt was discarded; it is kept for seven days."),
                                   {},
                                   tr("Restore it"),
                                   restore};
    });
}

}  // namespace ui::window
