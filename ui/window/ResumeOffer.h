// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QDateTime>
#include <QElapsedTimer>
#include <QObject>

#include "ui/kit/MessageBar.h"

namespace ui::catalog {
class LessonsPage;
}

namespace ui::window {

class Navigation;
class UnsavedWork;

/// Offers to resume or discard an attempt that was interrupted. The page of lessons shows the offer in a card, every
/// other page in a message.
class ResumeOffer final : public QObject
{
    Q_OBJECT
public:
    ResumeOffer(kit::MessageBar& messages, catalog::LessonsPage& lessons, Navigation& navigation, UnsavedWork& unsaved);

    /// Shows the offer.
    /// @param title  returns the title of the lesson or tooth
    void offer(const std::function<QString()>& title, const QDateTime& begun, bool isExam);
    /// Hides the offer.
    void forget();
    /// Shows that the attempt was discarded, and offers to restore it.
    void offerToRestore(const std::function<void()>& restore);

signals:
    void resumeRequested();
    void discardRequested();

private:
    void show();
    void resume();
    void discard();
    void askToDiscardExam();

    kit::MessageBar& m_messages;
    catalog::LessonsPage& m_lessons;
    Navigation& m_navigation;
    UnsavedWork& m_unsaved;
    std::function<kit::MessageBar::Message()> m_message;
    bool m_isExam = false;
    QElapsedTimer m_sinceDiscard;
};

}  // namespace ui::window
