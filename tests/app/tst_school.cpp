// SPDX-License-Identifier: GPL-3.0-or-later
// The whole program and the school's database: people come and go, and the database is damaged, gone, locked or full.
#include <array>

#include <sys/wait.h>
#include <unistd.h>

#include <QAbstractButton>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QFile>
#include <QFileDialog>
#include <QHeaderView>
#include <QJsonDocument>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QListWidget>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QScopeGuard>
#include <QSlider>
#include <QSpinBox>
#include <QSqlQuery>
#include <QStyleHints>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include "app/Application.h"
#include "database/sql/Attempts.h"
#include "database/sql/Audit.h"
#include "database/sql/Backups.h"
#include "database/sql/Classes.h"
#include "database/sql/ExamStarts.h"
#include "database/sql/Logins.h"
#include "database/sql/People.h"
#include "database/sql/Presets.h"
#include "database/sql/Settings.h"
#include "database/sql/Statement.h"
#include "lessons/LessonCatalog.h"
#include "lessons/LessonReader.h"
#include "lessons/PresetFile.h"
#include "tests/database/SchoolRig.h"
#include "tests/support/OpenGlMain.h"
#include "ui/admin/AdminPage.h"
#include "ui/admin/AuditPart.h"
#include "ui/admin/BackupPart.h"
#include "ui/admin/RosterPart.h"
#include "ui/charts/ChartPanel.h"
#include "ui/people/AssignPage.h"
#include "ui/people/ClassPage.h"
#include "ui/people/HistoryModel.h"
#include "ui/people/HistoryPage.h"
#include "ui/people/LoginPage.h"
#include "ui/people/TalkPanel.h"
#include "ui/presets/PresetsPage.h"
#include "ui/report/Report.h"
#include "ui/shell/Actions.h"
#include "ui/shell/MessageBar.h"
#include "ui/shell/TabularLabel.h"
#include "ui/shell/Tour.h"
#include "ui/study/Forecast.h"
#include "ui/study/HeatMap.h"
#include "ui/study/LessonCards.h"
#include "ui/study/LessonsPage.h"
#include "ui/study/ScorePage.h"
#include "ui/text/Language.h"
#include "ui/text/Texts.h"
#include "ui/tooth/ToothView.h"

using namespace database;
using ui::people::Door;

namespace {
constexpr int kPatienceMs = 30000;
const std::string kPassword = "correct horse";

/// A lesson of the teacher's that is an exam, while this lives.
class Exam
{
public:
    Exam()
    {
        QDir().mkpath(QFileInfo(m_file).absolutePath());
        QFile lesson(m_file);
        lesson.open(QIODevice::WriteOnly);
        lesson.write(R"({"format": 1, "based_on": "decay-36-1-small.lesson.json", "id": "exam-36", "exam": true,
                         "title": {"en": "The exam"}})");
    }
    ~Exam() { QFile::remove(m_file); }
    Exam(const Exam&) = delete;
    Exam& operator=(const Exam&) = delete;
    [[nodiscard]] const QString& file() const { return m_file; }

private:
    QString m_file = QDir(lessons::teachersFolder()).filePath("exam-36.lesson.json");
};
}  // namespace

class TestSchool : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup() { m_application.reset(); }

    void aDatabaseIsRestoredFromTheDoor_data();
    void aDatabaseIsRestoredFromTheDoor();
    void aSchoolWithoutPeopleIsNotBackedUp();
    void aLockedDatabaseIsTriedAgain();
    void aFileThatIsMovedAwayIsMissed();
    void whoIsDisabledIsShownOut();
    void nobodySeesTheClassOfWhoLeft();
    void aClassReportIsNoted();
    void theCardOfAnotherKeepsItsNameInAnotherLanguage();
    void anotherScoreIsNotOverruledUnseen();
    void theListFollowsWhatOthersSay();
    void whoLeftHisPlaceComesBackWithoutTheDatabase();
    void aLoginForgetsWhatWasMistyped();
    void whoWasLateToCreateTheSchoolIsAGuestOfIt();
    void aLateAnswerLetsNobodyIn();
    void nobodyWaitsAtTheDoorForEver();
    void eachDayHasItsBackup();
    void whoIsDisabledIsShownOutByLongWork();
    void whoseRoleWasChangedIsShownOut();
    void whatCostPointsInFreePracticeHasItsName();
    void twoAdminsUndoNothingOfEachOther();
    void whatAnotherAdminHasChangedIsToldBeforeItIsUndone_data();
    void whatAnotherAdminHasChangedIsToldBeforeItIsUndone();
    void aSchoolThatIsOpenElsewhereLogsNobodyOut();
    void aRestoreThrowsNobodyElseOut();
    void aClassReportIsOfTheClassThatWasShown();
    void underAClasssNameStandsNoOther();
    void whichClassesThereAreIsReadAgain();
    void whoIsTakenOutOfAClassSeesItNoLonger();
    void aLateAnswerTearsNobodyAway();
    void whatIsTypedWaitsForItsWriter();
    void theFolderOfLessonsIsNamed();
    void whatTheDiskRefusesIsKeptWhenItCanBe();
    void whatTheDiskRefusesIsKeptWhenItsMakerHasGone();
    void whatWaitsToBeKeptIsNotOffered();
    void whatIsKeptDuringAReplayIsNotOffered();
    void whatWasKeptBeforeAKillIsNotOffered();
    void anExamThatWasNotKeptIsGradedAgain();
    void whatWasGradedAndNotKeptIsUnfinished();
    void nothingIsCutWhileAGradeIsWorkedOut();
    void whoComesNextHasDecayToTakeOut();
    void aGuestsGradeIsKeptWhenHeLogsIn();
    void aGuestsGradeIsNobodysAfterAWhile();
    void aGuestsGradeIsNotAnothers();
    void aGuestsGradeCountsAsAnAttempt();
    void whatWasGradedIsNotUnfinished_data();
    void whatWasGradedIsNotUnfinished();
    void nobodyIsOfferedAnothersWork();
    void theLessonsForgetWhoLeft();
    void anOpenedAttemptHasThoseBeforeIt();
    void onesOwnAttemptsAreComparedInAReplay();
    void theSchoolsPresetIsTheAdmins();
    void theNextToothFeelsAsWasChosenElsewhere();
    void whatAnotherAdminHasChosenIsNotUndone();
    void aPresetIsRetiredAndTakenUpAgain();
    void whatIsGivenIsDueAndLimited();
    void noneBeginsAgainWhenTheAttemptsAreUsedUp();
    void aPresetGivesNoAttemptBack();
    void anUnfinishedAttemptIsNotTakenUpWhenTheAttemptsAreUsedUp();
    void anExamThatIsBrokenOffIsToldOf();
    void anExamIsBegunInOneWindow();
    void anExamThatIsTakenUpWasBegunOnce();
    void anExamHidesEarlierAttempts();
    void aGuestsExamIsNobodys();
    void lessonsAreChangedByWhoTeaches();
    void anAdminEntersAndChangesPeople();
    void aClassListIsSeenBeforeItIsEntered();
    void aBackupIsMadeTriedAndRestored();
    void anotherSchoolsBackupIsNotRestored();
    void aNetworkDriveIsForOneAndIsBackedUp();
    void whatWasDoneStandsInTheAudit();
    void attemptsDoNotHideWhatWasDone();
    void theDatabaseIsNamedWithItsWholePath();
    void onesOwnPasswordIsChanged();
    void aTeacherAssignsLessonsAndTakesThemBack();
    void commentsArePinnedToMomentsAndPlaces();
    void withoutItsRecordingAnAttemptIsOpenedAndOverruled_data();
    void withoutItsRecordingAnAttemptIsOpenedAndOverruled();
    void aScoreCardIsSavedWithItsAuditCode();
    void withoutADatabaseTheCardSaysSo();
    void everybodyIsShownRoundOnce();
    void aTeachersTourBeginsWithHisClasses();

private:
    template <class T>
    T* child(const char* name = "") const
    {
        return m_application->window().findChild<T*>(QString::fromLatin1(name));
    }
    [[nodiscard]] ui::shell::Actions& actions() const { return *child<ui::shell::Actions>(); }
    [[nodiscard]] QString message() const { return child<ui::shell::MessageBar>()->sentence(); }
    [[nodiscard]] QString removed() const { return child<ui::shell::TabularLabel>("enamelRemoved")->text(); }
    [[nodiscard]] QString saidAtDoor() const
    {
        QStringList words;
        for (const QLabel* label : child<ui::people::LoginPage>()->findChildren<QLabel*>())
            words << label->text();
        return words.join('\n');
    }
    [[nodiscard]] Door door() const { return child<ui::people::LoginPage>()->door(); }
    [[nodiscard]] QString file() const { return m_folder->filePath("school.sqlite"); }
    /// The program as a student starts it: at the door.
    void start(bool showsRound = false, const sql::Database::Options& opening = {});
    void click(const char* button) const { QTest::mouseClick(child<QPushButton>(button), Qt::LeftButton); }
    void logIn(const QString& name) const;
    /// From wherever he is.
    void leaveFor(const QString& name) const;
    void toTheTooth() const;
    void openSchool(ui::admin::AdminPage::Part part) const;
    void drill(double xMm) const;
    void beginLesson(const std::string& id) const;
    /// So many attempts, to Sam's class.
    void give(const std::string& lesson, int attempts) const;
    /// An admin at another station keeps a preset, if it is not there, and says that everybody's teeth feel like it.
    void chooseElsewhere(const std::string& preset) const;
    /// Has a lesson's work graded, and expects a little of it.
    void gradeLesson() const;
    /// Has the work graded and waits until `keeping` is said of it; empty: until nothing is.
    void grade(const QString& said) const;
    [[nodiscard]] QString keeping() const
    {
        const auto* label = child<QLabel>("historyRemark");
        return label->isVisible() ? label->text() : QString();
    }
    /// What the database holds, asked beside the program.
    [[nodiscard]] int attemptsKept() const { return count("attempts"); }
    [[nodiscard]] int count(const char* rows) const;
    /// Has everything checked with the audit codes of reports: that of now, another one, and none.
    void checkReportCodes() const;
    /// Opens the newest attempt of the history page.
    void openNewest() const;
    [[nodiscard]] QList<QPushButton*> pins() const;
    /// A second class: with Sue in it, and Ines.
    void enterSecondClass() const;
    /// Saves the card that is shown as a PDF, and waits until that is said.
    void saveCard(const QString& path) const;
    void typeBehindSamsName();

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<app::Application> m_application;
};

/// A school with an admin and two students.
void TestSchool::init()
{
    ui::text::Language::choose("en_GB");
    m_folder = std::make_unique<QTemporaryDir>();
    const auto database = sql::Database::open(file()).value();
    const auto key = StationKey::readOrMake(m_folder->filePath("station.key")).value();
    const sql::School school{database->handle(), key};
    const auto admin =
        sql::Logins::createFirstAdmin(school, {"admin", "Ada", "Admin", Role::Admin}, kPassword, {1, 8192}).value();
    for (const char* name : {"sam", "sue"}) {
        const auto entered = sql::addPerson(school, admin, {name, name, "Student", Role::Student}).value();
        QVERIFY(sql::Logins::redeem(school, name, entered.code, kPassword));
    }
    const auto teacher = sql::addPerson(school, admin, {"ines", "Ines", "Teach", Role::Instructor}).value();
    QVERIFY(sql::Logins::redeem(school, "ines", teacher.code, kPassword));
    const ClassId ofClass = sql::addClass(school, admin, "DEN101-A").value();
    for (const char* name : {"sam", "ines"}) {
        const auto id = sql::ask(school.db, "SELECT id FROM people WHERE username = ?", "read", {QLatin1String(name)});
        QVERIFY(sql::enrol(school, admin, ofClass, {id.value().toLongLong()}, true));
    }
}

void TestSchool::start(bool showsRound, const sql::Database::Options& opening)
{
    app::WindowOptions options;
    options.opening = opening;
    options.source = {36};
    options.database = file();
    options.asksWho = true;
    options.showsRound = showsRound;
    m_application = app::Application::make(options).value();
    m_application->show();
}

void TestSchool::logIn(const QString& name) const
{
    QTRY_VERIFY_WITH_TIMEOUT(child<QLineEdit>("username")->isEnabled(), kPatienceMs);
    child<QLineEdit>("username")->setText(name);
    child<QLineEdit>("password")->setText(QString::fromStdString(kPassword));
    click("logIn");
    QTRY_COMPARE_WITH_TIMEOUT(actions().account->text(), name, kPatienceMs);
}

void TestSchool::leaveFor(const QString& name) const
{
    actions().lock->trigger();
    QCOMPARE(door(), Door::Locked);
    click("otherLogin");
    QTRY_COMPARE_WITH_TIMEOUT(door(), Door::Login, kPatienceMs);
    logIn(name);
}

void TestSchool::toTheTooth() const
{
    for (int k = 0; k < 3 && !m_application->window().view().isVisible(); ++k)
        actions().back->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(actions().grade->isEnabled(), kPatienceMs);
}

void TestSchool::drill(double xMm) const
{
    ui::tooth::ToothView& view = m_application->window().view();
    const QString before = removed();
    const glm::dvec2 pixel = view.camera().pixelOf({xMm, 1.0, -1.0});
    const QPoint at(qRound(pixel.x), qRound(pixel.y));
    QTest::mouseMove(&view, at);
    QTest::mousePress(&view, Qt::LeftButton, {}, at);
    QTRY_VERIFY_WITH_TIMEOUT(removed() != before, kPatienceMs);
    QTest::mouseRelease(&view, Qt::LeftButton, {}, at);
    QTest::qWait(500);  // the stroke ends, and is told
}

void TestSchool::grade(const QString& said) const
{
    actions().grade->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::ScorePage>()->isVisible(), kPatienceMs);
    QTRY_VERIFY2_WITH_TIMEOUT(keeping().contains(said), qPrintable(keeping()), kPatienceMs);
}

void TestSchool::beginLesson(const std::string& id) const
{
    for (const lessons::CatalogEntry& entry : lessons::readCatalog(lessons::teachersFolder()))
        if (entry.read.lesson && entry.read.lesson->id == id)
            emit m_application->window().lessonChosen(*entry.read.lesson);
    QTest::qWait(100);
    QTRY_VERIFY_WITH_TIMEOUT(actions().grade->isEnabled(), kPatienceMs);
    QTest::qWait(500);  // the tooth has come to the servo
}

void TestSchool::give(const std::string& lesson, int attempts) const
{
    const auto database = sql::Database::open(file()).value();
    const auto key = StationKey::readOrMake(m_folder->filePath("station.key")).value();
    const sql::School school{database->handle(), key};
    const auto admin = sql::Logins::login(school, "admin", kPassword).value();
    const ClassId ofClass = sql::listClasses(school, admin).value().front().id;
    QVERIFY(sql::assign(school, admin, {0, ofClass, lesson, "", attempts}));
}

void TestSchool::chooseElsewhere(const std::string& preset) const
{
    const auto database = sql::Database::open(file()).value();
    const auto key = StationKey::readOrMake(m_folder->filePath("station.key")).value();
    const sql::School school{database->handle(), key};
    const auto admin = sql::Logins::login(school, "admin", kPassword).value();
    core::settings::FeelPreset kept = lessons::shippedPresets().front();
    kept.name = preset;
    kept.enamelRate *= 0.5;
    kept = lessons::hashed(kept);
    const QByteArray json = QJsonDocument(lessons::toJson(kept)).toJson(QJsonDocument::Compact);
    QVERIFY(sql::addPreset(school, admin, {kept.name, kept.version, kept.hash, json.toStdString()}));
    QVERIFY(sql::changeSetting(school, admin, "preset.in_use", preset + " v1"));
}

void TestSchool::gradeLesson() const
{
    actions().grade->trigger();
    QTRY_VERIFY2_WITH_TIMEOUT(child<ui::study::Forecast>()->isVisible(), qPrintable(message()), kPatienceMs);
    QTest::keyClick(child<QSlider>("expected"), Qt::Key_Right);
    QTest::keyClick(child<ui::study::Forecast>()->findChild<QRadioButton*>(), Qt::Key_Space);
    click("showScore");
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::ScorePage>()->isVisible(), kPatienceMs);
}

int TestSchool::count(const char* rows) const
{
    const auto database = sql::Database::open(file());
    return database ? sql::ask((*database)->handle(),
                               QStringLiteral("SELECT count(*) FROM %1").arg(QLatin1String(rows)), "count")
                          .value()
                          .toInt()
                    : -1;
}

void TestSchool::openNewest() const
{
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::people::HistoryPage>()->isVisible(), kPatienceMs);
    child<QTableView>("attempts")->selectRow(0);
    click("openAttempt");
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::ScorePage>()->isVisible(), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("counts")->isVisible(), kPatienceMs);
}

QList<QPushButton*> TestSchool::pins() const
{
    QList<QPushButton*> found;
    for (QPushButton* button : child<ui::people::TalkPanel>()->findChildren<QPushButton*>())
        if (button->property("kind") == "chip")
            found << button;
    return found;
}

void TestSchool::saveCard(const QString& path) const
{
    emit child<ui::study::ScorePage>()->pdfWanted();
    auto* dialog = child<QFileDialog>("QFileDialog");
    QVERIFY(dialog != nullptr);
    emit dialog->fileSelected(path);
    dialog->reject();
    QTRY_VERIFY2_WITH_TIMEOUT(child<QLabel>("scoreSaid")->text().contains(QFileInfo(path).fileName()),
                              qPrintable(child<QLabel>("scoreSaid")->text()), kPatienceMs);
    QFile pdf(path);
    QVERIFY(pdf.open(QIODevice::ReadOnly) && pdf.read(5) == "%PDF-");
}

void TestSchool::aDatabaseIsRestoredFromTheDoor_data()
{
    QTest::addColumn<bool>("isGone");
    QTest::addColumn<bool>("isMovedAside");
    QTest::newRow("noise in its place") << false << false;
    QTest::newRow("gone") << true << false;
    QTest::newRow("moved aside, by a restore that was killed") << true << true;
}

/// What was delivered after the backup is delivered again.
void TestSchool::aDatabaseIsRestoredFromTheDoor()
{
    QFETCH(bool, isGone);
    QFETCH(bool, isMovedAside);
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
    const QString aside = m_folder->filePath(
        QDateTime::currentDateTimeUtc().toString("'replaced-'yyyy-MM-dd-HH.mm.ss-") + QFileInfo(file()).fileName());
    if (isMovedAside)
        QVERIFY(database.rename(aside));
    else if (isGone)
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
    QStringList replaced = QDir(m_folder->path()).entryList({"replaced-*.sqlite"}, QDir::Files);
    if (isMovedAside)
        replaced.removeOne(QFileInfo(aside).fileName());
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
    // What was moved aside is later than the backup.
    QCOMPARE(noted.front().startsWith("backup:replaced-"), isMovedAside);
}

/// Its backup would be offered for restoring, and put an empty school in the place of a full one.
void TestSchool::aSchoolWithoutPeopleIsNotBackedUp()
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

void TestSchool::aLockedDatabaseIsTriedAgain()
{
    auto other = sql::Database::open(file()).value();
    QVERIFY(sql::execute(other->handle(), "PRAGMA locking_mode = EXCLUSIVE", "lock"));
    QVERIFY(sql::execute(other->handle(), "BEGIN EXCLUSIVE", "lock"));
    start();
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("tryAgain")->isVisible(), kPatienceMs);
    QVERIFY(!child<QPushButton>("restoreBackup")->isVisible());
    QVERIFY2(saidAtDoor().contains("Another program is writing to it"), qPrintable(saidAtDoor()));
    other.reset();
    click("tryAgain");
    QTRY_VERIFY_WITH_TIMEOUT(!child<QPushButton>("tryAgain")->isVisible(), kPatienceMs);
    logIn("sam");
}

/// Else everything would be written into a file that nobody finds any more.
void TestSchool::aFileThatIsMovedAwayIsMissed()
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

void TestSchool::whoIsDisabledIsShownOut()
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

/// Otto has no class; what he comes to is not Ines's, whose page it was.
void TestSchool::nobodySeesTheClassOfWhoLeft()
{
    {
        const auto database = sql::Database::open(file()).value();
        const sql::School school{database->handle(), StationKey::readOrMake(m_folder->filePath("station.key")).value()};
        const auto admin = sql::Logins::login(school, "admin", kPassword).value();
        const auto otto = sql::addPerson(school, admin, {"otto", "Otto", "Teach", Role::Instructor}).value();
        QVERIFY(sql::Logins::redeem(school, "otto", otto.code, kPassword));
    }
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    grade("first grade");
    leaveFor("ines");
    const auto* const matrix = child<QTableView>("matrix")->model();
    const auto* const attempts = child<QTableView>("attempts")->model();
    QTRY_COMPARE_WITH_TIMEOUT(matrix->rowCount(), 1, kPatienceMs);
    emit child<QTableView>("matrix")->verticalHeader()->sectionDoubleClicked(0);
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::people::HistoryPage>()->isVisible() && attempts->rowCount() == 1, kPatienceMs);
    actions().lock->trigger();
    click("otherLogin");
    QTRY_COMPARE_WITH_TIMEOUT(door(), Door::Login, kPatienceMs);
    QCOMPARE(matrix->rowCount(), 0);
    QCOMPARE(attempts->rowCount(), 0);
    logIn("otto");
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::people::ClassPage>()->isVisible(), kPatienceMs);
    QTest::qWait(500);
    QCOMPARE(matrix->rowCount(), 0);
    QVERIFY(child<QLabel>("classEmpty")->isVisible());
    QVERIFY(child<QLabel>("classEmpty")->text().contains("Here you will see your classes"));
    for (const QLabel* label : m_application->window().findChildren<QLabel*>())
        QVERIFY2(!label->isVisible() || !label->text().contains("sam"), qPrintable(label->text()));
}

/// Whatever leaves the school with names and marks.
void TestSchool::aClassReportIsNoted()
{
    start();
    logIn("ines");
    actions().classes->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(child<QTableView>("matrix")->model()->rowCount(), 1, kPatienceMs);
    const auto noted = [this] {
        return sql::ask(sql::Database::open(file()).value()->handle(),
                        "SELECT count(*) FROM audit WHERE action = 'class.export'", "count")
            ->toInt();
    };
    const QString table = m_folder->filePath("class.csv");
    emit child<ui::people::ClassPage>()->tableWanted(table);
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(table), kPatienceMs);
    QCOMPARE(noted(), 1);
    QVERIFY(!(QFile::permissions(table) & (QFile::ReadGroup | QFile::ReadOther)));
    // What somebody has let others read stays so.
    QVERIFY(QFile::setPermissions(table, QFile::permissions(table) | QFile::ReadOther));
    QVERIFY(child<ui::people::ClassPage>()->saveTable(table));
    QVERIFY(QFile::permissions(table) & QFile::ReadOther);
    // Who thinks otherwise, or has no printer, has taken nothing out.
    emit child<ui::people::ClassPage>()->printWanted();
    const auto printing = [this]() -> QDialog* {
        for (auto* dialog : m_application->window().findChildren<QDialog*>())
            if (dialog->inherits("QPrintDialog"))
                return dialog;
        return nullptr;
    };
    const auto isRefused = [this] {
        const auto labels = child<ui::people::ClassPage>()->findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(),
                           [](const QLabel* label) { return label->text().contains("There is no printer"); });
    };
    QTRY_VERIFY_WITH_TIMEOUT(printing() != nullptr || isRefused(), kPatienceMs);
    if (printing() != nullptr)
        printing()->reject();
    QTest::qWait(300);
    QCOMPARE(noted(), 1);
}

/// On the screen and on paper, whatever lies on one's own table.
void TestSchool::theCardOfAnotherKeepsItsNameInAnotherLanguage()
{
    start();
    logIn("sam");
    beginLesson("class1-36");
    drill(-2.0);
    gradeLesson();
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    leaveFor("ines");
    actions().classes->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(child<QTableView>("matrix")->model()->rowCount(), 1, kPatienceMs);
    emit child<QTableView>("matrix")->verticalHeader()->sectionDoubleClicked(0);
    openNewest();
    const auto* const page = child<ui::study::ScorePage>();
    const QString english = page->card().lesson;
    ui::text::Language::choose("de");
    QTRY_VERIFY_WITH_TIMEOUT(page->card().lesson != english, kPatienceMs);
    QVERIFY2(page->card().lesson.contains("36"), qPrintable(page->card().lesson));
}

void TestSchool::anotherScoreIsNotOverruledUnseen()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    grade("first grade");
    leaveFor("ines");
    actions().classes->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(child<QTableView>("matrix")->model()->rowCount(), 1, kPatienceMs);
    emit child<QTableView>("matrix")->verticalHeader()->sectionDoubleClicked(0);
    openNewest();
    auto* const talk = child<ui::people::TalkPanel>();
    QTRY_VERIFY_WITH_TIMEOUT(talk->findChild<QLineEdit*>("reason")->isVisible(), kPatienceMs);
    talk->findChild<QDoubleSpinBox*>("givenPoints")->setValue(55.5);
    talk->findChild<QLineEdit*>("reason")->setText("not so neat");
    // Meanwhile, at another station.
    {
        const auto database = sql::Database::open(file()).value();
        const sql::School school{database->handle(), StationKey::readOrMake(m_folder->filePath("station.key")).value()};
        const auto ines = sql::Logins::login(school, "ines", kPassword).value();
        const auto id = sql::ask(database->handle(), "SELECT max(id) FROM attempts", "read")->toLongLong();
        QVERIFY(sql::overrideScore(school, ines, {id}, 910, "neat"));
    }
    click("giveScore");
    const auto* const fault = talk->findChild<QLabel*>("fault");
    QTRY_VERIFY_WITH_TIMEOUT(fault->isVisible(), kPatienceMs);
    QVERIFY2(fault->text().contains("Somebody else has changed it meanwhile"), qPrintable(fault->text()));
    QTRY_VERIFY_WITH_TIMEOUT(talk->findChild<QLabel*>("counts")->text().contains("91.0"), kPatienceMs);
    // What was being given stays, to be given again or not.
    QCOMPARE(talk->findChild<QDoubleSpinBox*>("givenPoints")->value(), 55.5);
    QCOMPARE(talk->findChild<QLineEdit*>("reason")->text(), QString("not so neat"));
    QCOMPARE(count("overrides"), 1);
    click("giveScore");
    QTRY_COMPARE_WITH_TIMEOUT(count("overrides"), 2, kPatienceMs);
}

/// By F5, and by a card that was opened.
void TestSchool::theListFollowsWhatOthersSay()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    grade("first grade");
    leaveFor("ines");
    QTRY_COMPARE_WITH_TIMEOUT(child<QTableView>("matrix")->model()->rowCount(), 1, kPatienceMs);
    emit child<QTableView>("matrix")->verticalHeader()->sectionDoubleClicked(0);
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::people::HistoryPage>()->isVisible(), kPatienceMs);
    const auto listed = [this] {
        const auto* model = child<QTableView>("attempts")->model();
        return model->index(0, ui::people::HistoryModel::Score).data().toString();
    };
    const auto giveElsewhere = [this](int tenths) {
        const auto database = sql::Database::open(file()).value();
        const sql::School school{database->handle(), StationKey::readOrMake(m_folder->filePath("station.key")).value()};
        const auto ines = sql::Logins::login(school, "ines", kPassword).value();
        const auto id = sql::ask(database->handle(), "SELECT max(id) FROM attempts", "read")->toLongLong();
        QVERIFY(sql::overrideScore(school, ines, {id}, tenths, "neat"));
    };
    giveElsewhere(910);
    QVERIFY(listed() != "91.0");
    QVERIFY(actions().readAgain->isEnabled());
    actions().readAgain->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(listed(), QString("91.0"), kPatienceMs);
    giveElsewhere(820);
    openNewest();
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("counts")->text().contains("82.0"), kPatienceMs);
    actions().back->trigger();
    QVERIFY(child<ui::people::HistoryPage>()->isVisible());
    QTRY_COMPARE_WITH_TIMEOUT(listed(), QString("82.0"), kPatienceMs);
    // Who made it reads it anew as well.
    leaveFor("sam");
    actions().attempts->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(listed(), QString("82.0"), kPatienceMs);
    giveElsewhere(730);
    actions().readAgain->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(listed(), QString("73.0"), kPatienceMs);
}

void TestSchool::whoLeftHisPlaceComesBackWithoutTheDatabase()
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
void TestSchool::aLoginForgetsWhatWasMistyped()
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
void TestSchool::whoWasLateToCreateTheSchoolIsAGuestOfIt()
{
    QVERIFY(QFile::remove(file()));
    start();
    QTRY_COMPARE_WITH_TIMEOUT(door(), Door::NewSchool, kPatienceMs);
    {
        const auto database = sql::Database::open(file()).value();
        const sql::School school{database->handle(), StationKey::readOrMake(m_folder->filePath("station.key")).value()};
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
void TestSchool::aLateAnswerLetsNobodyIn()
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
void TestSchool::nobodyWaitsAtTheDoorForEver()
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
void TestSchool::eachDayHasItsBackup()
{
    start();
    const QString folder = sql::backupFolder(file());
    QTRY_COMPARE_WITH_TIMEOUT(sql::backupsIn(folder).size(), 1, kPatienceMs);
    QVERIFY(QFile::rename(sql::backupsIn(folder).front(), folder + "/backup-2026-01-01-10.00.00.sqlite"));
    auto* watch = m_application->findChild<QTimer*>("backupWatch");
    QVERIFY(watch != nullptr && watch->isActive());
    watch->setInterval(20);
    QTRY_COMPARE_WITH_TIMEOUT(sql::backupsIn(folder).size(), 2, kPatienceMs);
}

void TestSchool::whoIsDisabledIsShownOutByLongWork()
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
void TestSchool::whoseRoleWasChangedIsShownOut()
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

/// As in the lessons, and one criterion once.
void TestSchool::whatCostPointsInFreePracticeHasItsName()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    grade("first grade");
    actions().attempts->trigger();
    const auto* chart = child<ui::charts::ChartPanel>("otherChart");
    const auto names = [chart] {
        QStringList all;
        if (const auto* bars = std::get_if<ui::charts::Bars>(&chart->chart().content))
            for (const auto& bar : bars->bars)
                all << bar.name;
        return all;
    };
    QTRY_VERIFY2_WITH_TIMEOUT(names().contains("Sound tissue removed beside the decay") ||
                                  names().contains("Pulp opened") || names().contains("Decay left"),
                              qPrintable(names().join(", ")), kPatienceMs);
    QVERIFY2(!names().contains("Sound tissue") && !names().contains("Caries left"), qPrintable(names().join(", ")));
}

/// On the page of the people, as their admin.
void TestSchool::typeBehindSamsName()
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
void TestSchool::twoAdminsUndoNothingOfEachOther()
{
    typeBehindSamsName();
    const auto database = sql::Database::open(file()).value();
    const sql::School school{database->handle(), StationKey::readOrMake(m_folder->filePath("station.key")).value()};
    const auto other = sql::Logins::login(school, "admin", kPassword).value();
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

void TestSchool::whatAnotherAdminHasChangedIsToldBeforeItIsUndone_data()
{
    QTest::addColumn<bool>("isReadAgain");
    QTest::newRow("he saves it without looking again") << false;
    QTest::newRow("the list was read again while he typed") << true;
}

/// The same field: the later one is told what there is now, and puts his in the place of it all the same.
void TestSchool::whatAnotherAdminHasChangedIsToldBeforeItIsUndone()
{
    QFETCH(bool, isReadAgain);
    typeBehindSamsName();
    const auto database = sql::Database::open(file()).value();
    const sql::School school{database->handle(), StationKey::readOrMake(m_folder->filePath("station.key")).value()};
    const auto other = sql::Logins::login(school, "admin", kPassword).value();
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
void TestSchool::aSchoolThatIsOpenElsewhereLogsNobodyOut()
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
void TestSchool::aRestoreThrowsNobodyElseOut()
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

void TestSchool::enterSecondClass() const
{
    const auto database = sql::Database::open(file()).value();
    const sql::School school{database->handle(), StationKey::readOrMake(m_folder->filePath("station.key")).value()};
    const auto admin = sql::Logins::login(school, "admin", kPassword).value();
    const ClassId other = sql::addClass(school, admin, "DEN102-B").value();
    for (const char* name : {"sue", "ines"}) {
        const auto id = sql::ask(school.db, "SELECT id FROM people WHERE username = ?", "r", {QLatin1String(name)});
        QVERIFY(sql::enrol(school, admin, other, {id.value().toLongLong()}, true));
    }
}

/// Another was chosen by the time that the audit had answered.
void TestSchool::aClassReportIsOfTheClassThatWasShown()
{
    enterSecondClass();
    start();
    logIn("ines");
    const auto* const matrix = child<QTableView>("matrix")->model();
    const auto student = [matrix] { return matrix->headerData(0, Qt::Vertical).toString(); };
    QTRY_VERIFY_WITH_TIMEOUT(matrix->rowCount() == 1 && student().startsWith("sam"), kPatienceMs);
    auto* const classes = child<QComboBox>("classChooser");
    const QString table = m_folder->filePath("class.csv");
    emit child<ui::people::ClassPage>()->tableWanted(table);
    classes->setCurrentIndex(classes->findText("DEN102-B", Qt::MatchStartsWith));
    // Nor is one that has not been read yet taken out under the other's name.
    const QString none = m_folder->filePath("none.csv");
    emit child<ui::people::ClassPage>()->tableWanted(none);
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(table), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(student().startsWith("sue"), kPatienceMs);
    QFile written(table);
    QVERIFY(written.open(QIODevice::ReadOnly));
    const QByteArray rows = written.readAll();
    const auto noted = sql::ask(sql::Database::open(file()).value()->handle(),
                                "SELECT classes.name FROM audit JOIN classes ON audit.object = 'class:' || classes.id "
                                "WHERE action = 'class.export'",
                                "read");
    QCOMPARE(noted->toString(), QString("DEN101-A"));
    QVERIFY2(rows.contains("sam"), rows.constData());
    QVERIFY(!QFile::exists(none));
}

/// Where it cannot be read it says so, and is read again: by F5, and by itself.
void TestSchool::underAClasssNameStandsNoOther()
{
    enterSecondClass();
    start();
    logIn("ines");
    const auto* const matrix = child<QTableView>("matrix")->model();
    const auto student = [matrix] { return matrix->headerData(0, Qt::Vertical).toString(); };
    QTRY_VERIFY_WITH_TIMEOUT(matrix->rowCount() == 1 && student().startsWith("sam"), kPatienceMs);
    const auto name = [this](const char* from, const char* to) {
        return sql::execute(sql::Database::open(file()).value()->handle(),
                            QStringLiteral("ALTER TABLE %1 RENAME TO %2").arg(QLatin1String(from), QLatin1String(to)),
                            "name");
    };
    auto* const classes = child<QComboBox>("classChooser");
    const auto* const empty = child<QLabel>("classEmpty");
    for (const auto& [chosen, expected] : {std::pair("DEN102-B", "sue"), std::pair("DEN101-A", "sam")}) {
        QVERIFY(name("standings", "elsewhere"));
        classes->setCurrentIndex(classes->findText(chosen, Qt::MatchStartsWith));
        QCOMPARE(matrix->rowCount(), 0);
        QTRY_VERIFY2_WITH_TIMEOUT(empty->isVisible() && empty->text().contains("cannot be shown now") &&
                                      empty->text().contains("F5"),
                                  qPrintable(empty->text()), kPatienceMs);
        QCOMPARE(matrix->rowCount(), 0);
        QVERIFY(!child<QAbstractButton>("classReport")->isEnabled());
        QVERIFY(name("elsewhere", "standings"));
        if (QLatin1String(expected) == u"sue")
            actions().readAgain->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(matrix->rowCount() == 1 && student().startsWith(expected), kPatienceMs);
    }
    // What was read of the same class stays.
    QVERIFY(name("standings", "elsewhere"));
    actions().readAgain->trigger();
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("cannot be shown now"), qPrintable(message()), kPatienceMs);
    QVERIFY(matrix->rowCount() == 1 && student().startsWith("sam"));
    QVERIFY(name("elsewhere", "standings"));
    // That it could not be read is over when another is.
    classes->setCurrentIndex(classes->findText("DEN102-B", Qt::MatchStartsWith));
    QTRY_VERIFY_WITH_TIMEOUT(matrix->rowCount() == 1 && student().startsWith("sue"), kPatienceMs);
    QTRY_VERIFY2_WITH_TIMEOUT(!message().contains("cannot be shown now"), qPrintable(message()), kPatienceMs);
}

/// When a teacher logs in: they come by themselves, or by F5.
void TestSchool::whichClassesThereAreIsReadAgain()
{
    start();
    const auto name = [this](const char* from, const char* to) {
        return sql::execute(sql::Database::open(file()).value()->handle(),
                            QStringLiteral("ALTER TABLE %1 RENAME TO %2").arg(QLatin1String(from), QLatin1String(to)),
                            "name");
    };
    QTRY_VERIFY_WITH_TIMEOUT(child<QLineEdit>("username")->isEnabled(), kPatienceMs);
    const auto* const empty = child<QLabel>("classEmpty");
    const auto* const matrix = child<QTableView>("matrix")->model();
    for (const bool byHand : {true, false}) {
        QVERIFY(name("classes", "elsewhere"));
        if (byHand)
            logIn("ines");
        else
            leaveFor("ines");
        QTRY_VERIFY2_WITH_TIMEOUT(empty->isVisible() && empty->text().contains("cannot be shown now") &&
                                      empty->text().contains("F5 reads the classes again"),
                                  qPrintable(empty->text()), kPatienceMs);
        QVERIFY(name("elsewhere", "classes"));
        if (byHand)
            actions().readAgain->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(matrix->rowCount(), 1, kPatienceMs);
        QVERIFY(child<QComboBox>("classChooser")->isVisible());
    }
}

/// Nor comments he there, and he reads why.
void TestSchool::whoIsTakenOutOfAClassSeesItNoLonger()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    grade("first grade");
    leaveFor("ines");
    const auto* const matrix = child<QTableView>("matrix")->model();
    QTRY_COMPARE_WITH_TIMEOUT(matrix->rowCount(), 1, kPatienceMs);
    emit child<QTableView>("matrix")->verticalHeader()->sectionDoubleClicked(0);
    openNewest();
    auto* const words = child<QPlainTextEdit>("commentWords");
    QTRY_VERIFY_WITH_TIMEOUT(words->isVisible(), kPatienceMs);
    words->setPlainText("Half a sentence");
    QVERIFY(sql::execute(sql::Database::open(file()).value()->handle(),
                         "DELETE FROM enrolments WHERE person_id = (SELECT id FROM people WHERE username = 'ines')",
                         "write"));
    click("addComment");
    const auto* const fault = child<ui::people::TalkPanel>()->findChild<QLabel*>("fault");
    QTRY_VERIFY_WITH_TIMEOUT(fault->isVisible(), kPatienceMs);
    QVERIFY2(fault->text().contains("in none of your classes any more"), qPrintable(fault->text()));
    QCOMPARE(words->toPlainText(), QString("Half a sentence"));
    actions().back->trigger();
    actions().back->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::people::ClassPage>()->isVisible(), kPatienceMs);
    actions().readAgain->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(matrix->rowCount(), 0, kPatienceMs);
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("none of your classes any more"), qPrintable(message()), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("classEmpty")->text().contains("Here you will see your classes"),
                             kPatienceMs);
}

/// The school answers when he has gone on to the lessons, or has locked his place.
void TestSchool::aLateAnswerTearsNobodyAway()
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

/// A comment that was begun is shown to nobody else, and where it was begun it bears the name of who it is about.
void TestSchool::whatIsTypedWaitsForItsWriter()
{
    {
        const auto database = sql::Database::open(file()).value();
        const sql::School school{database->handle(), StationKey::readOrMake(m_folder->filePath("station.key")).value()};
        const auto admin = sql::Logins::login(school, "admin", kPassword).value();
        const auto sue = sql::ask(school.db, "SELECT id FROM people WHERE username = 'sue'", "read").value();
        QVERIFY(
            sql::enrol(school, admin, sql::listClasses(school, admin).value().front().id, {sue.toLongLong()}, true));
    }
    start();
    for (const char* name : {"sam", "sue"}) {
        if (QLatin1String(name) == u"sam")
            logIn(name);
        else
            leaveFor(name);
        toTheTooth();
        QTRY_COMPARE_WITH_TIMEOUT(removed(), QString("0.00"), kPatienceMs);
        drill(-2.0);
        grade("first grade");
    }
    leaveFor("ines");
    const auto* const matrix = child<QTableView>("matrix")->model();
    const auto openAttemptOf = [&](int row) {
        emit child<QTableView>("matrix")->verticalHeader()->sectionDoubleClicked(row);
        openNewest();
    };
    auto* const words = child<QPlainTextEdit>("commentWords");
    const auto* const page = child<ui::study::ScorePage>();
    actions().classes->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(matrix->rowCount(), 2, kPatienceMs);
    openAttemptOf(0);
    const QString first = page->person();
    QVERIFY(first.startsWith("sam") || first.startsWith("sue"));
    words->setPlainText("Half a sentence");
    actions().classes->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::people::ClassPage>()->isVisible(), kPatienceMs);
    openAttemptOf(1);
    QVERIFY(page->person() != first);
    QVERIFY(words->toPlainText().isEmpty());
    // The answer that loses nothing leads to whom it is about, and back to his attempts.
    m_application->window().close();
    click("questionSave");
    QTRY_COMPARE_WITH_TIMEOUT(words->toPlainText(), QString("Half a sentence"), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(page->isVisible(), kPatienceMs);
    QCOMPARE(page->person(), first);
    actions().back->trigger();
    QVERIFY(child<ui::people::HistoryPage>()->isVisible());
    const auto titles = child<ui::people::HistoryPage>()->findChildren<QLabel*>();
    QVERIFY(std::any_of(titles.begin(), titles.end(),
                        [&](const QLabel* one) { return one->isVisible() && one->text().contains(first); }));
    // Somebody else neither sees it nor is asked about it, and it is there again after another start.
    leaveFor("sam");
    actions().attempts->trigger();
    openNewest();
    QVERIFY(words->toPlainText().isEmpty());
    m_application->window().close();
    QVERIFY(!m_application->window().isVisible());
    start();
    logIn("ines");
    actions().classes->trigger();
    const auto* const matrixNow = child<QTableView>("matrix")->model();
    QTRY_COMPARE_WITH_TIMEOUT(matrixNow->rowCount(), 2, kPatienceMs);
    openAttemptOf(0);
    QTRY_COMPARE_WITH_TIMEOUT(child<QPlainTextEdit>("commentWords")->toPlainText(), QString("Half a sentence"),
                              kPatienceMs);
}

void TestSchool::theFolderOfLessonsIsNamed()
{
    start();
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("practiseAsGuest")->isVisible(), kPatienceMs);
    click("practiseAsGuest");
    toTheTooth();
    // Nothing here shows folders.
    const QByteArray path = qgetenv("PATH");
    const auto asItWas = qScopeGuard([&path] { qputenv("PATH", path); });
    for (const char* name : {"BROWSER", "DEFAULT_BROWSER"})  // nor does a test need one
        qunsetenv(name);
    qputenv("PATH", "/nowhere");
    emit m_application->window().lessonFolderWanted();
    QVERIFY2(message().contains(QDir::toNativeSeparators(lessons::teachersFolder())), qPrintable(message()));
}

void TestSchool::whatTheDiskRefusesIsKeptWhenItCanBe()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    // Not even root can write here.
    QFile inTheWay(m_folder->filePath("outbox"));
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    grade("not kept yet");
    QVERIFY2(message().contains("Make room on the disk"), qPrintable(message()));
    QVERIFY(inTheWay.remove());
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("is kept now"), qPrintable(message()), kPatienceMs);
    // What was said before is over.
    child<ui::shell::MessageBar>()->dismiss();
    QVERIFY2(!message().contains("Make room on the disk"), qPrintable(message()));
    QTRY_VERIFY2_WITH_TIMEOUT(keeping().contains("first grade"), qPrintable(keeping()), kPatienceMs);
}

/// Whoever works there by then.
void TestSchool::whatTheDiskRefusesIsKeptWhenItsMakerHasGone()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    QFile inTheWay(m_folder->filePath("outbox"));
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    grade("not kept yet");
    leaveFor("sue");
    QVERIFY2(!message().contains("Make room on the disk"), qPrintable(message()));
    QVERIFY(inTheWay.remove());
    QTRY_COMPARE_WITH_TIMEOUT(count("attempts a JOIN people p ON p.id = a.person_id WHERE p.username = 'sam'"), 1,
                              kPatienceMs);
    QCOMPARE(attemptsKept(), 1);
    QVERIFY2(!message().contains("is kept now"), qPrintable(message()));
    // It is not offered to be gone on with: that would be another.
    leaveFor("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<QListView>("lessonList")->model()->rowCount() > 2, kPatienceMs);
    QTest::qWait(500);
    QVERIFY2(!message().contains("an attempt of"), qPrintable(message()));
}

/// While it waits it is no unfinished work: it would become two attempts.
void TestSchool::whatWaitsToBeKeptIsNotOffered()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    QFile inTheWay(m_folder->filePath("outbox"));
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    grade("not kept yet");
    leaveFor("sue");
    // Whoever quits is told of it.
    m_application->window().close();
    QVERIFY(m_application->window().isVisible());
    QVERIFY2(child<QLabel>("questionText")->text().contains("1 grade"),
             qPrintable(child<QLabel>("questionText")->text()));
    click("questionStay");
    leaveFor("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<QListView>("lessonList")->model()->rowCount() > 2, kPatienceMs);
    QTest::qWait(500);
    QVERIFY2(!message().contains("an attempt of"), qPrintable(message()));
    QVERIFY(inTheWay.remove());
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
}

/// Its note cannot come to the recording then.
void TestSchool::whatIsKeptDuringAReplayIsNotOffered()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    QFile inTheWay(m_folder->filePath("outbox"));
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    grade("not kept yet");
    m_application->showMoment(0.1);
    QTRY_VERIFY_WITH_TIMEOUT(actions().pauseReplay->isEnabled(), kPatienceMs);
    QVERIFY(inTheWay.remove());
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    leaveFor("sue");
    leaveFor("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<QListView>("lessonList")->model()->rowCount() > 2, kPatienceMs);
    QTest::qWait(500);
    QVERIFY2(!message().contains("an attempt of"), qPrintable(message()));
}

/// A program that was killed then leaves the journal as it was before, and beside it as what it was graded.
void TestSchool::whatWasKeptBeforeAKillIsNotOffered()
{
    for (const bool isKept : {true, false}) {
        start();
        logIn("sam");
        toTheTooth();
        drill(isKept ? -2.0 : 2.0);
        QTest::qWait(300);  // the last of it reaches the disk
        const auto uid = sql::ask(sql::Database::open(file()).value()->handle(),
                                  "SELECT uid FROM people WHERE username = 'sam'", "read");
        const QDir folder(m_folder->filePath("unfinished/" + uid.value().toString()));
        const QStringList journals = folder.entryList({"*.cuspjournal"}, QDir::Files);
        QCOMPARE(journals.size(), 1);
        const QString journal = folder.filePath(journals.front());
        QVERIFY(QFile::copy(journal, m_folder->filePath("kept")));
        const int before = attemptsKept();
        grade("");
        QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), before + 1, kPatienceMs);
        QFile mark(journal + ".graded");
        QVERIFY(mark.open(QIODevice::ReadOnly));
        QByteArray marked = mark.readAll();
        mark.close();
        m_application.reset();
        if (!isKept)  // as another, which never got so far
            marked[0] = marked[0] == 'a' ? 'b' : 'a';
        QVERIFY(QFile::rename(m_folder->filePath("kept"), journal));
        QVERIFY(mark.open(QIODevice::WriteOnly) && mark.write(marked) == marked.size());
        mark.close();
        start();
        logIn("sam");
        QTRY_VERIFY_WITH_TIMEOUT(child<QListView>("lessonList")->model()->rowCount() > 2, kPatienceMs);
        if (isKept) {
            QTRY_VERIFY_WITH_TIMEOUT(!QFile::exists(journal), kPatienceMs);
            QTest::qWait(300);
            QVERIFY(folder.entryList({"*.graded"}, QDir::Files).isEmpty());
            QVERIFY(!child<QLabel>("continueWords")->text().contains("Continue where I stopped"));
        } else {
            QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("continueWords")->text().contains("Continue where I stopped"),
                                     kPatienceMs);
        }
        m_application.reset();
    }
}

/// As it stands: its score was seen.
void TestSchool::anExamThatWasNotKeptIsGradedAgain()
{
    const Exam exam;
    start();
    logIn("sam");
    beginLesson("exam-36");
    drill(-2.0);
    QFile inTheWay(m_folder->filePath("outbox"));
    QTRY_COMPARE_WITH_TIMEOUT(count("exam_starts"), 1, kPatienceMs);
    QVERIFY(QDir(m_folder->filePath("outbox")).removeRecursively());
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    gradeLesson();
    const int expectedTenths = 10 * child<QSlider>("expected")->value();
    QTRY_VERIFY2_WITH_TIMEOUT(keeping().contains("not kept yet"), qPrintable(keeping()), kPatienceMs);
    QTest::qWait(300);
    const auto uid = sql::ask(sql::Database::open(file()).value()->handle(),
                              "SELECT uid FROM people WHERE username = 'sam'", "read");
    const QDir folder(m_folder->filePath("unfinished/" + uid.value().toString()));
    const QString journal = folder.filePath(folder.entryList({"*.cuspjournal"}, QDir::Files).value(0));
    QVERIFY(QFile::copy(journal, m_folder->filePath("kept")));
    m_application.reset();
    QVERIFY(QFile::rename(m_folder->filePath("kept"), journal));
    QVERIFY(inTheWay.remove());
    start();
    logIn("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("continueWords")->text().contains("Continue where I stopped"), kPatienceMs);
    click("continue");
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    // What he had expected is not asked again: he knows the score.
    QVERIFY(!child<ui::study::Forecast>()->isVisible());
    const auto kept =
        sql::ask(sql::Database::open(file()).value()->handle(), "SELECT expected_tenths FROM attempts", "read");
    QCOMPARE(kept.value().toInt(), expectedTenths);
    toTheTooth();
    QVERIFY(!actions().drill->isEnabled());
}

/// As if it had never been graded.
void TestSchool::whatWasGradedAndNotKeptIsUnfinished()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    const QString own = removed();
    QFile inTheWay(m_folder->filePath("outbox"));
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    grade("not kept yet");
    leaveFor("sue");
    m_application.reset();
    QVERIFY(inTheWay.remove());
    start();
    logIn("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("continueWords")->text().contains("Continue where I stopped"), kPatienceMs);
    click("continue");
    toTheTooth();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), own, kPatienceMs);
    grade("first grade");
    QCOMPARE(attemptsKept(), 1);
}

/// Which would be an attempt of its own.
void TestSchool::nothingIsCutWhileAGradeIsWorkedOut()
{
    start();
    logIn("sam");
    toTheTooth();
    ui::tooth::ToothView& view = m_application->window().view();
    const QString before = removed();
    const glm::dvec2 pixel = view.camera().pixelOf({-2.0, 1.0, -1.0});
    const QPoint at(qRound(pixel.x), qRound(pixel.y));
    QTest::mouseMove(&view, at);
    QTest::mousePress(&view, Qt::LeftButton, {}, at);
    QTRY_VERIFY_WITH_TIMEOUT(removed() != before, kPatienceMs);
    grade("first grade");
    QTest::mouseRelease(&view, Qt::LeftButton, {}, at);
    leaveFor("sue");
    leaveFor("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<QListView>("lessonList")->model()->rowCount() > 2, kPatienceMs);
    QTest::qWait(500);
    QVERIFY2(!message().contains("an attempt of"), qPrintable(message()));
    QCOMPARE(attemptsKept(), 1);
}

/// The tooth of a lesson may have none, and practice is graded by it.
void TestSchool::whoComesNextHasDecayToTakeOut()
{
    start();
    logIn("sam");
    toTheTooth();
    const auto onTheTable = [this] { return m_application->window().view().tooth()->anatomy; };
    const auto whole = onTheTable();
    beginLesson("class1-36");
    QTRY_VERIFY_WITH_TIMEOUT(onTheTable() != whole, kPatienceMs);
    leaveFor("sue");
    toTheTooth();
    QTRY_COMPARE_WITH_TIMEOUT(onTheTable().get(), whole.get(), kPatienceMs);
}

void TestSchool::aGuestsGradeIsKeptWhenHeLogsIn()
{
    start();
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("practiseAsGuest")->isVisible(), kPatienceMs);
    click("practiseAsGuest");
    toTheTooth();
    drill(-2.0);
    grade("not logged in");
    QCOMPARE(attemptsKept(), 0);
    click("keepGrade");
    QVERIFY(child<QCheckBox>("keepOnLogin")->isVisible() && child<QCheckBox>("keepOnLogin")->isChecked());
    logIn("sue");
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    QVERIFY(child<ui::study::ScorePage>()->isVisible());
    const auto owner =
        sql::ask(sql::Database::open(file()).value()->handle(),
                 "SELECT people.username FROM attempts JOIN people ON people.id = attempts.person_id", "read");
    QCOMPARE(owner.value().toString(), QString("sue"));
    // Whoever comes next gets a whole tooth.
    leaveFor("sam");
    toTheTooth();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), QString("0.00"), kPatienceMs);
}

/// Whoever says so gets neither his grade nor his tooth.
void TestSchool::aGuestsGradeIsNotAnothers()
{
    start();
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("practiseAsGuest")->isVisible(), kPatienceMs);
    QVERIFY(!child<QCheckBox>("keepOnLogin")->isVisible());
    click("practiseAsGuest");
    toTheTooth();
    drill(-2.0);
    grade("not logged in");
    actions().account->trigger();  // of a guest's score card: to keep it
    child<QCheckBox>("keepOnLogin")->setChecked(false);
    logIn("sue");
    toTheTooth();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), QString("0.00"), kPatienceMs);
    QVERIFY(!child<ui::study::ScorePage>()->isVisible());
    QCOMPARE(attemptsKept(), 0);
}

/// Whoever logs in then is somebody else.
void TestSchool::aGuestsGradeIsNobodysAfterAWhile()
{
    start();
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("practiseAsGuest")->isVisible(), kPatienceMs);
    click("practiseAsGuest");
    toTheTooth();
    drill(-2.0);
    grade("not logged in");
    click("keepGrade");
    QVERIFY(child<QCheckBox>("keepOnLogin")->isVisible());
    m_application->window().setIdleLimit(std::chrono::milliseconds(300));
    QTRY_VERIFY_WITH_TIMEOUT(!child<QCheckBox>("keepOnLogin")->isVisible(), kPatienceMs);
    m_application->window().setIdleLimit(std::chrono::minutes(10));
    logIn("sue");
    toTheTooth();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), QString("0.00"), kPatienceMs);
    QCOMPARE(attemptsKept(), 0);
}

/// Else the limit would be got round by logging in afterwards.
void TestSchool::aGuestsGradeCountsAsAnAttempt()
{
    give("block-line", 1);
    start();
    const auto gradeAsGuest = [this] {
        QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("practiseAsGuest")->isVisible(), kPatienceMs);
        click("practiseAsGuest");
        toTheTooth();
        beginLesson("block-line");
        drill(0.0);
        gradeLesson();
        click("keepGrade");
        logIn("sam");
    };
    gradeAsGuest();
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    actions().lock->trigger();
    click("otherLogin");
    QTRY_COMPARE_WITH_TIMEOUT(door(), Door::Login, kPatienceMs);
    gradeAsGuest();
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("this grade is not kept"), qPrintable(message()), kPatienceMs);
    QVERIFY2(keeping().contains("not being kept"), qPrintable(keeping()));
    QVERIFY(!child<QPushButton>("keepGrade")->isVisible());
    QVERIFY(!actions().reload->isEnabled());
    // Nor when the same work is graded once more.
    toTheTooth();
    actions().grade->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::ScorePage>()->isVisible(), kPatienceMs);
    QTest::qWait(500);
    QCOMPARE(attemptsKept(), 1);
    // What was done can be kept as a recording.
    for (QPushButton* button : child<ui::shell::MessageBar>()->findChildren<QPushButton*>())
        if (button->text() == actions().saveRecording->text())
            button->click();
    QVERIFY(child<QFileDialog>("QFileDialog") != nullptr);
    child<QFileDialog>("QFileDialog")->reject();
}

void TestSchool::whatWasGradedIsNotUnfinished_data()
{
    QTest::addColumn<bool>("asGuest");
    QTest::addColumn<bool>("looksAtItAgain");
    QTest::newRow("a student's own") << false << false;
    QTest::newRow("a student's own, looked at afterwards") << false << true;
    QTest::newRow("a guest's who has logged in for it") << true << false;
    QTest::newRow("a guest's who has logged in for it, looked at afterwards") << true << true;
}

/// Its grade is kept: it is offered to nobody, and so is not graded twice.
void TestSchool::whatWasGradedIsNotUnfinished()
{
    QFETCH(bool, asGuest);
    QFETCH(bool, looksAtItAgain);
    start();
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("practiseAsGuest")->isVisible(), kPatienceMs);
    if (asGuest)
        click("practiseAsGuest");
    else
        logIn("sue");
    toTheTooth();
    beginLesson("block-line");
    drill(0.0);
    gradeLesson();
    if (asGuest) {
        click("keepGrade");
        logIn("sue");
    }
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    QTRY_VERIFY2_WITH_TIMEOUT(keeping().contains("first grade"), qPrintable(keeping()), kPatienceMs);
    if (looksAtItAgain) {
        toTheTooth();
        QTest::qWait(500);  // with the bur turning
    }
    leaveFor("sam");
    leaveFor("sue");
    QTRY_VERIFY_WITH_TIMEOUT(child<QListView>("lessonList")->model()->rowCount() > 2, kPatienceMs);
    QTest::qWait(500);  // what is unfinished is looked for
    QVERIFY2(!message().contains("an attempt of"), qPrintable(message()));
    QVERIFY2(!child<QLabel>("continueWords")->text().contains("Continue where I stopped"),
             qPrintable(child<QLabel>("continueWords")->text()));
}

/// Sam's half-done work is Sam's: Sue sees a whole tooth, and he finds it again.
void TestSchool::nobodyIsOfferedAnothersWork()
{
    start();
    logIn("sam");
    toTheTooth();
    const QString whole = removed();
    drill(-2.0);
    const QString own = removed();
    QElapsedTimer since;
    since.start();
    leaveFor("sue");
    qInfo("another had the place after %lld ms", since.elapsed());
    toTheTooth();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), whole, kPatienceMs);
    QVERIFY2(!message().contains("an attempt of"), qPrintable(message()));
    QVERIFY(!child<QFrame>("continueCard")->isVisibleTo(&m_application->window()));
    drill(2.0);
    leaveFor("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("continueWords")->text().contains("Continue where I stopped"), kPatienceMs);
    QVERIFY(child<QPushButton>("continue")->isVisible());
    click("continue");
    toTheTooth();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), own, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(actions().undo->isEnabled(), kPatienceMs);
    grade("first grade");
    QCOMPARE(attemptsKept(), 1);
}

void TestSchool::theLessonsForgetWhoLeft()
{
    start();
    logIn("sam");
    actions().lessons->trigger();
    const auto* list = child<QListView>("lessonList");
    QTRY_VERIFY_WITH_TIMEOUT(list->isVisible() && list->model()->rowCount() > 10, kPatienceMs);
    const QString first = list->currentIndex().data().toString();
    auto* search = child<ui::study::LessonsPage>()->findChild<QLineEdit*>();
    search->setText("decay 26");
    QVERIFY(list->currentIndex().data().toString() != first);
    const auto* const clear = search->findChild<QAbstractButton*>();
    QTRY_VERIFY(clear->property("opacity").toDouble() > 0.0);
    leaveFor("sue");
    actions().lessons->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(list->isVisible() && list->model()->rowCount() > 10, kPatienceMs);
    QVERIFY2(search->text().isEmpty(), qPrintable(search->text()));
    QTRY_COMPARE(clear->property("opacity").toDouble(), 0.0);
    QTRY_COMPARE_WITH_TIMEOUT(list->currentIndex().data().toString(), first, kPatienceMs);
}

void TestSchool::anOpenedAttemptHasThoseBeforeIt()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    grade("first grade");
    actions().back->trigger();
    drill(2.0);
    grade("");
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 2, kPatienceMs);
    leaveFor("ines");
    actions().classes->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<QTableView>("matrix")->model()->rowCount() == 1, kPatienceMs);
    emit child<QTableView>("matrix")->verticalHeader()->sectionDoubleClicked(0);
    openNewest();
    QTRY_COMPARE_WITH_TIMEOUT(child<ui::study::ScorePage>()->card().history.size(), 2, kPatienceMs);
    QVERIFY2(!keeping().contains("first grade"), qPrintable(keeping()));
    // And back step by step: to the student's attempts, to the class, to the tooth.
    QCOMPARE(actions().back->text(), QString("Back to the attempts"));
    actions().back->trigger();
    QVERIFY(child<ui::people::HistoryPage>()->isVisible());
    QCOMPARE(actions().back->text(), QString("Back to the class"));
    actions().back->trigger();
    QVERIFY(child<ui::people::ClassPage>()->isVisible());
    QCOMPARE(actions().back->text(), QString("Back to the tooth"));
    // What is done elsewhere meanwhile is read with F5.
    QVERIFY(sql::execute(sql::Database::open(file()).value()->handle(),
                         "UPDATE people SET given_name = 'Samuel' WHERE username = 'sam'", "write"));
    QCOMPARE(actions().readAgain->shortcut(), QKeySequence(Qt::Key_F5));
    actions().readAgain->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(
        child<QTableView>("matrix")->model()->headerData(0, Qt::Vertical).toString().contains("Samuel"), kPatienceMs);
    actions().back->trigger();
    QVERIFY(!actions().readAgain->isEnabled());
    QVERIFY(m_application->window().view().isVisible());
}

/// What an admin keeps and puts to use, everybody's teeth feel like; a student looks on.
void TestSchool::onesOwnAttemptsAreComparedInAReplay()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    grade("first grade");
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    toTheTooth();
    drill(2.0);
    actions().grade->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 2, kPatienceMs);
    // The other one, and any file; never the one that is played.
    const auto offersTheOther = [this] {
        QTRY_VERIFY_WITH_TIMEOUT(m_application->window().view().isVisible() && actions().beside->isEnabled(),
                                 kPatienceMs);
        actions().beside->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(child<QMenu>("besideMenu") != nullptr, kPatienceMs);
        const QList<QAction*> offered = child<QMenu>("besideMenu")->actions();
        QCOMPARE(offered.size(), 3);
        QVERIFY2(offered[0]->text().startsWith("Free practice"), qPrintable(offered[0]->text()));
        QVERIFY(offered[1]->isSeparator());
        QCOMPARE(offered[2]->text(), QString("From a file …"));
    };
    emit m_application->window().momentWanted(0.0);
    offersTheOther();
    delete child<QMenu>("besideMenu");
    actions().attempts->trigger();
    openNewest();
    click("replayScored");
    offersTheOther();
    child<QMenu>("besideMenu")->actions().front()->trigger();
    child<QMenu>("besideMenu")->close();
    const auto views = [this] { return m_application->window().findChildren<ui::tooth::ToothView*>().size(); };
    QTRY_COMPARE_WITH_TIMEOUT(views(), 2, kPatienceMs);
    QVERIFY(actions().beside->isChecked());
}

void TestSchool::theSchoolsPresetIsTheAdmins()
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
void TestSchool::theNextToothFeelsAsWasChosenElsewhere()
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

void TestSchool::whatAnotherAdminHasChosenIsNotUndone()
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

void TestSchool::aPresetIsRetiredAndTakenUpAgain()
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
    // Retired at another station meanwhile, it is taken up again by being put in use.
    actions().back->trigger();
    actions().presets->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(list->item(rowOf("junk"))->text().contains("in use"), kPatienceMs);
    {
        const auto database = sql::Database::open(file()).value();
        const auto key = StationKey::readOrMake(m_folder->filePath("station.key")).value();
        const sql::School school{database->handle(), key};
        const auto admin = sql::Logins::login(school, "admin", kPassword).value();
        QVERIFY(sql::changeSetting(school, admin, "preset.retired", "hard"));
    }
    list->setCurrentRow(rowOf("hard"));
    click("presetUse");
    QTRY_COMPARE_WITH_TIMEOUT(count("settings WHERE name = 'preset.in_use' AND value = 'hard v1'"), 1, kPatienceMs);
    QTRY_COMPARE_WITH_TIMEOUT(count("settings WHERE name = 'preset.retired' AND value = ''"), 1, kPatienceMs);
}

/// A teacher gives a class a lesson, due yesterday, to be tried once.
void TestSchool::whatIsGivenIsDueAndLimited()
{
    {
        const auto database = sql::Database::open(file()).value();
        const auto key = StationKey::readOrMake(m_folder->filePath("station.key")).value();
        const sql::School school{database->handle(), key};
        const auto admin = sql::Logins::login(school, "admin", kPassword).value();
        const ClassId ofClass = sql::listClasses(school, admin).value().front().id;
        const std::string due = QDateTime::currentDateTimeUtc().addDays(-1).toString(Qt::ISODate).toStdString();
        QVERIFY(sql::assign(school, admin, {0, ofClass, "decay-36-small", due, 1}));
        QVERIFY(sql::assign(school, admin, {0, ofClass, "somebodys-own", "", 0}));
    }
    start();
    logIn("sam");
    auto* const list = child<QListView>("lessonList");
    QTRY_VERIFY_WITH_TIMEOUT(list->model()->rowCount() > 2, kPatienceMs);
    QCOMPARE(list->model()->index(0, 0).data().toString(), QString("Given to you"));
    const QModelIndex card = list->model()->index(1, 0);
    QVERIFY2(card.data(ui::study::CardDue).toString().endsWith(", 1 day late · DEN101-A"),
             qPrintable(card.data(ui::study::CardDue).toString()));
    QVERIFY(card.data(ui::study::CardIsLate).toBool());
    const auto* const page = child<ui::study::LessonsPage>();
    const auto words = page->findChildren<QLabel*>();
    QVERIFY(std::any_of(words.begin(), words.end(), [](const QLabel* label) {
        return label->isVisible() && label->text().contains("not on this computer: somebodys-own");
    }));
    QVERIFY(!child<QFrame>("continueCard")->isVisible());
    list->setCurrentIndex(card);
    click("startLesson");
    QTRY_VERIFY_WITH_TIMEOUT(!page->isVisible() && actions().grade->isEnabled(), kPatienceMs);
    drill(-2.0);
    actions().grade->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::Forecast>()->isVisible(), kPatienceMs);
    QTest::keyClick(child<QSlider>("expected"), Qt::Key_Right);
    QTest::keyClick(child<ui::study::Forecast>()->findChild<QRadioButton*>(), Qt::Key_Space);
    click("showScore");
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    // It was the only one: the lesson is there to be read, and is not begun again.
    actions().lessons->trigger();
    const auto chooseIt = [list] {
        for (int row = 0; row < list->model()->rowCount(); ++row)
            if (list->model()->index(row, 0).data().toString() == u"Decay on 36, small")
                list->setCurrentIndex(list->model()->index(row, 0));
    };
    chooseIt();
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("whyNotStart")->isVisible(), kPatienceMs);
    QVERIFY(!child<QPushButton>("startLesson")->isEnabled());
    QVERIFY(!child<QFrame>("continueCard")->isVisible());
    // To cut on and have it graded again is another one, too.
    toTheTooth();
    drill(2.0);
    actions().grade->trigger();
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("used up your attempts"), qPrintable(message()), kPatienceMs);
    QVERIFY(!child<ui::study::Forecast>()->isVisible());
    // Sue's class has not been given it.
    leaveFor("sue");
    QTRY_VERIFY_WITH_TIMEOUT(list->model()->rowCount() > 2, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(list->model()->index(0, 0).data().toString() != "Given to you", kPatienceMs);
}

/// From the score card, by its button and by R, as from the list of lessons.
void TestSchool::noneBeginsAgainWhenTheAttemptsAreUsedUp()
{
    give("block-line", 2);
    start();
    logIn("sam");
    toTheTooth();
    beginLesson("block-line");
    drill(0.0);
    gradeLesson();
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    QTRY_VERIFY2_WITH_TIMEOUT(keeping().contains("first grade"), qPrintable(keeping()), kPatienceMs);
    QVERIFY(actions().reload->isEnabled());
    actions().reload->trigger();
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("Another attempt at the lesson"), qPrintable(message()), kPatienceMs);
    QVERIFY(m_application->window().view().isVisible());
    QTest::qWait(500);  // the tooth has come to the servo
    QCOMPARE(removed(), QString("0.00"));
    drill(0.0);
    gradeLesson();
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 2, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(!actions().reload->isEnabled(), kPatienceMs);
    QVERIFY2(actions().reload->toolTip().contains("used up your attempts"), qPrintable(actions().reload->toolTip()));
    toTheTooth();
    QVERIFY(!actions().reload->isEnabled());
    // Another lesson is another matter.
    beginLesson("block-circle");
    QVERIFY(actions().reload->isEnabled());
    QVERIFY(!actions().reload->toolTip().contains("used up"));
}

/// What is whole again because it was undone has a grade all the same, and can be redone.
void TestSchool::aPresetGivesNoAttemptBack()
{
    give("block-line", 1);
    start();
    logIn("sam");
    toTheTooth();
    beginLesson("block-line");
    drill(0.0);
    const auto loadSoft = [this] {
        auto soft = lessons::shippedPresets().back();
        emit m_application->window().feelWanted(soft);
        QTest::qWait(500);
    };
    const auto undo = [this] {
        for (int k = 0; k < 20 && actions().undo->isEnabled(); ++k) {
            actions().undo->trigger();
            QTest::qWait(200);
        }
        QTRY_COMPARE_WITH_TIMEOUT(removed(), QString("0.00"), kPatienceMs);
    };
    undo();
    QVERIFY(actions().redo->isEnabled());
    loadSoft();
    QVERIFY(actions().redo->isEnabled());
    drill(0.0);
    gradeLesson();
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(!actions().reload->isEnabled(), kPatienceMs);
    toTheTooth();
    undo();
    loadSoft();
    QVERIFY(!actions().reload->isEnabled());
    QVERIFY(actions().redo->isEnabled());
}

/// The teacher has given it meanwhile, and counts what was done before.
void TestSchool::anUnfinishedAttemptIsNotTakenUpWhenTheAttemptsAreUsedUp()
{
    start();
    logIn("sam");
    toTheTooth();
    beginLesson("block-line");
    drill(0.0);
    gradeLesson();
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    toTheTooth();
    drill(2.0);  // goes on with it
    leaveFor("sue");
    leaveFor("sam");
    const auto isOffered = [this] {
        return child<QPushButton>("continue")->isVisible() &&
               child<QLabel>("continueWords")->text().contains("Continue where I stopped");
    };
    QTRY_VERIFY_WITH_TIMEOUT(isOffered(), kPatienceMs);
    give("block-line", 1);
    click("continue");
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("used up your attempts"), qPrintable(message()), kPatienceMs);
    QCOMPARE(removed(), QString("0.00"));
    // From then on it is not offered, and is there again once there may be another attempt.
    const auto* list = child<QListView>("lessonList");
    actions().lessons->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(list->model()->index(0, 0).data().toString(), QString("Given to you"), kPatienceMs);
    QVERIFY(!isOffered());
    leaveFor("sue");
    leaveFor("sam");
    QTRY_COMPARE_WITH_TIMEOUT(list->model()->index(0, 0).data().toString(), QString("Given to you"), kPatienceMs);
    QTest::qWait(1000);  // what is unfinished is looked for
    QVERIFY(!isOffered());
    QVERIFY2(!message().contains("an attempt of"), qPrintable(message()));
    QVERIFY(sql::execute(sql::Database::open(file()).value()->handle(), "UPDATE assignments SET attempt_limit = 2",
                         "write"));
    leaveFor("sue");
    leaveFor("sam");
    QTRY_VERIFY_WITH_TIMEOUT(isOffered(), kPatienceMs);
}

/// Not to have it graded gives no attempt back.
void TestSchool::anExamThatIsBrokenOffIsToldOf()
{
    const Exam exam;
    {
        const auto database = sql::Database::open(this->file()).value();
        const auto key = StationKey::readOrMake(m_folder->filePath("station.key")).value();
        const sql::School school{database->handle(), key};
        const auto admin = sql::Logins::login(school, "admin", kPassword).value();
        const ClassId ofClass = sql::listClasses(school, admin).value().front().id;
        QVERIFY(sql::assign(school, admin, {0, ofClass, "exam-36", "", 2}));
    }
    start();
    logIn("sam");
    auto* const list = child<QListView>("lessonList");
    QTRY_VERIFY_WITH_TIMEOUT(list->model()->rowCount() > 2, kPatienceMs);
    list->setCurrentIndex(list->model()->index(1, 0));
    click("startLesson");
    QTRY_VERIFY_WITH_TIMEOUT(!list->isVisible() && actions().grade->isEnabled(), kPatienceMs);
    // To have looked at it is not to have begun.
    QTest::qWait(500);
    QCOMPARE(count("exam_starts"), 0);
    drill(-2.0);
    QTRY_COMPARE_WITH_TIMEOUT(count("exam_starts"), 1, kPatienceMs);
    // It is begun anew, which he is told the price of, and again.
    const auto beginAnew = [this, list] {
        actions().lessons->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(list->isVisible() && child<QPushButton>("startLesson")->isEnabled(), kPatienceMs);
        click("startLesson");
        QVERIFY(child<QWidget>("workQuestion") != nullptr);
        QVERIFY(child<QLabel>("questionDetail")->text().contains("counts as an attempt"));
        click("questionDiscard");
    };
    beginAnew();
    QTRY_VERIFY_WITH_TIMEOUT(!list->isVisible() && actions().grade->isEnabled(), kPatienceMs);
    QTest::qWait(500);
    drill(-2.0);
    QTRY_COMPARE_WITH_TIMEOUT(count("exam_starts"), 2, kPatienceMs);
    beginAnew();
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("used up your attempts"), qPrintable(message()), kPatienceMs);
    m_application.reset();  // in the midst of it

    start();
    logIn("ines");
    actions().classes->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<QTableView>("matrix")->model()->rowCount() == 1, kPatienceMs);
    const auto sam = sql::ask(sql::Database::open(this->file()).value()->handle(),
                              "SELECT id FROM people WHERE username = 'sam'", "read");
    emit child<ui::people::ClassPage>()->studentWanted(sam.value().toLongLong());
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::people::HistoryPage>()->isVisible(), kPatienceMs);
    const QString told = child<QLabel>("examsWithoutScore")->text();
    QVERIFY2(child<QLabel>("examsWithoutScore")->isVisible() && told.count("The exam, begun") == 2, qPrintable(told));
}

/// It was opened in two of them, with one attempt left.
void TestSchool::anExamIsBegunInOneWindow()
{
    const Exam exam;
    give("exam-36", 1);
    start();
    logIn("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::LessonsPage>()->isVisible(), kPatienceMs);
    beginLesson("exam-36");
    {
        const auto database = sql::Database::open(file()).value();
        const auto key = StationKey::readOrMake(m_folder->filePath("station.key")).value();
        const sql::School school{database->handle(), key};
        const auto sam = sql::Logins::login(school, "sam", kPassword).value();
        QVERIFY(sql::deliverExam(school, sam.uid(), {newUid(), "exam-36", "2026-01-01T00:00:00Z"}));
    }
    drill(-2.0);
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("begun in another window"), qPrintable(message()), kPatienceMs);
    QVERIFY(!actions().drill->isEnabled() && !actions().reload->isEnabled());
    actions().grade->trigger();
    QTRY_VERIFY2_WITH_TIMEOUT(message().contains("used up your attempts"), qPrintable(message()), kPatienceMs);
    QVERIFY(!child<ui::study::Forecast>()->isVisible());
    QCOMPARE(count("exam_starts"), 1);
}

/// The school is told when it could not be told before the program was killed, and never twice.
void TestSchool::anExamThatIsTakenUpWasBegunOnce()
{
    const Exam exam;
    give("exam-36", 1);
    start();
    logIn("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::LessonsPage>()->isVisible(), kPatienceMs);
    beginLesson("exam-36");
    QVERIFY(QDir(m_folder->path()).mkpath("outbox"));
    QFile inTheWay(m_folder->filePath("outbox"));
    QVERIFY(QDir(m_folder->filePath("outbox")).removeRecursively());
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    drill(-2.0);
    QCOMPARE(count("exam_starts"), 0);
    const auto uid = sql::ask(sql::Database::open(file()).value()->handle(),
                              "SELECT uid FROM people WHERE username = 'sam'", "read");
    const QDir folder(m_folder->filePath("unfinished/" + uid.value().toString()));
    for (int kill = 0; kill < 2; ++kill) {
        const QString journal = folder.filePath(folder.entryList({"*.cuspjournal"}, QDir::Files).value(0));
        QVERIFY(QFile::copy(journal, m_folder->filePath("kept")));
        m_application.reset();
        QVERIFY(QFile::rename(m_folder->filePath("kept"), journal));
        if (kill == 0)
            QVERIFY(inTheWay.remove());
        start();
        logIn("sam");
        QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("continueWords")->text().contains("Continue where I stopped"),
                                 kPatienceMs);
        click("continue");
        QTRY_VERIFY2_WITH_TIMEOUT(message().contains("goes on where it was left"), qPrintable(message()), kPatienceMs);
        QTRY_COMPARE_WITH_TIMEOUT(count("exam_starts"), 1, kPatienceMs);
        QTest::qWait(500);
        QCOMPARE(count("exam_starts"), 1);
        QVERIFY(actions().drill->isEnabled());
    }
}

void TestSchool::anExamHidesEarlierAttempts()
{
    const Exam exam;
    start();
    logIn("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::LessonsPage>()->isVisible(), kPatienceMs);
    beginLesson("exam-36");
    drill(-2.0);
    gradeLesson();
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 1, kPatienceMs);
    beginLesson("exam-36");
    QTRY_COMPARE_WITH_TIMEOUT(removed(), QString("0.00"), kPatienceMs);
    drill(-2.0);
    actions().attempts->trigger();
    auto* const history = child<ui::people::HistoryPage>();
    QTRY_VERIFY_WITH_TIMEOUT(history->isVisible(), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(child<QTableView>("attempts")->model()->rowCount() == 1, kPatienceMs);
    child<QTableView>("attempts")->selectRow(0);
    for (const char* button : {"openAttempt", "replayAttempt"}) {
        m_application->window().showMessage("Nothing yet.");
        click(button);
        QTRY_VERIFY2_WITH_TIMEOUT(message().contains("You are in an exam"), qPrintable(message()), kPatienceMs);
        QVERIFY(history->isVisible());
    }
    toTheTooth();
    gradeLesson();
    QTRY_COMPARE_WITH_TIMEOUT(attemptsKept(), 2, kPatienceMs);
    actions().attempts->trigger();
    openNewest();
}

/// Else he could do it as often as he likes, and log in for the best.
void TestSchool::aGuestsExamIsNobodys()
{
    const Exam exam;
    start();
    QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("practiseAsGuest")->isVisible(), kPatienceMs);
    click("practiseAsGuest");
    toTheTooth();
    emit m_application->window().lessonChosen(*lessons::readLesson(exam.file()).lesson);
    QTest::qWait(100);
    QTRY_VERIFY_WITH_TIMEOUT(actions().grade->isEnabled(), kPatienceMs);
    drill(-2.0);
    actions().grade->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::Forecast>()->isVisible(), kPatienceMs);
    QTest::keyClick(child<QSlider>("expected"), Qt::Key_Right);
    QTest::keyClick(child<ui::study::Forecast>()->findChild<QRadioButton*>(), Qt::Key_Space);
    click("showScore");
    QTRY_VERIFY2_WITH_TIMEOUT(keeping().contains("not being kept"), qPrintable(keeping()), kPatienceMs);
    QVERIFY(!child<QPushButton>("keepGrade")->isVisible());
    emit m_application->window().keepWanted();
    logIn("sue");
    QTest::qWait(500);
    QCOMPARE(attemptsKept(), 0);
}

void TestSchool::lessonsAreChangedByWhoTeaches()
{
    start();
    logIn("sam");
    QTRY_VERIFY_WITH_TIMEOUT(child<QListView>("lessonList")->model()->rowCount() > 2, kPatienceMs);
    QVERIFY(!actions().editLesson->isVisible() && !actions().editLesson->isEnabled());
    leaveFor("ines");
    // A teacher's day begins with her classes.
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::people::ClassPage>()->isVisible(), kPatienceMs);
    actions().lessons->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(actions().editLesson->isVisible() && actions().editLesson->isEnabled(), kPatienceMs);
    actions().lock->trigger();
    click("otherLogin");
    QTRY_COMPARE_WITH_TIMEOUT(door(), Door::Login, kPatienceMs);
    click("practiseAsGuest");
    QTRY_VERIFY_WITH_TIMEOUT(!child<ui::people::LoginPage>()->isVisible(), kPatienceMs);
    QVERIFY(!actions().editLesson->isVisible());
}

void TestSchool::aTeacherAssignsLessonsAndTakesThemBack()
{
    start();
    logIn("ines");
    actions().classes->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::people::ClassPage>()->isVisible(), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(child<QTableView>("matrix")->model()->rowCount() == 1, kPatienceMs);
    click("assignLessons");
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::people::AssignPage>()->isVisible(), kPatienceMs);
    auto* offers = child<QListView>("offers")->model();
    QVERIFY(offers->rowCount() > 10);
    for (const int row : {1, 2})
        QVERIFY(offers->setData(offers->index(row, 0), Qt::Checked, Qt::CheckStateRole));
    click("assignTicked");
    QTRY_COMPARE_WITH_TIMEOUT(child<QTableView>("given")->model()->rowCount(), 2, kPatienceMs);
    QCOMPARE(count("assignments"), 2);
    // The titles of the catalogue, and when it is due, stand over the matrix.
    actions().back->trigger();
    QVERIFY(child<ui::people::ClassPage>()->isVisible());
    const auto* matrix = child<QTableView>("matrix")->model();
    QTRY_COMPARE_WITH_TIMEOUT(matrix->columnCount(), 3, kPatienceMs);
    const QString head = matrix->headerData(1, Qt::Horizontal).toString();
    QVERIFY2(head.contains("due") && !head.contains('-'), qPrintable(head));
    click("assignLessons");
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::people::AssignPage>()->isVisible(), kPatienceMs);
    click("undoAssign");
    QTRY_COMPARE_WITH_TIMEOUT(child<QTableView>("given")->model()->rowCount(), 0, kPatienceMs);
    QCOMPARE(count("assignments"), 0);
    QCOMPARE(child<QLabel>("assignSaid")->text(), QString("That was undone."));
}

/// By the teacher; the student finds them at his own attempt.
void TestSchool::commentsArePinnedToMomentsAndPlaces()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    grade("first grade");
    // When the points went is found out again.
    const auto moments = [this] {
        const auto buttons = child<ui::study::ScorePage>()->findChildren<QPushButton*>();
        return std::count_if(buttons.begin(), buttons.end(),
                             [](const QPushButton* button) { return button->text().contains("never removed"); });
    };
    actions().attempts->trigger();
    openNewest();
    QTRY_COMPARE_WITH_TIMEOUT(moments(), 1, kPatienceMs);
    leaveFor("ines");
    actions().classes->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<QTableView>("matrix")->model()->rowCount() == 1, kPatienceMs);
    emit child<QTableView>("matrix")->verticalHeader()->sectionDoubleClicked(0);
    openNewest();
    QTRY_COMPARE_WITH_TIMEOUT(moments(), 1, kPatienceMs);
    auto* heat = child<ui::study::HeatMap>();
    QTRY_VERIFY_WITH_TIMEOUT(heat->height() > 100, kPatienceMs);
    QTest::mouseClick(heat, Qt::LeftButton, {}, heat->rect().center());
    QVERIFY(heat->pin());
    QVERIFY(!child<QCheckBox>("atMoment")->isVisible());
    // The replay is played from the card, and Esc leads back there.
    click("replayScored");
    QTRY_VERIFY_WITH_TIMEOUT(m_application->window().view().isVisible(), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(child<QCheckBox>("atMoment")->text().contains("0:0"), kPatienceMs);
    QTest::qWait(300);
    actions().back->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::ScorePage>()->isVisible(), kPatienceMs);
    QVERIFY(child<QCheckBox>("atMoment")->isVisible());
    child<QCheckBox>("atMoment")->setChecked(true);
    QVERIFY(child<QCheckBox>("atPlace")->isChecked());
    child<QPlainTextEdit>("commentWords")->setPlainText("Here you pressed too hard.");
    click("addComment");
    QTRY_COMPARE_WITH_TIMEOUT(pins().size(), 2, kPatienceMs);
    QCOMPARE(count("comments WHERE moment_ms IS NOT NULL AND x_um IS NOT NULL"), 1);
    const auto place = heat->pin();
    // Another score is in the list behind the card, too.
    child<QDoubleSpinBox>("givenPoints")->setValue(91.5);
    child<QLineEdit>("reason")->setText("Seen by hand.");
    click("giveScore");
    const auto listed = [this] {
        const auto* model = child<QTableView>("attempts")->model();
        return model->index(0, ui::people::HistoryModel::Score).data().toString();
    };
    QTRY_COMPARE_WITH_TIMEOUT(listed(), QString("91.5"), kPatienceMs);

    // He is told of it at home, and reads it from there.
    leaveFor("sam");
    auto* news = child<QLabel>("feedbackWords");
    QTRY_VERIFY_WITH_TIMEOUT(news->isVisible(), kPatienceMs);
    QVERIFY2(news->text().startsWith("Ines Teach has written about your attempt"), qPrintable(news->text()));
    const auto shown = [this] {
        const auto* model = child<QTableView>("attempts")->model();
        return model->index(0, ui::people::HistoryModel::Feedback).data().toString();
    };
    click("readFeedback");
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::ScorePage>()->isVisible(), kPatienceMs);
    QTRY_COMPARE_WITH_TIMEOUT(pins().size(), 2, kPatienceMs);
    QTRY_COMPARE_WITH_TIMEOUT(count("settings WHERE name LIKE 'feedback.%'"), 1, kPatienceMs);
    actions().lessons->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!news->isVisible() && child<QListView>("lessonList")->isVisible(), kPatienceMs);
    actions().attempts->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(shown(), QString("read"), kPatienceMs);
    openNewest();
    QTRY_COMPARE_WITH_TIMEOUT(pins().size(), 2, kPatienceMs);
    QVERIFY(!child<QPlainTextEdit>("commentWords")->isVisible());
    QVERIFY(!heat->pin());
    pins().back()->click();
    QVERIFY(heat->pin());
    for (std::size_t k = 0; k < 3; ++k)
        QVERIFY(std::abs((*heat->pin())[k] - (*place)[k]) < 0.001);
    pins().front()->click();
    QTRY_VERIFY_WITH_TIMEOUT(m_application->window().view().isVisible(), kPatienceMs);
    // What was said is read where it was meant, however the replay was begun, and the way back leads there.
    const auto* remark = child<QLabel>("remark");
    const QString remarked = QStringLiteral("Ines Teach: Here you pressed too hard.");
    QTRY_VERIFY_WITH_TIMEOUT(remark->isVisible() && remark->text() == remarked, kPatienceMs);
    actions().back->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::ScorePage>()->isVisible(), kPatienceMs);
    QVERIFY(remark->text().isEmpty());
    actions().attempts->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<QTableView>("attempts")->isVisible(), kPatienceMs);
    child<QTableView>("attempts")->selectRow(0);
    click("replayAttempt");
    QTRY_VERIFY_WITH_TIMEOUT(remark->isVisible() && remark->text() == remarked, kPatienceMs);
    actions().back->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<QTableView>("attempts")->isVisible(), kPatienceMs);

    // The teacher takes it back, and finds it in the field, with what it was pinned to.
    leaveFor("ines");
    actions().classes->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<QTableView>("matrix")->model()->rowCount() == 1, kPatienceMs);
    emit child<QTableView>("matrix")->verticalHeader()->sectionDoubleClicked(0);
    openNewest();
    QTRY_COMPARE_WITH_TIMEOUT(pins().size(), 2, kPatienceMs);
    QTest::mouseClick(child<ui::people::TalkPanel>()->findChild<QPushButton*>("takeBack"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(pins().size(), 0, kPatienceMs);
    QCOMPARE(count("comments WHERE withdrawn_utc IS NOT NULL"), 1);
    QCOMPARE(child<QPlainTextEdit>("commentWords")->toPlainText(), QString("Here you pressed too hard."));
    QVERIFY(child<QCheckBox>("atMoment")->isChecked() && child<QCheckBox>("atPlace")->isChecked());
}

void TestSchool::withoutItsRecordingAnAttemptIsOpenedAndOverruled_data()
{
    QTest::addColumn<QString>("lost");
    QTest::addColumn<bool>("hasSheet");
    QTest::newRow("its file has gone") << "" << true;
    QTest::newRow("none was kept") << "UPDATE attempts SET recording_hash = ''" << true;
    QTest::newRow("nor a sheet, as in a sample school") << "UPDATE score_sheets SET json = '{\"format\":2}'" << false;
}

/// From its score sheet, as it was marked.
void TestSchool::withoutItsRecordingAnAttemptIsOpenedAndOverruled()
{
    QFETCH(QString, lost);
    QFETCH(bool, hasSheet);
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    grade("first grade");
    const auto* const page = child<ui::study::ScorePage>();
    const lessons::ScoreSheet marked = page->card().sheet;
    QVERIFY(QDir(m_folder->filePath("recordings")).removeRecursively());
    if (!lost.isEmpty())
        QVERIFY(sql::execute(sql::Database::open(file()).value()->handle(), lost, "lose"));
    leaveFor("ines");
    QTRY_COMPARE_WITH_TIMEOUT(child<QTableView>("matrix")->model()->rowCount(), 1, kPatienceMs);
    emit child<QTableView>("matrix")->verticalHeader()->sectionDoubleClicked(0);
    openNewest();
    QCOMPARE(page->person(), QString("sam Student"));
    const lessons::ScoreSheet shown = page->card().sheet;
    if (hasSheet)
        QVERIFY(shown == marked);
    QCOMPARE(shown.totalTenths, marked.totalTenths);
    QCOMPARE(shown.criteria.size(), marked.criteria.size());
    for (std::size_t k = 0; k < marked.criteria.size(); ++k) {
        QCOMPARE(shown.criteria[k].lostTenths, marked.criteria[k].lostTenths);
        QCOMPARE(ui::text::criterionName(shown.criteria[k]), ui::text::criterionName(marked.criteria[k]));
        QCOMPARE(ui::text::criterionWorked(shown.criteria[k], shown.verdict).contains("not stored"), !hasSheet);
    }
    QVERIFY2(child<QLabel>("unrecorded")->isVisible() && child<QLabel>("unrecorded")->text().contains("no recording"),
             qPrintable(child<QLabel>("unrecorded")->text()));
    QVERIFY(!child<QPushButton>("replayScored")->isVisible() && !child<ui::study::HeatMap>()->isVisible());
    QVERIFY(!child<QLabel>("howToPin")->isVisible());
    child<QPlainTextEdit>("commentWords")->setPlainText("Do it again.");
    click("addComment");
    QTRY_COMPARE_WITH_TIMEOUT(count("comments"), 1, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(child<QPlainTextEdit>("commentWords")->toPlainText().isEmpty(), kPatienceMs);  // answered
    child<QDoubleSpinBox>("givenPoints")->setValue(91.5);
    child<QLineEdit>("reason")->setText("Seen by hand.");
    click("giveScore");
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("counts")->text().contains("91.5"), kPatienceMs);
    QCOMPARE(count("overrides"), 1);
    QCOMPARE(page->card().sheet.totalTenths, marked.totalTenths);
    saveCard(m_folder->filePath("old.pdf"));
    // Who made it reads it as well, and what is on the table is graded for itself.
    leaveFor("sam");
    actions().attempts->trigger();
    openNewest();
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("counts")->text().contains("91.5"), kPatienceMs);
    QVERIFY(child<QLabel>("unrecorded")->isVisible());
    toTheTooth();
    drill(2.0);
    grade("");
    QVERIFY(!child<QLabel>("unrecorded")->isVisible() && child<ui::study::HeatMap>()->isVisible());
}

/// Of the work that was just graded, and of an old attempt.
void TestSchool::aScoreCardIsSavedWithItsAuditCode()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    grade("first grade");
    // The title of a PDF is UTF-16, with the least byte last.
    const auto hasCodeOfNow = [this](const QString& path) {
        const auto database = sql::Database::open(file()).value();
        const sql::School school{database->handle(), StationKey::readOrMake(m_folder->filePath("station.key")).value()};
        QByteArray code;
        for (const QChar one : QString::fromStdString(sql::auditHead(school)->code()))
            code += QByteArray(1, '\0') + one.toLatin1();
        QFile pdf(path);
        return code.size() > 20 && pdf.open(QIODevice::ReadOnly) && pdf.readAll().contains(code);
    };
    saveCard(m_folder->filePath("new.pdf"));
    QVERIFY(hasCodeOfNow(m_folder->filePath("new.pdf")));
    leaveFor("ines");
    leaveFor("sam");
    actions().attempts->trigger();
    openNewest();
    saveCard(m_folder->filePath("old.pdf"));
    QVERIFY(hasCodeOfNow(m_folder->filePath("old.pdf")));
    QVERIFY(!hasCodeOfNow(m_folder->filePath("new.pdf")));
}

void TestSchool::withoutADatabaseTheCardSaysSo()
{
    app::WindowOptions options;
    options.source = {36};
    options.database = m_folder->filePath("no folder/no school.sqlite");
    m_application = app::Application::make(options).value();
    m_application->show();
    toTheTooth();
    drill(-2.0);
    grade("");
    saveCard(m_folder->filePath("guest.pdf"));
}

void TestSchool::openSchool(ui::admin::AdminPage::Part part) const
{
    actions().school->trigger();
    child<ui::admin::AdminPage>()->show(part);
    QVERIFY(child<ui::admin::AdminPage>()->isVisible());
}

void TestSchool::anAdminEntersAndChangesPeople()
{
    start();
    logIn("sam");
    QVERIFY(!actions().school->isVisible());
    leaveFor("admin");
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::admin::AdminPage>()->isVisible(), kPatienceMs);  // where an admin's begins
    openSchool(ui::admin::AdminPage::People);
    const auto* people = child<QTableView>("people")->model();
    QTRY_COMPARE_WITH_TIMEOUT(people->rowCount(), 4, kPatienceMs);
    const auto database = sql::Database::open(file()).value();
    const sql::School school{database->handle(), StationKey::readOrMake(m_folder->filePath("station.key")).value()};
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

void TestSchool::aClassListIsSeenBeforeItIsEntered()
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
    click("enterRoster");
    QTRY_VERIFY2_WITH_TIMEOUT(said().contains("was entered"), qPrintable(said()), kPatienceMs);
    QCOMPARE(count("people"), 5);
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

void TestSchool::aBackupIsMadeTriedAndRestored()
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
    // A backup is looked at less thoroughly, and says nothing against what was found.
    click("backUp");
    QTRY_VERIFY2_WITH_TIMEOUT(said().contains("found is in this backup, too"), qPrintable(said()), kPatienceMs);
    QVERIFY(child<QPlainTextEdit>("findings")->isVisible());
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
void TestSchool::anotherSchoolsBackupIsNotRestored()
{
    support::SchoolRig other(false);
    other.populate();
    const QString folder = sql::backupFolder(file());
    QVERIFY(sql::backUp(other.school().db, folder, QDateTime::currentDateTimeUtc()));
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

void TestSchool::checkReportCodes() const
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
void TestSchool::aNetworkDriveIsForOneAndIsBackedUp()
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
void TestSchool::attemptsDoNotHideWhatWasDone()
{
    {
        const auto database = sql::Database::open(file()).value();
        const auto key = StationKey::readOrMake(m_folder->filePath("station.key")).value();
        const sql::School school{database->handle(), key};
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

/// However it was named: who looks for it, or for its backups, has to know where they lie.
void TestSchool::theDatabaseIsNamedWithItsWholePath()
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

void TestSchool::whatWasDoneStandsInTheAudit()
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

void TestSchool::onesOwnPasswordIsChanged()
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
    const auto database = sql::Database::open(file()).value();
    const sql::School school{database->handle(), StationKey::readOrMake(m_folder->filePath("station.key")).value()};
    QVERIFY(sql::Logins::login(school, "sam", "battery staple"));
}

/// Kept with the person, not with the computer; a guest's on the computer.
void TestSchool::everybodyIsShownRoundOnce()
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
void TestSchool::aTeachersTourBeginsWithHisClasses()
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
    return support::openGlMain<TestSchool>(argc, argv);
}

#include "tst_school.moc"
