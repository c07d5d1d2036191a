// SPDX-License-Identifier: GPL-3.0-or-later
// The whole program at the door: who comes in, who is shown out, and what if the database is damaged, gone or locked.
#include <QAction>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QPushButton>
#include <QSqlQuery>
#include <QTableView>
#include <QTest>

#include "app/Application.h"
#include "database/sql/Backups.h"
#include "database/sql/Logins.h"
#include "database/sql/Statement.h"
#include "tests/app/SchoolWindow.h"
#include "tests/support/OpenGlMain.h"
#include "ui/admin/AdminPage.h"
#include "ui/people/ClassPage.h"
#include "ui/people/HistoryPage.h"
#include "ui/people/LoginPage.h"
#include "ui/shell/Tour.h"
#include "ui/study/LessonsPage.h"
#include "ui/tooth/ToothView.h"

using namespace database;
using support::kPassword;
using support::kPatienceMs;
using support::OtherStation;
using ui::people::Door;

class TestSchoolDoor : public support::SchoolWindow
{
    Q_OBJECT
private slots:
    void init() { makeSchool(); }
    void cleanup() { m_application.reset(); }

    void aDatabaseIsRestoredFromTheDoor_data();
    void aDatabaseIsRestoredFromTheDoor();
    void aFileThatBecameNoiseIsRestoredFromTheDoor();
    void anotherSchoolInItsPlaceLetsNobodyStay();
    void aSchoolWithoutPeopleIsNotBackedUp();
    void aLockedDatabaseIsTriedAgain();
    void aFileThatIsMovedAwayIsMissed();
    void whoIsDisabledIsShownOut();
    void whoLeftHisPlaceComesBackWithoutTheDatabase();
    void aLoginForgetsWhatWasMistyped();
    void whoWasLateToCreateTheSchoolIsAGuestOfIt();
    void aLateAnswerLetsNobodyIn();
    void nobodyWaitsAtTheDoorForEver();
    void eachDayHasItsBackup();
    void whoIsDisabledIsShownOutByLongWork();
    void whoseRoleWasChangedIsShownOut();
    void aLateAnswerTearsNobodyAway();
    void theDatabaseIsNamedWithItsWholePath();
    void onesOwnPasswordIsChanged();
    void everybodyIsShownRoundOnce();
    void aTeachersTourBeginsWithHisClasses();

private:
    /// The school's file, and what lies beside it, under the window.
    void moveAway() const
    {
        for (const char* end : {"", "-wal", "-shm"})
            QFile::rename(file() + end, m_folder->filePath(QStringLiteral("away.sqlite")) + end);
    }
};

void TestSchoolDoor::aDatabaseIsRestoredFromTheDoor_data()
{
    QTest::addColumn<bool>("isGone");
    QTest::newRow("noise in its place") << false;
    QTest::newRow("gone") << true;
}

/// What was delivered after the backup is delivered again.
void TestSchoolDoor::aDatabaseIsRestoredFromTheDoor()
{
    QFETCH(bool, isGone);
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    grade("first grade");
    {
        const auto database = sql::Database::open(file()).value();
        QVERIFY(sql::backUp(database->handle(), sql::backupFolder(file()), QDateTime::currentDateTimeUtc()));
    }
    actions().back->trigger();
    drill(2.0);
    grade("");
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 2, kPatienceMs);
    m_application.reset();

    QFile database(file());
    if (isGone)
        QVERIFY(database.remove());
    else {
        QVERIFY(database.open(QIODevice::WriteOnly));
        database.write(QByteArray(100'000, 'n'));
        database.close();
    }
    start();
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("restoreBackup")->isVisible(), kPatienceMs);
    QCOMPARE(child<QPushButton>("tryAgain")->isVisible(), !isGone);
    if (isGone)
        QCOMPARE(door(), Door::NewSchool);
    // Meanwhile one can practise.
    QVERIFY(child<QPushButton>("practiseAsGuest")->isEnabled());
    click("restoreBackup");
    QTRY_VERIFY_WITH_TIMEOUT(!child<QPushButton>("restoreBackup")->isVisible(), kPatienceMs);
    QCOMPARE(door(), Door::Login);
    const QStringList replaced = QDir(m_folder->path()).entryList({"replaced-*.sqlite"}, QDir::Files);
    // Where it was gone, an empty one had been begun.
    QCOMPARE(replaced.size(), 1);
    QTRY_VERIFY2_WITH_TIMEOUT(saidAtDoor().contains("is in place"), qPrintable(saidAtDoor()), kPatienceMs);
    QCOMPARE(m_application->window().focusWidget(), child<QLineEdit>("username"));  // one logs in next
    QVERIFY2(saidAtDoor().contains("is kept beside it as " + replaced.value(0)), qPrintable(saidAtDoor()));
    logIn("sam");
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 2, kPatienceMs);
    QStringList noted;
    QVERIFY(sql::forEach(sql::Database::open(file()).value()->handle(),
                         "SELECT object FROM audit WHERE action = 'backup.restored'", "read it", {},
                         [&](const QSqlQuery& row) { noted += row.value(0).toString(); }));
    QCOMPARE(noted.size(), 1);
    QVERIFY2(noted.front().startsWith("backup:backup-"), qPrintable(noted.front()));
}

/// While the window stood open.
void TestSchoolDoor::aFileThatBecameNoiseIsRestoredFromTheDoor()
{
    start();
    QTRY_COMPARE_WITH_TIMEOUT(sql::backupsIn(sql::backupFolder(file())).size(), 1, kPatienceMs);
    moveAway();
    QFile noise(file());
    QVERIFY(noise.open(QIODevice::WriteOnly) && noise.write(QByteArray(100'000, 'n')) == 100'000);
    noise.close();
    child<QLineEdit>("username")->setText("sam");
    child<QLineEdit>("password")->setText(QString::fromStdString(kPassword));
    click("logIn");
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("restoreBackup")->isVisible(), kPatienceMs);
    QVERIFY(child<QPushButton>("tryAgain")->isVisible());
    QCOMPARE(saidAtDoor().count("no database of Cusp"), 1);
    click("restoreBackup");
    QTRY_VERIFY2_WITH_TIMEOUT(saidAtDoor().contains("is in place"), qPrintable(saidAtDoor()), kPatienceMs);
    logIn("sam");
}

/// Who has logged in to one is nobody in another.
void TestSchoolDoor::anotherSchoolInItsPlaceLetsNobodyStay()
{
    const QString other = m_folder->filePath("other.sqlite");
    {
        const OtherStation elsewhere(other);
        QVERIFY(sql::Logins::createFirstAdmin(elsewhere.school, {"admin", "", "", database::Role::Admin}, kPassword,
                                              {1, 8192}));
    }
    start();
    logIn("ines");
    moveAway();
    QVERIFY(QFile::rename(other, file()));
    actions().classes->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(m_application->window().isAtDoor() && door() == Door::Login, kPatienceMs);
    QTRY_VERIFY2_WITH_TIMEOUT(saidAtDoor().contains("Another school is now where yours was"), qPrintable(saidAtDoor()),
                              kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(!child<QPushButton>("tryAgain")->isVisible(), kPatienceMs);
    logIn("admin");
    QCOMPARE(count("people"), 1);
}

/// Its backup would be offered for restoring, and put an empty school in the place of a full one.
void TestSchoolDoor::aSchoolWithoutPeopleIsNotBackedUp()
{
    QVERIFY(QFile::remove(file()));
    start();
    QTRY_COMPARE_WITH_TIMEOUT(door(), Door::NewSchool, kPatienceMs);
    // Who has only practised comes back to where the school is created.
    click("practiseAsGuest");
    QTRY_VERIFY_WITH_TIMEOUT(!m_application->window().isAtDoor(), kPatienceMs);
    actions().account->trigger();
    QCOMPARE(door(), Door::NewSchool);
    child<QLineEdit>("username")->setText("nora");
    child<QLineEdit>("password")->setText(QString::fromStdString(kPassword));
    child<QLineEdit>("passwordAgain")->setText(QString::fromStdString(kPassword));
    click("logIn");
    QTRY_COMPARE_WITH_TIMEOUT(actions().account->text(), QString("nora"), kPatienceMs);
    // As a terminal makes one of whatever there is.
    const QString folder = sql::backupFolder(file());
    const QString elsewhere = m_folder->filePath("empty.sqlite");
    QVERIFY(sql::backUp(sql::Database::open(elsewhere).value()->handle(), folder,
                        QDateTime::currentDateTimeUtc().addDays(-1)));
    openSchool(ui::admin::AdminPage::Backups);
    click("backUp");
    const auto said = [this] { return child<QLabel>("backupSaid")->text(); };
    QTRY_VERIFY2_WITH_TIMEOUT(said().contains("Its pages and keys are whole"), qPrintable(said()), kPatienceMs);
    QCOMPARE(sql::backupsIn(folder).size(), 2);
    QTRY_COMPARE_WITH_TIMEOUT(child<QTableView>("backups")->model()->rowCount(), 1, kPatienceMs);
}

void TestSchoolDoor::aLockedDatabaseIsTriedAgain()
{
    auto other = sql::Database::open(file()).value();
    QVERIFY(sql::execute(other->handle(), "PRAGMA locking_mode = EXCLUSIVE", "lock"));
    QVERIFY(sql::execute(other->handle(), "BEGIN EXCLUSIVE", "lock"));
    start();
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("tryAgain")->isVisible(), kPatienceMs);
    QVERIFY(!child<QPushButton>("restoreBackup")->isVisible());
    QVERIFY2(saidAtDoor().contains("Another program is writing to the school's data"), qPrintable(saidAtDoor()));
    other.reset();
    click("tryAgain");
    QTRY_VERIFY_WITH_TIMEOUT(!child<QPushButton>("tryAgain")->isVisible(), kPatienceMs);
    logIn("sam");
}

/// Else everything would be written into a file that nobody finds any more.
void TestSchoolDoor::aFileThatIsMovedAwayIsMissed()
{
    start();
    logIn("sam");
    give("block-line", 3);
    toTheTooth();
    actions().lessons->trigger();
    const auto given = [this] {
        const auto* cards = child<QListView>("lessonList")->model();
        QStringList said;
        for (int row = 0; row < cards->rowCount(); ++row)
            said << cards->index(row, 0).data(Qt::AccessibleDescriptionRole).toString();
        return said.join('\n');
    };
    QTRY_VERIFY2_WITH_TIMEOUT(given().contains("DEN101-A"), qPrintable(given()), kPatienceMs);
    toTheTooth();
    drill(-2.0);
    QVERIFY(QFile::rename(file(), file() + ".away"));
    grade("The school's database gets it when it can be reached");
    actions().attempts->trigger();
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("The file is not there"), qPrintable(message()), kPatienceMs);
    // What was read before still stands.
    actions().lessons->trigger();
    QTest::qWait(200);
    QVERIFY2(given().contains("DEN101-A"), qPrintable(given()));
    QVERIFY(!QFile::exists(file()));
    QVERIFY(QFile::rename(file() + ".away", file()));
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
}

void TestSchoolDoor::whoIsDisabledIsShownOut()
{
    start();
    logIn("ines");
    actions().classes->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(child<QTableView>("matrix")->model()->rowCount(), 1, kPatienceMs);
    QVERIFY(sql::execute(sql::Database::open(file()).value()->handle(),
                         "UPDATE people SET disabled = 1 WHERE username = 'ines'", "write"));
    actions().readAgain->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(door(), Door::Login, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(m_application->window().isAtDoor(), kPatienceMs);
    QVERIFY2(saidAtDoor().contains("This account was disabled"), qPrintable(saidAtDoor()));
}

void TestSchoolDoor::whoLeftHisPlaceComesBackWithoutTheDatabase()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    QVERIFY(QFile::rename(file(), file() + ".away"));
    actions().lock->trigger();
    QCOMPARE(door(), Door::Locked);
    const auto tryWith = [this](const QString& password) {
        QTRY_VERIFY_WITH_TIMEOUT(child<QLineEdit>("password")->isEnabled(), kPatienceMs);
        child<QLineEdit>("password")->setText(password);
        click("logIn");
        QTRY_VERIFY_WITH_TIMEOUT(!m_application->window().isAtDoor() || child<QLineEdit>("password")->isEnabled(),
                                 kPatienceMs);
    };
    for (int k = 0; k < 4; ++k) {
        tryWith("somebody else's");
        QVERIFY2(saidAtDoor().contains("Name or password is wrong"), qPrintable(saidAtDoor()));
        QVERIFY(m_application->window().isAtDoor());
    }
    tryWith(QString::fromStdString(kPassword));
    QVERIFY2(saidAtDoor().contains("Too many logins have failed"), qPrintable(saidAtDoor()));
    QTest::qWait(2100);
    tryWith(QString::fromStdString(kPassword));
    QTRY_VERIFY_WITH_TIMEOUT(!m_application->window().isAtDoor(), kPatienceMs);
    QVERIFY(m_application->window().view().isVisible());
    // Nobody else comes in so.
    actions().lock->trigger();
    click("otherLogin");
    QTRY_COMPARE_WITH_TIMEOUT(door(), Door::Login, kPatienceMs);
    child<QLineEdit>("username")->setText("sam");
    tryWith(QString::fromStdString(kPassword));
    QVERIFY(m_application->window().isAtDoor());
}

/// Neither his own slips of before nor another's make anybody wait.
void TestSchoolDoor::aLoginForgetsWhatWasMistyped()
{
    start();
    logIn("sam");
    const auto tryWith = [this](const QString& password) {
        QTRY_VERIFY_WITH_TIMEOUT(child<QLineEdit>("password")->isEnabled(), kPatienceMs);
        child<QLineEdit>("password")->setText(password);
        click("logIn");
        QTRY_VERIFY_WITH_TIMEOUT(!m_application->window().isAtDoor() || child<QLineEdit>("password")->isEnabled(),
                                 kPatienceMs);
    };
    const QString right = QString::fromStdString(kPassword);
    QVERIFY(QFile::rename(file(), file() + ".away"));
    actions().lock->trigger();
    for (int k = 0; k < 3; ++k)
        tryWith("somebody else's");
    QVERIFY2(saidAtDoor().contains("Name or password is wrong"), qPrintable(saidAtDoor()));
    QVERIFY(QFile::rename(file() + ".away", file()));
    tryWith(right);
    QVERIFY(!m_application->window().isAtDoor());
    QVERIFY(QFile::rename(file(), file() + ".away"));
    actions().lock->trigger();
    tryWith("a slip");
    tryWith(right);
    QVERIFY2(!m_application->window().isAtDoor(), qPrintable(saidAtDoor()));
    // Sue's place is hers.
    actions().lock->trigger();
    for (int k = 0; k < 6; ++k)
        tryWith("somebody else's");
    QVERIFY2(saidAtDoor().contains("Too many logins have failed"), qPrintable(saidAtDoor()));
    QVERIFY(QFile::rename(file() + ".away", file()));
    click("otherLogin");
    QTRY_COMPARE_WITH_TIMEOUT(door(), Door::Login, kPatienceMs);
    logIn("sue");
    // By then what her own password fits to has been read: the desk answers in turn.
    actions().attempts->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::people::HistoryPage>()->isVisible(), kPatienceMs);
    QVERIFY(QFile::rename(file(), file() + ".away"));
    actions().lock->trigger();
    tryWith(right);
    QVERIFY2(!m_application->window().isAtDoor(), qPrintable(saidAtDoor()));
    QVERIFY(QFile::rename(file() + ".away", file()));
}

/// Its lessons are changed by who teaches there.
void TestSchoolDoor::whoWasLateToCreateTheSchoolIsAGuestOfIt()
{
    QVERIFY(QFile::remove(file()));
    start();
    QTRY_COMPARE_WITH_TIMEOUT(door(), Door::NewSchool, kPatienceMs);
    {
        const OtherStation elsewhere(file());
        const sql::School& school = elsewhere.school;
        QVERIFY(sql::Logins::createFirstAdmin(school, {"boss", "Bea", "Boss", Role::Admin}, kPassword, {1, 8192}));
    }
    child<QLineEdit>("username")->setText("nora");
    child<QLineEdit>("password")->setText(QString::fromStdString(kPassword));
    child<QLineEdit>("passwordAgain")->setText(QString::fromStdString(kPassword));
    click("logIn");
    QTRY_COMPARE_WITH_TIMEOUT(door(), Door::Login, kPatienceMs);
    QVERIFY2(saidAtDoor().contains("Somebody has been entered here meanwhile"), qPrintable(saidAtDoor()));
    QCOMPARE(m_application->window().focusWidget(), child<QLineEdit>("username"));
    click("practiseAsGuest");
    QTRY_VERIFY_WITH_TIMEOUT(!m_application->window().isAtDoor(), kPatienceMs);
    actions().lessons->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::LessonsPage>()->isVisible(), kPatienceMs);
    QVERIFY(!actions().editLesson->isVisible() && !actions().editLesson->isEnabled());
}

/// Who has gone away from the door meanwhile is not let in: somebody else may sit there by then.
void TestSchoolDoor::aLateAnswerLetsNobodyIn()
{
    start();
    QTRY_VERIFY_WITH_TIMEOUT(child<QLineEdit>("username")->isEnabled(), kPatienceMs);
    const int before = count("audit WHERE action = 'login'");
    QStringList names;
    connect(actions().account, &QAction::changed, this, [&] { names << actions().account->text(); });
    {
        const auto other = sql::Database::open(file()).value();
        QVERIFY(sql::execute(other->handle(), "BEGIN IMMEDIATE", "hold it"));
        child<QLineEdit>("username")->setText("sue");
        child<QLineEdit>("password")->setText(QString::fromStdString(kPassword));
        click("logIn");
        QVERIFY(!child<QLineEdit>("username")->isEnabled());
        click("practiseAsGuest");
        QTRY_VERIFY_WITH_TIMEOUT(!m_application->window().isAtDoor(), kPatienceMs);
        QVERIFY(sql::execute(other->handle(), "ROLLBACK", "let it go"));
    }
    QTRY_COMPARE_WITH_TIMEOUT(count("audit WHERE action = 'login'"), before + 1, kPatienceMs);
    // Whoever comes next is answered after her.
    actions().account->trigger();
    logIn("sam");
    QVERIFY2(!names.contains("sue"), qPrintable(names.join(u' ')));
}

/// A server that hangs gives no answer at all. Whose place it is comes back to it all the same.
void TestSchoolDoor::nobodyWaitsAtTheDoorForEver()
{
    sql::Database::Options patient;
    patient.patience = std::chrono::minutes(5);
    start(false, patient);
    logIn("sam");
    toTheTooth();
    const auto other = sql::Database::open(file()).value();
    QVERIFY(sql::execute(other->handle(), "BEGIN IMMEDIATE", "hold it"));
    actions().lock->trigger();
    const auto tryWith = [this](const QString& password) {
        child<QLineEdit>("password")->setText(password);
        click("logIn");
        QTRY_VERIFY_WITH_TIMEOUT(!m_application->window().isAtDoor() || child<QLineEdit>("password")->isEnabled(),
                                 kPatienceMs);
    };
    tryWith("a slip");
    QVERIFY2(saidAtDoor().contains("Name or password is wrong"), qPrintable(saidAtDoor()));
    tryWith(QString::fromStdString(kPassword));
    QVERIFY2(!m_application->window().isAtDoor(), qPrintable(saidAtDoor()));
    QVERIFY(m_application->window().view().isVisible());
    // Lessons are files: they are there all the same, as long as what is noted of this login waits.
    m_application->window().setLessons({}, {});
    QCOMPARE(child<QListView>("lessonList")->model()->rowCount(), 0);
    actions().lessons->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<QListView>("lessonList")->model()->rowCount() > 2, kPatienceMs);
    QVERIFY(sql::execute(other->handle(), "ROLLBACK", "let it go"));
}

/// A window may stay open for weeks.
void TestSchoolDoor::eachDayHasItsBackup()
{
    start();
    const QString folder = sql::backupFolder(file());
    QTRY_COMPARE_WITH_TIMEOUT(sql::backupsIn(folder).size(), 1, kPatienceMs);
    QVERIFY(QFile::rename(sql::backupsIn(folder).front(), folder + "/backup-2026-01-01-10.00.00.sqlite"));
    auto* watch = m_application->findChild<QTimer*>("backupWatch");
    QVERIFY(watch != nullptr && watch->isActive());
    watch->setInterval(2);  // many times while one backup is made: it is one all the same
    QTRY_COMPARE_WITH_TIMEOUT(sql::backupsIn(folder).size(), 2, kPatienceMs);
    QTest::qWait(1000);
    QCOMPARE(sql::backupsIn(folder).size(), 2);
}

void TestSchoolDoor::whoIsDisabledIsShownOutByLongWork()
{
    start();
    logIn("admin");
    openSchool(ui::admin::AdminPage::Backups);
    QTest::qWait(1000);  // what the page asks for has been answered
    QVERIFY(sql::execute(sql::Database::open(file()).value()->handle(),
                         "UPDATE people SET disabled = 1 WHERE username = 'admin'", "write"));
    click("checkAll");
    QTRY_COMPARE_WITH_TIMEOUT(door(), Door::Login, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(m_application->window().isAtDoor(), kPatienceMs);
    QVERIFY2(saidAtDoor().contains("This account was disabled"), qPrintable(saidAtDoor()));
}

/// He would see pages that are closed to him.
void TestSchoolDoor::whoseRoleWasChangedIsShownOut()
{
    start();
    logIn("admin");
    openSchool(ui::admin::AdminPage::People);
    QTRY_COMPARE_WITH_TIMEOUT(child<QTableView>("people")->model()->rowCount(), 4, kPatienceMs);
    QVERIFY(sql::execute(sql::Database::open(file()).value()->handle(),
                         "UPDATE people SET role = 'student' WHERE username = 'admin'", "write"));
    actions().readAgain->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(door(), Door::Login, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(m_application->window().isAtDoor(), kPatienceMs);
    QVERIFY2(saidAtDoor().contains("Your role was changed"), qPrintable(saidAtDoor()));
    QVERIFY2(message().isEmpty(), qPrintable(message()));
    logIn("admin");
    QVERIFY(!actions().school->isVisible());
}

/// The school answers when he has gone on to the lessons, or has locked his place.
void TestSchoolDoor::aLateAnswerTearsNobodyAway()
{
    start();
    logIn("ines");
    const auto* const classes = child<ui::people::ClassPage>();
    const auto* const list = child<QListView>("lessonList");
    QTRY_VERIFY_WITH_TIMEOUT(classes->isVisible(), kPatienceMs);
    for (QAction* late : {actions().classes, actions().attempts}) {
        toTheTooth();
        late->trigger();
        actions().lessons->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(list->isVisible(), kPatienceMs);
        QTest::qWait(1500);
        QVERIFY(list->isVisible());
    }
    // What was asked for where he still is, is there when he comes back.
    toTheTooth();
    actions().classes->trigger();
    actions().lock->trigger();
    QCOMPARE(door(), Door::Locked);
    QTest::qWait(1500);
    QVERIFY(m_application->window().isAtDoor());
    child<QLineEdit>("password")->setText(QString::fromStdString(kPassword));
    click("logIn");
    QTRY_VERIFY_WITH_TIMEOUT(classes->isVisible(), kPatienceMs);
}

/// However it was named: who looks for it, or for its backups, has to know where they lie.
void TestSchoolDoor::theDatabaseIsNamedWithItsWholePath()
{
    const QString before = QDir::currentPath();
    QVERIFY(QDir::setCurrent(m_folder->path()));
    app::WindowOptions options;
    options.source = {36};
    options.database = QStringLiteral("school.sqlite");
    options.asksWho = true;
    m_application = app::Application::make(options).value();
    m_application->show();
    logIn("admin");
    const auto named = [this] {
        const auto labels = child<ui::admin::AdminPage>()->findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [whole = QDir::toNativeSeparators(file())](const QLabel* one) {
            return one->isVisible() && one->text().contains(whole);
        });
    };
    for (const auto part : {ui::admin::AdminPage::Backups, ui::admin::AdminPage::Station}) {
        openSchool(part);
        QTRY_VERIFY_WITH_TIMEOUT(named(), kPatienceMs);
    }
    m_application.reset();
    QVERIFY(QDir::setCurrent(before));
}

void TestSchoolDoor::onesOwnPasswordIsChanged()
{
    start();
    logIn("sam");
    const auto change = [this](const QString& old, const QString& next) {
        if (door() != Door::OwnPassword) {
            actions().lock->trigger();
            click("changePassword");
        }
        child<QLineEdit>("oldPassword")->setText(old);
        child<QLineEdit>("password")->setText(next);
        child<QLineEdit>("passwordAgain")->setText(next);
        click("logIn");
    };
    // From under his name he gets there without being locked out, and back to where he was.
    actions().lessons->trigger();
    const auto menu = child<QMenu>("accountMenu");
    const auto open = [menu, this] {
        menu->findChild<QAction*>("ownPassword")->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(door(), Door::OwnPassword, kPatienceMs);
    };
    open();
    click("otherLogin");
    QVERIFY(child<ui::study::LessonsPage>()->isVisible());
    open();
    actions().back->trigger();
    QVERIFY(child<ui::study::LessonsPage>()->isVisible());
    // But the place is locked there as anywhere else.
    open();
    actions().lock->trigger();
    QCOMPARE(door(), Door::Locked);
    actions().back->trigger();
    QVERIFY(child<ui::people::LoginPage>()->isVisible());
    click("changePassword");
    change("wrong", "battery staple");
    QTRY_VERIFY_WITH_TIMEOUT(child<QLineEdit>("oldPassword")->isEnabled(), kPatienceMs);
    QVERIFY(child<ui::people::LoginPage>()->isVisible());
    change(QString::fromStdString(kPassword), "battery staple");
    QTRY_VERIFY_WITH_TIMEOUT(!child<ui::people::LoginPage>()->isVisible(), kPatienceMs);
    QVERIFY2(message().contains("password was changed"), qPrintable(message()));
    const OtherStation elsewhere(file());
    const sql::School& school = elsewhere.school;
    QVERIFY(sql::Logins::login(school, "sam", "battery staple"));
}

/// Kept with the person, not with the computer; a guest's on the computer.
void TestSchoolDoor::everybodyIsShownRoundOnce()
{
    start(true);
    auto* tour = child<ui::shell::Tour>("tour");
    logIn("sam");
    QTRY_VERIFY_WITH_TIMEOUT(tour->isVisible(), kPatienceMs);
    QVERIFY(tour->steps() >= 4);
    // The place is locked in the middle of it: it was not seen.
    actions().lock->trigger();
    QVERIFY(!tour->isVisible());
    QCOMPARE(count("settings WHERE name = 'tour.seen'"), 0);
    click("otherLogin");
    QTRY_COMPARE_WITH_TIMEOUT(door(), Door::Login, kPatienceMs);
    logIn("sue");
    QTRY_VERIFY_WITH_TIMEOUT(tour->isVisible(), kPatienceMs);
    actions().back->trigger();
    QVERIFY(!tour->isVisible());
    QTRY_COMPARE_WITH_TIMEOUT(count("settings WHERE name = 'tour.seen' AND value = 'yes'"), 1, kPatienceMs);
    leaveFor("sam");
    QTRY_VERIFY_WITH_TIMEOUT(tour->isVisible(), kPatienceMs);
    while (tour->isVisible())
        tour->next();
    QTRY_COMPARE_WITH_TIMEOUT(count("settings WHERE name = 'tour.seen'"), 2, kPatienceMs);
    leaveFor("sue");
    QTest::qWait(500);
    QVERIFY(!tour->isVisible());
    // It can be had again.
    actions().tour->trigger();
    QVERIFY(tour->isVisible());
    tour->end();

    for (const bool isFirst : {true, false}) {
        m_application.reset();
        start(true);
        QTRY_VERIFY_WITH_TIMEOUT(child<QLineEdit>("username")->isEnabled(), kPatienceMs);
        click("practiseAsGuest");
        QTest::qWait(300);
        QCOMPARE(child<ui::shell::Tour>("tour")->isVisible(), isFirst);
        if (isFirst)
            child<ui::shell::Tour>("tour")->end();
    }
}

/// The class page is filled while the tour is on: it stays below, and takes no key.
void TestSchoolDoor::aTeachersTourBeginsWithHisClasses()
{
    start(true);
    m_application->window().activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&m_application->window()));
    auto* tour = child<ui::shell::Tour>("tour");
    logIn("ines");
    QTRY_VERIFY_WITH_TIMEOUT(tour->isVisible(), kPatienceMs);
    QVERIFY(child<ui::people::ClassPage>()->isVisible());
    QTRY_COMPARE_WITH_TIMEOUT(child<QTableView>("matrix")->model()->rowCount(), 1, kPatienceMs);
    QVERIFY(child<ui::people::ClassPage>()->isAncestorOf(tour->target()));
    QVERIFY(tour->isAncestorOf(m_application->window().focusWidget()));
    tour->next();
    QVERIFY(child<ui::study::LessonsPage>()->isVisible());
    QTest::qWait(500);
    QVERIFY(child<ui::study::LessonsPage>()->isVisible());
    QVERIFY(tour->isAncestorOf(m_application->window().focusWidget()));
    actions().back->trigger();
    QVERIFY(child<ui::people::ClassPage>()->isVisible());
}

int main(int argc, char** argv)
{
    return support::openGlMain<TestSchoolDoor>(argc, argv);
}

#include "tst_school_door.moc"
