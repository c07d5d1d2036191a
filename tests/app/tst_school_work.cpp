// SPDX-License-Identifier: GPL-3.0-or-later
// The whole program and what a student cuts at a school: it is graded, saved, limited, offered again, commented on.
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QPlainTextEdit>
#include <QSlider>

#include "database/Outbox.h"
#include "database/Passwords.h"
#include "database/sql/Attempts.h"
#include "database/sql/Audit.h"
#include "database/sql/Backups.h"
#include "database/sql/StartedExams.h"
#include "lessons/LessonReader.h"
#include "lessons/PresetFile.h"
#include "tests/app/SchoolWindow.h"
#include "tests/support/Files.h"
#include "tests/support/OpenGlMain.h"
#include "tests/support/Tables.h"
#include "ui/catalog/LessonsPage.h"
#include "ui/charts/ChartPanel.h"
#include "ui/people/HistoryModel.h"
#include "ui/people/HistoryPage.h"
#include "ui/scoring/CommentsPanel.h"
#include "ui/scoring/HeatMap.h"
#include "ui/scoring/ScorePage.h"
#include "ui/scoring/ScorePredictionPage.h"
#include "ui/tooth/ToothView.h"

using namespace database;
using support::Exam;
using support::OtherStation;
using ui::people::LoginMode;

class TestSchoolWork : public support::SchoolWindow
{
    Q_OBJECT
private slots:
    void initTestCase() { makeSchool(); }
    void init() { takeCopyOfSchool(); }
    void cleanup()
    {
        m_application.reset();
        expectProven(std::exchange(m_doubt, Doubt::None));
    }

    /// An instructor assigns an exam. A student then makes the file of its lesson easier, or removes it.
    void anAssignedExamIsTheSchools_data() { support::rows<bool>("isRemoved", {false, true}); }
    void anAssignedExamIsTheSchools()
    {
        QFETCH(bool, isRemoved);
        const Exam exam;
        const std::string assigned = lessons::lessonNamed("exam-36").value().hash;
        assign("exam-36", 1);
        exam.change(R"("rules": {"pulp_exposed": false}, "minutes": 90)");
        QVERIFY(lessons::lessonNamed("exam-36").value().hash != assigned);
        if (isRemoved)
            exam.remove();
        startAs("sam");
        WAIT_FOR(child<QListView>("lessonList")->model()->rowCount() > 2);
        startAssigned(true);
        drill(-2.0);
        gradeLesson(1);
        QCOMPARE(OtherStation(file()).ask("SELECT lesson_hash FROM attempts").toString().toStdString(), assigned);
    }

    /// The student opens the changed file without the list: it is practice, and the score card says so.
    void aChangedLessonIsPractice()
    {
        assign("block-line", 3);
        const QString own = m_folder->filePath("own.lesson.json");
        support::write(own, R"({"format": 1, "based_on": "block-1-line.lesson.json", "minutes": 90})");
        beginAs("sam");
        openLesson(lessons::readLesson(own).lesson.value());
        drill(0.0);
        gradeLesson(1);
        m_doubt = Doubt::Version;
        const auto* told = child<QLabel>("doubt");
        WAIT_FOR(told->isVisible());
        QCOMPARE(child<QLabel>("verdict")->text(), QString("Does not count"));
        QCOMPARE(count("standings"), 0);
    }

    /// A student can read the key of the station, and so sign a letter with any score.
    void aScoreThatItsRecordingDoesNotGiveDoesNotCount()
    {
        beginAs("sam");
        drill(-2.0);
        grade("");
        WAIT_FOR_VALUE(attempts(), 1);
        m_application.reset();
        {
            const OtherStation elsewhere(file());
            const Login sam = elsewhere.logIn("sam");
            AttemptRecord forged = sql::openAttempt(elsewhere.school, sam, {1}).value();
            forged.uid = newUid();
            forged.scoreTenths = 1000;
            forged.passed = true;
            QVERIFY(Outbox(m_folder->filePath("outbox"), elsewhere.school.key)
                        .put(sam, forged, sql::openRecording(elsewhere.school, sam, {1}).value()));
        }
        beginAs("sam");
        WAIT_FOR_VALUE(attempts(), 2);
        QCOMPARE(count("attempts WHERE doubt = 'score'"), 1);
        QCOMPARE(count("standings WHERE best_tenths = 1000"), 0);
        openAttempts();
        openNewest();
        QVERIFY(child<QLabel>("doubt")->isVisible());
        // An earlier program of the student has delivered it unchecked. The computer of the teacher checks it.
        OtherStation(file()).execute("UPDATE attempts SET doubt = ''");
        switchTo("ines");
        WAIT_FOR_VALUE(count("attempts WHERE checked = 1 AND doubt = 'score'"), 1);
        WAIT_FOR_VALUE(count("attempts WHERE checked = 1 AND doubt = ''"), 1);
        waitForMessage("does not match its recording");
    }

    /// Somebody puts a copy from before their exam in the place of the database, which is signed as well as it was.
    void anOlderCopyIsNoticed()
    {
        m_application.reset();
        const QString copy = m_folder->filePath("copy");
        beginAs("sam");
        m_application.reset();
        QVERIFY(QFile::copy(file(), copy));
        beginAs("sam");
        drill(-2.0);
        grade("");
        WAIT_FOR_VALUE(attempts(), 1);
        m_application.reset();
        for (const char* part : {"", "-wal", "-shm"})
            QFile::remove(file() + part);
        QVERIFY(QFile::copy(copy, file()));
        start();
        waitForMessage("older than when this computer last used it");
        QCOMPARE(count("audit WHERE action = 'audit.older'"), 1);
        m_application.reset();
        start();
        logIn("sam");
        QCOMPARE(count("audit WHERE action = 'audit.older'"), 1);
    }

    /// On a slow computer the tooth is made in the background while people log in and out.
    void whoLogsInBeforeTheFirstToothIsMadeGetsIt()
    {
        app::WindowOptions options;
        options.source = {36};
        options.build.gridSide = 1000;
        options.asksWho = true;
        begin(options);
        logIn("sam");
        switchTo("sue");
        goToTooth();
    }

    void aGuestsGradeIsSavedWithALogin()
    {
        assign("block-line", 1);
        start();
        beGuest();
        goToTooth();
        doLesson("block-line", 0);
        QVERIFY2(saved().contains("not logged in"), qPrintable(saved()));
        click("keepGrade");
        QVERIFY(child<QCheckBox>("keepOnLogin")->isVisible() && child<QCheckBox>("keepOnLogin")->isChecked());
        logIn("sam");
        WAIT_FOR_VALUE(attempts(), 1);
        QVERIFY(child<ui::scoring::ScorePage>()->isVisible());
        QCOMPARE(count("attempts JOIN people ON people.id = attempts.person_id WHERE people.username = 'sam'"), 1);
        // It counts as an attempt: a second one is not saved, and cannot be begun again.
        logOut();
        beGuest();
        goToTooth();
        waitForWholeTooth();
        doLesson("block-line", 1);
        click("keepGrade");
        logIn("sam");
        waitForSaved("will not be here next time");
        QVERIFY(!child<QPushButton>("keepGrade")->isVisible() && !actions().reload->isEnabled());
        goToTooth();
        actions().grade->trigger();
        waitForPage<ui::scoring::ScorePage>();
        QCOMPARE(attempts(), 1);
    }

    /// The attempt of a guest is not saved if the next user declines it or logs in after some time. An exam is never
    /// saved: a guest could repeat it and log in for the best result.
    void aGuestsGradeIsOtherwiseNobodys()
    {
        const Exam exam;
        start();
        for (const bool isIdle : {false, true}) {
            beGuest();
            goToTooth();
            drill(-2.0);
            grade("not logged in");
            click("keepGrade");
            auto* const keep = child<QCheckBox>("keepOnLogin");
            QVERIFY(keep->isVisible());
            if (isIdle) {
                window().account().idleLock().setLimit(std::chrono::milliseconds(300));
                WAIT_FOR(!keep->isVisible());
                window().account().idleLock().setLimit(std::chrono::minutes(10));
            } else {
                keep->setChecked(false);
            }
            logIn("sue");
            goToTooth();
            waitForWholeTooth();
            QCOMPARE(attempts(), 0);
            logOut();
        }
        beGuest();
        goToTooth();
        doLesson("exam-36", 0);
        waitForSaved("will not be here next time");
        QVERIFY(!child<QPushButton>("keepGrade")->isVisible());
        emit window().account().keepRequested();
        logIn("sue");
        openAttempts();
        QCOMPARE(attempts(), 0);
    }

    /// With its audit code on the PDF, in the charts, and to be replayed beside another.
    void anAttemptIsGradedSavedAndShown()
    {
        beginAs("sam");
        // The bur is not lifted while the score is worked out: that is no new attempt.
        const QString before = removed();
        press({-2.0, 1.0, -1.0});
        WAIT_FOR(removed() != before);
        grade("No earlier grades");
        release();
        QCOMPARE(attempts(), 1);
        const QString path = m_folder->filePath("new.pdf");
        savePdf(path);
        // The title of a PDF is UTF-16.
        QByteArray code;
        for (const QChar one : QString::fromStdString(sql::auditHead(OtherStation(file()).school)->code()))
            code += QByteArray(1, '\0') + one.toLatin1();
        QFile pdf(path);
        QVERIFY(code.size() > 20 && pdf.open(QIODevice::ReadOnly) && pdf.readAll().contains(code));
        goToTooth();
        drill(2.0);
        grade("");
        WAIT_FOR_VALUE(attempts(), 2);
        // A criterion of free practice is called as in the lessons.
        actions().attempts->trigger();
        const auto* chart = child<ui::charts::ChartPanel>("otherChart");
        const auto names = [chart] {
            QStringList all;
            if (const auto* bars = std::get_if<ui::charts::Bars>(&chart->chart().content))
                for (const auto& bar : bars->bars)
                    all << bar.name;
            return all.join(", ");
        };
        WAIT_FOR(!names().isEmpty());
        QVERIFY2(!names().contains("Caries left"), qPrintable(names()));
        openNewest();
        WAIT_FOR_VALUE(child<ui::scoring::ScorePage>()->card().history.size(), 2);
        // The other one is offered beside the replay, and a file.
        click("replayScored");
        WAIT_FOR(window().view().isVisible() && actions().beside->isEnabled());
        actions().beside->trigger();
        WAIT_FOR(child<QMenu>("besideMenu") != nullptr);
        QCOMPARE(child<QMenu>("besideMenu")->actions().size(), 3);
        child<QMenu>("besideMenu")->actions().front()->trigger();
        child<QMenu>("besideMenu")->close();
        WAIT_FOR_VALUE(window().findChildren<ui::tooth::ToothView*>().size(), 2);
        // A teacher goes the same way, and back step by step.
        switchTo("ines");
        openStudent();
        openNewest();
        WAIT_FOR_VALUE(child<ui::scoring::ScorePage>()->card().history.size(), 2);
        actions().back->trigger();
        QVERIFY(child<ui::people::HistoryPage>()->isVisible());
        goBackTo<ui::tooth::ToothView>();
    }

    /// The assigned lesson was due yesterday and allows two attempts. Neither undo nor another preset gives an attempt
    /// back.
    void aLessonIsDueAndLimited()
    {
        assign("block-line", 2, QDateTime::currentDateTimeUtc().addDays(-1).toString(Qt::ISODate).toStdString());
        startAs("sam");
        auto* const list = child<QListView>("lessonList");
        const auto heading = [list] { return list->model()->index(0, 0).data().toString(); };
        const auto undoAndLoadSoft = [this] {
            const auto isUndone = [this] {
                actions().undo->trigger();
                return removed() == "0.00";
            };
            WAIT_FOR(isUndone());
            WAIT_FOR(actions().redo->isEnabled());
            emit window().hardness().feelRequested(lessons::shippedPresets().back());
            waitForTicks(500);
            QVERIFY(actions().redo->isEnabled());
        };
        WAIT_FOR_VALUE(heading(), QString("Assigned to you"));
        startAssigned();
        drill(0.0);
        undoAndLoadSoft();
        drill(0.0);
        gradeLesson(1);
        waitForSaved("No earlier grades");
        QVERIFY(actions().reload->isEnabled());
        waitForNewTooth([this] { actions().reload->trigger(); });
        waitForWholeTooth();
        drill(0.0);
        gradeLesson(2);
        // It is not begun again, from the card, the tooth or the list, nor graded again after another cut.
        WAIT_FOR(!actions().reload->isEnabled());
        goToTooth();
        undoAndLoadSoft();
        QVERIFY(!actions().reload->isEnabled());
        drill(2.0);
        actions().grade->trigger();
        waitForMessage("no attempts left");
        QVERIFY(!child<ui::scoring::ScorePredictionPage>()->isVisible());
        actions().lessons->trigger();
        WAIT_FOR(child<QLabel>("whyNotStart")->isVisible());
        QVERIFY(!child<QPushButton>("startLesson")->isEnabled());
        openLesson("block-circle");
        QVERIFY(actions().reload->isEnabled());
        // It was not assigned to Sue's class.
        switchTo("sue");
        WAIT_FOR(list->model()->rowCount() > 2 && heading() != "Assigned to you");
    }

    /// Another user gets a whole tooth, of which Sam sees nothing; the idle lock keeps it for Sam as well.
    void anUnfinishedAttemptIsItsStudents()
    {
        beginAs("sam");
        const auto onTheTable = [this] { return window().view().tooth()->anatomy; };
        const auto whole = onTheTable();
        openLesson("class1-36");
        QVERIFY(onTheTable() != whole);
        drill(-2.0);
        const QString own = removed();
        window().account().idleLock().setLimit(std::chrono::milliseconds(300));
        WAIT_FOR(isAtDoor() && door() == LoginMode::Locked);
        window().account().idleLock().setLimit(std::chrono::minutes(10));
        tryPassword();
        WAIT_FOR(window().view().isVisible());
        QCOMPARE(removed(), own);
        switchTo("sue");
        goToTooth();
        waitForWholeTooth();
        QCOMPARE(onTheTable().get(), whole.get());  // the one of practice, which has decay to be removed
        expectNothingUnfinished();
        goToTooth();
        drill(2.0);
        switchTo("sam");
        WAIT_FOR(isUnfinishedOffered());
        waitForNewTooth([this] { click("continue"); });
        WAIT_FOR_VALUE(removed(), own);
        WAIT_FOR(actions().undo->isEnabled());
        gradeLesson(1);
    }

    /// The teacher has assigned the lesson meanwhile, and counts what was done before.
    void anUnfinishedAttemptIsNotResumedBeyondTheLimit()
    {
        beginAs("sam");
        doLesson("block-line", 1);
        goToTooth();
        drill(2.0);
        switchTo("sue");
        switchTo("sam");
        WAIT_FOR(isUnfinishedOffered());
        assign("block-line", 1);
        click("continue");
        waitForMessage("no attempts left");
        QCOMPARE(removed(), QString("0.00"));
        switchTo("sue");
        switchTo("sam");
        expectNothingUnfinished();
        // It is offered again with a higher limit.
        OtherStation(file()).execute("UPDATE assignments SET attempt_limit = 2");
        switchTo("sue");
        switchTo("sam");
        WAIT_FOR(isUnfinishedOffered());
    }

    /// What is graded is not offered as unfinished, even if the program is killed before the journal says so.
    void anAttemptIsGradedOnce()
    {
        const QString uid = uidOf("sam");
        for (const bool isKept : {true, false}) {
            beginAs("sam");
            drill(isKept ? -2.0 : 2.0);
            WAIT_FOR_VALUE(journals(uid).size(), 1);
            const QString journal = m_folder->filePath("unfinished/" + uid + '/' + journals(uid).front());
            QVERIFY(QFile::copy(journal, m_folder->filePath("kept")));
            const int before = attempts();
            grade("");
            WAIT_FOR_VALUE(attempts(), before + 1);
            QFile mark(journal + ".graded");
            QVERIFY(mark.open(QIODevice::ReadOnly));
            QByteArray marked = mark.readAll();
            mark.close();
            if (isKept) {
                switchTo("sue");
                switchTo("sam");
                expectNothingUnfinished();
            }
            m_application.reset();
            if (!isKept)  // as of another attempt, which never got so far
                marked[0] = marked[0] == 'a' ? 'b' : 'a';
            QVERIFY(QFile::rename(m_folder->filePath("kept"), journal));
            QVERIFY(mark.open(QIODevice::WriteOnly) && mark.write(marked) == marked.size());
            mark.close();
            startAs("sam");
            if (isKept) {
                WAIT_FOR(!QFile::exists(journal) && !mark.exists());
                expectNothingUnfinished();
            } else {
                WAIT_FOR(isUnfinishedOffered());
            }
            m_application.reset();
        }
    }

    /// Each attempt is delivered once and under the name of its own student, whoever is logged in by then.
    void whatTheDiskRefusesIsDeliveredLater()
    {
        beginAs("sam");
        blockOutbox();
        drill(-2.0);
        grade("not saved yet");
        waitForMessage("Make room on the disk");
        switchTo("sue");
        QVERIFY2(!message().contains("Make room on the disk"), qPrintable(message()));
        // Whoever quits is asked.
        window().close();
        QVERIFY(window().isVisible());
        click("questionStay");
        goToTooth();
        drill(2.0);
        grade("not saved yet");
        // During a replay the journal cannot be told that the attempt is saved.
        m_application->showMoment(0.1);
        WAIT_FOR(actions().pauseReplay->isEnabled());
        freeOutbox();
        WAIT_FOR_VALUE(attempts(), 2);
        for (const QString name : {"sam", "sue"}) {
            QCOMPARE(count("attempts a JOIN people p ON p.id = a.person_id WHERE p.username = '" + name + "'"), 1);
            switchTo(name);
            expectNothingUnfinished();
        }
    }

    /// As if it had never been graded: the program ended before it could be saved anywhere.
    void whatWasNotDeliveredIsUnfinished()
    {
        beginAs("sam");
        drill(-2.0);
        const QString own = removed();
        blockOutbox();
        grade("not saved yet");
        switchTo("sue");
        m_application.reset();
        freeOutbox();
        startAs("sam");
        WAIT_FOR(isUnfinishedOffered());
        waitForNewTooth([this] { click("continue"); });
        WAIT_FOR_VALUE(removed(), own);
        grade("No earlier grades");
        QCOMPARE(attempts(), 1);
    }

    /// An attempt that was delivered after the backup is delivered again.
    void aRestoredSchoolGetsItsAttemptsAgain()
    {
        beginAs("sam");
        QVERIFY(sql::backUp(OtherStation(file()).school.db, sql::backupFolder(file()),
                            QDateTime::currentDateTimeUtc().addSecs(1)));
        drill(-2.0);
        grade("No earlier grades");
        WAIT_FOR_VALUE(attempts(), 1);
        m_application.reset();
        damageSchool();
        start();
        click("restoreBackup");
        waitForDoorToSay("was restored");
        logIn("sam");
        WAIT_FOR_VALUE(attempts(), 1);
    }

    /// To break it off gives no attempt back. To have looked at it is not to have begun.
    void anExamThatIsBrokenOffCounts()
    {
        const Exam exam;
        assign("exam-36", 2);
        startAs("sam");
        auto* const list = child<QListView>("lessonList");
        WAIT_FOR(list->model()->rowCount() > 2);
        startAssigned(true);
        QCOMPARE(count("exam_starts"), 0);
        drill(-2.0);
        WAIT_FOR_VALUE(count("exam_starts"), 1);
        const auto beginAnew = [this, list] {
            actions().lessons->trigger();
            WAIT_FOR(list->isVisible());
            click("startLesson");
            click("questionSave");
            QVERIFY(child<QLabel>("questionDetail")->text().contains("counts as an attempt"));
            click("questionDiscard");
        };
        waitForNewTooth(beginAnew);
        drill(-2.0);
        WAIT_FOR_VALUE(count("exam_starts"), 2);
        beginAnew();
        waitForMessage("no attempts left");
        m_application.reset();
        startAs("ines");
        openStudent();
        const auto* const told = child<QLabel>("examsWithoutScore");
        WAIT_FOR(told->isVisible() && told->text().count("The exam, begun") == 2);
    }

    /// It was opened in two windows, with one attempt left.
    void anExamIsBegunInOneWindow()
    {
        const Exam exam;
        assign("exam-36", 1);
        beginAs("sam");
        openLesson("exam-36");
        {
            const OtherStation elsewhere(file());
            QVERIFY(sql::deliverExam(elsewhere.school, elsewhere.logIn("sam").uid(),
                                     {newUid(), "exam-36", "2026-01-01T00:00:00Z"}));
        }
        press({-2.0, 1.0, -1.0});
        waitForMessage("started in another window");
        release();
        for (const QAction* action : {actions().drill, actions().reload, actions().grade})
            QVERIFY2(!action->isEnabled(), qPrintable(action->text()));
        QCOMPARE(count("exam_starts"), 1);
        // Nothing is lost by leaving it, so nothing is asked.
        window().close();
        QVERIFY(child<QWidget>("workQuestion") == nullptr);
    }

    /// The school could not be told before the program was killed, is told later, and not twice.
    void anExamThatIsResumedWasBegunOnce()
    {
        const Exam exam;
        assign("exam-36", 1);
        beginAs("sam");
        openLesson("exam-36");
        blockOutbox();
        drill(-2.0);
        QCOMPARE(count("exam_starts"), 0);
        const QString uid = uidOf("sam");
        for (const bool isFirst : {true, false}) {
            static_cast<void>(killWithJournal(uid));
            if (isFirst)
                freeOutbox();
            startAs("sam");
            WAIT_FOR(isUnfinishedOffered());
            waitForNewTooth([this] { click("continue"); });
            WAIT_FOR_VALUE(count("exam_starts"), 1);
            QVERIFY(actions().drill->isEnabled());
        }
        gradeLesson(1);
        QCOMPARE(count("exam_starts"), 1);
    }

    /// Its score was seen, and the program killed before it could be saved.
    void anExamThatWasSeenIsGradedAsItStands()
    {
        const Exam exam;
        beginAs("sam");
        openLesson("exam-36");
        drill(-2.0);
        WAIT_FOR_VALUE(count("exam_starts"), 1);
        blockOutbox();
        gradeLesson(0);
        const int expectedTenths = 10 * child<QSlider>("expected")->value();
        waitForSaved("not saved yet");
        static_cast<void>(killWithJournal(uidOf("sam")));
        freeOutbox();
        startAs("sam");
        WAIT_FOR(isUnfinishedOffered());
        click("continue");
        WAIT_FOR_VALUE(attempts(), 1);
        // The forecast is not asked again: the student knows the score.
        QVERIFY(!child<ui::scoring::ScorePredictionPage>()->isVisible());
        QCOMPARE(OtherStation(file()).ask("SELECT expected_tenths FROM attempts").toInt(), expectedTenths);
        goToTooth();
        QVERIFY(!actions().drill->isEnabled());
    }

    /// The student looks at the tooth once more before the forecast: that takes no time of the exam. The attempt is not
    /// shown during the next.
    void anExamEndsWhenItsTimeIsOverAndHidesEarlierAttempts()
    {
        const Exam exam;
        beginAs("sam");
        QElapsedTimer clock;
        clock.start();
        openLesson("exam-36");
        drill(-2.0);
        window().lessonController().endExam();
        emit window().gradeRequested();
        waitForPage<ui::scoring::ScorePredictionPage>();
        const qint64 endMs = clock.elapsed();
        actions().back->trigger();
        QVERIFY(window().view().isVisible());
        WAIT_FOR(clock.hasExpired(2 * endMs));
        gradeLesson(1);
        const qint64 durationMs = OtherStation(file()).ask("SELECT duration_ms FROM attempts").toLongLong();
        QVERIFY2(durationMs > 0 && durationMs <= endMs, qPrintable(QString::number(durationMs)));

        openLesson("exam-36");
        waitForWholeTooth();
        drill(-2.0);
        openAttempts();
        WAIT_FOR_VALUE(child<QTableView>("attempts")->model()->rowCount(), 1);
        child<QTableView>("attempts")->selectRow(0);
        for (const char* button : {"openAttempt", "replayAttempt"}) {
            window().showMessage("Nothing yet.");
            click(button);
            waitForMessage("not available during an exam");
            QVERIFY(child<ui::people::HistoryPage>()->isVisible());
        }
        goToTooth();
        gradeLesson(2);
        openAttempts();
        openNewest();
    }

    /// With a pin on the tooth and in the replay.
    void aCommentAndAScoreReachTheStudent()
    {
        beginAs("sam");
        drill(-2.0);
        grade("No earlier grades");
        switchTo("ines");
        openStudent();
        openNewest();
        auto* heat = child<ui::scoring::HeatMap>();
        WAIT_FOR(heat->height() > 100);
        QTest::mouseClick(heat, Qt::LeftButton, {}, heat->rect().center());
        QVERIFY(heat->pin());
        const auto* const atMoment = child<QCheckBox>("atMoment");
        QVERIFY(!atMoment->isVisible());
        // A moment is chosen in the replay, which leads back to the card.
        click("replayScored");
        WAIT_FOR(window().view().isVisible() && atMoment->text().contains("0:0"));
        actions().back->trigger();
        WAIT_FOR(child<ui::scoring::ScorePage>()->isVisible() && atMoment->isVisible());
        child<QCheckBox>("atMoment")->setChecked(true);
        QVERIFY(child<QCheckBox>("atPlace")->isChecked());
        child<QPlainTextEdit>("commentWords")->setPlainText("Here you pressed too hard.");
        click("addComment");
        WAIT_FOR_VALUE(pins().size(), 2);
        QCOMPARE(count("comments WHERE moment_ms IS NOT NULL AND x_um IS NOT NULL"), 1);
        const auto place = heat->pin();
        child<QDoubleSpinBox>("givenPoints")->setValue(91.5);
        child<QLineEdit>("reason")->setText("Seen by hand.");
        click("giveScore");
        const auto listed = [this](int column) {
            return child<QTableView>("attempts")->model()->index(0, column).data().toString();
        };
        WAIT_FOR_VALUE(listed(ui::people::HistoryModel::Score), QString("91.5"));

        switchTo("sam");
        const auto* const news = child<QLabel>("feedbackWords");
        WAIT_FOR(news->isVisible() && news->text().contains("Ines Teach"));
        click("readFeedback");
        waitForPage<ui::scoring::ScorePage>();
        WAIT_FOR_VALUE(pins().size(), 2);
        WAIT_FOR(child<QLabel>("counts")->text().contains("91.5"));
        QVERIFY(!child<QPlainTextEdit>("commentWords")->isVisible());
        WAIT_FOR_VALUE(count("settings WHERE name LIKE 'feedback.%'"), 1);
        actions().lessons->trigger();
        WAIT_FOR(!news->isVisible() && child<QListView>("lessonList")->isVisible());
        actions().attempts->trigger();
        WAIT_FOR_VALUE(listed(ui::people::HistoryModel::Feedback), QString("read"));
        openNewest();
        WAIT_FOR_VALUE(pins().size(), 2);
        pins().back()->click();
        QVERIFY(heat->pin());
        for (std::size_t k = 0; k < 3; ++k)
            QVERIFY(std::abs((*heat->pin())[k] - (*place)[k]) < 0.001);
        pins().front()->click();
        const auto* remark = child<QLabel>("remark");
        WAIT_FOR(remark->isVisible() && remark->text().contains("Here you pressed too hard."));
        actions().back->trigger();
        waitForPage<ui::scoring::ScorePage>();

        // The teacher takes the comment back, and finds it in the field.
        switchTo("ines");
        openStudent();
        openNewest();
        WAIT_FOR_VALUE(pins().size(), 2);
        QTest::mouseClick(child<ui::scoring::CommentsPanel>()->findChild<QPushButton*>("takeBack"), Qt::LeftButton);
        WAIT_FOR_VALUE(pins().size(), 0);
        QCOMPARE(count("comments WHERE withdrawn_utc IS NOT NULL"), 1);
        QCOMPARE(child<QPlainTextEdit>("commentWords")->toPlainText(), QString("Here you pressed too hard."));
        QVERIFY(child<QCheckBox>("atMoment")->isChecked() && child<QCheckBox>("atPlace")->isChecked());
    }

    /// Everybody's attempts feel as an admin has chosen, and say so.
    void theAdminsPresetIsFelt()
    {
        core::settings::FeelPreset hard = lessons::shippedPresets().front();
        hard.name = "hard";
        hard.version = 0;
        hard.enamelRate *= 0.5;
        startAs("admin");
        actions().presets->trigger();
        emit window().hardness().saveRequested(hard);
        WAIT_FOR_VALUE(count("presets WHERE name = 'hard'"), 1);
        // A preset that is not in use can be retired and offered again.
        click("presetRetire");
        WAIT_FOR(!child<QPushButton>("presetUse")->isEnabled());
        click("presetRetire");
        WAIT_FOR_VALUE(count("settings WHERE name = 'preset.retired' AND value = ''"), 1);
        click("presetUse");
        WAIT_FOR_VALUE(count("settings WHERE name = 'preset.in_use' AND value = 'hard v1'"), 1);
        switchTo("sam");
        actions().presets->trigger();
        QVERIFY(!child<QPushButton>("presetUse")->isEnabled() && !child<QPushButton>("presetImport")->isEnabled());
        hard.dentinRate *= 0.5;
        emit window().hardness().saveRequested(hard);
        WAIT_FOR(child<QLabel>("presetFault")->text().contains("only an admin"));
        QCOMPARE(count("presets WHERE name = 'hard'"), 1);
        goToTooth();
        drill(-2.0);
        grade("No earlier grades");
        const auto felt = [this](int attempt) {
            return OtherStation(file())
                .ask(QStringLiteral("SELECT preset FROM attempts ORDER BY id LIMIT 1 OFFSET %1").arg(attempt))
                .toString();
        };
        QCOMPARE(felt(0), QString("hard v1"));
        // At another station an admin chooses another, which the next tooth feels like.
        OtherStation(file()).execute("UPDATE settings SET value = 'natural v1' WHERE name = 'preset.in_use'");
        waitForNewTooth([this] { emit window().toothChosen(26); });
        goToTooth();
        drill(-2.0);
        grade("");
        WAIT_FOR_VALUE(attempts(), 2);
        QCOMPARE(felt(1), QString("natural v1"));
    }

private:
    Doubt m_doubt = Doubt::None;  ///< with which the attempts of the test are stored

    void beginAs(const QString& name)
    {
        startAs(name);
        goToTooth();
    }

    void waitForWholeTooth() const { WAIT_FOR_VALUE(removed(), QString("0.00")); }

    /// Starts the first of the assigned lessons.
    void startAssigned(bool isExam = false) const
    {
        auto* const list = child<QListView>("lessonList");
        list->setCurrentIndex(list->model()->index(1, 0));
        waitForNewTooth([this, isExam] {
            click("startLesson");
            if (isExam)
                click("questionSave");
        });
    }

    /// Begins to cut the lesson, and has it graded.
    void doLesson(const std::string& lesson, int expectedAttempts) const
    {
        openLesson(lesson);
        drill(0.0);
        gradeLesson(expectedAttempts);
    }

    /// Prevents letters to the school, even for root: a file is where their folder belongs.
    void blockOutbox() const
    {
        QDir(m_folder->filePath("outbox")).removeRecursively();
        QFile inTheWay(m_folder->filePath("outbox"));
        QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    }

    void freeOutbox() const { QVERIFY(QFile::remove(m_folder->filePath("outbox"))); }

    /// Checks that the window has looked for unfinished attempts of the user and offers none.
    void expectNothingUnfinished() const
    {
        // The school answers in order: the lessons are read after that. Unfinished attempts are offered on that page.
        actions().lessons->trigger();
        WAIT_FOR(child<QListView>("lessonList")->model()->rowCount() > 2);
        openAttempts();
        actions().lessons->trigger();
        waitForPage<ui::catalog::LessonsPage>();
        QVERIFY(!isUnfinishedOffered());
    }

    [[nodiscard]] QList<QPushButton*> pins() const
    {
        QList<QPushButton*> found;
        for (QPushButton* button : child<ui::scoring::CommentsPanel>()->findChildren<QPushButton*>())
            if (button->property("kind") == "chip")
                found << button;
        return found;
    }
};

int main(int argc, char** argv)
{
    return support::openGlMain<TestSchoolWork>(argc, argv);
}

#include "tst_school_work.moc"
