// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QObject>
#include <QString>

#include "app/pages/ClassController.h"
#include "app/pages/CommentsController.h"
#include "app/pages/LessonNames.h"
#include "app/school/SchoolAccess.h"
#include "app/school/UserQueries.h"
#include "core/recording/Recording.h"
#include "database/AttemptRecord.h"
#include "lessons/ScoreSheet.h"
#include "ui/window/MainWindow.h"

namespace app {

/// Lists the saved attempts of a person, and opens an attempt with its score card, its comments or its replay. Ui
/// thread.
class AttemptHistoryController final : public QObject
{
    Q_OBJECT

public:
    /// @param school  outlives this
    /// @param who     returns the present login
    AttemptHistoryController(ui::window::MainWindow& window, SchoolAccess& school,
                             std::function<database::Login()> who);

    /// The score page shows this saved attempt now, and its comments are read. Empty: it shows none that is saved.
    void talkAbout(const std::optional<database::AttemptRecord>& attempt);

    /// The saved attempt on the score page; empty: there is none.
    [[nodiscard]] const std::optional<database::AttemptRecord>& talkedAbout() const { return m_comments.attempt(); }
    /// Full name of the person who made it.
    [[nodiscard]] const QString& nameOfTalkedAbout() const { return m_comments.maker(); }
    /// Who made it, and when; empty: there is none.
    [[nodiscard]] QString whoseIsTalkedAbout() const { return m_comments.makerAndTime(); }
    /// This saved attempt is replayed now. If it is the one on the score page, comments can be added at its moments.
    /// Empty: no saved attempt is replayed.
    void followReplay(const std::optional<database::AttemptRecord>& played) { m_comments.followReplay(played); }

    /// Shows the score card of an attempt whose recording cannot be graded again, from its stored score sheet.
    void openSheet(const database::AttemptRecord& attempt);

    /// Another user logs in: nothing that was read for the one before is shown, printed or named.
    void forget();

signals:
    /// Emitted when a recording is to be replayed; followReplay() is called then.
    /// @param whose  who made it, and when
    void replayRequested(const core::recording::Recording& recording, const database::AttemptRecord& attempt,
                         const QString& whose);
    /// Emitted when a recording is to be replayed beside the one that is replayed now.
    void besideRequested(const core::recording::Recording& recording, const QString& name);
    /// Emitted when the score card of an attempt is to be shown.
    void scoreRequested(const database::AttemptRecord& attempt, const core::recording::Recording& recording);
    /// Emitted when the score card of an attempt without a readable recording is to be shown, from this sheet.
    /// @param work  returns the lesson or the tooth, in the present language
    void sheetRequested(const database::AttemptRecord& attempt, const lessons::ScoreSheet& sheet,
                        const std::function<QString()>& work);

private:
    void connectHistory();
    void connectParts();
    void open(database::PersonId person, const QString& fullName, const std::optional<std::string>& lesson);
    void readAgain();
    void showWaiting();
    void readClassmates(const QString& lesson);
    using UseAttempt = std::function<void(const database::AttemptRecord&, const core::recording::Recording&)>;
    using UseRecord = std::function<void(const database::AttemptRecord&)>;
    /// @param orElse  called if there is no readable recording; empty: a message says so
    void fetch(qint64 attempt, const UseAttempt& use, const UseRecord& orElse = {});
    [[nodiscard]] QString workOf(const database::AttemptRecord& attempt) const;
    void offerBeside(const std::string& lesson, const std::string& tooth);
    void showBesides(const std::vector<database::AttemptRecord>& attempts);
    void showReadError(const core::Error& error);
    [[nodiscard]] QString makerOf(const database::AttemptRecord& attempt) const;

    ui::window::MainWindow& m_window;
    UserQueries m_queries;
    LessonNames m_lessons;
    CommentsController m_comments;
    ClassController m_classes;
    database::PersonId m_requested;           ///< whose attempts were asked for last
    database::PersonId m_person;              ///< whose attempts are listed
    std::map<std::int64_t, QString> m_names;  ///< of the people whose attempts have been listed
};

}  // namespace app
