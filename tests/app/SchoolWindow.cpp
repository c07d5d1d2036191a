// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/SchoolWindow.h"

#include <QFileDialog>
#include <QHeaderView>
#include <QLineEdit>
#include <QListView>

#include "app/school/AuditMemory.h"
#include "database/AttemptCheck.h"
#include "database/sql/Attempts.h"
#include "database/sql/Classes.h"
#include "database/sql/Doubts.h"
#include "database/sql/Logins.h"
#include "database/sql/People.h"
#include "database/sql/StartedExams.h"
#include "lessons/LessonVersion.h"
#include "ui/people/HistoryPage.h"
#include "ui/scoring/ScorePage.h"
#include "ui/scoring/ScorePredictionPage.h"
#include "ui/text/Language.h"
#include "ui/tooth/ToothView.h"

using namespace database;
using ui::people::LoginMode;

namespace support {

namespace {

constexpr PasswordCost kCheap{1, 8192};

StationKey keyBeside(const QString& place)
{
    return place.contains("://") ? StationKey::make()
                                 : StationKey::readOrMake(QFileInfo(place).dir().filePath("station.key")).value();
}

}  // namespace

OtherStation::OtherStation(const QString& place)
    : database(sql::Database::open(place).value()), school{database->handle(), keyBeside(place)}
{
    school.leastCost = kCheap;
}

Login OtherStation::logIn(const std::string& name) const
{
    return sql::Logins::login(school, name, kPassword).value();
}

void SchoolWindow::makeSchool(const QString& server)
{
    ui::text::Language::choose("en_GB");
    m_folder = std::make_unique<QTemporaryDir>();
    m_server = server;
    {
        const OtherStation elsewhere(place());
        const sql::DatabaseContext& school = elsewhere.school;
        const auto admin =
            sql::Logins::createFirstAdmin(school, {"admin", "Ada", "Admin", Role::Admin}, kPassword, kCheap).value();
        for (const NewPerson& person : {NewPerson{"sam", "sam", "Student", Role::Student},
                                        {"sue", "sue", "Student", Role::Student},
                                        {"ines", "Ines", "Teach", Role::Instructor}}) {
            const auto entered = sql::addPerson(school, admin, person).value();
            QVERIFY(sql::Logins::redeem(school, person.username, entered.code, kPassword));
        }
        const ClassId ofClass = sql::addClass(school, admin, "DEN101-A").value();
        for (const char* name : {"sam", "ines"})
            QVERIFY(sql::enrol(school, admin, ofClass, {elsewhere.idOf(name)}, true));
    }
    m_original = std::exchange(m_folder, std::make_unique<QTemporaryDir>());
}

void SchoolWindow::takeCopyOfSchool()
{
    m_folder = std::make_unique<QTemporaryDir>();
    QFile::remove(app::AuditMemory::defaultFile());  // the copy is older than what the test before has seen
    for (const QFileInfo& one : QDir(m_original->path()).entryInfoList(QDir::Files))
        QVERIFY(QFile::copy(one.filePath(), m_folder->filePath(one.fileName())));
}

QString SchoolWindow::saidAtDoor() const
{
    QStringList words;
    for (const QLabel* label : child<ui::people::LoginPage>()->findChildren<QLabel*>())
        words << label->text();
    return words.join('\n');
}

void SchoolWindow::waitForDoorToSay(const QString& words) const
{
    QTRY_VERIFY2_WITH_TIMEOUT(saidAtDoor().contains(words), qPrintable(saidAtDoor()), kPatienceMs);
}

void SchoolWindow::moveAway() const
{
    for (const char* end : {"", "-wal", "-shm"})
        QFile::rename(file() + end, m_folder->filePath(QStringLiteral("away.sqlite")) + end);
}

void SchoolWindow::damageSchool() const
{
    moveAway();
    QFile noise(file());
    QVERIFY(noise.open(QIODevice::WriteOnly) && noise.write(QByteArray(100'000, 'n')) == 100'000);
}

void SchoolWindow::start(app::WindowOptions options)
{
    if (!m_server.isEmpty())
        options.retry = std::chrono::milliseconds(300);
    options.source = {36};
    options.database = place();
    options.asksWho = true;
    begin(options);
    // When the first tooth is ready, the program may open its page over one that was requested meanwhile.
    WAIT_FOR(window().view().tooth() != nullptr);
}

void SchoolWindow::typeLogin(const QString& name, const QString& password) const
{
    WAIT_FOR(child<QLineEdit>("username")->isEnabled());
    child<QLineEdit>("username")->setText(name);
    child<QLineEdit>("password")->setText(password);
    click("logIn");
}

void SchoolWindow::tryPassword(const QString& password) const
{
    WAIT_FOR(child<QLineEdit>("password")->isEnabled());
    child<QLineEdit>("password")->setText(password);
    click("logIn");
    WAIT_FOR(!isAtDoor() || child<QLineEdit>("password")->isEnabled());
}

void SchoolWindow::logIn(const QString& name) const
{
    typeLogin(name);
    WAIT_FOR_VALUE(actions().account->text(), name);
}

void SchoolWindow::logOut() const
{
    actions().lock->trigger();
    QCOMPARE(door(), LoginMode::Locked);
    click("otherLogin");
    WAIT_FOR_VALUE(door(), LoginMode::Login);
}

void SchoolWindow::switchTo(const QString& name) const
{
    logOut();
    logIn(name);
}

void SchoolWindow::beGuest() const
{
    WAIT_FOR(child<QPushButton>("practiseAsGuest")->isVisible());
    click("practiseAsGuest");
    WAIT_FOR(!isAtDoor());
}

void SchoolWindow::goToTooth() const
{
    // A page that was requested earlier may open late, over the practice room.
    const auto isThere = [this] {
        if (!window().view().isVisible())
            actions().back->trigger();
        return actions().grade->isEnabled();
    };
    WAIT_FOR(isThere());
}

void SchoolWindow::openAdminPage(ui::admin::AdminPage::Part part) const
{
    actions().school->trigger();
    child<ui::admin::AdminPage>()->show(part);
    QVERIFY(child<ui::admin::AdminPage>()->isVisible());
}

void SchoolWindow::assign(const std::string& lesson, int attempts, const std::string& dueUtc) const
{
    const OtherStation elsewhere(place());
    const auto admin = elsewhere.logIn("admin");
    const ClassId ofClass = sql::listClasses(elsewhere.school, admin).value().front().id;
    const lessons::Lesson version = lessons::lessonNamed(QString::fromStdString(lesson)).value();
    QVERIFY(sql::assign(elsewhere.school, admin, {0, ofClass, lesson, dueUtc, attempts, version.hash}, {},
                        lessons::packVersion(version).value()));
}

void SchoolWindow::expectProven(database::Doubt doubt) const
{
    const OtherStation elsewhere(place());
    const auto admin = elsewhere.logIn("admin");
    const auto all = sql::attemptsToCheck(elsewhere.school, admin, 100);
    for (const AttemptId id : *all) {
        const auto attempt = sql::openAttempt(elsewhere.school, admin, id);
        QCOMPARE(doubtId(attempt->doubt), doubtId(doubt));
        const auto recording = sql::openRecording(elsewhere.school, admin, id);
        const auto starts = sql::examStarts(elsewhere.school, admin, attempt->person, attempt->lessonId);
        QCOMPARE(doubtId(checkAttempt(*attempt, recording.value(), {}, *starts)), std::string());
    }
}

void SchoolWindow::grade(const QString& words) const
{
    gradeUntil<ui::scoring::ScorePage>();
    waitForSaved(words);
}

void SchoolWindow::gradeLesson(int expectedAttempts) const
{
    gradeUntil<ui::scoring::ScorePredictionPage>();
    expectScore();
    WAIT_FOR_VALUE(attempts(), expectedAttempts);
}

QString SchoolWindow::saved() const
{
    const auto* label = child<QLabel>("historyRemark");
    return label->isVisible() ? label->text() : QString();
}

void SchoolWindow::openAttempts() const
{
    actions().attempts->trigger();
    waitForPage<ui::people::HistoryPage>();
}

void SchoolWindow::waitForSaved(const QString& words) const
{
    QTRY_VERIFY2_WITH_TIMEOUT(saved().contains(words), qPrintable(saved()), kPatienceMs);
}

int SchoolWindow::count(const QString& rows) const
{
    const auto database = sql::Database::open(place());
    return database ? sql::ask((*database)->handle(), "SELECT count(*) FROM " + rows, "count").value().toInt() : -1;
}

void SchoolWindow::openStudent() const
{
    WAIT_FOR(studentsShown() > 0);
    emit child<QTableView>("matrix")->verticalHeader()->sectionClicked(0);
    waitForPage<ui::people::HistoryPage>();
}

void SchoolWindow::openNewest() const
{
    waitForPage<ui::people::HistoryPage>();
    WAIT_FOR(child<QTableView>("attempts")->model()->rowCount() > 0);
    child<QTableView>("attempts")->selectRow(0);
    click("openAttempt");
    waitForPage<ui::scoring::ScorePage>();
    WAIT_FOR(child<QLabel>("counts")->isVisible());
}

void SchoolWindow::savePdf(const QString& path) const
{
    emit child<ui::scoring::ScorePage>()->pdfRequested();
    auto* dialog = child<QFileDialog>("QFileDialog");
    QVERIFY(dialog != nullptr);
    emit dialog->fileSelected(path);
    dialog->reject();
    QTRY_VERIFY2_WITH_TIMEOUT(child<QLabel>("scoreSaid")->text().contains(QFileInfo(path).fileName()),
                              qPrintable(child<QLabel>("scoreSaid")->text()), kPatienceMs);
    QFile pdf(path);
    QVERIFY(pdf.open(QIODevice::ReadOnly) && pdf.read(5) == "%PDF-");
}

QString SchoolWindow::uidOf(const QString& name) const
{
    return OtherStation(place()).ask("SELECT uid FROM people WHERE username = '" + name + "'").toString();
}

bool SchoolWindow::isUnfinishedOffered() const
{
    return child<QPushButton>("continue")->isVisible() && child<QLabel>("continueWords")->text().contains("Continue ");
}

}  // namespace support
