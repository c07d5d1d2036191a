// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>

#include "tests/support/Suite.h"
#include "tests/ui/PageTest.h"
#include "ui/admin/AdminPage.h"
#include "ui/admin/AuditPart.h"
#include "ui/admin/PeoplePart.h"
#include "ui/admin/RosterPart.h"

using ui::admin::AdminPage;
using ui::admin::PeoplePart;

namespace {

const QString kAdmin = QStringLiteral("the admin");

database::Person someone(qint64 id, const std::string& given, bool hasPassword,
                         const std::vector<database::ClassId>& classes = {})
{
    const std::string number = std::to_string(id);
    return {{id}, number, "s" + number, given, "Berg", database::Role::Student, false, hasPassword, "", "", classes};
}

}  // namespace

class TestAdminPage : public support::PageTest<AdminPage>
{
    Q_OBJECT
private slots:
    void initTestCase() { prepare(); }
    void init()
    {
        openPage();
        people().setAdmin(kAdmin);
    }

    void aCodeStaysWithItsPerson()
    {
        database::Person ada = someone(1, "Ada", false);
        const database::Person bob = someone(2, "Bob", true);
        setPeople({ada, bob});
        choose(0);
        showCode(ada);
        QVERIFY(showsCode());
        choose(1);
        QVERIFY(!showsCode());
        // The list shows which users' codes are still visible.
        const auto state = [this](int row) {
            return child<QTableView>("people")->model()->index(row, 5).data().toString();
        };
        QVERIFY2(state(0).contains("shown here") && !state(1).contains("shown here"), qPrintable(state(0)));
        m_page->show(AdminPage::Roster);
        m_page->show(AdminPage::People);
        choose(0);
        QVERIFY(showsCode());
        QCOMPARE(textOf("oneTimeCode"), QString("1234-5678"));
        // The admin may have given the code to the user already, so neither one key nor a double click replaces it.
        QSignalSpy reset(&people(), &PeoplePart::resetRequested);
        click("resetPassword");
        click("resetPassword");
        QCOMPARE(reset.size(), 0);
        QVERIFY2(said().contains("make another"), qPrintable(said()));
        click("keepAsItIs");
        QVERIFY(showsCode());
        // The user has used the code.
        setPeople({someone(1, "Ada", true), bob});
        QVERIFY(!showsCode());
        // Another admin has made another code, which invalidates this one.
        showCode(ada);
        QVERIFY(showsCode());
        ada.codeUntilUtc = "9999-01-01T00:00:00Z";
        setPeople({ada, bob});
        QVERIFY(!showsCode());
        QCOMPARE(state(0), QString("has a one-time code"));
        // The admin logs out.
        showCode(ada);
        QVERIFY(showsCode() && !people().unsavedChanges().isEmpty());
        // A code that was copied does not count as unsaved.
        click("copyCode");
        QVERIFY(showsCode() && people().unsavedChanges().isEmpty());
        people().discardChanges();
        QVERIFY(!showsCode() && !state(0).contains("shown here"));
    }

    void aPersonIsErasedAfterAQuestion()
    {
        database::Person ada = someone(1, "Ada", true);
        database::Person own = someone(2, "Bob", true);
        own.uid = kAdmin.toStdString();
        setPeople({ada, own});
        const auto* erase = child<QPushButton>("erasePerson");
        QVERIFY(!erase->isVisible());  // a new person
        choose(1);
        QVERIFY(!erase->isVisible());
        choose(0);
        QVERIFY(erase->isVisible());
        QSignalSpy erased(&people(), &PeoplePart::eraseRequested);
        // Enter and Esc keep the person: the button that erases is not the default.
        for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Escape}) {
            click("erasePerson");
            auto* const question = child<QWidget>("eraseQuestion");
            QVERIFY(question != nullptr && question->findChild<QLabel*>("questionText")->text().contains("Ada Berg"));
            QCOMPARE(QApplication::focusWidget()->objectName(), QString("questionStay"));
            QTest::keyClick(QApplication::focusWidget(), key);
            QVERIFY(!question->isVisible());
        }
        QCOMPARE(erased.size(), 0);
        QTest::keyClicks(child<QLineEdit>("personGiven"), "x");
        click("erasePerson");
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QCOMPARE(QApplication::focusWidget()->objectName(), QString("questionDiscard"));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
        QCOMPARE(erased.size(), 1);
        QCOMPARE(erased[0][0].toLongLong(), 1);
        QCOMPARE(QApplication::focusWidget()->objectName(), QString("people"));
        // Nothing can be changed of an erased person.
        ada.username = ada.pseudonym();
        ada.givenName.clear();
        ada.familyName.clear();
        ada.disabled = true;
        setPeople({ada, own});
        const QAbstractItemModel* const rows = child<QTableView>("people")->model();
        const int row = rows->index(0, 1).data().toString().startsWith("erased-") ? 0 : 1;
        choose(row);
        QCOMPARE(rows->index(row, 5).data().toString(), QString("erased"));
        QVERIFY(people().unsavedChanges().isEmpty());
        QVERIFY2(said().contains("was erased"), qPrintable(said()));
        for (const char* name : {"erasePerson", "resetPassword", "disablePerson", "savePerson"})
            QVERIFY2(!child<QPushButton>(name)->isVisible(), name);
        QVERIFY(!child<QLineEdit>("personGiven")->isEnabled());
        choose(1 - row);
        QVERIFY(child<QLineEdit>("personGiven")->isEnabled() && child<QPushButton>("savePerson")->isVisible());
    }

    void aDoubleClickOnEnterTakesNoPasswordAway()
    {
        QSignalSpy entered(&people(), &PeoplePart::addRequested);
        QSignalSpy changed(&people(), &PeoplePart::changeRequested);
        QSignalSpy reset(&people(), &PeoplePart::resetRequested);
        click("newPerson");
        child<QLineEdit>("personUsername")->setText("eve");
        click("savePerson");
        people().confirm({1}, [] { return QString("eve was entered."); });
        showCode(someone(1, "Eve", false));
        setPeople({someone(1, "Eve", false)});
        click("savePerson");
        click("resetPassword");
        QCOMPARE(entered.size(), 1);
        QCOMPARE(changed.size() + reset.size(), 0);
        // Later the button resets the password.
        QTRY_VERIFY((click("resetPassword"), !reset.empty()));
    }

    void theQuestionOfAPasswordEndsWithAnythingElse()
    {
        setPeople({someone(1, "Ada", true)});
        choose(0);
        const auto* keep = child<QPushButton>("keepAsItIs");
        const std::function<void()> others[] = {[this] { QTest::keyClicks(child<QLineEdit>("personGiven"), "x"); },
                                                [this] { click("savePerson"); }};
        for (const auto& doSomethingElse : others) {
            click("resetPassword");
            QVERIFY(keep->isVisible());
            doSomethingElse();
            QVERIFY(!keep->isVisible() && said().isEmpty());
        }
    }

    /// An admin who gives up their own role cannot undo that.
    void onesOwnRoleIsNotGivenUpByOneClick()
    {
        database::Person own = someone(1, "Ada", true);
        own.uid = kAdmin.toStdString();
        own.role = database::Role::Admin;
        setPeople({own});
        choose(0);
        std::vector<database::Person> sent;
        connect(&people(), &PeoplePart::changeRequested, this,
                [&](const database::Person& person, const auto&) { sent.push_back(person); });
        auto* role = child<QComboBox>("personRole");
        const auto chooseStudent = [role] {
            role->setCurrentIndex(0);
            emit role->activated(0);
        };
        chooseStudent();
        click("savePerson");
        click("savePerson");  // the second click of a double click
        QVERIFY(sent.empty());
        QVERIFY2(said().contains("an admin no longer"), qPrintable(said()));
        click("keepAsItIs");
        QCOMPARE(role->currentIndex(), 2);
        chooseStudent();
        click("savePerson");
        QVERIFY(sent.empty());
        QTRY_VERIFY((click("savePerson"), !sent.empty()));
        QCOMPARE(sent.back().role, database::Role::Student);
        people().confirm(own.id, [] { return QString("Ada Berg was changed."); });
        setPeople({own});
        // An admin cannot disable their own account by one click either.
        sent.clear();
        QTRY_VERIFY((click("disablePerson"), said().contains("your own account")));
        QVERIFY(sent.empty());
        QTRY_VERIFY((click("disablePerson"), !sent.empty()));
        QVERIFY(sent.back().disabled);
    }

    /// The form was opened but not changed, so it takes over another admin's changes.
    void aTouchedFormTakesOverWhatOthersHaveEntered()
    {
        const QList<database::SchoolClass> classes{{{1}, "Year 1", 0}, {{2}, "Year 2", 0}, {{3}, "Year 3", 0}};
        database::Person hugo = someone(1, "Hugo", true, {{1}, {3}});
        setPeople({hugo}, classes);
        choose(0);
        QTest::keyClicks(child<QLineEdit>("personGiven"), "X");
        const auto tick = [this](const QString& name) {
            return child<QListWidget>("personClasses")->findItems(name, Qt::MatchExactly).front();
        };
        tick("Year 3")->setCheckState(Qt::Unchecked);
        hugo.role = database::Role::Instructor;
        hugo.classes = {{2}, {3}};
        setPeople({hugo}, classes);
        QCOMPARE(child<QLineEdit>("personGiven")->text(), QString("HugoX"));
        QCOMPARE(child<QComboBox>("personRole")->currentIndex(), 1);
        for (const auto& [name, state] :
             {std::pair("Year 1", Qt::Unchecked), {"Year 2", Qt::Checked}, {"Year 3", Qt::Unchecked}})
            QCOMPARE(tick(name)->checkState(), state);
        QSignalSpy changed(&people(), &PeoplePart::changeRequested);
        click("savePerson");
        QCOMPARE(changed.size(), 1);
        const auto sent = changed[0][0].value<database::Person>();
        QCOMPARE(sent.givenName, std::string("HugoX"));
        QCOMPARE(sent.role, database::Role::Instructor);
        QCOMPARE(changed[0][1].value<QSet<qint64>>(), QSet<qint64>{2});
    }

    /// Passing through the list with Tab selects no user.
    void nobodyIsChosenByPassingThroughTheList()
    {
        setPeople({someone(1, "Ada", true), someone(2, "Bob", true)});
        click("newPerson");
        const auto* given = child<QLineEdit>("personGiven");
        auto* table = child<QTableView>("people");
        table->setFocus();
        table->selectionModel()->setCurrentIndex(table->model()->index(0, 0), QItemSelectionModel::NoUpdate);
        QVERIFY(given->text().isEmpty());
        QTest::keyClick(table, Qt::Key_Space);
        QCOMPARE(given->text(), QString("Ada"));
        QTest::keyClick(table, Qt::Key_Down);
        QCOMPARE(given->text(), QString("Bob"));
        // A search does not select another user.
        child<QLineEdit>("peopleSearch")->setText("Ada");
        QCOMPARE(given->text(), QString("Bob"));
        child<QLineEdit>("peopleSearch")->clear();
        QVERIFY(table->selectionModel()->isRowSelected(1));
    }

    /// After a search the view scrolls to the selected user. Reading the list again does not scroll it.
    void whoIsChosenIsInSightAfterASearch()
    {
        QList<database::Person> all;
        for (int k = 1001; k <= 3000; ++k)
            all << someone(k, "Ada", true);
        setPeople(all);
        QVERIFY2(child<QLabel>("peopleCount")->text().contains("2,000"),
                 qPrintable(child<QLabel>("peopleCount")->text()));
        const auto* table = child<QTableView>("people");
        const auto isSeen = [table] {
            const QModelIndexList rows = table->selectionModel()->selectedRows();
            return rows.size() == 1 && table->viewport()->rect().contains(table->visualRect(rows.front()).center());
        };
        auto* search = child<QLineEdit>("peopleSearch");
        search->setText("s2500");
        choose(0);
        search->clear();
        QVERIFY(isSeen());
        QScrollBar* bar = table->verticalScrollBar();
        bar->setValue(bar->value() / 2);
        const int scrolled = bar->value();
        QVERIFY(!isSeen());
        setPeople(all);
        QCOMPARE(bar->value(), scrolled);
        QCOMPARE(table->selectionModel()->selectedRows().size(), 1);
        // A user who has just been added is scrolled into view.
        all << someone(999, "Zoe", false);
        all.back().familyName = "Zuse";
        people().confirm({999}, [] { return QString("Zoe was entered."); });
        setPeople(all);
        QTRY_VERIFY(isSeen());
    }

    void aFaultGoesWithWhatItWasSaidOf()
    {
        const database::Person ada = someone(1, "Ada", true);
        setPeople({ada}, {{{4}, "Year 1", 0}});
        choose(0);
        QSignalSpy wanted(&people(), &PeoplePart::classRequested);
        auto* name = child<QLineEdit>("className");
        const auto* fault = child<QLabel>("personFault");
        name->setText("Year|2");
        click("addClass");
        QTest::keyClick(name, Qt::Key_Return);  // before the answer has arrived
        QCOMPARE(wanted.size(), 1);
        people().refuseClass([] { return QString("No class can be called that."); });
        QVERIFY(fault->isVisible());
        QCOMPARE(name->text(), QString("Year|2"));
        name->setText("Year 2");
        click("addClass");
        QCOMPARE(wanted.back().front().toString(), QString("Year 2"));
        people().confirmClass("Year 2");
        QVERIFY(!fault->isVisible() && name->text().isEmpty());
        click("newPerson");
        click("savePerson");
        QVERIFY(fault->isVisible() && fault->text().contains("is missing"));
    }

    void classesThatAreThereAreTicked()
    {
        setPeople({someone(1, "Ada", true, {{4}})}, {{{1}, "Year 1", 0}, {{4}, "Year 4", 0}});
        choose(0);
        QSignalSpy wanted(&people(), &PeoplePart::classRequested);
        const auto* list = child<QListWidget>("personClasses");
        QCOMPARE(list->item(0)->text(), QString("Year 4"));  // the user's own classes come first
        QCOMPARE(list->item(1)->checkState(), Qt::Unchecked);
        child<QLineEdit>("className")->setText("Year 1");
        click("addClass");
        QCOMPARE(wanted.size(), 0);
        QCOMPARE(list->findItems("Year 1", Qt::MatchExactly).front()->checkState(), Qt::Checked);
    }

    void aListOfNobodyIsAFault()
    {
        m_page->show(AdminPage::Roster);
        m_page->roster().showOutcome({}, "class.csv", false);
        const auto* fault = child<QLabel>("rosterFault");
        QVERIFY2(fault->isVisible() && fault->text().contains("nobody in class.csv"), qPrintable(fault->text()));
        QVERIFY(!child<QLabel>("rosterSaid")->isVisible() && !child<QPushButton>("enterRoster")->isVisible());
        // The outcome warns of lines with too few fields.
        database::RosterOutcome looked;
        looked.people = {{"eve", "Eve", database::Role::Student, {}, true, "", "", true},
                         {"ada", "Ada Berg", database::Role::Student, {}, false, "", "", false}};
        m_page->roster().showOutcome(looked, "class.csv", false);
        const auto* rows = child<QTableView>("roster")->model();
        QCOMPARE(rows->index(0, 4).data().toString(), QString("new; the line has fewer fields than the first"));
        QCOMPARE(rows->index(1, 4).data().toString(), QString("known"));
    }

    void anAuditThatCannotBeReadKeepsItsRows()
    {
        ui::admin::AuditPart& audit = m_page->audit();
        auto* without = child<QCheckBox>("auditNoAttempts");
        const auto* counted = child<QLabel>("auditCount");
        audit.keepRows();
        QVERIFY(counted->text().isEmpty());  // it is unknown whether there are any
        database::AuditRow row;
        row.seq = 7;
        audit.setRows({row}, "1234", true);
        QSignalSpy wanted(&audit, &ui::admin::AuditPart::newestRequested);
        without->click();
        QCOMPARE(wanted.size(), 1);
        QVERIFY(!child<QPushButton>("olderAudit")->isEnabled());
        audit.keepRows();
        QVERIFY(!without->isChecked() && counted->text().startsWith('1'));
        QCOMPARE(child<QTableView>("audit")->model()->rowCount(), 1);
        QVERIFY(child<QPushButton>("olderAudit")->isEnabled());
    }

private:
    [[nodiscard]] PeoplePart& people() const { return m_page->people(); }
    [[nodiscard]] QString said() const { return textOf("personSaid"); }
    [[nodiscard]] bool showsCode() const { return child<QLabel>("oneTimeCode")->isVisible(); }
    void choose(int row) const
    {
        auto* table = child<QTableView>("people");
        table->setCurrentIndex(table->model()->index(row, 0));
    }
    void showCode(const database::Person& person) const { people().showCode(person, "1234-5678"); }
    void setPeople(const QList<database::Person>& all, const QList<database::SchoolClass>& classes = {}) const
    {
        people().setPeople(all, classes);
    }
};

CUSP_TEST(TestAdminPage)
#include "tst_admin_page.moc"
