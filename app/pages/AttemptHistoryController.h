// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QObject>
#include <QString>
#include <QTimer>

#include "app/school/SchoolService.h"
#include "core/recording/Recording.h"
#include "database/AttemptRecord.h"
#include "database/ClassOverview.h"
#include "database/Person.h"
#include "lessons/LessonCatalog.h"
#include "lessons/ScoreSheet.h"
#include "ui/people/AssignPage.h"
#include "ui/report/Report.h"
#include "ui/text/PeopleTexts.h"
#include "ui/window/MainWindow.h"

namespace app {

/// Fills the pages of attempts and classes from the school's data, and opens what is chosen there. Ui thread.
class AttemptHistoryController final : public QObject
{
    Q_OBJECT

public:
    /// @param who  works here now
    AttemptHistoryController(ui::window::MainWindow& window, SchoolService& desk, std::function<database::Login()> who);

    /// An attempt that is kept has been opened: what people say of it is shown, and asked for. Nothing: another one is
    /// on the page.
    void talkAbout(const std::optional<database::AttemptRecord>& attempt);

    /// With the name of who made it; nothing: none is open.
    [[nodiscard]] const std::optional<database::AttemptRecord>& talkedAbout() const { return m_talkedAbout; }
    [[nodiscard]] const QString& nameOfTalkedAbout() const { return m_talkedName; }
    /// Who made it, and when; empty: none is open.
    [[nodiscard]] QString whoseIsTalkedAbout() const;
    /// This attempt is played now; where it is the one that is talked about, comments can be pinned to its moments.
    /// Nothing: none that is kept is played.
    void followReplay(const std::optional<database::AttemptRecord>& played);

    /// The score card of one whose recording cannot be marked is to be shown from its sheet.
    void openSheet(const database::AttemptRecord& attempt);

    /// Somebody else comes: nothing that was read for the one before is shown, printed or named any more.
    void forget();

signals:
    /// This recording is to be played; followReplay() is to be told.
    /// @param whose  who made it, and when
    void replayRequested(const core::recording::Recording& recording, const database::AttemptRecord& attempt,
                         const QString& whose);
    /// This recording is to be put beside what is played.
    void besideRequested(const core::recording::Recording& recording, const QString& name);
    /// This attempt's score card is to be shown.
    void scoreRequested(const database::AttemptRecord& attempt, const core::recording::Recording& recording);
    /// The same of one without a recording that can be read: all that there is to show is this sheet.
    /// @param work  what was done, in the language there is
    void sheetRequested(const database::AttemptRecord& attempt, const lessons::ScoreSheet& sheet,
                        const std::function<QString()>& work);

private:
    /// Like SchoolService::ask(), but drops the answer if another person works here by then.
    template <class Work, class Done>
    void askAs(Work work, Done done)
    {
        m_desk.ask(this, std::move(work), [this, who = m_who(), done = std::move(done)](auto& answer) mutable {
            if (m_who() == who)
                done(answer);
        });
    }
    [[nodiscard]] std::function<bool()> isStillThere() const;
    void tellRemarks();
    void readLessons(const std::function<void()>& then);
    void tellLessons();
    [[nodiscard]] const lessons::Lesson* lesson(const std::string& id) const;
    void openHistory(database::PersonId person, const QString& fullName, const std::optional<std::string>& lesson);
    void tellClassAt(const QString& lesson);
    void openClasses();
    /// @param then  once they are shown
    void tellClasses(const std::function<void()>& then = {});
    void tellUnlisted(const core::Error& error);
    void openAssign();
    void tellOverview(database::ClassId ofClass);
    void tellUnread(database::ClassId ofClass, const core::Error& error);
    void changeAssignments(const QList<ui::people::AssignmentChange>& changes);
    void tellResults(const QString& lesson);
    using UseAttempt = std::function<void(const database::AttemptRecord&, const core::recording::Recording&)>;
    using UseRecord = std::function<void(const database::AttemptRecord&)>;
    /// @param orElse  where there is no recording that can be read; nothing: that is said
    void fetch(qint64 attempt, const UseAttempt& use, const UseRecord& orElse = {});
    [[nodiscard]] QString workOf(const database::AttemptRecord& attempt) const;
    [[nodiscard]] bool playsTalkedAbout() const;
    void offerBeside(const std::string& lesson, const std::string& tooth);
    void tellBesides(const std::vector<database::AttemptRecord>& attempts);
    void refuse(const core::Error& error);
    [[nodiscard]] QString whyNotDone(const core::Error& error) const;
    [[nodiscard]] bool isOfAnotherNow(const core::Error& error) const;
    void connectTalk();
    [[nodiscard]] QString makerOf(const database::AttemptRecord& attempt) const;
    void tellTalk();
    void tellAttempts();
    void tellWaiting();
    void tellBefore();
    void noteSeen(const database::AttemptRecord& attempt);
    template <class Work>
    void sayInTalk(Work work);
    void takeBack(qint64 comment);
    void tellRefused(qint64 attempt, const QString& whose, const QString& sentence);
    void connectReport();
    [[nodiscard]] ui::report::ClassReport report() const;
    void withReport(const std::function<void(const ui::report::ClassReport&)>& use);

    ui::window::MainWindow& m_window;
    SchoolService& m_desk;
    std::function<database::Login()> m_who;
    database::PersonId m_asked;               ///< whose attempts are to be shown
    database::PersonId m_person;              ///< whose are
    std::map<std::int64_t, QString> m_names;  ///< of those whose attempts have been shown
    database::ClassOverview m_overview;
    QList<database::ClassAssignment> m_given;  ///< to that class
    QTimer m_again;                            ///< until a class that could not be read is tried once more
    database::LessonResults m_results;
    std::optional<database::AttemptRecord> m_talkedAbout;
    QString m_talkedName;  ///< of who made it
    std::optional<database::AttemptRecord> m_played;
    database::AttemptId m_reads;                   ///< what was said of this one is to be read
    std::vector<lessons::CatalogEntry> m_catalog;  ///< as it was when a page was opened last
    ui::text::LessonTitles m_titles;
};

}  // namespace app
