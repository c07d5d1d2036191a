// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <QObject>
#include <QString>

#include "app/school/UserQueries.h"
#include "core/base/Result.h"
#include "database/AttemptRecord.h"
#include "database/ClassOverview.h"
#include "ui/window/MainWindow.h"

namespace app {

/// Shows the comments on a saved attempt and the scores that instructors gave for it, on the score page and in its
/// replay, and saves new ones. Ui thread.
class CommentsController final : public QObject
{
    Q_OBJECT

public:
    CommentsController(ui::window::MainWindow& window, UserQueries queries);

    /// The score page shows this attempt now; empty: it shows none that is saved.
    /// @param maker  full name of the person who made it
    void open(const std::optional<database::AttemptRecord>& attempt, const QString& maker);
    /// When this attempt is opened next, the page scrolls to its comments; {}: it does not.
    void scrollTo(database::AttemptId attempt) { m_scrollsTo = attempt; }
    /// This saved attempt is replayed now: its comments are shown at their moments. Empty: no saved attempt is
    /// replayed.
    void followReplay(const std::optional<database::AttemptRecord>& replayed);

    [[nodiscard]] const std::optional<database::AttemptRecord>& attempt() const { return m_attempt; }
    [[nodiscard]] const std::optional<database::AttemptRecord>& replayed() const { return m_replayed; }
    [[nodiscard]] const QString& maker() const { return m_maker; }
    /// Who made the open attempt, and when; empty: none is open.
    [[nodiscard]] QString makerAndTime() const;

    /// Another user logs in: nothing that was read for the one before is kept.
    void forget();

signals:
    /// Emitted when something cannot be read.
    void readFailed(const core::Error& error);
    /// Emitted when comments on an attempt of this person were read, which may differ from those in the list.
    void commentsRead(database::PersonId person);
    /// Emitted when the user has seen new comments on their own attempts.
    void feedbackSeen(const std::vector<database::Feedback>& feedback);

private:
    void connectPanel();
    void readComments();
    void readHistory();
    void readRemarks();
    void markSeen();
    template <class Work>
    void change(Work work);
    void withdraw(qint64 comment);
    void showRefusal(qint64 attempt, const QString& makerAndTime, const QString& sentence);
    [[nodiscard]] QString whyNotDone(const core::Error& error) const;
    [[nodiscard]] bool replaysOpenAttempt() const;

    ui::window::MainWindow& m_window;
    UserQueries m_queries;
    std::optional<database::AttemptRecord> m_attempt;  ///< on the score page
    QString m_maker;
    std::optional<database::AttemptRecord> m_replayed;
    database::AttemptId m_scrollsTo;
};

/// Who made an attempt, and when.
[[nodiscard]] QString makerAndTime(const QString& maker, const database::AttemptRecord& attempt);

}  // namespace app
