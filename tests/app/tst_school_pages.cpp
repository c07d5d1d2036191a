// SPDX-License-Identifier: GPL-3.0-or-later
// The whole program at a school, as far as no tooth is cut: the login, a teacher's pages and an admin's.
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QJsonDocument>
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
#include "database/sql/Presets.h"
#include "lessons/PresetFile.h"
#include "lessons/ScoreSheetJson.h"
#include "tests/app/SchoolWindow.h"
#include "tests/database/SchoolRig.h"
#include "tests/support/OpenGlMain.h"
#include "ui/admin/BackupPart.h"
#include "ui/admin/RosterPart.h"
#include "ui/people/AssignPage.h"
#include "ui/people/ClassPage.h"
#include "ui/people/HistoryModel.h"
#include "ui/people/HistoryPage.h"
#include "ui/people/TalkPanel.h"
#include "ui/shell/Tour.h"
#include "ui/study/HeatMap.h"
#include "ui/study/LessonsPage.h"
#include "ui/study/ScorePage.h"
#include "ui/text/Texts.h"
#include "ui/tooth/ToothView.h"

using namespace database;
using support::kPassword;
using support::kPatienceMs;
using support::OtherStation;
using ui::admin::AdminPage;
using ui::people::ClassPage;
using ui::people::Door;

class TestSchoolPages : public support::SchoolWindow
{
    Q_OBJECT
private slots:
    void initTestCase() { makeSchool(); }
    void init() { takeCopyOfSchool(); }
    void cleanup() { m_application.reset(); }

    void theFirstAdminCreatesTheSchool();
    void whoMayNotStayIsLoggedOut_data();
    void whoMayNotStayIsLoggedOut();
    void theLockIsOpenedWithoutTheDatabase();
    void theLockIsOpenedWhileTheDatabaseHangs();
    void theOwnPasswordIsChanged();
    void aLateLoginLetsNobodyIn();
    void nothingOpensOverTheLock();
    void aLockedDatabaseIsTriedAgain();
    void aBackupIsRestoredFromTheLogin();
    void anotherSchoolInItsPlaceLetsNobodyStay();
    void eachDayHasItsBackup();
    void theTourIsShownOnce();
    void aClassIsSeenByItsTeachersOnly();
    void aClassReportIsNoted();
    void anotherScoreIsNotOverruledUnseen();
    void withoutItsRecordingAnAttemptIsOpenedAndOverruled_data();
    void withoutItsRecordingAnAttemptIsOpenedAndOverruled();
    void lessonsAreChangedByTeachers();
    void aTeacherAssignsLessonsAndTakesThemBack();
    void twoAdminsUndoNothingOfEachOther();
    void aPresetIsRetiredAndTakenUpAgain();
    void anAdminEntersAndChangesPeople();
    void aClassListIsSeenBeforeItIsEntered();
    void aBackupIsMadeCheckedAndRestored();
    void aRestoreLogsOutNobodyElse();
    void aNetworkDriveIsForOneAndIsBackedUp();
    void theAuditShowsWhatWasDone();

private:
    /// Delivers an attempt of Sam's without a recording. Returns its score sheet.
    lessons::ScoreSheet deliverAttempt(const std::string& recordingHash = {}, bool hasSheet = true) const;
    [[nodiscard]] QStringList backups() const { return sql::backupsIn(sql::backupFolder(file())); }
    [[nodiscard]] QString backupSaid() const { return child<QLabel>("backupSaid")->text(); }
    /// Clicks a button that asks for a second click, which does not count as long as it may be of a double click.
    void clickTwice(const char* button) const;
    void choosePerson(const QString& username) const;
    void beginAsInes();
};

lessons::ScoreSheet TestSchoolPages::deliverAttempt(const std::string& recordingHash, bool hasSheet) const
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

void TestSchoolPages::clickTwice(const char* button) const
{
    click(button);
    click(button);
    const int usual = QApplication::doubleClickInterval();
    const auto asItWas = qScopeGuard([usual] { QApplication::setDoubleClickInterval(usual); });
    QApplication::setDoubleClickInterval(0);
    click(button);
}

void TestSchoolPages::choosePerson(const QString& username) const
{
    auto* const table = child<QTableView>("people");
    QTRY_VERIFY_WITH_TIMEOUT(table->model()->rowCount() > 3, kPatienceMs);
    for (int row = 0; row < table->model()->rowCount(); ++row)
        if (table->model()->index(row, 1).data().toString() == username)
            table->setCurrentIndex(table->model()->index(row, 0));
}

void TestSchoolPages::beginAsInes()
{
    start();
    logIn("ines");
    QTRY_COMPARE_WITH_TIMEOUT(studentsShown(), 1, kPatienceMs);
}

void TestSchoolPages::theFirstAdminCreatesTheSchool()
{
    QVERIFY(QFile::remove(file()));
    start();
    QTRY_COMPARE_WITH_TIMEOUT(door(), Door::NewSchool, kPatienceMs);
    // A guest comes back to the same page, and may change no lessons.
    beGuest();
    actions().account->trigger();
    QCOMPARE(door(), Door::NewSchool);
    child<QLineEdit>("passwordAgain")->setText(QString::fromStdString(kPassword));
    typeLogin("nora");
    QTRY_COMPARE_WITH_TIMEOUT(actions().account->text(), QString("nora"), kPatienceMs);
    QCOMPARE(count("people WHERE role = 'admin'"), 1);
    openAdminPage(AdminPage::Backups);
    click("backUp");
    QTRY_VERIFY2_WITH_TIMEOUT(backupSaid().contains("whole"), qPrintable(backupSaid()), kPatienceMs);
}

void TestSchoolPages::whoMayNotStayIsLoggedOut_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("change");
    QTest::addColumn<bool>("byLongWork");
    QTest::addColumn<QString>("reason");
    QTest::newRow("a teacher is disabled") << "ines"
                                           << "disabled = 1" << false << "This account was disabled";
    QTest::newRow("an admin is disabled") << "admin"
                                          << "disabled = 1" << true << "This account was disabled";
    QTest::newRow("an admin is one no longer") << "admin"
                                               << "role = 'student'" << false << "Your role was changed";
}

void TestSchoolPages::whoMayNotStayIsLoggedOut()
{
    QFETCH(QString, name);
    QFETCH(QString, change);
    QFETCH(bool, byLongWork);
    QFETCH(QString, reason);
    start();
    logIn(name);
    if (name == "ines") {
        actions().classes->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(studentsShown(), 1, kPatienceMs);
    } else if (byLongWork) {
        openAdminPage(AdminPage::Backups);
        QTRY_VERIFY_WITH_TIMEOUT(child<QTableView>("backups")->model()->rowCount() > 0, kPatienceMs);
    } else {
        openAdminPage(AdminPage::People);
        QTRY_COMPARE_WITH_TIMEOUT(child<QTableView>("people")->model()->rowCount(), 4, kPatienceMs);
    }
    OtherStation(file()).execute("UPDATE people SET " + change + " WHERE username = '" + name + "'");
    if (byLongWork)
        click("checkAll");
    else
        actions().readAgain->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(isAtDoor() && door() == Door::Login, kPatienceMs);
    QVERIFY2(saidAtDoor().contains(reason), qPrintable(saidAtDoor()));
    if (change.startsWith("role")) {
        logIn(name);
        QVERIFY(!actions().school->isVisible());
    }
}

/// By the password that was known last; wrong ones make the same user wait, and nobody else.
void TestSchoolPages::theLockIsOpenedWithoutTheDatabase()
{
    const QString right = QString::fromStdString(kPassword);
    const auto setReachable = [this](bool reachable) {
        const QString away = file() + ".away";
        QVERIFY(reachable ? QFile::rename(away, file()) : QFile::rename(file(), away));
    };
    start();
    logIn("sam");
    goToTooth();
    setReachable(false);
    actions().lock->trigger();
    QCOMPARE(door(), Door::Locked);
    for (int k = 0; k < 4; ++k) {
        tryPassword("somebody else's");
        QVERIFY2(saidAtDoor().contains("Name or password is wrong"), qPrintable(saidAtDoor()));
        QVERIFY(isAtDoor());
    }
    tryPassword(right);
    QVERIFY2(saidAtDoor().contains("Too many logins have failed"), qPrintable(saidAtDoor()));
    const auto unlocks = [&] {
        if (isAtDoor())
            tryPassword(right);
        return !isAtDoor();
    };
    QTRY_VERIFY_WITH_TIMEOUT(unlocks(), kPatienceMs);
    QVERIFY(window().view().isVisible());
    // A login forgets the wrong ones before it.
    actions().lock->trigger();
    for (int k = 0; k < 3; ++k)
        tryPassword("somebody else's");
    setReachable(true);
    tryPassword(right);
    QVERIFY2(!isAtDoor(), qPrintable(saidAtDoor()));
    setReachable(false);
    actions().lock->trigger();
    tryPassword("a slip");
    tryPassword(right);
    QVERIFY2(!isAtDoor(), qPrintable(saidAtDoor()));
    // Nobody logs in without the database, and another user does not wait for the mistakes of the one before.
    actions().lock->trigger();
    for (int k = 0; k < 6; ++k)
        tryPassword("somebody else's");
    QVERIFY2(saidAtDoor().contains("Too many logins have failed"), qPrintable(saidAtDoor()));
    click("otherLogin");
    QTRY_COMPARE_WITH_TIMEOUT(door(), Door::Login, kPatienceMs);
    child<QLineEdit>("username")->setText("sam");
    tryPassword(right);
    QVERIFY(isAtDoor());
    setReachable(true);
    logIn("sue");
    // The school answers in order: by the time of the attempts, Sue's own password is known.
    actions().attempts->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::people::HistoryPage>()->isVisible(), kPatienceMs);
    setReachable(false);
    actions().lock->trigger();
    tryPassword(right);
    QVERIFY2(!isAtDoor(), qPrintable(saidAtDoor()));
}

/// A database that hangs gives no answer at all.
void TestSchoolPages::theLockIsOpenedWhileTheDatabaseHangs()
{
    sql::Database::Options patient;
    patient.patience = std::chrono::minutes(5);
    start(false, patient);
    logIn("sam");
    goToTooth();
    const OtherStation other(file());
    other.execute("BEGIN IMMEDIATE");
    actions().lock->trigger();
    tryPassword(QString::fromStdString(kPassword));
    QVERIFY2(!isAtDoor(), qPrintable(saidAtDoor()));
    // Lessons are files, and are read without it.
    window().setLessons({}, {});
    actions().lessons->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<QListView>("lessonList")->model()->rowCount() > 2, kPatienceMs);
    other.execute("ROLLBACK");
}

void TestSchoolPages::theOwnPasswordIsChanged()
{
    start();
    logIn("sam");
    const auto change = [this](const QString& old, const QString& next) {
        QTRY_VERIFY_WITH_TIMEOUT(child<QLineEdit>("oldPassword")->isEnabled(), kPatienceMs);
        child<QLineEdit>("oldPassword")->setText(old);
        child<QLineEdit>("password")->setText(next);
        child<QLineEdit>("passwordAgain")->setText(next);
        click("logIn");
    };
    const auto open = [this] {
        child<QMenu>("accountMenu")->findChild<QAction*>("ownPassword")->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(door(), Door::OwnPassword, kPatienceMs);
    };
    // From the menu it leads back to the page before; from the lock it does not.
    actions().lessons->trigger();
    open();
    actions().back->trigger();
    QVERIFY(child<ui::study::LessonsPage>()->isVisible());
    open();
    actions().lock->trigger();
    QCOMPARE(door(), Door::Locked);
    actions().back->trigger();
    QVERIFY(isAtDoor());
    click("changePassword");
    change("wrong", "battery staple");
    QTRY_VERIFY_WITH_TIMEOUT(child<QLineEdit>("oldPassword")->isEnabled(), kPatienceMs);
    QVERIFY(isAtDoor());
    change(QString::fromStdString(kPassword), "battery staple");
    QTRY_VERIFY_WITH_TIMEOUT(!isAtDoor(), kPatienceMs);
    QVERIFY(sql::Logins::login(OtherStation(file()).school, "sam", "battery staple"));
    QVERIFY(!sql::Logins::login(OtherStation(file()).school, "sam", kPassword));
}

/// By then somebody else may sit there.
void TestSchoolPages::aLateLoginLetsNobodyIn()
{
    start();
    QTRY_VERIFY_WITH_TIMEOUT(child<QLineEdit>("username")->isEnabled(), kPatienceMs);
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
    QTRY_COMPARE_WITH_TIMEOUT(count("audit WHERE action = 'login'"), before + 1, kPatienceMs);
    // The next login is answered after hers.
    actions().account->trigger();
    logIn("sam");
    QVERIFY2(!names.contains("sue"), qPrintable(names.join(u' ')));
}

void TestSchoolPages::nothingOpensOverTheLock()
{
    beginAsInes();
    goToTooth();
    actions().classes->trigger();
    actions().lock->trigger();
    QCOMPARE(door(), Door::Locked);
    // The wrong password is answered after the classes.
    tryPassword("somebody else's");
    QVERIFY(isAtDoor() && door() == Door::Locked);
    tryPassword(QString::fromStdString(kPassword));
    QTRY_VERIFY_WITH_TIMEOUT(child<ClassPage>()->isVisible(), kPatienceMs);
}

void TestSchoolPages::aLockedDatabaseIsTriedAgain()
{
    auto other = std::make_unique<OtherStation>(file());
    other->execute("PRAGMA locking_mode = EXCLUSIVE");
    other->execute("BEGIN EXCLUSIVE");
    sql::Database::Options opening;
    opening.patience = std::chrono::milliseconds(100);
    start(false, opening);
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("tryAgain")->isVisible(), kPatienceMs);
    QVERIFY(!child<QPushButton>("restoreBackup")->isVisible());
    QVERIFY2(saidAtDoor().contains("Another program is writing to the school's data"), qPrintable(saidAtDoor()));
    other.reset();
    click("tryAgain");
    QTRY_VERIFY_WITH_TIMEOUT(!child<QPushButton>("tryAgain")->isVisible(), kPatienceMs);
    logIn("sam");
}

/// The file was damaged while the window was open.
void TestSchoolPages::aBackupIsRestoredFromTheLogin()
{
    start();
    QTRY_COMPARE_WITH_TIMEOUT(backups().size(), 1, kPatienceMs);
    moveAway();
    QFile noise(file());
    QVERIFY(noise.open(QIODevice::WriteOnly) && noise.write(QByteArray(100'000, 'n')) == 100'000);
    noise.close();
    typeLogin("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("restoreBackup")->isVisible(), kPatienceMs);
    QVERIFY(child<QPushButton>("tryAgain")->isVisible() && child<QPushButton>("practiseAsGuest")->isEnabled());
    click("restoreBackup");
    QTRY_VERIFY2_WITH_TIMEOUT(saidAtDoor().contains("is in place"), qPrintable(saidAtDoor()), kPatienceMs);
    QCOMPARE(window().focusWidget(), child<QLineEdit>("username"));
    logIn("sam");
    QCOMPARE(count("audit WHERE action = 'backup.restored'"), 1);
}

void TestSchoolPages::anotherSchoolInItsPlaceLetsNobodyStay()
{
    const QString other = m_folder->filePath("other.sqlite");
    QVERIFY(sql::Logins::createFirstAdmin(OtherStation(other).school, {"admin", "", "", Role::Admin}, kPassword,
                                          support::SchoolRig::kCheap));
    beginAsInes();
    moveAway();
    QVERIFY(QFile::rename(other, file()));
    actions().classes->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(isAtDoor() && door() == Door::Login, kPatienceMs);
    QTRY_VERIFY2_WITH_TIMEOUT(saidAtDoor().contains("Another school is now where yours was"), qPrintable(saidAtDoor()),
                              kPatienceMs);
    logIn("admin");
    QCOMPARE(count("people"), 1);
}

/// A window may stay open for weeks.
void TestSchoolPages::eachDayHasItsBackup()
{
    start();
    QTRY_COMPARE_WITH_TIMEOUT(backups().size(), 1, kPatienceMs);
    QVERIFY(QFile::rename(backups().front(), sql::backupFolder(file()) + "/backup-2026-01-01-10.00.00.sqlite"));
    auto* watch = m_application->findChild<QTimer*>("backupWatch");
    QVERIFY(watch != nullptr && watch->isActive());
    const QSignalSpy looks(watch, &QTimer::timeout);
    watch->setInterval(2);
    QTRY_COMPARE_WITH_TIMEOUT(backups().size(), 2, kPatienceMs);
    const qsizetype before = looks.size();
    QTRY_VERIFY_WITH_TIMEOUT(looks.size() > before + 50, kPatienceMs);
    QCOMPARE(backups().size(), 2);
}

/// It is noted with the user, and a guest's on the computer.
void TestSchoolPages::theTourIsShownOnce()
{
    start(true);
    auto* tour = child<ui::shell::Tour>("tour");
    logIn("sam");
    QTRY_VERIFY_WITH_TIMEOUT(tour->isVisible(), kPatienceMs);
    // Whoever locks the window in the middle of it has not seen it.
    actions().lock->trigger();
    QVERIFY(!tour->isVisible());
    QCOMPARE(count("settings WHERE name = 'tour.seen'"), 0);
    tryPassword(QString::fromStdString(kPassword));
    switchTo("sue");
    QTRY_VERIFY_WITH_TIMEOUT(tour->isVisible(), kPatienceMs);
    actions().back->trigger();
    QVERIFY(!tour->isVisible());
    QTRY_COMPARE_WITH_TIMEOUT(count("settings WHERE name = 'tour.seen' AND value = 'yes'"), 1, kPatienceMs);
    // A teacher's begins with the classes, which are filled below it.
    switchTo("ines");
    QTRY_VERIFY_WITH_TIMEOUT(tour->isVisible(), kPatienceMs);
    QVERIFY(child<ClassPage>()->isVisible() && child<ClassPage>()->isAncestorOf(tour->target()));
    tour->next();
    QVERIFY(child<ui::study::LessonsPage>()->isVisible());
    while (tour->isVisible())
        tour->next();
    QTRY_COMPARE_WITH_TIMEOUT(count("settings WHERE name = 'tour.seen'"), 2, kPatienceMs);
    switchTo("sue");
    actions().attempts->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::people::HistoryPage>()->isVisible(), kPatienceMs);
    QVERIFY(!tour->isVisible());
    actions().tour->trigger();
    QVERIFY(tour->isVisible());
    tour->end();
    logOut();
    for (const bool isFirst : {true, false}) {
        beGuest();
        QCOMPARE(tour->isVisible(), isFirst);
        tour->end();
        actions().account->trigger();
    }
}

void TestSchoolPages::aClassIsSeenByItsTeachersOnly()
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
    QTRY_COMPARE_WITH_TIMEOUT(attempts->rowCount(), 1, kPatienceMs);
    logOut();
    QCOMPARE(studentsShown(), 0);
    QCOMPARE(attempts->rowCount(), 0);
    logIn("otto");
    QTRY_VERIFY_WITH_TIMEOUT(empty->isVisible() && empty->text().contains(noClass), kPatienceMs);
    QCOMPARE(studentsShown(), 0);
    QVERIFY(labelWith("sam") == nullptr);
    // A teacher who is taken out of the class adds no comment, reads why, and sees it no longer.
    switchTo("ines");
    openStudent();
    openNewest();
    auto* const words = child<QPlainTextEdit>("commentWords");
    QTRY_VERIFY_WITH_TIMEOUT(words->isVisible(), kPatienceMs);
    words->setPlainText("A sentence");
    click("addComment");
    QTRY_VERIFY_WITH_TIMEOUT(words->toPlainText().isEmpty(), kPatienceMs);
    words->setPlainText("Half a sentence");
    OtherStation(file()).execute(
        "DELETE FROM enrolments WHERE person_id = (SELECT id FROM people WHERE username = 'ines')");
    click("addComment");
    const auto* const fault = child<ui::people::TalkPanel>()->findChild<QLabel*>("fault");
    QTRY_VERIFY_WITH_TIMEOUT(fault->isVisible(), kPatienceMs);
    QVERIFY2(fault->text().contains("in none of your classes any more"), qPrintable(fault->text()));
    QCOMPARE(words->toPlainText(), QString("Half a sentence"));
    QCOMPARE(count("comments"), 1);
    words->clear();
    goBackTo<ClassPage>();
    actions().readAgain->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(studentsShown(), 0, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(empty->text().contains(noClass), kPatienceMs);
}

/// It leaves the school with names and scores. It is of the class that was shown when it was asked for.
void TestSchoolPages::aClassReportIsNoted()
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
    const auto noted = [this] { return count("audit WHERE action = 'class.export'"); };
    const QString table = m_folder->filePath("class.csv");
    emit child<ClassPage>()->tableWanted(table);
    auto* const classes = child<QComboBox>("classChooser");
    classes->setCurrentIndex(classes->findText("DEN102-B", Qt::MatchStartsWith));
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(table), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(matrix->rowCount() == 1 && student().startsWith("sue"), kPatienceMs);
    QFile written(table);
    QVERIFY(written.open(QIODevice::ReadOnly) && written.readAll().contains("sam"));
    QCOMPARE(noted(), 1);
    QCOMPARE(OtherStation(file())
                 .ask("SELECT classes.name FROM audit JOIN classes ON audit.object = 'class:' || classes.id "
                      "WHERE action = 'class.export'")
                 .toString(),
             QString("DEN101-A"));
    QVERIFY(!(QFile::permissions(table) & (QFile::ReadGroup | QFile::ReadOther)));
    // A report that is not printed has not left the school.
    emit child<ClassPage>()->printWanted();
    const auto printing = [this]() -> QDialog* {
        for (auto* dialog : window().findChildren<QDialog*>())
            if (dialog->inherits("QPrintDialog"))
                return dialog;
        return nullptr;
    };
    QTRY_VERIFY_WITH_TIMEOUT(printing() != nullptr || labelWith("There is no printer") != nullptr, kPatienceMs);
    if (printing() != nullptr)
        printing()->reject();
    actions().readAgain->trigger();
    QCOMPARE(noted(), 1);
}

void TestSchoolPages::anotherScoreIsNotOverruledUnseen()
{
    deliverAttempt();
    beginAsInes();
    openStudent();
    openNewest();
    auto* const talk = child<ui::people::TalkPanel>();
    auto* const points = talk->findChild<QDoubleSpinBox*>("givenPoints");
    auto* const reason = talk->findChild<QLineEdit*>("reason");
    QTRY_VERIFY_WITH_TIMEOUT(reason->isVisible(), kPatienceMs);
    points->setValue(55.5);
    reason->setText("not so neat");
    const auto giveElsewhere = [this](int tenths) {
        const OtherStation elsewhere(file());
        const auto id = elsewhere.ask("SELECT max(id) FROM attempts").toLongLong();
        QVERIFY(sql::overrideScore(elsewhere.school, elsewhere.logIn("ines"), {id}, tenths, "neat"));
    };
    giveElsewhere(910);
    click("giveScore");
    const auto* const fault = talk->findChild<QLabel*>("fault");
    QTRY_VERIFY_WITH_TIMEOUT(fault->isVisible(), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(talk->findChild<QLabel*>("counts")->text().contains("91.0"), kPatienceMs);
    // What was typed stays, to be given again or not.
    QCOMPARE(points->value(), 55.5);
    QCOMPARE(reason->text(), QString("not so neat"));
    QCOMPARE(count("overrides"), 1);
    click("giveScore");
    QTRY_COMPARE_WITH_TIMEOUT(count("overrides"), 2, kPatienceMs);
    // F5 reads the list anew.
    const auto listed = [this] {
        return child<QTableView>("attempts")->model()->index(0, ui::people::HistoryModel::Score).data().toString();
    };
    QTRY_COMPARE_WITH_TIMEOUT(listed(), QString("55.5"), kPatienceMs);
    goBackTo<ui::people::HistoryPage>();
    giveElsewhere(730);
    actions().readAgain->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(listed(), QString("73.0"), kPatienceMs);
}

void TestSchoolPages::withoutItsRecordingAnAttemptIsOpenedAndOverruled_data()
{
    QTest::addColumn<QString>("recordingHash");
    QTest::addColumn<bool>("hasSheet");
    QTest::newRow("its file has gone") << QString(64, 'd') << true;
    QTest::newRow("none was saved") << "" << true;
    QTest::newRow("nor a sheet, as in a sample school") << "" << false;
}

/// From its score sheet, as it was scored.
void TestSchoolPages::withoutItsRecordingAnAttemptIsOpenedAndOverruled()
{
    QFETCH(QString, recordingHash);
    QFETCH(bool, hasSheet);
    const lessons::ScoreSheet scored = deliverAttempt(recordingHash.toStdString(), hasSheet);
    beginAsInes();
    openStudent();
    openNewest();
    const auto* const page = child<ui::study::ScorePage>();
    QCOMPARE(page->person(), QString("sam Student"));
    const lessons::ScoreSheet shown = page->card().sheet;
    if (hasSheet)
        QVERIFY(shown == scored);
    QCOMPARE(shown.totalTenths, scored.totalTenths);
    QCOMPARE(shown.criteria.size(), scored.criteria.size());
    for (std::size_t k = 0; k < scored.criteria.size(); ++k) {
        QCOMPARE(shown.criteria[k].lostTenths, scored.criteria[k].lostTenths);
        QCOMPARE(ui::text::criterionWorked(shown.criteria[k], shown.verdict).contains("not stored"), !hasSheet);
    }
    const auto* const unrecorded = child<QLabel>("unrecorded");
    QVERIFY2(unrecorded->isVisible(), qPrintable(unrecorded->text()));
    QVERIFY(!child<QPushButton>("replayScored")->isVisible() && !child<ui::study::HeatMap>()->isVisible());
    child<QPlainTextEdit>("commentWords")->setPlainText("Do it again.");
    click("addComment");
    QTRY_COMPARE_WITH_TIMEOUT(count("comments"), 1, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(child<QPlainTextEdit>("commentWords")->toPlainText().isEmpty(), kPatienceMs);
    child<QDoubleSpinBox>("givenPoints")->setValue(91.5);
    child<QLineEdit>("reason")->setText("Seen by hand.");
    click("giveScore");
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("counts")->text().contains("91.5"), kPatienceMs);
    QCOMPARE(count("overrides"), 1);
    QCOMPARE(page->card().sheet.totalTenths, scored.totalTenths);
    savePdf(m_folder->filePath("old.pdf"));
    switchTo("sam");
    actions().attempts->trigger();
    openNewest();
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("counts")->text().contains("91.5"), kPatienceMs);
    QVERIFY(unrecorded->isVisible());
}

void TestSchoolPages::lessonsAreChangedByTeachers()
{
    const auto mayEdit = [this] { return actions().editLesson->isVisible() && actions().editLesson->isEnabled(); };
    start();
    logIn("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<QListView>("lessonList")->model()->rowCount() > 2, kPatienceMs);
    QVERIFY(!actions().editLesson->isVisible() && !actions().editLesson->isEnabled());
    switchTo("ines");
    QTRY_VERIFY_WITH_TIMEOUT(child<ClassPage>()->isVisible(), kPatienceMs);  // where a teacher begins
    actions().lessons->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(mayEdit(), kPatienceMs);
    logOut();
    beGuest();
    actions().lessons->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::LessonsPage>()->isVisible(), kPatienceMs);
    QVERIFY(!actions().editLesson->isVisible() && !actions().editLesson->isEnabled());
}

void TestSchoolPages::aTeacherAssignsLessonsAndTakesThemBack()
{
    beginAsInes();
    const auto openAssignments = [this] {
        click("assignLessons");
        QTRY_VERIFY_WITH_TIMEOUT(child<ui::people::AssignPage>()->isVisible(), kPatienceMs);
    };
    const auto* given = child<QTableView>("given")->model();
    openAssignments();
    auto* offers = child<QListView>("offers")->model();
    QVERIFY(offers->rowCount() > 10);
    for (const int row : {1, 2})
        QVERIFY(offers->setData(offers->index(row, 0), Qt::Checked, Qt::CheckStateRole));
    click("assignTicked");
    QTRY_COMPARE_WITH_TIMEOUT(given->rowCount(), 2, kPatienceMs);
    QCOMPARE(count("assignments"), 2);
    actions().back->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(child<QTableView>("matrix")->model()->columnCount(), 3, kPatienceMs);
    openAssignments();
    click("undoAssign");
    QTRY_COMPARE_WITH_TIMEOUT(given->rowCount(), 0, kPatienceMs);
    QCOMPARE(count("assignments"), 0);
}

/// One has begun to type when the other saves.
void TestSchoolPages::twoAdminsUndoNothingOfEachOther()
{
    start();
    logIn("admin");
    openAdminPage(AdminPage::People);
    choosePerson("sam");
    QTest::keyClicks(child<QLineEdit>("personGiven"), "X");
    const OtherStation elsewhere(file());
    const auto other = elsewhere.logIn("admin");
    Person sam = sql::findPerson(elsewhere.school, other, "sam").value();
    sam.role = Role::Instructor;
    QVERIFY(sql::changePerson(elsewhere.school, other, sam));
    const ClassId next = sql::addClass(elsewhere.school, other, "DEN102-B").value();
    const ClassId before = sql::listClasses(elsewhere.school, other).value().front().id;
    QVERIFY(sql::enrol(elsewhere.school, other, next, sam.id, true));
    QVERIFY(sql::enrol(elsewhere.school, other, before, sam.id, false));
    actions().readAgain->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(child<QListWidget>("personClasses")->count(), 2, kPatienceMs);
    click("savePerson");
    const auto samNow = [&] {
        const auto all = sql::listPeople(elsewhere.school, other).value();
        return *std::find_if(all.begin(), all.end(), [](const Person& one) { return one.username == "sam"; });
    };
    QTRY_COMPARE_WITH_TIMEOUT(samNow().givenName, std::string("samX"), kPatienceMs);
    QCOMPARE(samNow().role, Role::Instructor);
    QCOMPARE(samNow().classes, std::vector<ClassId>{next});
}

void TestSchoolPages::aPresetIsRetiredAndTakenUpAgain()
{
    for (const char* name : {"junk", "hard"}) {
        const OtherStation elsewhere(file());
        const auto admin = elsewhere.logIn("admin");
        core::settings::FeelPreset preset = lessons::shippedPresets().front();
        preset.name = name;
        preset.enamelRate *= 0.5;
        preset = lessons::hashed(preset);
        const QByteArray json = QJsonDocument(lessons::toJson(preset)).toJson(QJsonDocument::Compact);
        QVERIFY(
            sql::addPreset(elsewhere.school, admin, {preset.name, preset.version, preset.hash, json.toStdString()}));
        QVERIFY(sql::changeSetting(elsewhere.school, admin, "preset.in_use", preset.name + " v1"));
    }
    start();
    logIn("admin");
    const auto* list = child<QListWidget>("presetList");
    const auto rowOf = [list](const QString& name) {
        for (int row = 0; row < list->count(); ++row)
            if (list->item(row)->text().startsWith(name))
                return row;
        return -1;
    };
    const auto choose = [&](const QString& name) {
        actions().presets->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(rowOf(name) >= 0, kPatienceMs);
        child<QListWidget>("presetList")->setCurrentRow(rowOf(name));
    };
    auto* retire = child<QPushButton>("presetRetire");
    for (const char* name : {"hard", "natural"}) {  // in use, and shipped
        choose(name);
        QVERIFY(!retire->isEnabled());
    }
    choose("junk");
    click("presetRetire");
    QTRY_VERIFY_WITH_TIMEOUT(list->item(rowOf("junk"))->text().contains("retired"), kPatienceMs);
    QVERIFY(!child<QPushButton>("presetUse")->isEnabled());
    switchTo("sam");
    choose("hard");
    QTRY_VERIFY_WITH_TIMEOUT(rowOf("junk") < 0, kPatienceMs);
    QVERIFY(!retire->isVisible());
    switchTo("admin");
    choose("junk");
    click("presetRetire");
    QTRY_COMPARE_WITH_TIMEOUT(count("settings WHERE name = 'preset.retired' AND value = ''"), 1, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("presetUse")->isEnabled(), kPatienceMs);
}

void TestSchoolPages::anAdminEntersAndChangesPeople()
{
    start();
    logIn("sam");
    QVERIFY(!actions().school->isVisible());
    switchTo("admin");
    QTRY_VERIFY_WITH_TIMEOUT(child<AdminPage>()->isVisible(), kPatienceMs);  // where an admin begins
    openAdminPage(AdminPage::People);
    const auto* people = child<QTableView>("people")->model();
    QTRY_COMPARE_WITH_TIMEOUT(people->rowCount(), 4, kPatienceMs);
    const OtherStation elsewhere(file());
    const sql::School& school = elsewhere.school;
    const auto* const fault = child<QLabel>("personFault");
    const auto* const code = child<QLabel>("oneTimeCode");
    // A new user, in a class, with a code that is good for one login.
    click("newPerson");
    child<QLineEdit>("personUsername")->setText("tom");
    child<QLineEdit>("personFamily")->setText("Three");
    auto* classes = child<QListWidget>("personClasses");
    QTRY_COMPARE_WITH_TIMEOUT(classes->count(), 1, kPatienceMs);
    classes->item(0)->setCheckState(Qt::Checked);
    click("savePerson");
    QTRY_VERIFY_WITH_TIMEOUT(code->isVisible(), kPatienceMs);
    const QString tomsCode = code->text();
    QTRY_COMPARE_WITH_TIMEOUT(people->rowCount(), 5, kPatienceMs);
    QCOMPARE(count("enrolments"), 3);
    click("newPerson");
    child<QLineEdit>("personUsername")->setText("tom");
    click("savePerson");
    QTRY_VERIFY_WITH_TIMEOUT(fault->text().contains("taken"), kPatienceMs);
    child<QLineEdit>("personUsername")->clear();
    // The only admin cannot be disabled.
    choosePerson("admin");
    clickTwice("disablePerson");
    QTRY_VERIFY2_WITH_TIMEOUT(fault->text().contains("the last admin"), qPrintable(fault->text()), kPatienceMs);
    // A password is reset neither by one click nor by a double click. Esc cancels, and the page stays.
    choosePerson("sue");
    QVERIFY(!code->isVisible());
    click("resetPassword");
    click("resetPassword");
    QTest::keyClick(child<QPushButton>("keepAsItIs"), Qt::Key_Escape);
    QVERIFY(!child<QPushButton>("keepAsItIs")->isVisible() && child<AdminPage>()->isVisible());
    QVERIFY(sql::Logins::login(school, "sue", kPassword));
    clickTwice("resetPassword");
    QTRY_VERIFY_WITH_TIMEOUT(code->isVisible(), kPatienceMs);
    QVERIFY(!sql::Logins::login(school, "sue", kPassword));
    // The code of a disabled user is not shown.
    click("disablePerson");
    QTRY_COMPARE_WITH_TIMEOUT(child<QPushButton>("disablePerson")->text(), QString("Enable"), kPatienceMs);
    QVERIFY(!code->isVisible());
    QVERIFY(sql::findPerson(school, elsewhere.logIn("admin"), "sue")->disabled);
    // Classes.
    child<QLineEdit>("className")->setText("DEN|102");
    click("addClass");
    QTRY_VERIFY_WITH_TIMEOUT(fault->text().contains("|"), kPatienceMs);
    child<QLineEdit>("className")->setText("DEN102");
    click("addClass");
    QTRY_COMPARE_WITH_TIMEOUT(classes->count(), 2, kPatienceMs);
    // The new class is ticked for sue, which is not saved.
    choosePerson("tom");
    click("questionDiscard");
    QCOMPARE(classes->item(0)->checkState(), Qt::Checked);
    classes->item(0)->setCheckState(Qt::Unchecked);
    child<QLineEdit>("personGiven")->setText("Tom");
    click("savePerson");
    QTRY_COMPARE_WITH_TIMEOUT(count("enrolments"), 2, kPatienceMs);
    QCOMPARE(sql::findPerson(school, elsewhere.logIn("admin"), "tom")->fullName(), std::string("Tom Three"));
    QVERIFY(sql::Logins::redeem(school, "tom", tomsCode.toStdString(), kPassword));
}

void TestSchoolPages::aClassListIsSeenBeforeItIsEntered()
{
    start();
    logIn("admin");
    openAdminPage(AdminPage::Roster);
    const auto said = [this] { return child<QLabel>("rosterSaid")->text() + child<QLabel>("rosterFault")->text(); };
    const auto* rows = child<QTableView>("roster")->model();
    const auto choose = [&](const QByteArray& lines, const QString& answer) {
        const QString path = m_folder->filePath("class.csv");
        QFile list(path);
        QVERIFY(list.open(QIODevice::WriteOnly));
        list.write(lines);
        list.close();
        emit child<ui::admin::RosterPart>()->fileChosen(path);
        QTRY_VERIFY2_WITH_TIMEOUT(said().contains(answer), qPrintable(said()), kPatienceMs);
    };
    const QByteArray begin = "username,given_name,family_name,role,class\nsam,Sam,One,student,DEN101-A\n";
    choose(begin + "!!,X,Y,student,DEN101-A\n", "1 fault");
    QCOMPARE(rows->index(0, 0).data().toString(), QString("3"));
    QVERIFY(!child<QPushButton>("enterRoster")->isVisible());
    choose(begin + "new1,N,Ew,student,DEN103\n", "1 new person");
    QCOMPARE(count("people"), 4);
    // Somebody else enters the same username meanwhile, whose name the list would change.
    {
        const OtherStation elsewhere(file());
        const auto admin = elsewhere.logIn("admin");
        QVERIFY(sql::addPerson(elsewhere.school, admin, {"new1", "Otto", "Other", Role::Student}));
    }
    click("enterRoster");
    QTRY_VERIFY2_WITH_TIMEOUT(said().contains("Nothing was entered"), qPrintable(said()), kPatienceMs);
    QCOMPARE(count("people WHERE given_name = 'Otto'"), 1);
    QVERIFY(rows->index(1, 4).data().toString().contains("Otto Other"));
    choose(begin + "new2,N,Ew,student,DEN103\n", "1 new person");
    click("enterRoster");
    QTRY_COMPARE_WITH_TIMEOUT(count("people"), 6, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("saveCodes")->isVisible(), kPatienceMs);
    emit child<ui::admin::RosterPart>()->fileChosen(m_folder->filePath("nothing.csv"));
    QTRY_VERIFY2_WITH_TIMEOUT(said().contains("cannot be read"), qPrintable(said()), kPatienceMs);
}

void TestSchoolPages::aBackupIsMadeCheckedAndRestored()
{
    start();
    logIn("admin");
    openAdminPage(AdminPage::Backups);
    const auto* rows = child<QTableView>("backups")->model();
    QTRY_COMPARE_WITH_TIMEOUT(rows->rowCount(), 1, kPatienceMs);  // today's
    const auto doAndWait = [this](const char* button, const QString& words) {
        click(button);
        QTRY_VERIFY2_WITH_TIMEOUT(backupSaid().contains(words), qPrintable(backupSaid()), kPatienceMs);
    };
    // The names of backups differ by the second.
    QVERIFY(QFile::rename(backups().front(), sql::backupFolder(file()) + "/backup-2026-01-01-10.00.00.sqlite"));
    doAndWait("backUp", "Its pages and keys are whole");
    QTRY_COMPARE_WITH_TIMEOUT(rows->rowCount(), 2, kPatienceMs);
    QVERIFY(!child<QPushButton>("restoreThis")->isEnabled());
    doAndWait("checkAll", "Nothing is wrong");
    // With the audit code of a report: no code, the present one, and a wrong one.
    auto* code = child<QLineEdit>("reportCode");
    code->setText("412");
    click("checkAll");
    QVERIFY(child<QLabel>("reportCodeFault")->isVisible());
    const QString head =
        OtherStation(file()).ask("SELECT seq || '-' || substr(hash, 1, 12) FROM audit_seal").toString();
    code->setText(' ' + head.toUpper());
    QVERIFY(!child<QLabel>("reportCodeFault")->isVisible());
    doAndWait("checkAll", head.toUpper());
    code->setText("3-000000000000");
    doAndWait("checkAll", "1 thing");
    QVERIFY(child<QPlainTextEdit>("findings")->isVisible());
    code->clear();
    // A user who is entered after the backup is gone with the restore, which is asked about.
    child<AdminPage>()->show(AdminPage::People);
    choosePerson("sam");
    click("newPerson");
    child<QLineEdit>("personUsername")->setText("tom");
    click("savePerson");
    QTRY_COMPARE_WITH_TIMEOUT(count("people"), 5, kPatienceMs);
    child<AdminPage>()->show(AdminPage::Backups);
    child<QTableView>("backups")->setCurrentIndex(rows->index(0, 0));
    click("restoreThis");
    QTest::keyClick(child<QPushButton>("keepPresent"), Qt::Key_Escape);
    QVERIFY(child<AdminPage>()->isVisible() && !child<QPushButton>("keepPresent")->isVisible());
    clickTwice("restoreThis");
    QTRY_VERIFY2_WITH_TIMEOUT(saidAtDoor().contains("is in place"), qPrintable(saidAtDoor()), kPatienceMs);
    QCOMPARE(count("people"), 4);
    QCOMPARE(count("audit a JOIN people p ON p.uid = a.actor "
                   "WHERE a.action = 'backup.restored' AND p.username = 'admin'"),
             1);
    logIn("admin");
}

/// Nobody is logged out if the restore is refused, or if the admin who asked for it has left.
void TestSchoolPages::aRestoreLogsOutNobodyElse()
{
    start();
    logIn("admin");
    openAdminPage(AdminPage::Backups);
    QTRY_COMPARE_WITH_TIMEOUT(child<QTableView>("backups")->model()->rowCount(), 1, kPatienceMs);  // today's
    {
        const OtherStation elsewhere(file());
        emit child<ui::admin::BackupPart>()->restoreWanted(backups().front());
        QTRY_VERIFY2_WITH_TIMEOUT(backupSaid().contains("was not restored"), qPrintable(backupSaid()), kPatienceMs);
        QVERIFY(!isAtDoor());
        QCOMPARE(actions().account->text(), QString("admin"));
    }
    emit child<ui::admin::BackupPart>()->restoreWanted(backups().front());
    logOut();  // before the backup has been looked at
    logIn("sam");
    QTRY_VERIFY2_WITH_TIMEOUT(backupSaid().isEmpty(), qPrintable(backupSaid()), kPatienceMs);
    QCOMPARE(actions().account->text(), QString("sam"));
    QVERIFY(!isAtDoor());
    QCOMPARE(count("audit WHERE action = 'backup.restored'"), 0);
}

/// The one connection that such a file allows does everything.
void TestSchoolPages::aNetworkDriveIsForOneAndIsBackedUp()
{
    deliverAttempt();
    sql::Database::Options opening;
    opening.fileSystemOf = [](const QString&) { return FileSystem::Network; };
    opening.patience = std::chrono::milliseconds(200);
    start(false, opening);
    logIn("sam");
    const auto other = sql::Database::open(file(), std::chrono::milliseconds(50));
    QVERIFY(!other.has_value() && other.error().code == core::ErrorCode::Busy);
    switchTo("admin");
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("network drive"), qPrintable(message()), kPatienceMs);
    openAdminPage(AdminPage::Backups);
    QTRY_COMPARE_WITH_TIMEOUT(backups().size(), 1, kPatienceMs);
    for (const auto& [button, words] :
         {std::pair{"backUp", "Its pages and keys are whole"}, std::pair{"checkAll", "Nothing is wrong: 1 attempts"}}) {
        click(button);
        QTRY_VERIFY2_WITH_TIMEOUT(backupSaid().contains(words), qPrintable(backupSaid()), kPatienceMs);
    }
}

/// Also among more attempts than are read at once.
void TestSchoolPages::theAuditShowsWhatWasDone()
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
    start();
    logIn("admin");
    openAdminPage(AdminPage::Audit);
    const auto* rows = child<QTableView>("audit")->model();
    auto* search = child<QLineEdit>("auditSearch");
    const auto actionAt = [rows](int row) { return rows->index(row, 3).data().toString(); };
    QTRY_COMPARE_WITH_TIMEOUT(rows->rowCount(), 500, kPatienceMs);
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
    QTRY_COMPARE_WITH_TIMEOUT(rows->rowCount(), count("audit WHERE action = 'person.add'"), kPatienceMs);
    QVERIFY(rows->rowCount() >= 3);
    QVERIFY(!child<QPushButton>("olderAudit")->isEnabled());
    search->clear();
    // With attempts again, and older rows that are asked for twice come once. The newest that is shown counts: the cost
    // of passwords may be raised meanwhile.
    child<QAbstractButton>("auditNoAttempts")->click();
    QTRY_COMPARE_WITH_TIMEOUT(rows->rowCount(), 500, kPatienceMs);
    click("olderAudit");
    click("olderAudit");
    QTRY_VERIFY_WITH_TIMEOUT(!child<QPushButton>("olderAudit")->isEnabled(), kPatienceMs);
    QCOMPARE(rows->rowCount(), count("audit WHERE seq <= " + rows->index(0, 0).data().toString()));
    // A setting of the station, and its row in the audit.
    openAdminPage(AdminPage::Station);
    auto* idle = child<QSpinBox>("idleMinutes");
    QTRY_VERIFY_WITH_TIMEOUT(labelWith("On their way") != nullptr, kPatienceMs);
    idle->setValue(3);
    emit idle->editingFinished();
    QTRY_COMPARE_WITH_TIMEOUT(count("settings WHERE name = 'idle.minutes' AND value = '3'"), 1, kPatienceMs);
}

int main(int argc, char** argv)
{
    return support::openGlMain<TestSchoolPages>(argc, argv);
}

#include "tst_school_pages.moc"
