// SPDX-License-Identifier: GPL-3.0-or-later
// The whole program as an admin has it: people, presets, backups, the audit.
#include <array>

#include <sys/wait.h>
#include <unistd.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QStyleHints>
#include <QTableView>
#include <QTest>

#include "database/sql/Audit.h"
#include "database/sql/Backups.h"
#include "database/sql/Classes.h"
#include "database/sql/Logins.h"
#include "database/sql/People.h"
#include "database/sql/Presets.h"
#include "database/sql/Settings.h"
#include "database/sql/Statement.h"
#include "lessons/PresetFile.h"
#include "tests/app/SchoolWindow.h"
#include "tests/database/SchoolRig.h"
#include "tests/support/OpenGlMain.h"
#include "ui/admin/AdminPage.h"
#include "ui/admin/AuditPart.h"
#include "ui/admin/BackupPart.h"
#include "ui/admin/RosterPart.h"
#include "ui/people/LoginPage.h"
#include "ui/presets/PresetsPage.h"
#include "ui/shell/MessageBar.h"

using namespace database;
using support::Exam;
using support::kPassword;
using support::kPatienceMs;
using support::OtherStation;

class TestSchoolOffice : public support::SchoolWindow
{
    Q_OBJECT
private slots:
    void init() { makeSchool(); }
    void cleanup() { m_application.reset(); }

    void twoAdminsUndoNothingOfEachOther();
    void whatAnotherAdminHasChangedIsToldBeforeItIsUndone_data();
    void whatAnotherAdminHasChangedIsToldBeforeItIsUndone();
    void aSchoolThatIsOpenElsewhereLogsNobodyOut();
    void aRestoreThrowsNobodyElseOut();
    void theSchoolsPresetIsTheAdmins();
    void theNextToothFeelsAsWasChosenElsewhere();
    void whatAnotherAdminHasChosenIsNotUndone();
    void aPresetIsRetiredAndTakenUpAgain();
    void anAdminEntersAndChangesPeople();
    void aClassListIsSeenBeforeItIsEntered();
    void aBackupIsMadeTriedAndRestored();
    void anotherSchoolsBackupIsNotRestored();
    void aNetworkDriveIsForOneAndIsBackedUp();
    void whatWasDoneStandsInTheAudit();
    void attemptsDoNotHideWhatWasDone();

private:
    /// An admin at another station keeps a preset, if it is not there, and says that everybody's teeth feel like it.
    void chooseElsewhere(const std::string& preset) const;
    void typeBehindSamsName();
    /// Has everything checked with the audit codes of reports: that of now, another one, and none.
    void checkReportCodes() const;
};

void TestSchoolOffice::chooseElsewhere(const std::string& preset) const
{
    const OtherStation elsewhere(file());
    const sql::School& school = elsewhere.school;
    const auto admin = elsewhere.logIn("admin");
    core::settings::FeelPreset kept = lessons::shippedPresets().front();
    kept.name = preset;
    kept.enamelRate *= 0.5;
    kept = lessons::hashed(kept);
    const QByteArray json = QJsonDocument(lessons::toJson(kept)).toJson(QJsonDocument::Compact);
    QVERIFY(sql::addPreset(school, admin, {kept.name, kept.version, kept.hash, json.toStdString()}));
    QVERIFY(sql::changeSetting(school, admin, "preset.in_use", preset + " v1"));
}

/// On the page of the people, as their admin.
void TestSchoolOffice::typeBehindSamsName()
{
    start();
    logIn("admin");
    openSchool(ui::admin::AdminPage::People);
    const auto* people = child<QTableView>("people")->model();
    QTRY_COMPARE_WITH_TIMEOUT(people->rowCount(), 4, kPatienceMs);
    for (int row = 0; row < people->rowCount(); ++row)
        if (people->index(row, 1).data().toString() == "sam")
            child<QTableView>("people")->setCurrentIndex(people->index(row, 0));
    QTest::keyClicks(child<QLineEdit>("personGiven"), "X");
}

/// One has begun to type when the other saves.
void TestSchoolOffice::twoAdminsUndoNothingOfEachOther()
{
    typeBehindSamsName();
    const OtherStation elsewhere(file());
    const sql::School& school = elsewhere.school;
    const auto other = elsewhere.logIn("admin");
    Person sam = sql::findPerson(school, other, "sam").value();
    sam.role = Role::Instructor;
    QVERIFY(sql::changePerson(school, other, sam));
    const ClassId next = sql::addClass(school, other, "DEN102-B").value();
    const ClassId before = sql::listClasses(school, other).value().front().id;
    QVERIFY(sql::enrol(school, other, next, sam.id, true));
    QVERIFY(sql::enrol(school, other, before, sam.id, false));
    actions().readAgain->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(child<QListWidget>("personClasses")->count(), 2, kPatienceMs);
    click("savePerson");
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("personSaid")->text().contains("was changed"), kPatienceMs);
    const auto all = sql::listPeople(school, other).value();
    for (const Person& one : all)
        if (one.username == "sam") {
            QCOMPARE(one.givenName, std::string("samX"));
            QCOMPARE(one.role, Role::Instructor);
            QCOMPARE(one.classes, std::vector<ClassId>{next});
        }
}

void TestSchoolOffice::whatAnotherAdminHasChangedIsToldBeforeItIsUndone_data()
{
    QTest::addColumn<bool>("isReadAgain");
    QTest::newRow("he saves it without looking again") << false;
    QTest::newRow("the list was read again while he typed") << true;
}

/// The same field: the later one is told what there is now, and puts his in the place of it all the same.
void TestSchoolOffice::whatAnotherAdminHasChangedIsToldBeforeItIsUndone()
{
    QFETCH(bool, isReadAgain);
    typeBehindSamsName();
    const OtherStation elsewhere(file());
    const sql::School& school = elsewhere.school;
    const auto other = elsewhere.logIn("admin");
    Person sam = sql::findPerson(school, other, "sam").value();
    sam.givenName = "Samuel";
    sam.familyName = "Stone";
    QVERIFY(sql::changePerson(school, other, sam));
    if (isReadAgain)
        actions().readAgain->trigger();
    else
        click("savePerson");
    const auto* const fault = child<QLabel>("personFault");
    QTRY_VERIFY2_WITH_TIMEOUT(fault->text().contains("There is now: Given name: Samuel."), qPrintable(fault->text()),
                              kPatienceMs);
    QVERIFY(fault->isVisible());
    QCOMPARE(child<QLineEdit>("personGiven")->text(), QString("samX"));
    QCOMPARE(child<QLineEdit>("personFamily")->text(), QString("Stone"));
    QCOMPARE(sql::findPerson(school, other, "sam")->givenName, std::string("Samuel"));
    QTest::qWait(2 * QGuiApplication::styleHints()->mouseDoubleClickInterval());
    click("savePerson");
    QTRY_COMPARE_WITH_TIMEOUT(child<QLabel>("personSaid")->text(), QString("samX Stone was changed."), kPatienceMs);
    QCOMPARE(sql::findPerson(school, other, "sam")->fullName(), std::string("samX Stone"));
}

/// It would not be restored while another window has it, and the next one is made when that is closed.
void TestSchoolOffice::aSchoolThatIsOpenElsewhereLogsNobodyOut()
{
    std::array<int, 2> ends{};
    std::array<int, 2> opened{};
    QCOMPARE(pipe(ends.data()) + pipe(opened.data()), 0);
    const pid_t other = fork();
    if (other == 0) {
        close(ends[1]);
        const auto database = sql::Database::open(file());
        static_cast<void>(write(opened[1], database ? "y" : "n", 1));
        char byte = 0;
        static_cast<void>(read(ends[0], &byte, 1));  // until the test closes its end
        _exit(0);
    }
    char byte = 0;
    QCOMPARE(read(opened[0], &byte, 1), 1);
    QCOMPARE(byte, 'y');
    start();
    logIn("admin");
    openSchool(ui::admin::AdminPage::Backups);
    QTRY_VERIFY_WITH_TIMEOUT(!sql::backupsIn(sql::backupFolder(file())).isEmpty(), kPatienceMs);  // today's
    QTest::qWait(1000);
    const auto restore = [this] {
        emit child<ui::admin::BackupPart>()->restoreWanted(
            QDir(sql::backupFolder(file())).filePath(sql::backupsIn(sql::backupFolder(file())).front()));
    };
    const auto said = [this] { return child<QLabel>("backupSaid")->text(); };
    restore();
    QTRY_VERIFY2_WITH_TIMEOUT(said().contains("another window of Cusp"), qPrintable(said()), kPatienceMs);
    QVERIFY(!m_application->window().isAtDoor());
    QCOMPARE(actions().account->text(), QString("admin"));
    close(ends[1]);
    int status = 0;
    QCOMPARE(waitpid(other, &status, 0), other);
    for (const int end : {ends[0], opened[0], opened[1]})
        close(end);
    restore();
    QTRY_VERIFY2_WITH_TIMEOUT(saidAtDoor().contains("is in place"), qPrintable(saidAtDoor()), kPatienceMs);
}

/// Who had asked for it has left while the backup was looked at.
void TestSchoolOffice::aRestoreThrowsNobodyElseOut()
{
    start();
    logIn("admin");
    openSchool(ui::admin::AdminPage::Backups);
    click("backUp");
    QTRY_VERIFY_WITH_TIMEOUT(child<QTableView>("backups")->model()->rowCount() > 0, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("backUp")->isEnabled(), kPatienceMs);
    emit child<ui::admin::BackupPart>()->restoreWanted(
        QDir(sql::backupFolder(file())).filePath(sql::backupsIn(sql::backupFolder(file())).front()));
    // All of this before the answer is heard.
    actions().lock->trigger();
    child<QPushButton>("otherLogin")->click();
    QTest::qWait(1000);
    QVERIFY2(!saidAtDoor().contains("restored"), qPrintable(saidAtDoor()));
    QVERIFY2(!saidAtDoor().contains("in place"), qPrintable(saidAtDoor()));
    logIn("sam");
}

void TestSchoolOffice::theSchoolsPresetIsTheAdmins()
{
    start();
    logIn("admin");
    ui::shell::MainWindow& window = m_application->window();
    actions().presets->trigger();
    core::settings::FeelPreset hard = lessons::shippedPresets().front();
    hard.name = "hard";
    hard.version = 0;
    hard.enamelRate *= 0.5;
    emit window.presetSaveWanted(hard);
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("hard"), qPrintable(message()), kPatienceMs);
    QVERIFY(child<QPushButton>("presetUse")->isEnabled());
    window.showPresetFault("That was not done, because the server does not answer.");
    click("presetUse");
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("everybody"), qPrintable(message()), kPatienceMs);
    QVERIFY(!child<QLabel>("presetFault")->isVisible());
    leaveFor("sam");
    actions().presets->trigger();
    QVERIFY(!child<QPushButton>("presetUse")->isEnabled());
    QVERIFY(!child<QPushButton>("presetImport")->isEnabled());
    hard.dentinRate *= 0.5;
    emit window.presetSaveWanted(hard);
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("presetFault")->text().contains("only an admin"), kPatienceMs);
    toTheTooth();
    drill(-2.0);
    grade("first grade");
    const auto preset = sql::ask(sql::Database::open(file()).value()->handle(), "SELECT preset FROM attempts", "read");
    QCOMPARE(preset.value().toString(), QString("hard v1"));
}

/// At another station an admin chooses a preset, while somebody is logged in here.
void TestSchoolOffice::theNextToothFeelsAsWasChosenElsewhere()
{
    const Exam exam;
    start();
    logIn("sam");
    toTheTooth();
    const auto felt = [this](int attempt) {
        return sql::ask(sql::Database::open(file()).value()->handle(),
                        QStringLiteral("SELECT preset FROM attempts ORDER BY id LIMIT 1 OFFSET %1").arg(attempt),
                        "read")
            .value()
            .toString();
    };
    chooseElsewhere("hard");
    beginLesson("exam-36");
    drill(-2.0);
    gradeLesson();
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    QCOMPARE(felt(0), QString("hard v1"));
    // Another attempt at it is another tooth, too.
    chooseElsewhere("soft");
    actions().reload->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("Another attempt"), kPatienceMs);
    QTRY_COMPARE_WITH_TIMEOUT(removed(), QString("0.00"), kPatienceMs);
    QTest::qWait(500);
    drill(-2.0);
    gradeLesson();
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 2, kPatienceMs);
    QCOMPARE(felt(1), QString("soft v1"));
    chooseElsewhere("middle");
    emit m_application->window().toothChosen(26);
    QTRY_VERIFY_WITH_TIMEOUT(m_application->window().windowTitle().startsWith("Tooth 26"), kPatienceMs);
    toTheTooth();
    QTest::qWait(500);
    drill(-2.0);
    grade("");
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 3, kPatienceMs);
    QCOMPARE(felt(2), QString("middle v1"));
}

void TestSchoolOffice::whatAnotherAdminHasChosenIsNotUndone()
{
    start();
    logIn("admin");
    const auto inUse = [this] {
        return sql::ask(sql::Database::open(file()).value()->handle(),
                        "SELECT value FROM settings WHERE owner = '' AND name = 'preset.in_use'", "read")
            .value()
            .toString();
    };
    const auto undo = [this] {
        for (QPushButton* button : child<ui::shell::MessageBar>()->findChildren<QPushButton*>())
            if (button->isVisible() && button->text() == "Undo")
                button->click();
    };
    const auto use = [this, inUse](const char* name) {
        for (const lessons::ReadPreset& read : child<ui::presets::PresetsPage>()->all())
            if (read.preset && read.preset->name == name)
                emit m_application->window().presetUseWanted(*read.preset);
        QTRY_COMPARE_WITH_TIMEOUT(inUse(), QString(name) + " v1", kPatienceMs);
        QTRY_VERIFY2_WITH_TIMEOUT(message().contains("everybody"), qPrintable(message()), kPatienceMs);
        QTest::qWait(200);
    };
    toTheTooth();
    chooseElsewhere("hard");
    actions().presets->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<QListWidget>("presetList")->count() == 2, kPatienceMs);
    // Chosen here after this window has read what was in use.
    chooseElsewhere("soft");
    use("hard");
    undo();
    QTRY_COMPARE_WITH_TIMEOUT(inUse(), QString("soft v1"), kPatienceMs);
    use("natural");
    chooseElsewhere("hard");
    undo();
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("hard, version 1"), qPrintable(message()), kPatienceMs);
    QCOMPARE(inUse(), QString("hard v1"));
}

void TestSchoolOffice::aPresetIsRetiredAndTakenUpAgain()
{
    chooseElsewhere("junk");
    chooseElsewhere("hard");
    start();
    logIn("admin");
    toTheTooth();
    actions().presets->trigger();
    auto* list = child<QListWidget>("presetList");
    const auto rowOf = [list](const QString& name) {
        for (int row = 0; row < list->count(); ++row)
            if (list->item(row)->text().startsWith(name))
                return row;
        return -1;
    };
    const auto isOffered = [this](const QString& preset) {
        return child<QComboBox>("presetOther")->findText(preset) >= 0;
    };
    auto* retire = child<QPushButton>("presetRetire");
    QTRY_VERIFY_WITH_TIMEOUT(rowOf("junk") >= 0 && rowOf("hard") >= 0, kPatienceMs);
    list->setCurrentRow(rowOf("hard"));
    QVERIFY(!retire->isEnabled());  // it is in use
    list->setCurrentRow(rowOf("natural"));
    QVERIFY(!retire->isEnabled());
    list->setCurrentRow(rowOf("junk"));
    QVERIFY(isOffered("junk v1"));
    retire->click();
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("junk is offered to nobody"), qPrintable(message()), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(!isOffered("junk v1"), kPatienceMs);
    QVERIFY(list->item(rowOf("junk"))->text().contains("retired"));
    QVERIFY(!child<QPushButton>("presetUse")->isEnabled());
    leaveFor("sam");
    toTheTooth();
    actions().presets->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(rowOf("hard") >= 0 && rowOf("junk") < 0, kPatienceMs);
    QVERIFY(!retire->isVisible());
    leaveFor("admin");
    toTheTooth();
    actions().presets->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(rowOf("junk") >= 0, kPatienceMs);
    list->setCurrentRow(rowOf("junk"));
    QCOMPARE(retire->text(), QString("Take up again"));
    retire->click();
    QTRY_VERIFY_WITH_TIMEOUT(isOffered("junk v1"), kPatienceMs);
    // Chosen at another station meanwhile, it is not retired.
    chooseElsewhere("junk");
    retire->click();
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("presetFault")->text().contains("not retired"), kPatienceMs);
    QCOMPARE(count("settings WHERE name = 'preset.retired' AND value = ''"), 1);
    QTRY_VERIFY_WITH_TIMEOUT(list->item(rowOf("junk"))->text().contains("in use"), kPatienceMs);
    // Retired at another station meanwhile, it is taken up again by being put in use.
    {
        const OtherStation elsewhere(file());
        const sql::School& school = elsewhere.school;
        const auto admin = elsewhere.logIn("admin");
        QVERIFY(sql::changeSetting(school, admin, "preset.retired", "hard"));
    }
    list->setCurrentRow(rowOf("hard"));
    click("presetUse");
    QTRY_COMPARE_WITH_TIMEOUT(count("settings WHERE name = 'preset.in_use' AND value = 'hard v1'"), 1, kPatienceMs);
    QTRY_COMPARE_WITH_TIMEOUT(count("settings WHERE name = 'preset.retired' AND value = ''"), 1, kPatienceMs);
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("had retired it"), qPrintable(message()), kPatienceMs);
    // What is done elsewhere is seen by who reads again, and by who keeps a new version.
    QTRY_VERIFY_WITH_TIMEOUT(list->item(rowOf("hard"))->text().contains("in use"), kPatienceMs);
    chooseElsewhere("junk");
    QVERIFY(list->item(rowOf("hard"))->text().contains("in use"));
    actions().readAgain->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(list->item(rowOf("junk"))->text().contains("in use"), kPatienceMs);
    chooseElsewhere("hard");
    const auto all = child<ui::presets::PresetsPage>()->all();
    const auto junk = std::find_if(all.begin(), all.end(), [](const lessons::ReadPreset& one) {
        return one.preset && one.preset->name == "junk";
    });
    core::settings::FeelPreset next = *junk->preset;
    next.version = 0;
    next.notes = "another";
    emit m_application->window().presetSaveWanted(next);
    QTRY_VERIFY_WITH_TIMEOUT(list->item(rowOf("hard"))->text().contains("in use"), kPatienceMs);
}

void TestSchoolOffice::anAdminEntersAndChangesPeople()
{
    start();
    logIn("sam");
    QVERIFY(!actions().school->isVisible());
    leaveFor("admin");
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::admin::AdminPage>()->isVisible(), kPatienceMs);  // where an admin's begins
    openSchool(ui::admin::AdminPage::People);
    const auto* people = child<QTableView>("people")->model();
    QTRY_COMPARE_WITH_TIMEOUT(people->rowCount(), 4, kPatienceMs);
    const OtherStation elsewhere(file());
    const sql::School& school = elsewhere.school;
    // Somebody new, in a class, with a code that lets him in.
    click("newPerson");
    child<QLineEdit>("personUsername")->setText("tom");
    child<QLineEdit>("personFamily")->setText("Three");
    auto* classes = child<QListWidget>("personClasses");
    QTRY_COMPARE_WITH_TIMEOUT(classes->count(), 1, kPatienceMs);
    classes->item(0)->setCheckState(Qt::Checked);
    click("savePerson");
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("oneTimeCode")->isVisible(), kPatienceMs);
    const QString code = child<QLabel>("oneTimeCode")->text();
    QTRY_COMPARE_WITH_TIMEOUT(people->rowCount(), 5, kPatienceMs);
    QCOMPARE(count("enrolments"), 3);
    // The same name again is refused, and said where it was typed.
    click("newPerson");
    child<QLineEdit>("personUsername")->setText("tom");
    click("savePerson");
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("personFault")->text().contains("taken"), kPatienceMs);
    // Nobody would be left: the only admin cannot be disabled.
    const auto select = [&](const QString& login) {
        for (int row = 0; row < people->rowCount(); ++row)
            if (people->index(row, 1).data().toString() == login)
                child<QTableView>("people")->setCurrentIndex(people->index(row, 0));
    };
    select("admin");
    click("disablePerson");
    QTest::qWait(2 * QGuiApplication::styleHints()->mouseDoubleClickInterval() + 50);
    click("disablePerson");
    QTRY_VERIFY2_WITH_TIMEOUT(child<QLabel>("personFault")->text().contains("the last admin"),
                              qPrintable(child<QLabel>("personFault")->text()), 5000);
    select("sue");
    QVERIFY(!child<QLabel>("oneTimeCode")->isVisible());
    // A password is not taken away by one click, nor by a double click; Esc leaves it, and the page stays.
    click("resetPassword");
    click("resetPassword");
    QVERIFY(child<QLabel>("personSaid")->text().startsWith("sue Student will need"));
    QTest::keyClick(child<QPushButton>("keepAsItIs"), Qt::Key_Escape);
    QVERIFY(!child<QPushButton>("keepAsItIs")->isVisible() && child<ui::admin::AdminPage>()->isVisible());
    QVERIFY(sql::Logins::login(school, "sue", kPassword));
    click("resetPassword");
    QTest::qWait(2 * QGuiApplication::styleHints()->mouseDoubleClickInterval() + 50);
    click("resetPassword");
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("oneTimeCode")->isVisible(), kPatienceMs);
    QVERIFY(!sql::Logins::login(school, "sue", kPassword));
    // A code that would let nobody in is not shown any longer.
    click("disablePerson");
    QVERIFY(!child<QLabel>("oneTimeCode")->isVisible());
    QTRY_COMPARE_WITH_TIMEOUT(child<QPushButton>("disablePerson")->text(), QString("Enable"), kPatienceMs);
    // A class has its name, and takes another, but none that parts classes in a class list.
    child<QLineEdit>("className")->setText("DEN|102");
    click("addClass");
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("personFault")->text().contains("|"), kPatienceMs);
    child<QLineEdit>("className")->setText("DEN102");
    click("addClass");
    QTRY_COMPARE_WITH_TIMEOUT(classes->count(), 2, kPatienceMs);
    QCOMPARE(count("classes"), 2);
    select("tom");
    QCOMPARE(classes->item(0)->checkState(), Qt::Checked);
    classes->item(0)->setCheckState(Qt::Unchecked);
    child<QLineEdit>("personGiven")->setText("Tom");
    click("savePerson");
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("personSaid")->text().contains("Tom Three"), kPatienceMs);
    QTRY_COMPARE_WITH_TIMEOUT(count("enrolments"), 2, kPatienceMs);
    // The code is good for one login.
    QVERIFY(sql::Logins::redeem(school, "tom", code.toStdString(), kPassword));
    QVERIFY(!sql::Logins::login(school, "sue", kPassword));
}

void TestSchoolOffice::aClassListIsSeenBeforeItIsEntered()
{
    const QString path = m_folder->filePath("class.csv");
    const auto write = [&path](const QByteArray& all) {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(all);
    };
    start();
    logIn("admin");
    openSchool(ui::admin::AdminPage::Roster);
    auto* part = child<ui::admin::RosterPart>();
    const auto said = [this] { return child<QLabel>("rosterSaid")->text() + child<QLabel>("rosterFault")->text(); };
    write("username,given_name,family_name,role,class\nsam,Sam,One,student,DEN101-A\n!!,X,Y,student,DEN101-A\n");
    emit part->fileChosen(path);
    QTRY_VERIFY2_WITH_TIMEOUT(said().contains("1 fault"), qPrintable(said()), kPatienceMs);
    QCOMPARE(child<QTableView>("roster")->model()->index(0, 0).data().toString(), QString("3"));
    QVERIFY(!child<QPushButton>("enterRoster")->isVisible());
    write("username,given_name,family_name,role,class\nsam,Sam,One,student,DEN101-A\nnew1,N,Ew,student,DEN103\n");
    emit part->fileChosen(path);
    QTRY_VERIFY2_WITH_TIMEOUT(said().contains("1 person known already. 1 new person would be entered."),
                              qPrintable(said()), kPatienceMs);
    QCOMPARE(count("people"), 4);
    // Meanwhile somebody else enters one of them, under another name, which the list would change.
    {
        const OtherStation elsewhere(file());
        const auto admin = elsewhere.logIn("admin");
        QVERIFY(sql::addPerson(elsewhere.school, admin, {"new1", "Otto", "Other", Role::Student}));
    }
    click("enterRoster");
    QTRY_VERIFY2_WITH_TIMEOUT(said().contains("Nothing was entered"), qPrintable(said()), kPatienceMs);
    {
        const OtherStation elsewhere(file());
        const auto admin = elsewhere.logIn("admin");
        QCOMPARE(sql::findPerson(elsewhere.school, admin, "new1")->givenName, std::string("Otto"));
    }
    const QString state = child<QTableView>("roster")->model()->index(1, 4).data().toString();
    QVERIFY2(state.contains("Otto Other"), qPrintable(state));
    // What it would do now has been seen.
    write("username,given_name,family_name,role,class\nsam,Sam,One,student,DEN101-A\nnew2,N,Ew,student,DEN103\n");
    emit part->fileChosen(path);
    QTRY_VERIFY2_WITH_TIMEOUT(said().contains("1 new person would be entered."), qPrintable(said()), kPatienceMs);
    click("enterRoster");
    QTRY_VERIFY2_WITH_TIMEOUT(said().contains("was entered"), qPrintable(said()), kPatienceMs);
    QCOMPARE(count("people"), 6);
    QVERIFY2(child<QPushButton>("saveCodes")->isVisible(), qPrintable(said()));
    write(QByteArray("\xff\xfe\x00 noise", 10));
    emit part->fileChosen(path);
    QTRY_VERIFY2_WITH_TIMEOUT(said().contains("1 fault"), qPrintable(said()), kPatienceMs);
    const auto* rows = child<QTableView>("roster")->model();
    QVERIFY2(rows->index(0, 2).data().toString().contains("no UTF-8"), qPrintable(rows->index(0, 2).data().toString()));
    // Too long a list says what may be.
    write("username\n" + QByteArray("x\n").repeated(20'000));
    emit part->fileChosen(path);
    QTRY_VERIFY2_WITH_TIMEOUT(said().contains("more than 20,000 lines"), qPrintable(said()), kPatienceMs);
    emit part->fileChosen(m_folder->filePath("nothing.csv"));
    QVERIFY2(said().contains("cannot be read"), qPrintable(said()));
}

void TestSchoolOffice::aBackupIsMadeTriedAndRestored()
{
    start();
    logIn("admin");
    openSchool(ui::admin::AdminPage::Backups);
    const auto* backups = child<QTableView>("backups");
    // Today's has been made by itself.
    const QString folder = sql::backupFolder(file());
    QTRY_COMPARE_WITH_TIMEOUT(sql::backupsIn(folder).size(), 1, kPatienceMs);
    QTest::qWait(1100);  // names differ by the second
    const auto said = [this] { return child<QLabel>("backupSaid")->text(); };
    click("backUp");
    QTRY_VERIFY2_WITH_TIMEOUT(said().contains("Its pages and keys are whole"), qPrintable(said()), kPatienceMs);
    // What was made before an accident is not thinned out by the one that is made after it.
    QCOMPARE(sql::backupsIn(folder).size(), 2);
    QTRY_COMPARE_WITH_TIMEOUT(backups->model()->rowCount(), 2, kPatienceMs);
    // The table had the focus meanwhile; that chooses no backup.
    QCOMPARE(m_application->window().focusWidget(), child<QPushButton>("backUp"));
    QVERIFY(!child<QPushButton>("restoreThis")->isEnabled());
    backups->selectionModel()->setCurrentIndex(backups->model()->index(1, 0), QItemSelectionModel::NoUpdate);
    QVERIFY(!child<QPushButton>("restoreThis")->isEnabled());
    QTest::keyClick(child<QTableView>("backups"), Qt::Key_Space);
    QVERIFY(child<QPushButton>("restoreThis")->isEnabled());
    click("drillRestore");
    QTRY_VERIFY2_WITH_TIMEOUT(said().contains("Restoring works"), qPrintable(said()), kPatienceMs);
    click("checkAll");
    QTRY_VERIFY2_WITH_TIMEOUT(said().contains("Nothing is wrong"), qPrintable(said()), kPatienceMs);
    checkReportCodes();
    click("backUp");
    QTRY_COMPARE_WITH_TIMEOUT(backups->model()->rowCount(), 3, kPatienceMs);
    // Somebody is entered after the backup, and is gone with the restore.
    child<ui::admin::AdminPage>()->show(ui::admin::AdminPage::People);
    QTRY_COMPARE_WITH_TIMEOUT(child<QTableView>("people")->model()->rowCount(), 4, kPatienceMs);
    child<QLineEdit>("personUsername")->setText("tom");
    click("savePerson");
    QTRY_COMPARE_WITH_TIMEOUT(count("people"), 5, kPatienceMs);
    child<ui::admin::AdminPage>()->show(ui::admin::AdminPage::Backups);
    child<QTableView>("backups")->setCurrentIndex(backups->model()->index(0, 0));
    click("restoreThis");
    QVERIFY(child<QPushButton>("restoreThis")->text().contains("log everybody out"));
    click("restoreThis");  // of a double click
    QVERIFY(child<ui::admin::AdminPage>()->isVisible());
    QTest::keyClick(child<QPushButton>("keepPresent"), Qt::Key_Escape);
    QVERIFY(child<ui::admin::AdminPage>()->isVisible());
    QVERIFY(!child<QPushButton>("restoreThis")->text().contains("log everybody out"));
    click("restoreThis");
    click("keepPresent");
    QVERIFY(!child<QPushButton>("restoreThis")->text().contains("log everybody out"));
    click("restoreThis");
    QTest::qWait(2 * QGuiApplication::styleHints()->mouseDoubleClickInterval() + 50);
    click("restoreThis");
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::people::LoginPage>()->isVisible(), kPatienceMs);
    // Who looked in between would make an empty one.
    QTRY_VERIFY2_WITH_TIMEOUT(saidAtDoor().contains("is in place"), qPrintable(saidAtDoor()), kPatienceMs);
    QCOMPARE(count("people"), 4);
    const auto actor = sql::ask(
        sql::Database::open(file()).value()->handle(),
        "SELECT p.username FROM audit a JOIN people p ON p.uid = a.actor WHERE a.action = 'backup.restored'", "read");
    QCOMPARE(actor->toString(), QString("admin"));
    logIn("admin");
}

/// Which somebody has put among those of this one.
void TestSchoolOffice::anotherSchoolsBackupIsNotRestored()
{
    support::SchoolRig other(false);
    other.populate();
    const QString folder = sql::backupFolder(file());
    QVERIFY(sql::backUp(other.school().db, folder, QDateTime::currentDateTimeUtc().addDays(-1)));
    start();
    const int people = count("people");
    logIn("admin");
    // This one has none of today yet.
    QTRY_COMPARE_WITH_TIMEOUT(sql::backupsIn(folder).size(), 2, kPatienceMs);
    openSchool(ui::admin::AdminPage::Backups);
    const auto* backups = child<QTableView>("backups")->model();
    QTRY_COMPARE_WITH_TIMEOUT(backups->rowCount(), 2, kPatienceMs);
    child<QTableView>("backups")->setCurrentIndex(backups->index(1, 0));
    click("restoreThis");
    QTest::qWait(2 * QGuiApplication::styleHints()->mouseDoubleClickInterval() + 50);
    click("restoreThis");
    QTRY_VERIFY2_WITH_TIMEOUT(saidAtDoor().contains("nothing has been changed. It is no backup of this school."),
                              qPrintable(saidAtDoor()), kPatienceMs);
    QCOMPARE(count("people"), people);
    logIn("admin");
}

void TestSchoolOffice::checkReportCodes() const
{
    auto* code = child<QLineEdit>("reportCode");
    const auto said = [this] { return child<QLabel>("backupSaid")->text(); };
    const QString seen = said();
    code->setText("412");
    click("checkAll");
    QVERIFY(child<QLabel>("reportCodeFault")->isVisible());
    QCOMPARE(said(), seen);
    const QString head = sql::ask(sql::Database::open(file()).value()->handle(),
                                  "SELECT seq || '-' || substr(hash, 1, 12) FROM audit_seal", "read")
                             .value()
                             .toString();
    code->setText(' ' + head.toUpper());
    QVERIFY(!child<QLabel>("reportCodeFault")->isVisible());
    QTest::keyClick(code, Qt::Key_Return);
    QTRY_VERIFY2_WITH_TIMEOUT(said().contains("with the code " + head.toUpper()), qPrintable(said()), kPatienceMs);
    code->setText("3-000000000000");
    click("checkAll");
    QTRY_VERIFY2_WITH_TIMEOUT(said().contains("1 thing"), qPrintable(said()), kPatienceMs);
    QVERIFY(child<QPlainTextEdit>("findings")->isVisible());
    code->clear();
}

/// The one connection that such a file allows does everything.
void TestSchoolOffice::aNetworkDriveIsForOneAndIsBackedUp()
{
    sql::Database::Options opening;
    opening.fileSystemOf = [](const QString&) { return FileSystem::Network; };
    opening.patience = std::chrono::milliseconds(200);
    start(false, opening);
    logIn("sam");
    QCOMPARE(message(), QString());
    toTheTooth();
    drill(-2.0);
    grade("first grade");
    // Nobody else gets in.
    const auto other = sql::Database::open(file(), std::chrono::milliseconds(50));
    QVERIFY(!other.has_value() && other.error().code == core::ErrorCode::Busy);
    leaveFor("admin");
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("network drive"), qPrintable(message()), kPatienceMs);
    openSchool(ui::admin::AdminPage::Backups);
    QTRY_COMPARE_WITH_TIMEOUT(sql::backupsIn(sql::backupFolder(file())).size(), 1, kPatienceMs);
    const auto said = [this] { return child<QLabel>("backupSaid")->text(); };
    for (const auto& [button, words] :
         {std::pair{"backUp", "Its pages and keys are whole"}, std::pair{"drillRestore", "Restoring works"},
          std::pair{"checkAll", "Nothing is wrong: 1 attempts"}}) {
        click(button);
        QTRY_VERIFY2_WITH_TIMEOUT(said().contains(words), qPrintable(said()), kPatienceMs);
    }
    m_application.reset();
    QCOMPARE(attemptsKept(), 1);
}

/// Of more attempts than are read at once.
void TestSchoolOffice::attemptsDoNotHideWhatWasDone()
{
    {
        const OtherStation elsewhere(file());
        const sql::School& school = elsewhere.school;
        QVERIFY(sql::inTurn(school, "note attempts", [&]() -> core::Status {
            sql::AuditBatch batch(school);
            for (int k = 0; k < 505; ++k)
                if (auto noted = batch.note("system", "attempt.add", "attempt:" + std::to_string(k)); !noted)
                    return noted;
            return batch.seal();
        }));
    }
    start();
    logIn("admin");
    openSchool(ui::admin::AdminPage::Audit);
    const auto* rows = child<QTableView>("audit")->model();
    const auto* counted = child<QLabel>("auditCount");
    QTRY_COMPARE_WITH_TIMEOUT(rows->rowCount(), 500, kPatienceMs);
    child<QLineEdit>("auditSearch")->setText("entered a person");
    QCOMPARE(rows->rowCount(), 0);
    QVERIFY2(counted->text().contains("newest 500"), qPrintable(counted->text()));
    QVERIFY(child<QPushButton>("olderAudit")->isEnabled());
    auto* without = child<QCheckBox>("auditNoAttempts");
    QVERIFY(!without->accessibleName().isEmpty());
    without->click();
    QTRY_COMPARE_WITH_TIMEOUT(rows->rowCount(), count("audit WHERE action = 'person.add'"), kPatienceMs);
    QVERIFY(rows->rowCount() >= 3);
    // All of them were read: there is nothing that older ones could bring.
    QCOMPARE(counted->text(), QString::number(rows->rowCount()) + " rows");
    QVERIFY(!child<QPushButton>("olderAudit")->isEnabled());
    child<QLineEdit>("auditSearch")->clear();
    // Up to the newest that is shown: what a login raises is noted while it is looked at.
    const auto there = [&](const QByteArray& which) {
        return count("audit WHERE " + which + " seq <= " + rows->index(0, 0).data().toString().toLatin1());
    };
    QCOMPARE(rows->rowCount(), there("action != 'attempt.add' AND"));
    // With attempts again, and older ones asked for twice come once.
    without->click();
    QTRY_COMPARE_WITH_TIMEOUT(rows->rowCount(), 500, kPatienceMs);
    click("olderAudit");
    click("olderAudit");
    QTRY_COMPARE_WITH_TIMEOUT(rows->rowCount(), there(""), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(!child<QPushButton>("olderAudit")->isEnabled(), kPatienceMs);
    QCOMPARE(rows->rowCount(), there(""));
}

void TestSchoolOffice::whatWasDoneStandsInTheAudit()
{
    start();
    logIn("admin");
    openSchool(ui::admin::AdminPage::Audit);
    const auto* rows = child<QTableView>("audit")->model();
    QTRY_VERIFY_WITH_TIMEOUT(rows->rowCount() > 5, kPatienceMs);
    // An admin's login also raises what passwords cost, once that is found to be too little for this computer.
    int login = 0;
    while (rows->index(login, 3).data().toString() == "changed a setting")
        ++login;
    QCOMPARE(rows->index(login, 3).data().toString(), QString("logged in"));
    QCOMPARE(rows->index(login, 2).data().toString(), QString("Ada Admin (admin)"));
    child<QLineEdit>("auditSearch")->setText("one-time");
    QCOMPARE(rows->rowCount(), 3);
    QVERIFY(child<QLabel>("auditCode")->text().contains(QString::number(count("audit")) + '-'));
    // What does not fit into its column ends in "…", and is there to be read.
    const QString longName(200, 'w');
    child<ui::admin::AuditPart>()->setRows(
        {{1, "2026-05-04T10:20:30Z", "", "preset.add", "preset:" + longName.toStdString() + " v1", "{}", ""}}, "1-0",
        false);
    child<QLineEdit>("auditSearch")->clear();
    QVERIFY(rows->index(0, 4).data().toString().contains(longName));
    QVERIFY(rows->index(0, 4).data(Qt::ToolTipRole).toString().contains(longName));
    QVERIFY(child<QTableView>("audit")->columnWidth(4) <= 320);
    child<ui::admin::AdminPage>()->show(ui::admin::AdminPage::Station);
    auto* idle = child<QSpinBox>("idleMinutes");
    QTRY_COMPARE_WITH_TIMEOUT(idle->value(), 10, kPatienceMs);
    idle->setValue(3);
    emit idle->editingFinished();
    QTRY_COMPARE_WITH_TIMEOUT(count("settings WHERE name = 'idle.minutes' AND value = '3'"), 1, kPatienceMs);
}

int main(int argc, char** argv)
{
    return support::openGlMain<TestSchoolOffice>(argc, argv);
}

#include "tst_school_office.moc"
