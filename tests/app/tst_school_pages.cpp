// SPDX-License-Identifier: GPL-3.0-or-later
// The whole program at a school, without cutting a tooth: the login, the pages of a teacher and of an admin.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QListView>
#include <QListWidget>
#include <QMenu>
#include <QPlainTextEdit>
#include <QScopeGuard>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTimer>

#include "database/sql/Backups.h"
#include "database/sql/Classes.h"
#include "lessons/ScoreSheetJson.h"
#include "tests/app/SchoolWindow.h"
#include "tests/database/SchoolRig.h"
#include "tests/support/Files.h"
#include "tests/support/OpenGlMain.h"
#include "ui/admin/BackupPart.h"
#include "ui/admin/RosterPart.h"
#include "ui/catalog/LessonsPage.h"
#include "ui/people/AssignPage.h"
#include "ui/people/ClassPage.h"
#include "ui/people/HistoryModel.h"
#include "ui/people/HistoryPage.h"
#include "ui/scoring/CommentsPanel.h"
#include "ui/scoring/HeatMap.h"
#include "ui/scoring/ScorePage.h"
#include "ui/text/Texts.h"
#include "ui/tooth/ToothView.h"
#include "ui/window/Tour.h"

using namespace database;
using support::kPassword;
using support::kPatienceMs;
using support::OtherStation;
using ui::admin::AdminPage;
using ui::people::ClassPage;
using ui::people::LoginMode;

class TestSchoolPages : public support::SchoolWindow
{
    Q_OBJECT
private slots:
    void initTestCase() { makeSchool(); }
    void init() { takeCopyOfSchool(); }
    void cleanup() { m_application.reset(); }

    void theFirstAdminCreatesTheSchool()
    {
        QVERIFY(QFile::remove(file()));
        start();
        WAIT_FOR_VALUE(door(), LoginMode::Welcome);
        QVERIFY(!child<QLineEdit>("username")->isVisible());
        click("practiseNow");
        WAIT_FOR(!isAtDoor());
        // A guest who goes back to the login sees the same page.
        actions().account->trigger();
        QCOMPARE(door(), LoginMode::Welcome);
        click("setUpSchool");
        QCOMPARE(door(), LoginMode::NewSchool);
        click("otherLogin");
        QCOMPARE(door(), LoginMode::Welcome);
        click("setUpSchool");
        child<QLineEdit>("passwordAgain")->setText(kRight);
        typeLogin("nora");
        WAIT_FOR_VALUE(actions().account->text(), QString("nora"));
        QCOMPARE(count("people WHERE role = 'admin'"), 1);
    }

    void whoMayNotStayIsLoggedOut_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("change");
        QTest::addColumn<QString>("list");
        QTest::addColumn<QString>("reason");
        const auto row = [](const char* title, const char* name, const char* change, const char* list,
                            const char* reason) { QTest::newRow(title) << name << change << list << reason; };
        row("a teacher is disabled", "ines", "disabled = 1", "matrix", "This account was disabled");
        row("an admin is disabled", "admin", "disabled = 1", "backups", "This account was disabled");
        row("an admin is one no longer", "admin", "role = 'student'", "people", "Your role was changed");
    }

    /// A user who was disabled or whose role was changed is logged out when they reload a page or do something on it.
    void whoMayNotStayIsLoggedOut()
    {
        QFETCH(QString, name);
        QFETCH(QString, change);
        QFETCH(QString, list);
        QFETCH(QString, reason);
        const bool byLongWork = list == "backups";
        startAs(name);
        if (name == "admin")
            openAdminPage(byLongWork ? AdminPage::Backups : AdminPage::People);
        WAIT_FOR(child<QTableView>(qPrintable(list))->model()->rowCount() > 0);
        OtherStation(file()).execute("UPDATE people SET " + change + " WHERE username = '" + name + "'");
        if (byLongWork)
            click("checkAll");
        else
            actions().readAgain->trigger();
        WAIT_FOR(isAtDoor() && door() == LoginMode::Login);
        QVERIFY2(saidAtDoor().contains(reason), qPrintable(saidAtDoor()));
        if (change.startsWith("role")) {
            logIn(name);
            QVERIFY(!actions().school->isVisible());
        }
    }

    /// The lock accepts the last known password. Wrong passwords cause a waiting time for the same user only.
    void theLockIsOpenedWithoutTheDatabase()
    {
        const auto setReachable = [this](bool reachable) {
            const QString away = file() + ".away";
            QVERIFY(reachable ? QFile::rename(away, file()) : QFile::rename(file(), away));
        };
        const auto lockAndTryWrong = [this](int times) {
            actions().lock->trigger();
            QCOMPARE(door(), LoginMode::Locked);
            for (int k = 0; k < times; ++k) {
                tryPassword("somebody else's");
                QVERIFY(isAtDoor());
            }
        };
        const auto unlock = [this] {
            tryPassword();
            QVERIFY2(!isAtDoor(), qPrintable(saidAtDoor()));
        };
        const auto mustWait = [this] { return saidAtDoor().contains("Too many logins have failed"); };
        startAs("sam");
        goToTooth();
        setReachable(false);
        lockAndTryWrong(4);
        QVERIFY2(saidAtDoor().contains("Wrong username or password"), qPrintable(saidAtDoor()));
        tryPassword();
        QVERIFY2(isAtDoor() && mustWait(), qPrintable(saidAtDoor()));
        const auto unlocks = [&] {
            if (isAtDoor())
                tryPassword();
            return !isAtDoor();
        };
        WAIT_FOR(unlocks());
        QVERIFY(window().view().isVisible());
        // A successful login resets the count of wrong passwords.
        lockAndTryWrong(3);
        setReachable(true);
        unlock();
        setReachable(false);
        lockAndTryWrong(1);
        unlock();
        // A login needs the database, and another user does not wait for the mistakes of the one before.
        lockAndTryWrong(6);
        QVERIFY2(mustWait(), qPrintable(saidAtDoor()));
        click("otherLogin");
        WAIT_FOR_VALUE(door(), LoginMode::Login);
        child<QLineEdit>("username")->setText("sam");
        tryPassword();
        QVERIFY(isAtDoor());
        setReachable(true);
        logIn("sue");
        openAttempts();  // Sue's own password is known by then
        setReachable(false);
        lockAndTryWrong(0);
        unlock();
    }

    /// A hanging database does not answer. The right password unlocks the window nevertheless, and a wrong one does
    /// not.
    void theLockIsOpenedWhileTheDatabaseHangs()
    {
        app::WindowOptions options;
        options.opening.patience = std::chrono::minutes(5);
        options.loginPatience = std::chrono::milliseconds(300);
        start(options);
        logIn("sam");
        goToTooth();
        const OtherStation other(file());
        other.execute("BEGIN IMMEDIATE");
        actions().lock->trigger();
        tryPassword("somebody else's");
        QVERIFY(isAtDoor() && door() == LoginMode::Locked);
        QVERIFY2(saidAtDoor().contains("Wrong username or password"), qPrintable(saidAtDoor()));
        tryPassword();
        QVERIFY2(!isAtDoor(), qPrintable(saidAtDoor()));
        QVERIFY(window().view().isVisible());
        // Lessons are files, and are read without it.
        window().lessonsPage().setLessons({}, {});
        actions().lessons->trigger();
        WAIT_FOR(lessonsShown() > 2);
        other.execute("ROLLBACK");
    }

    void theOwnPasswordIsChanged()
    {
        startAs("sam");
        const QString next = "battery staple";
        const auto changeFrom = [this, next](const QString& old) {
            WAIT_FOR(child<QLineEdit>("oldPassword")->isEnabled());
            child<QLineEdit>("oldPassword")->setText(old);
            child<QLineEdit>("password")->setText(next);
            child<QLineEdit>("passwordAgain")->setText(next);
            click("logIn");
        };
        const auto open = [this] {
            child<QMenu>("accountMenu")->findChild<QAction*>("ownPassword")->trigger();
            WAIT_FOR_VALUE(door(), LoginMode::OwnPassword);
        };
        // A page opened from the menu leads back to the page before; from the lock it does not.
        actions().lessons->trigger();
        open();
        actions().back->trigger();
        QVERIFY(child<ui::catalog::LessonsPage>()->isVisible());
        open();
        actions().lock->trigger();
        QCOMPARE(door(), LoginMode::Locked);
        actions().back->trigger();
        QVERIFY(isAtDoor());
        click("changePassword");
        changeFrom("wrong");
        WAIT_FOR(child<QLineEdit>("oldPassword")->isEnabled());
        QVERIFY(isAtDoor());
        changeFrom(kRight);
        WAIT_FOR(!isAtDoor());
        QVERIFY(sql::Logins::login(OtherStation(file()).school, "sam", next.toStdString()));
        QVERIFY(!sql::Logins::login(OtherStation(file()).school, "sam", kPassword));
    }

    /// Another user may be at the computer when the answer arrives.
    void aLateLoginLetsNobodyIn()
    {
        start();
        WAIT_FOR(child<QLineEdit>("username")->isEnabled());
        const int before = count("audit WHERE action = 'login'");
        QStringList names;
        connect(actions().account, &QAction::changed, this, [&] { names << actions().account->text(); });
        {
            const OtherStation other(file());
            other.execute("BEGIN IMMEDIATE");
            typeLogin("sue");
            QVERIFY(!child<QLineEdit>("username")->isEnabled());
            beGuest();
            other.execute("ROLLBACK");
        }
        WAIT_FOR_VALUE(count("audit WHERE action = 'login'"), before + 1);
        // The next login is answered after Sue's.
        actions().account->trigger();
        logIn("sam");
        QVERIFY2(!names.contains("sue"), qPrintable(names.join(u' ')));
    }

    void nothingOpensOverTheLock()
    {
        beginAsInes();
        goToTooth();
        actions().classes->trigger();
        actions().lock->trigger();
        QCOMPARE(door(), LoginMode::Locked);
        tryPassword("somebody else's");  // answered after the classes
        QVERIFY(isAtDoor() && door() == LoginMode::Locked);
        tryPassword();
        waitForPage<ClassPage>();
    }

    void aLockedDatabaseIsTriedAgain()
    {
        auto other = std::make_unique<OtherStation>(file());
        other->execute("PRAGMA locking_mode = EXCLUSIVE");
        other->execute("BEGIN EXCLUSIVE");
        app::WindowOptions options;
        options.opening.patience = std::chrono::milliseconds(100);
        start(options);
        WAIT_FOR(child<QPushButton>("tryAgain")->isVisible());
        QVERIFY(!child<QPushButton>("restoreBackup")->isVisible());
        QVERIFY2(saidAtDoor().contains("Another program is writing to the school's database"),
                 qPrintable(saidAtDoor()));
        other.reset();
        click("tryAgain");
        WAIT_FOR(!child<QPushButton>("tryAgain")->isVisible());
        logIn("sam");
    }

    /// The database file is damaged while the window is open.
    void aBackupIsRestoredFromTheLogin()
    {
        start();
        WAIT_FOR_VALUE(backups().size(), 1);
        damageSchool();
        typeLogin("sam");
        WAIT_FOR(child<QPushButton>("restoreBackup")->isVisible());
        QVERIFY(child<QPushButton>("tryAgain")->isVisible() && child<QPushButton>("practiseAsGuest")->isEnabled());
        click("restoreBackup");
        waitForDoorToSay("was restored");
        QCOMPARE(window().focusWidget(), child<QLineEdit>("username"));
        logIn("sam");
        QCOMPARE(count("audit WHERE action = 'backup.restored'"), 1);
    }

    void anotherSchoolInItsPlaceLetsNobodyStay()
    {
        const QString other = m_folder->filePath("other.sqlite");
        QVERIFY(sql::Logins::createFirstAdmin(OtherStation(other).school, {"admin", "", "", Role::Admin}, kPassword,
                                              support::SchoolRig::kCheap));
        beginAsInes();
        moveAway();
        QVERIFY(QFile::rename(other, file()));
        actions().classes->trigger();
        WAIT_FOR(isAtDoor() && door() == LoginMode::Login);
        waitForDoorToSay("another school is now where yours was");
        logIn("admin");
        QCOMPARE(count("people"), 1);
    }

    /// The program makes a backup each day, because a window may stay open for weeks.
    void eachDayHasItsBackup()
    {
        start();
        WAIT_FOR_VALUE(backups().size(), 1);
        makeBackupOlder();
        auto* watch = m_application->findChild<QTimer*>("backupWatch");
        QVERIFY(watch != nullptr && watch->isActive());
        const QSignalSpy looks(watch, &QTimer::timeout);
        watch->setInterval(2);
        WAIT_FOR_VALUE(backups().size(), 2);
        const qsizetype before = looks.size();
        WAIT_FOR(looks.size() > before + 50);
        QCOMPARE(backups().size(), 2);
    }

    /// The user's settings in the database note that the tour was shown.
    void theTourIsShownOnce()
    {
        app::WindowOptions options;
        options.showsRound = true;
        start(options);
        auto* tour = child<ui::window::Tour>("tour");
        logIn("sam");
        WAIT_FOR(tour->isVisible());
        // Locking the window during the tour does not count as having seen it.
        actions().lock->trigger();
        QVERIFY(!tour->isVisible());
        QCOMPARE(count("settings WHERE name = 'tour.seen'"), 0);
        tryPassword();
        // A teacher's tour begins with the classes, while the list behind it is still being filled.
        switchTo("ines");
        WAIT_FOR(tour->isVisible());
        QVERIFY(child<ClassPage>()->isVisible() && child<ClassPage>()->isAncestorOf(tour->target()));
        tour->next();
        QVERIFY(child<ui::catalog::LessonsPage>()->isVisible());
        while (tour->isVisible())
            tour->next();
        WAIT_FOR_VALUE(count("settings WHERE name = 'tour.seen' AND value = 'yes'"), 1);
        switchTo("ines");
        openAttempts();
        QVERIFY(!tour->isVisible());
        actions().tour->trigger();
        QVERIFY(tour->isVisible());
        tour->end();
        logOut();
        // A guest is led to the tooth.
        beGuest();
        QVERIFY(!tour->isVisible());
    }

    void aClassIsSeenByItsTeachersOnly()
    {
        deliverAttempt();
        {
            const OtherStation elsewhere(file());
            const auto otto =
                sql::addPerson(elsewhere.school, elsewhere.logIn("admin"), {"otto", "Otto", "Teach", Role::Instructor});
            QVERIFY(sql::Logins::redeem(elsewhere.school, "otto", otto->code, kPassword));
        }
        beginAsInes();
        const auto* const attempts = child<QTableView>("attempts")->model();
        const auto* const empty = child<QLabel>("classEmpty");
        const QString noClass = "Here you will see your classes";
        openStudent();
        WAIT_FOR_VALUE(attempts->rowCount(), 1);
        logOut();
        QCOMPARE(studentsShown(), 0);
        QCOMPARE(attempts->rowCount(), 0);
        logIn("otto");
        WAIT_FOR(empty->isVisible() && empty->text().contains(noClass));
        QCOMPARE(studentsShown(), 0);
        QVERIFY(labelWith("sam") == nullptr);
        // A teacher who is removed from the class can no longer comment on its attempts, is told why, and no longer
        // sees the class.
        switchTo("ines");
        openStudent();
        openNewest();
        auto* const words = child<QPlainTextEdit>("commentWords");
        WAIT_FOR(words->isVisible());
        words->setPlainText("A sentence");
        click("addComment");
        WAIT_FOR(words->toPlainText().isEmpty());
        words->setPlainText("Half a sentence");
        OtherStation(file()).execute(
            "DELETE FROM enrolments WHERE person_id = (SELECT id FROM people WHERE username = 'ines')");
        click("addComment");
        const auto* const fault = child<ui::scoring::CommentsPanel>()->findChild<QLabel*>("fault");
        WAIT_FOR(fault->isVisible());
        QVERIFY2(fault->text().contains("in none of your classes any more"), qPrintable(fault->text()));
        QCOMPARE(words->toPlainText(), QString("Half a sentence"));
        QCOMPARE(count("comments"), 1);
        words->clear();
        goBackTo<ClassPage>();
        actions().readAgain->trigger();
        WAIT_FOR_VALUE(studentsShown(), 0);
        WAIT_FOR(empty->text().contains(noClass));
    }

    /// The export is noted in the audit, because it leaves the school with names and scores. It is of the class that
    /// was shown when it was requested.
    void aClassReportIsNoted()
    {
        {
            const OtherStation elsewhere(file());
            const auto admin = elsewhere.logIn("admin");
            const ClassId second = sql::addClass(elsewhere.school, admin, "DEN102-B").value();
            for (const char* name : {"sue", "ines"})
                QVERIFY(sql::enrol(elsewhere.school, admin, second, {elsewhere.idOf(name)}, true));
        }
        beginAsInes();
        const auto* const matrix = child<QTableView>("matrix")->model();
        const auto student = [matrix] { return matrix->headerData(0, Qt::Vertical).toString(); };
        QVERIFY2(student().startsWith("sam"), qPrintable(student()));
        const QString table = m_folder->filePath("class.csv");
        emit child<ClassPage>()->tableRequested(table);
        auto* const classes = child<QComboBox>("classChooser");
        classes->setCurrentIndex(classes->findText("DEN102-B", Qt::MatchStartsWith));
        WAIT_FOR(QFile::exists(table));
        WAIT_FOR(matrix->rowCount() == 1 && student().startsWith("sue"));
        QFile written(table);
        QVERIFY(written.open(QIODevice::ReadOnly) && written.readAll().contains("sam"));
        QVERIFY(!(QFile::permissions(table) & (QFile::ReadGroup | QFile::ReadOther)));
        QCOMPARE(count("audit JOIN classes ON audit.object = 'class:' || classes.id "
                       "WHERE action = 'class.export' AND classes.name = 'DEN101-A'"),
                 1);
        QCOMPARE(count("audit WHERE action = 'class.export'"), 1);
    }

    void anotherScoreIsNotOverruledUnseen()
    {
        deliverAttempt();
        beginAsInes();
        openStudent();
        openNewest();
        auto* const talk = child<ui::scoring::CommentsPanel>();
        auto* const points = talk->findChild<QDoubleSpinBox*>("givenPoints");
        auto* const reason = talk->findChild<QLineEdit*>("reason");
        WAIT_FOR(reason->isVisible());
        points->setValue(55.5);
        reason->setText("not so neat");
        const auto giveElsewhere = [this](int tenths) {
            const OtherStation elsewhere(file());
            const auto id = elsewhere.ask("SELECT max(id) FROM attempts").toLongLong();
            QVERIFY(sql::overrideScore(elsewhere.school, elsewhere.logIn("ines"), {id}, tenths, "neat"));
        };
        giveElsewhere(910);
        click("giveScore");
        WAIT_FOR(talk->findChild<QLabel*>("fault")->isVisible());
        WAIT_FOR(talk->findChild<QLabel*>("counts")->text().contains("91.0"));
        // The entered values stay, so that the teacher can submit them again or discard them.
        QCOMPARE(points->value(), 55.5);
        QCOMPARE(reason->text(), QString("not so neat"));
        QCOMPARE(count("overrides"), 1);
        click("giveScore");
        WAIT_FOR_VALUE(count("overrides"), 2);
        // F5 reads the list again.
        const auto listed = [this] {
            return child<QTableView>("attempts")->model()->index(0, ui::people::HistoryModel::Score).data().toString();
        };
        WAIT_FOR_VALUE(listed(), QString("55.5"));
        goBackTo<ui::people::HistoryPage>();
        giveElsewhere(730);
        actions().readAgain->trigger();
        WAIT_FOR_VALUE(listed(), QString("73.0"));
    }

    void withoutItsRecordingAnAttemptIsOpenedAndOverruled_data()
    {
        QTest::addColumn<QString>("recordingHash");
        QTest::addColumn<bool>("hasSheet");
        QTest::newRow("its file has gone") << QString(64, 'd') << true;
        QTest::newRow("none was saved") << "" << true;
        QTest::newRow("nor a sheet, as in a sample school") << "" << false;
    }

    /// The score page is filled from the saved score sheet.
    void withoutItsRecordingAnAttemptIsOpenedAndOverruled()
    {
        QFETCH(QString, recordingHash);
        QFETCH(bool, hasSheet);
        const lessons::ScoreSheet scored = deliverAttempt(recordingHash.toStdString(), hasSheet);
        beginAsInes();
        openStudent();
        openNewest();
        const auto* const page = child<ui::scoring::ScorePage>();
        QCOMPARE(page->person(), QString("sam Student"));
        const lessons::ScoreSheet shown = page->card().sheet;
        if (hasSheet)
            QVERIFY(shown == scored);
        QCOMPARE(shown.totalTenths, scored.totalTenths);
        QCOMPARE(shown.criteria.size(), scored.criteria.size());
        for (std::size_t k = 0; k < scored.criteria.size(); ++k) {
            QCOMPARE(shown.criteria[k].lostTenths, scored.criteria[k].lostTenths);
            QCOMPARE(ui::text::criterionWorked(shown.criteria[k], shown.verdict).contains("not saved"), !hasSheet);
        }
        const auto* const unrecorded = child<QLabel>("unrecorded");
        QVERIFY2(unrecorded->isVisible(), qPrintable(unrecorded->text()));
        QVERIFY(!child<QPushButton>("replayScored")->isVisible() && !child<ui::scoring::HeatMap>()->isVisible());
        child<QPlainTextEdit>("commentWords")->setPlainText("Do it again.");
        click("addComment");
        WAIT_FOR_VALUE(count("comments"), 1);
        WAIT_FOR(child<QPlainTextEdit>("commentWords")->toPlainText().isEmpty());
        child<QDoubleSpinBox>("givenPoints")->setValue(91.5);
        child<QLineEdit>("reason")->setText("Seen by hand.");
        click("giveScore");
        WAIT_FOR(child<QLabel>("counts")->text().contains("91.5"));
        QCOMPARE(count("overrides"), 1);
        QCOMPARE(page->card().sheet.totalTenths, scored.totalTenths);
        savePdf(m_folder->filePath("old.pdf"));
        switchTo("sam");
        openAttempts();
        openNewest();
        WAIT_FOR(child<QLabel>("counts")->text().contains("91.5"));
        QVERIFY(unrecorded->isVisible());
    }

    void lessonsAreChangedByTeachers()
    {
        const auto mayEdit = [this] { return actions().editLesson->isVisible() && actions().editLesson->isEnabled(); };
        const auto isFolderOffered = [this] { return child<QPushButton>("ownLessons")->isVisible(); };
        startAs("sam");
        WAIT_FOR(lessonsShown() > 2);
        QVERIFY(!actions().editLesson->isVisible() && !actions().editLesson->isEnabled());
        QVERIFY(!isFolderOffered());
        switchTo("ines");
        waitForPage<ClassPage>();  // the first page of a teacher
        actions().lessons->trigger();
        WAIT_FOR(mayEdit());
        QVERIFY(isFolderOffered());
        logOut();
        beGuest();
        actions().lessons->trigger();
        waitForPage<ui::catalog::LessonsPage>();
        QVERIFY(!actions().editLesson->isVisible() && !actions().editLesson->isEnabled());
    }

    void aTeacherAssignsLessonsAndTakesThemBack()
    {
        beginAsInes();
        const auto openAssignments = [this] {
            click("assignLessons");
            waitForPage<ui::people::AssignPage>();
        };
        const auto* given = child<QTableView>("given")->model();
        openAssignments();
        auto* offers = child<QListView>("offers")->model();
        QVERIFY(offers->rowCount() > 10);
        for (const int row : {1, 2})
            QVERIFY(offers->setData(offers->index(row, 0), Qt::Checked, Qt::CheckStateRole));
        click("assignTicked");
        WAIT_FOR_VALUE(given->rowCount(), 2);
        QCOMPARE(count("assignments"), 2);
        actions().back->trigger();
        WAIT_FOR_VALUE(child<QTableView>("matrix")->model()->columnCount(), 3);
        openAssignments();
        click("undoAssign");
        WAIT_FOR_VALUE(given->rowCount(), 0);
        QCOMPARE(count("assignments"), 0);
    }

    void anAdminEntersAndChangesPeople()
    {
        startAs("sam");
        QVERIFY(!actions().school->isVisible());
        switchTo("admin");
        waitForPage<AdminPage>();  // the first page of an admin
        openAdminPage(AdminPage::People);
        const auto* people = child<QTableView>("people")->model();
        WAIT_FOR_VALUE(people->rowCount(), 4);
        const OtherStation elsewhere(file());
        const sql::DatabaseContext& school = elsewhere.school;
        const auto* const fault = child<QLabel>("personFault");
        const auto* const code = child<QLabel>("oneTimeCode");
        // Adds a user to a class; the one-time code is valid for one login.
        click("newPerson");
        child<QLineEdit>("personUsername")->setText("tom");
        child<QLineEdit>("personFamily")->setText("Three");
        auto* classes = child<QListWidget>("personClasses");
        WAIT_FOR_VALUE(classes->count(), 1);
        classes->item(0)->setCheckState(Qt::Checked);
        click("savePerson");
        WAIT_FOR(code->isVisible());
        const QString tomsCode = code->text();
        WAIT_FOR_VALUE(people->rowCount(), 5);
        QCOMPARE(count("enrolments"), 3);
        // The only admin cannot be disabled.
        choosePerson("admin");
        clickTwice("disablePerson");
        WAIT_FOR(fault->text().contains("the last admin"));
        // Neither one click nor a double click resets a password. Esc cancels, and the page stays open.
        choosePerson("sue");
        QVERIFY(!code->isVisible());
        click("resetPassword");
        click("resetPassword");
        QTest::keyClick(child<QPushButton>("keepAsItIs"), Qt::Key_Escape);
        QVERIFY(!child<QPushButton>("keepAsItIs")->isVisible() && child<AdminPage>()->isVisible());
        QVERIFY(sql::Logins::login(school, "sue", kPassword));
        clickTwice("resetPassword");
        WAIT_FOR(code->isVisible());
        QVERIFY(!sql::Logins::login(school, "sue", kPassword));
        // The code of a disabled user is not shown.
        click("disablePerson");
        WAIT_FOR_VALUE(child<QPushButton>("disablePerson")->text(), QString("Enable"));
        QVERIFY(!code->isVisible());
        QVERIFY(sql::findPerson(school, elsewhere.logIn("admin"), "sue")->disabled);
        // A class is added, which is ticked for Sue and not saved.
        child<QLineEdit>("className")->setText("DEN102");
        click("addClass");
        WAIT_FOR_VALUE(classes->count(), 2);
        choosePerson("tom");
        click("questionDiscard");
        QCOMPARE(classes->item(0)->checkState(), Qt::Checked);
        classes->item(0)->setCheckState(Qt::Unchecked);
        child<QLineEdit>("personGiven")->setText("Tom");
        click("savePerson");
        WAIT_FOR_VALUE(count("enrolments"), 2);
        QCOMPARE(sql::findPerson(school, elsewhere.logIn("admin"), "tom")->fullName(), std::string("Tom Three"));
        QVERIFY(sql::Logins::redeem(school, "tom", tomsCode.toStdString(), kPassword));
    }

    void aClassListIsSeenBeforeItIsEntered()
    {
        beginAsAdmin(AdminPage::Roster);
        const auto said = [this] { return child<QLabel>("rosterSaid")->text() + child<QLabel>("rosterFault")->text(); };
        const auto* rows = child<QTableView>("roster")->model();
        const auto choose = [&](const std::string& lines, const QString& answer) {
            const QString path = m_folder->filePath("class.csv");
            support::write(path, "username,given_name,family_name,role,class\nsam,Sam,One,student,DEN101-A\n" + lines);
            emit child<ui::admin::RosterPart>()->fileChosen(path);
            QTRY_VERIFY2_WITH_TIMEOUT(said().contains(answer), qPrintable(said()), kPatienceMs);
        };
        choose("!!,X,Y,student,DEN101-A\n", "1 fault");
        QCOMPARE(rows->index(0, 0).data().toString(), QString("3"));
        QVERIFY(!child<QPushButton>("enterRoster")->isVisible());
        choose("new1,N,Ew,student,DEN103\n", "1 new person");
        QCOMPARE(count("people"), 4);
        // Another station adds a user with the same username meanwhile. The list would change their name.
        {
            const OtherStation elsewhere(file());
            const auto admin = elsewhere.logIn("admin");
            QVERIFY(sql::addPerson(elsewhere.school, admin, {"new1", "Otto", "Other", Role::Student}));
        }
        click("enterRoster");
        WAIT_FOR(said().contains("Nothing was entered"));
        QCOMPARE(count("people WHERE given_name = 'Otto'"), 1);
        QVERIFY(rows->index(1, 4).data().toString().contains("Otto Other"));
        choose("new2,N,Ew,student,DEN103\n", "1 new person");
        click("enterRoster");
        WAIT_FOR_VALUE(count("people"), 6);
        WAIT_FOR(child<QPushButton>("saveCodes")->isVisible());
        emit child<ui::admin::RosterPart>()->fileChosen(m_folder->filePath("nothing.csv"));
        WAIT_FOR(said().contains("cannot be read"));
    }

    void aBackupIsMadeCheckedAndRestored()
    {
        beginAsAdmin(AdminPage::Backups);
        const auto* rows = child<QTableView>("backups")->model();
        WAIT_FOR_VALUE(rows->rowCount(), 1);  // today's
        makeBackupOlder();
        clickAtBackups("backUp", "Its pages and keys are whole");
        WAIT_FOR_VALUE(rows->rowCount(), 2);
        QVERIFY(!child<QPushButton>("restoreThis")->isEnabled());
        clickAtBackups("checkAll", "Nothing is wrong");
        // Checks with the audit code of a report: no valid code, the present one, and a wrong one.
        auto* code = child<QLineEdit>("reportCode");
        code->setText("412");
        click("checkAll");
        QVERIFY(child<QLabel>("reportCodeFault")->isVisible());
        const QString head =
            OtherStation(file()).ask("SELECT seq || '-' || substr(hash, 1, 12) FROM audit_seal").toString().toUpper();
        code->setText(' ' + head);
        QVERIFY(!child<QLabel>("reportCodeFault")->isVisible());
        clickAtBackups("checkAll", head);
        code->setText("3-000000000000");
        clickAtBackups("checkAll", "1 thing");
        QVERIFY(child<QPlainTextEdit>("findings")->isVisible());
        code->clear();
        // The restore asks for confirmation. A user who was added after the backup is missing afterwards.
        {
            const OtherStation elsewhere(file());
            QVERIFY(sql::addPerson(elsewhere.school, elsewhere.logIn("admin"), {"tom", "", "", Role::Student}));
        }
        child<QTableView>("backups")->setCurrentIndex(rows->index(0, 0));
        click("restoreThis");
        QTest::keyClick(child<QPushButton>("keepPresent"), Qt::Key_Escape);
        QVERIFY(child<AdminPage>()->isVisible() && !child<QPushButton>("keepPresent")->isVisible());
        QCOMPARE(count("people"), 5);
        clickTwice("restoreThis");
        waitForDoorToSay("was restored");
        QCOMPARE(count("people"), 4);
        QCOMPARE(count("audit a JOIN people p ON p.uid = a.actor "
                       "WHERE a.action = 'backup.restored' AND p.username = 'admin'"),
                 1);
        logIn("admin");
    }

    /// Nobody is logged out if the restore is refused, or if the admin who requested it has logged out.
    void aRestoreLogsOutNobodyElse()
    {
        beginAsAdmin(AdminPage::Backups);
        WAIT_FOR_VALUE(child<QTableView>("backups")->model()->rowCount(), 1);  // today's
        const auto* said = child<QLabel>("backupSaid");
        {
            const OtherStation elsewhere(file());
            emit child<ui::admin::BackupPart>()->restoreRequested(backups().front());
            QTRY_VERIFY2_WITH_TIMEOUT(said->text().contains("was not restored"), qPrintable(said->text()), kPatienceMs);
            QVERIFY(!isAtDoor());
            QCOMPARE(actions().account->text(), QString("admin"));
        }
        emit child<ui::admin::BackupPart>()->restoreRequested(backups().front());
        logOut();  // before the backup was checked
        logIn("sam");
        QTRY_VERIFY2_WITH_TIMEOUT(said->text().isEmpty(), qPrintable(said->text()), kPatienceMs);
        QCOMPARE(actions().account->text(), QString("sam"));
        QVERIFY(!isAtDoor());
        QCOMPARE(count("audit WHERE action = 'backup.restored'"), 0);
    }

    /// The only connection that a database on a network drive allows does everything.
    void aNetworkDriveIsForOneAndIsBackedUp()
    {
        deliverAttempt();
        app::WindowOptions options;
        options.opening.fileSystemOf = [](const QString&) { return FileSystem::Network; };
        options.opening.patience = std::chrono::milliseconds(200);
        start(options);
        logIn("sam");
        const auto other = sql::Database::open(file(), std::chrono::milliseconds(50));
        QVERIFY(!other.has_value() && other.error().code == core::ErrorCode::Busy);
        switchTo("admin");
        waitForMessage("network drive");
        openAdminPage(AdminPage::Backups);
        WAIT_FOR_VALUE(backups().size(), 1);
        clickAtBackups("backUp", "Its pages and keys are whole");
        clickAtBackups("checkAll", "Nothing is wrong: 1 attempts");
    }

    /// The audit is searched also beyond the rows that are read at once.
    void theAuditShowsWhatWasDone()
    {
        {
            const OtherStation elsewhere(file());
            QVERIFY(sql::inTurn(elsewhere.school, "note attempts", [&]() -> core::Status {
                sql::AuditBatch batch(elsewhere.school);
                for (int k = 0; k < 505; ++k)
                    if (auto noted = batch.note("system", "attempt.add", "attempt:" + std::to_string(k)); !noted)
                        return noted;
                return batch.seal();
            }));
        }
        beginAsAdmin(AdminPage::Audit);
        const auto* rows = child<QTableView>("audit")->model();
        auto* search = child<QLineEdit>("auditSearch");
        const auto actionAt = [rows](int row) { return rows->index(row, 3).data().toString(); };
        WAIT_FOR_VALUE(rows->rowCount(), 500);
        // An admin's login may also raise the cost of passwords.
        int login = 0;
        while (actionAt(login) == "changed a setting")
            ++login;
        QCOMPARE(actionAt(login), QString("logged in"));
        QCOMPARE(rows->index(login, 2).data().toString(), QString("Ada Admin (admin)"));
        QVERIFY(child<QLabel>("auditCode")->text().contains('-'));
        search->setText("entered a person");
        QCOMPARE(rows->rowCount(), 0);
        QVERIFY(child<QPushButton>("olderAudit")->isEnabled());
        child<QAbstractButton>("auditNoAttempts")->click();
        WAIT_FOR_VALUE(rows->rowCount(), count("audit WHERE action = 'person.add'"));
        QVERIFY(rows->rowCount() >= 3);
        QVERIFY(!child<QPushButton>("olderAudit")->isEnabled());
        search->clear();
        // Attempts are shown again. Older rows that are requested twice appear once. The newest row is compared,
        // because a row about the cost of passwords may be added meanwhile.
        child<QAbstractButton>("auditNoAttempts")->click();
        WAIT_FOR_VALUE(rows->rowCount(), 500);
        click("olderAudit");
        click("olderAudit");
        WAIT_FOR(!child<QPushButton>("olderAudit")->isEnabled());
        QCOMPARE(rows->rowCount(), count("audit WHERE seq <= " + rows->index(0, 0).data().toString()));
        // A setting of the station is saved.
        openAdminPage(AdminPage::Station);
        auto* idle = child<QSpinBox>("idleMinutes");
        WAIT_FOR(labelWith("On their way") != nullptr);
        idle->setValue(3);
        emit idle->editingFinished();
        WAIT_FOR_VALUE(count("settings WHERE name = 'idle.minutes' AND value = '3'"), 1);
    }

private:
    const QString kRight = QString::fromStdString(kPassword);

    /// Delivers an attempt of Sam without a recording. Returns its score sheet.
    lessons::ScoreSheet deliverAttempt(const std::string& recordingHash = {}, bool hasSheet = true) const
    {
        lessons::ScoreSheet sheet;
        sheet.rubricId = "removal";
        sheet.rubricVersion = 1;
        sheet.passMarkTenths = 750;
        sheet.totalTenths = 893;
        lessons::Criterion depth;
        depth.id = depth.measure = "depth";
        depth.unit = "mm";
        depth.measured = 2.5;
        depth.weightTenths = 300;
        depth.share = 0.357;
        depth.lostTenths = 107;
        sheet.criteria = {depth};
        AttemptRecord attempt = support::SchoolRig::attempt("", sheet.totalTenths);
        attempt.lessonHash.clear();
        attempt.criteria = {{depth.id, depth.lostTenths, depth.weightTenths}};
        if (hasSheet)
            attempt.scoreSheetJson = lessons::toJson(sheet).toStdString();
        const OtherStation elsewhere(file());
        attempt.personUid = elsewhere.logIn("sam").uid();
        const auto id = sql::deliverAttempt(elsewhere.school, attempt, {});
        if (!id)
            qFatal("%s", id.error().detail.c_str());
        if (!recordingHash.empty())
            elsewhere.execute("UPDATE attempts SET recording_hash = '" + QString::fromStdString(recordingHash) + "'");
        return sheet;
    }

    [[nodiscard]] QStringList backups() const { return sql::backupsIn(sql::backupFolder(file())); }
    /// Gives the backup an older name, because the names of backups differ only by the second.
    void makeBackupOlder() const
    {
        QVERIFY(QFile::rename(backups().front(), sql::backupFolder(file()) + "/backup-2026-01-01-10.00.00.sqlite"));
    }

    void clickAtBackups(const char* button, const QString& words) const
    {
        click(button);
        const auto* said = child<QLabel>("backupSaid");
        QTRY_VERIFY2_WITH_TIMEOUT(said->text().contains(words), qPrintable(said->text()), kPatienceMs);
    }

    /// Clicks a button and confirms it by a second click. The second click does not count while it may belong to a
    /// double click.
    void clickTwice(const char* button) const
    {
        click(button);
        click(button);
        const int usual = QApplication::doubleClickInterval();
        const auto asItWas = qScopeGuard([usual] { QApplication::setDoubleClickInterval(usual); });
        QApplication::setDoubleClickInterval(0);
        click(button);
    }

    void choosePerson(const QString& username) const
    {
        auto* const table = child<QTableView>("people");
        WAIT_FOR(table->model()->rowCount() > 3);
        const auto found = table->model()->match(table->model()->index(0, 1), Qt::DisplayRole, username);
        QVERIFY(!found.isEmpty());
        table->setCurrentIndex(found.front().siblingAtColumn(0));
    }

    [[nodiscard]] int lessonsShown() const { return child<QListView>("lessonList")->model()->rowCount(); }

    void beginAsInes()
    {
        startAs("ines");
        WAIT_FOR_VALUE(studentsShown(), 1);
    }

    void beginAsAdmin(AdminPage::Part part)
    {
        startAs("admin");
        openAdminPage(part);
    }
};

int main(int argc, char** argv)
{
    return support::openGlMain<TestSchoolPages>(argc, argv);
}

#include "tst_school_pages.moc"
