// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/SchoolWindow.h"

#include <QDeadlineTimer>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QRadioButton>
#include <QSlider>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include "app/Application.h"
#include "database/sql/Classes.h"
#include "database/sql/Logins.h"
#include "database/sql/People.h"
#include "database/sql/Statement.h"
#include "lessons/LessonCatalog.h"
#include "ui/admin/AdminPage.h"
#include "ui/people/HistoryPage.h"
#include "ui/people/LoginPage.h"
#include "ui/study/Forecast.h"
#include "ui/study/ScorePage.h"
#include "ui/text/Language.h"
#include "ui/text/Texts.h"
#include "ui/tooth/ToothView.h"

using namespace database;
using ui::people::Door;

namespace support {

namespace {

StationKey keyBeside(const QString& place)
{
    return place.contains("://") ? StationKey::make()
                                 : StationKey::readOrMake(QFileInfo(place).dir().filePath("station.key")).value();
}

}  // namespace

OtherStation::OtherStation(const QString& place)
    : database(sql::Database::open(place).value()), school{database->handle(), keyBeside(place)}
{}

Session OtherStation::logIn(const std::string& name) const
{
    return sql::Logins::login(school, name, kPassword).value();
}

/// A school with an admin and two students.
void SchoolWindow::makeSchool(const QString& server)
{
    ui::text::Language::choose("en_GB");
    m_folder = std::make_unique<QTemporaryDir>();
    m_server = server;
    const OtherStation elsewhere(place());
    const sql::School& school = elsewhere.school;
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

void SchoolWindow::start(bool showsRound, const sql::Database::Options& opening)
{
    app::WindowOptions options;
    options.opening = opening;
    options.source = {36};
    options.database = place();
    options.asksWho = true;
    options.showsRound = showsRound;
    m_application = app::Application::make(options).value();
    m_application->show();
}

void SchoolWindow::logIn(const QString& name) const
{
    QTRY_VERIFY_WITH_TIMEOUT(child<QLineEdit>("username")->isEnabled(), kPatienceMs);
    child<QLineEdit>("username")->setText(name);
    child<QLineEdit>("password")->setText(QString::fromStdString(kPassword));
    click("logIn");
    QTRY_COMPARE_WITH_TIMEOUT(actions().account->text(), name, kPatienceMs);
}

void SchoolWindow::leaveFor(const QString& name) const
{
    actions().lock->trigger();
    QCOMPARE(door(), Door::Locked);
    click("otherLogin");
    QTRY_COMPARE_WITH_TIMEOUT(door(), Door::Login, kPatienceMs);
    logIn(name);
}

void SchoolWindow::toTheTooth() const
{
    // What was asked for from there before may come late, and open over it.
    const QDeadlineTimer patience(kPatienceMs);
    do {
        for (int k = 0; k < 3 && !m_application->window().view().isVisible(); ++k)
            actions().back->trigger();
    } while (!QTest::qWaitFor([this] { return actions().grade->isEnabled(); }, 2000) && !patience.hasExpired());
    QVERIFY2(actions().grade->isEnabled(), qPrintable(message()));
}

QPoint SchoolWindow::press(double xMm) const
{
    ui::tooth::ToothView& view = m_application->window().view();
    const glm::dvec2 pixel = view.camera().pixelOf({xMm, 1.0, -1.0});
    const QPoint at(qRound(pixel.x), qRound(pixel.y));
    QTest::mouseMove(&view, at);
    QTest::mousePress(&view, Qt::LeftButton, {}, at);
    return at;
}

void SchoolWindow::drill(double xMm) const
{
    const QString before = removed();
    const QPoint at = press(xMm);
    QTRY_VERIFY_WITH_TIMEOUT(removed() != before, kPatienceMs);
    QTest::mouseRelease(&m_application->window().view(), Qt::LeftButton, {}, at);
    QTest::qWait(500);  // the stroke ends, and is told
}

void SchoolWindow::grade(const QString& said) const
{
    actions().grade->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::ScorePage>()->isVisible(), kPatienceMs);
    QTRY_VERIFY2_WITH_TIMEOUT(keeping().contains(said), qPrintable(keeping()), kPatienceMs);
}

void SchoolWindow::beginLesson(const std::string& id) const
{
    for (const lessons::CatalogEntry& entry : lessons::readCatalog(lessons::teachersFolder()))
        if (entry.read.lesson && entry.read.lesson->id == id)
            emit m_application->window().lessonChosen(*entry.read.lesson);
    QTest::qWait(100);
    QTRY_VERIFY_WITH_TIMEOUT(actions().grade->isEnabled(), kPatienceMs);
    QTest::qWait(500);  // the tooth has come to the servo
}

void SchoolWindow::give(const std::string& lesson, int attempts) const
{
    const OtherStation elsewhere(place());
    const sql::School& school = elsewhere.school;
    const auto admin = elsewhere.logIn("admin");
    const ClassId ofClass = sql::listClasses(school, admin).value().front().id;
    QVERIFY(sql::assign(school, admin, {0, ofClass, lesson, "", attempts}));
}

void SchoolWindow::gradeLesson() const
{
    actions().grade->trigger();
    QTRY_VERIFY2_WITH_TIMEOUT(child<ui::study::Forecast>()->isVisible(), qPrintable(message()), kPatienceMs);
    QTest::keyClick(child<QSlider>("expected"), Qt::Key_Right);
    QTest::keyClick(child<ui::study::Forecast>()->findChild<QRadioButton*>(), Qt::Key_Space);
    click("showScore");
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::ScorePage>()->isVisible(), kPatienceMs);
}

int SchoolWindow::count(const char* rows) const
{
    const auto database = sql::Database::open(place());
    return database ? sql::ask((*database)->handle(),
                               QStringLiteral("SELECT count(*) FROM %1").arg(QLatin1String(rows)), "count")
                          .value()
                          .toInt()
                    : -1;
}

void SchoolWindow::openNewest() const
{
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::people::HistoryPage>()->isVisible(), kPatienceMs);
    child<QTableView>("attempts")->selectRow(0);
    click("openAttempt");
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::ScorePage>()->isVisible(), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("counts")->isVisible(), kPatienceMs);
}

void SchoolWindow::saveCard(const QString& path) const
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

void SchoolWindow::openSchool(ui::admin::AdminPage::Part part) const
{
    actions().school->trigger();
    child<ui::admin::AdminPage>()->show(part);
    QVERIFY(child<ui::admin::AdminPage>()->isVisible());
}

}  // namespace support
