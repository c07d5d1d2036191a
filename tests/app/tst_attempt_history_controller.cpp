// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of attempts, comments and classes on fake repositories: answers that are late, arrive for another user, or
// do not arrive.
#include <memory>

#include <QFile>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include "app/pages/AttemptHistoryController.h"
#include "core/session/SessionChannels.h"
#include "tests/app/FakeSchool.h"
#include "tests/database/SchoolRig.h"
#include "ui/kit/MessageBar.h"
#include "ui/people/ClassPage.h"
#include "ui/people/HistoryPage.h"
#include "ui/scoring/CommentsPanel.h"
#include "ui/scoring/ScorePage.h"
#include "ui/window/MainWindow.h"

using core::ErrorCode;
using database::AttemptRecord;
using database::AttemptTalk;
using ui::scoring::CommentsPanel;
using ui::window::MainWindow;

namespace {

constexpr std::int64_t kAttempt = 7;

}  // namespace

class TestAttemptHistoryController : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        // Only the database makes logins.
        const support::SchoolRig rig(support::populatedSchool(false));
        m_student = rig.student;
        m_teacher = rig.instructor;
        m_classId = rig.first;
    }
    void init() { m_school = std::make_unique<support::FakeSchool>(); }
    void cleanup()
    {
        m_history.reset();
        m_window.reset();
    }

    void listsOnesOwnAttempts()
    {
        makeController(m_student);
        addAttempt(m_student);
        addAttempt(m_teacher, kAttempt + 1);
        m_school->waiting = 2;
        openOwn();
        QCOMPARE(m_window->page(), static_cast<const QWidget*>(&m_window->historyPage()));
        QCOMPARE(listed(), 1);
    }

    void aListThatCannotBeReadIsNotOpened()
    {
        makeController(m_student);
        m_school->outage = core::Error{ErrorCode::ConnectionLost, "the server is away"};
        openOwn();
        QVERIFY(m_window->page() != static_cast<const QWidget*>(&m_window->historyPage()));
        QVERIFY(!sentence().isEmpty());
    }

    void aListForAnotherUserIsDropped()
    {
        makeController(m_student);
        addAttempt(m_student);
        emit m_window->navigation().attemptsRequested();
        waitUntilAsked();
        m_who = m_teacher;
        m_school->answer();
        QVERIFY(m_window->page() != static_cast<const QWidget*>(&m_window->historyPage()));
        QCOMPARE(listed(), 0);
    }

    void aPageThatWasLeftIsNotOpenedLate()
    {
        makeController(m_student);
        addAttempt(m_student);
        emit m_window->navigation().attemptsRequested();
        waitUntilAsked();
        m_window->navigation().openClasses();
        m_school->answer();
        QVERIFY(m_window->page() != static_cast<const QWidget*>(&m_window->historyPage()));
    }

    void anAttemptWithoutARecordingIsShownFromItsSheet()
    {
        makeController(m_student);
        addAttempt(m_student);
        QSignalSpy scores(m_history.get(), &app::AttemptHistoryController::scoreRequested);
        QSignalSpy sheets(m_history.get(), &app::AttemptHistoryController::sheetRequested);
        emit m_window->historyPage().attemptOpenRequested(kAttempt);
        m_school->answer();
        QTRY_COMPARE(sheets.count(), 1);
        QCOMPARE(scores.count(), 0);
    }

    void aMissingRecordingIsNotReplayed()
    {
        makeController(m_student);
        addAttempt(m_student);
        QSignalSpy replays(m_history.get(), &app::AttemptHistoryController::replayRequested);
        emit m_window->historyPage().replayRequested(kAttempt);
        m_school->answer();
        QCOMPARE(replays.count(), 0);
        QVERIFY(sentence().contains("recording"));
    }

    void aDamagedRecordingIsAnError()
    {
        makeController(m_student);
        addAttempt(m_student);
        m_school->attempts.recordings[kAttempt] = "noise";
        QSignalSpy replays(m_history.get(), &app::AttemptHistoryController::replayRequested);
        emit m_window->historyPage().replayRequested(kAttempt);
        m_school->answer();
        QCOMPARE(replays.count(), 0);
        QVERIFY(!sentence().isEmpty());
    }

    void aTeacherIsToldWhenAStudentHasLeftTheirClasses()
    {
        makeController(m_teacher);
        addAttempt(m_student);
        m_school->attempts.refusal = core::Error{ErrorCode::NotAllowed, "not in your classes"};
        emit m_window->historyPage().replayRequested(kAttempt);
        m_school->answer();
        QVERIFY2(sentence().contains("none of your classes"), qPrintable(sentence()));
    }

    void aCommentIsSavedAndReadAgain()
    {
        makeController(m_teacher);
        openAttempt(m_student);
        emit panel().commentRequested("well done", {}, {});
        m_school->answer();
        const AttemptTalk& talk = m_school->comments.talks[kAttempt];
        QCOMPARE(talk.comments.size(), std::size_t{1});
        QCOMPARE(talk.comments.front().words, std::string("well done"));
        QVERIFY(m_school->comments.seen.empty());  // only the student's own look marks a comment as seen
    }

    void aScoreIsNotGivenOverOneThatTheTeacherHasNotSeen()
    {
        makeController(m_teacher);
        openAttempt(m_student);
        m_school->comments.talks[kAttempt].overrides.push_back({"Otto Teach", "2026-11-20T10:00:00Z", 700, "reason"});
        emit panel().overrideRequested(900, "another reason", 0);
        m_school->answer();
        QCOMPARE(m_school->comments.talks[kAttempt].overrides.size(), std::size_t{1});
    }

    void aStudentHasSeenTheCommentsThatWereShown()
    {
        makeController(m_student);
        m_school->comments.talks[kAttempt].comments.push_back(
            {1, "Ines Teach", "2026-11-20T10:00:00Z", "well done", {}, {}});
        openAttempt(m_student);
        QVERIFY(m_school->comments.seen == std::vector{kAttempt});
    }

    void aRefusedCommentIsReportedWhereTheUserIsNow()
    {
        makeController(m_teacher);
        openAttempt(m_student);
        m_school->comments.refusal = core::Error{ErrorCode::NotAllowed, "not in your classes"};
        emit panel().commentRequested("well done", {}, {});
        m_window->navigation().openLessons();
        m_school->answer();
        QVERIFY2(sentence().contains("none of your classes"), qPrintable(sentence()));
    }

    void forgettingClosesTheAttempt()
    {
        makeController(m_teacher);
        openAttempt(m_student);
        QVERIFY(m_history->talkedAbout());
        m_history->forget();
        QVERIFY(!m_history->talkedAbout());
        QVERIFY(m_history->whoseIsTalkedAbout().isEmpty());
    }

    void studentsOfTheSameNameAreToldApart()
    {
        makeController(m_teacher);
        m_school->classes.overviews = {
            classOf({student(1, "s1", "Sam One"), student(2, "s2", "Sam One"), student(3, "s3", "")})};
        openClass();
        const QByteArray csv = m_window->classPage().csv();
        for (const char* name : {"Sam One (s1)", "Sam One (s2)", "s3"})
            QVERIFY2(csv.contains(name), csv.constData());
    }

    void aTableOfAClassIsNotedInTheAudit()
    {
        makeController(m_teacher);
        m_school->classes.overviews = {classOf({student(1, "s1", "Sam One")})};
        openClass();
        QTemporaryDir folder;
        emit m_window->classPage().tableRequested(folder.filePath("class.csv"));
        m_school->answer();
        QVERIFY(m_school->classes.exported == std::vector{m_classId});
        QVERIFY(QFile::exists(folder.filePath("class.csv")));
    }

    void noTableLeavesTheSchoolUnnoted()
    {
        makeController(m_teacher);
        m_school->classes.overviews = {classOf({student(1, "s1", "Sam One")})};
        openClass();
        QTemporaryDir folder;
        m_school->classes.refusal = core::Error{ErrorCode::ConnectionLost, "the server is away"};
        emit m_window->classPage().tableRequested(folder.filePath("class.csv"));
        m_school->answer();
        QVERIFY(!QFile::exists(folder.filePath("class.csv")));
    }

private:
    void makeController(const database::Login& who)
    {
        m_who = who;
        m_window = std::make_unique<MainWindow>(m_links);
        m_window->setWho(who);
        m_window->show();
        m_history = std::make_unique<app::AttemptHistoryController>(*m_window, *m_school, [this] { return m_who; });
    }
    AttemptRecord addAttempt(const database::Login& of, std::int64_t id = kAttempt)
    {
        AttemptRecord record = support::SchoolRig::attempt("class1-36", 700);
        record.id = id;
        record.person = of.person();
        m_school->attempts.all.push_back(record);
        return record;
    }
    /// Opens a comment panel as the score page does when it shows a saved attempt.
    void openAttempt(const database::Login& of)
    {
        m_history->talkAbout(addAttempt(of));
        m_school->answer();
    }
    /// Waits for the request: the catalog is read on another thread first.
    void waitUntilAsked() const { QTRY_VERIFY(m_school->isAsked()); }
    void openOwn()
    {
        emit m_window->navigation().attemptsRequested();
        waitUntilAsked();
        m_school->answer();
    }
    void openClass()
    {
        m_school->classes.all = {{m_classId, "DEN101-A", 3, 1}};
        emit m_window->navigation().classesRequested();
        waitUntilAsked();
        m_school->answer();
    }
    [[nodiscard]] database::ClassOverview classOf(std::vector<database::MatrixStudent> students) const
    {
        database::ClassOverview overview;
        overview.id = m_classId;
        overview.name = "DEN101-A";
        overview.cells.resize(students.size());
        overview.students = std::move(students);
        return overview;
    }
    [[nodiscard]] static database::MatrixStudent student(std::int64_t id, const char* username, const char* fullName)
    {
        database::MatrixStudent one;
        one.id = {id};
        one.username = username;
        one.fullName = fullName;
        return one;
    }
    [[nodiscard]] int listed() const { return m_window->historyPage().findChild<QTableView*>()->model()->rowCount(); }
    [[nodiscard]] CommentsPanel& panel() const { return m_window->scorePage().talk(); }
    [[nodiscard]] QString sentence() const { return m_window->messages().sentence(); }

    database::Login m_student;
    database::Login m_teacher;
    database::Login m_who;
    database::ClassId m_classId;
    core::session::UiChannels m_links;
    std::unique_ptr<support::FakeSchool> m_school;
    std::unique_ptr<MainWindow> m_window;
    std::unique_ptr<app::AttemptHistoryController> m_history;
};

QTEST_MAIN(TestAttemptHistoryController)
#include "tst_attempt_history_controller.moc"
