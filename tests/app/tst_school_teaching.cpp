// SPDX-License-Identifier: GPL-3.0-or-later
// The whole program as a teacher has it: classes, their reports, comments, scores of his own, lessons.
#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableView>
#include <QTest>

#include "database/sql/Attempts.h"
#include "database/sql/Audit.h"
#include "database/sql/Classes.h"
#include "database/sql/Logins.h"
#include "database/sql/People.h"
#include "database/sql/Statement.h"
#include "tests/app/SchoolWindow.h"
#include "tests/support/OpenGlMain.h"
#include "ui/people/AssignPage.h"
#include "ui/people/ClassPage.h"
#include "ui/people/HistoryModel.h"
#include "ui/people/HistoryPage.h"
#include "ui/people/LoginPage.h"
#include "ui/people/TalkPanel.h"
#include "ui/study/HeatMap.h"
#include "ui/study/ScorePage.h"
#include "ui/text/Language.h"
#include "ui/text/Texts.h"
#include "ui/tooth/ToothView.h"

using namespace database;
using support::kPassword;
using support::kPatienceMs;
using support::OtherStation;
using ui::people::Door;

class TestSchoolTeaching : public support::SchoolWindow
{
    Q_OBJECT
private slots:
    void init() { makeSchool(); }
    void cleanup() { m_application.reset(); }

    void nobodySeesTheClassOfWhoLeft();
    void aClassReportIsNoted();
    void theCardOfAnotherKeepsItsNameInAnotherLanguage();
    void anotherScoreIsNotOverruledUnseen();
    void theListFollowsWhatOthersSay();
    void aClassReportIsOfTheClassThatWasShown();
    void underAClasssNameStandsNoOther();
    void whichClassesThereAreIsReadAgain();
    void whoIsTakenOutOfAClassSeesItNoLonger();
    void whatIsTypedWaitsForItsWriter();
    void lessonsAreChangedByWhoTeaches();
    void aTeacherAssignsLessonsAndTakesThemBack();
    void commentsArePinnedToMomentsAndPlaces();
    void withoutItsRecordingAnAttemptIsOpenedAndOverruled_data();
    void withoutItsRecordingAnAttemptIsOpenedAndOverruled();
    void aScoreCardIsSavedWithItsAuditCode();

private:
    [[nodiscard]] QList<QPushButton*> pins() const;
    /// A second class: with Sue in it, and Ines.
    void enterSecondClass() const;
};

QList<QPushButton*> TestSchoolTeaching::pins() const
{
    QList<QPushButton*> found;
    for (QPushButton* button : child<ui::people::TalkPanel>()->findChildren<QPushButton*>())
        if (button->property("kind") == "chip")
            found << button;
    return found;
}

/// Otto has no class; what he comes to is not Ines's, whose page it was.
void TestSchoolTeaching::nobodySeesTheClassOfWhoLeft()
{
    {
        const OtherStation elsewhere(file());
        const sql::School& school = elsewhere.school;
        const auto admin = elsewhere.logIn("admin");
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
    emit child<QTableView>("matrix")->verticalHeader()->sectionClicked(0);
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::people::HistoryPage>()->isVisible() && attempts->rowCount() == 1, kPatienceMs);
    actions().lock->trigger();
    click("otherLogin");
    QTRY_COMPARE_WITH_TIMEOUT(door(), Door::Login, kPatienceMs);
    QCOMPARE(matrix->rowCount(), 0);
    QCOMPARE(attempts->rowCount(), 0);
    logIn("otto");
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::people::ClassPage>()->isVisible(), kPatienceMs);
    const auto* const empty = child<QLabel>("classEmpty");
    QTRY_VERIFY_WITH_TIMEOUT(empty->isVisible() && empty->text().contains("Here you will see your classes"),
                             kPatienceMs);
    QTest::qWait(500);
    QCOMPARE(matrix->rowCount(), 0);
    for (const QLabel* label : m_application->window().findChildren<QLabel*>())
        QVERIFY2(!label->isVisible() || !label->text().contains("sam"), qPrintable(label->text()));
}

/// Whatever leaves the school with names and marks.
void TestSchoolTeaching::aClassReportIsNoted()
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
void TestSchoolTeaching::theCardOfAnotherKeepsItsNameInAnotherLanguage()
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
    emit child<QTableView>("matrix")->verticalHeader()->sectionClicked(0);
    openNewest();
    const auto* const page = child<ui::study::ScorePage>();
    const QString english = page->card().lesson;
    ui::text::Language::choose("de");
    QTRY_VERIFY_WITH_TIMEOUT(page->card().lesson != english, kPatienceMs);
    QVERIFY2(page->card().lesson.contains("36"), qPrintable(page->card().lesson));
}

void TestSchoolTeaching::anotherScoreIsNotOverruledUnseen()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    grade("first grade");
    leaveFor("ines");
    actions().classes->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(child<QTableView>("matrix")->model()->rowCount(), 1, kPatienceMs);
    emit child<QTableView>("matrix")->verticalHeader()->sectionClicked(0);
    openNewest();
    auto* const talk = child<ui::people::TalkPanel>();
    QTRY_VERIFY_WITH_TIMEOUT(talk->findChild<QLineEdit*>("reason")->isVisible(), kPatienceMs);
    talk->findChild<QDoubleSpinBox*>("givenPoints")->setValue(55.5);
    talk->findChild<QLineEdit*>("reason")->setText("not so neat");
    // Meanwhile, at another station.
    {
        const OtherStation elsewhere(file());
        const sql::School& school = elsewhere.school;
        const auto ines = elsewhere.logIn("ines");
        const auto id = sql::ask(school.db, "SELECT max(id) FROM attempts", "read")->toLongLong();
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
void TestSchoolTeaching::theListFollowsWhatOthersSay()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    grade("first grade");
    leaveFor("ines");
    QTRY_COMPARE_WITH_TIMEOUT(child<QTableView>("matrix")->model()->rowCount(), 1, kPatienceMs);
    emit child<QTableView>("matrix")->verticalHeader()->sectionClicked(0);
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::people::HistoryPage>()->isVisible(), kPatienceMs);
    const auto listed = [this] {
        const auto* model = child<QTableView>("attempts")->model();
        return model->index(0, ui::people::HistoryModel::Score).data().toString();
    };
    const auto giveElsewhere = [this](int tenths) {
        const OtherStation elsewhere(file());
        const sql::School& school = elsewhere.school;
        const auto ines = elsewhere.logIn("ines");
        const auto id = sql::ask(school.db, "SELECT max(id) FROM attempts", "read")->toLongLong();
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

void TestSchoolTeaching::enterSecondClass() const
{
    const OtherStation elsewhere(file());
    const sql::School& school = elsewhere.school;
    const auto admin = elsewhere.logIn("admin");
    const ClassId other = sql::addClass(school, admin, "DEN102-B").value();
    for (const char* name : {"sue", "ines"}) {
        const auto id = sql::ask(school.db, "SELECT id FROM people WHERE username = ?", "r", {QLatin1String(name)});
        QVERIFY(sql::enrol(school, admin, other, {id.value().toLongLong()}, true));
    }
}

/// Another was chosen by the time that the audit had answered.
void TestSchoolTeaching::aClassReportIsOfTheClassThatWasShown()
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
void TestSchoolTeaching::underAClasssNameStandsNoOther()
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
void TestSchoolTeaching::whichClassesThereAreIsReadAgain()
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
void TestSchoolTeaching::whoIsTakenOutOfAClassSeesItNoLonger()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    grade("first grade");
    leaveFor("ines");
    const auto* const matrix = child<QTableView>("matrix")->model();
    QTRY_COMPARE_WITH_TIMEOUT(matrix->rowCount(), 1, kPatienceMs);
    emit child<QTableView>("matrix")->verticalHeader()->sectionClicked(0);
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

/// A comment that was begun is shown to nobody else, and where it was begun it bears the name of who it is about.
void TestSchoolTeaching::whatIsTypedWaitsForItsWriter()
{
    {
        const OtherStation elsewhere(file());
        const sql::School& school = elsewhere.school;
        const auto admin = elsewhere.logIn("admin");
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
        emit child<QTableView>("matrix")->verticalHeader()->sectionClicked(row);
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

void TestSchoolTeaching::lessonsAreChangedByWhoTeaches()
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

void TestSchoolTeaching::aTeacherAssignsLessonsAndTakesThemBack()
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
void TestSchoolTeaching::commentsArePinnedToMomentsAndPlaces()
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
    emit child<QTableView>("matrix")->verticalHeader()->sectionClicked(0);
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
    emit child<QTableView>("matrix")->verticalHeader()->sectionClicked(0);
    openNewest();
    QTRY_COMPARE_WITH_TIMEOUT(pins().size(), 2, kPatienceMs);
    QTest::mouseClick(child<ui::people::TalkPanel>()->findChild<QPushButton*>("takeBack"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(pins().size(), 0, kPatienceMs);
    QCOMPARE(count("comments WHERE withdrawn_utc IS NOT NULL"), 1);
    QCOMPARE(child<QPlainTextEdit>("commentWords")->toPlainText(), QString("Here you pressed too hard."));
    QVERIFY(child<QCheckBox>("atMoment")->isChecked() && child<QCheckBox>("atPlace")->isChecked());
}

void TestSchoolTeaching::withoutItsRecordingAnAttemptIsOpenedAndOverruled_data()
{
    QTest::addColumn<QString>("lost");
    QTest::addColumn<bool>("hasSheet");
    QTest::newRow("its file has gone") << "" << true;
    QTest::newRow("none was kept") << "UPDATE attempts SET recording_hash = ''" << true;
    QTest::newRow("nor a sheet, as in a sample school") << "UPDATE score_sheets SET json = '{\"format\":2}'" << false;
}

/// From its score sheet, as it was marked.
void TestSchoolTeaching::withoutItsRecordingAnAttemptIsOpenedAndOverruled()
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
    emit child<QTableView>("matrix")->verticalHeader()->sectionClicked(0);
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
void TestSchoolTeaching::aScoreCardIsSavedWithItsAuditCode()
{
    start();
    logIn("sam");
    toTheTooth();
    drill(-2.0);
    grade("first grade");
    // The title of a PDF is UTF-16, with the least byte last.
    const auto hasCodeOfNow = [this](const QString& path) {
        const OtherStation elsewhere(file());
        const sql::School& school = elsewhere.school;
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

int main(int argc, char** argv)
{
    return support::openGlMain<TestSchoolTeaching>(argc, argv);
}

#include "tst_school_teaching.moc"
