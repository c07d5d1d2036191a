// SPDX-License-Identifier: GPL-3.0-or-later
// The admin's page on fake repositories: adding, changing and checking, and answers that arrive after the admin has
// logged out.
#include <memory>

#include <QFile>
#include <QLabel>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include "app/pages/AdminController.h"
#include "core/session/SessionChannels.h"
#include "tests/app/FakeSchool.h"
#include "tests/database/SchoolRig.h"
#include "ui/admin/AdminPage.h"
#include "ui/admin/BackupPart.h"
#include "ui/admin/PeoplePart.h"
#include "ui/admin/RosterPart.h"
#include "ui/admin/StationPart.h"
#include "ui/kit/MessageBar.h"
#include "ui/window/MainWindow.h"

using core::ErrorCode;
using database::ClassId;
using database::Person;
using database::Role;
using ui::admin::AdminPage;

class TestAdminController : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        // Only the database makes logins.
        support::SchoolRig rig(support::populatedSchool(false));
        m_admin = rig.admin;
        m_next = rig.join({"admin2", "Eve", "Admin", Role::Admin}, rig.first);
    }
    void init()
    {
        m_school = std::make_unique<support::FakeSchool>();
        m_school->classes.all = {{ClassId{1}, "A"}, {ClassId{2}, "B"}};
        m_who = m_admin;
        m_window = std::make_unique<ui::window::MainWindow>(m_links);
        m_window->setWho(m_who);
        m_controller = std::make_unique<app::AdminController>(
            *m_window, *m_school,
            app::AdminController::Place{database::Address::parse("school.sqlite").value(), m_folder.path(),
                                        [] { return QString(); }, 1000.0},
            [this] { return m_who; });
    }
    void cleanup()
    {
        m_controller.reset();
        m_window.reset();
    }

    void aPersonIsEnteredWithTheirClasses()
    {
        emit page().people().addRequested({"new1", "Nia", "New", Role::Student}, {2, 1});
        m_school->answer();
        QCOMPARE(m_school->people.all.size(), std::size_t{1});
        QVERIFY((m_school->people.all.front().classes == std::vector<ClassId>{{1}, {2}}));
        QCOMPARE(page().people().findChild<QTableView*>("people")->model()->rowCount(), 1);
    }

    void onlyWhatTheAdminHasChangedIsSent()
    {
        addPerson({{1}, {2}});
        Person renamed = m_school->people.all.front();
        renamed.familyName = "Renamed";
        emit page().people().changeRequested(renamed, {1});
        m_school->answer();
        QCOMPARE(m_school->people.all.front().familyName, std::string("Renamed"));
        QVERIFY(m_school->people.all.front().classes == std::vector{ClassId{1}});
    }

    void aPersonThatAnotherAdminHasChangedIsReadAgain()
    {
        addPerson({});
        Person renamed = m_school->people.all.front();
        renamed.familyName = "Mine";
        m_school->people.all.front().familyName = "Theirs";
        emit page().people().changeRequested(renamed, {});
        m_school->answer();
        QCOMPARE(m_school->people.all.front().familyName, std::string("Theirs"));
        QVERIFY(!page().people().findChild<QLabel*>("personFault")->text().isEmpty());
    }

    void aCodeIsNotShownToTheNextAdmin()
    {
        addPerson({});
        page().people().findChild<QTableView*>("people")->selectRow(0);
        emit page().people().resetRequested(m_school->people.all.front().id.value);
        m_who = m_next;
        m_window->setWho(m_who);
        m_school->answer();
        QVERIFY(page().people().findChild<QLabel*>("oneTimeCode")->text().isEmpty());
    }

    void anErasedPersonIsListedUnderTheirPseudonym()
    {
        addPerson({});
        const auto* const rows = page().people().findChild<QTableView*>("people")->model();
        const auto* const words = page().people().findChild<QLabel*>("personSaid");
        emit page().people().eraseRequested(m_school->people.all.front().id.value);
        m_school->answer();
        QVERIFY(rows->index(0, 1).data().toString().startsWith("erased-"));
        QVERIFY2(words->text().contains("The person was erased"), qPrintable(words->text()));
        m_school->people.refusal = core::Error{ErrorCode::NobodyLeft, "the last admin"};
        emit page().people().eraseRequested(m_school->people.all.front().id.value);
        m_school->answer();
        QVERIFY(page().people().findChild<QLabel*>("personFault")->text().contains("the last admin"));
    }

    void aFileThatStaysUncleanIsNamed()
    {
        addPerson({});
        m_school->people.isFileClean = false;
        emit page().people().eraseRequested(m_school->people.all.front().id.value);
        m_school->answer();
        QVERIFY(page().people().findChild<QLabel*>("personSaid")->text().contains("may contain the names"));
    }

    void aClassListIsShownBeforeItIsEntered()
    {
        m_school->people.outcome.people = {rosterPerson(false)};
        choose("username\nnew1\n");
        QCOMPARE(m_school->people.imports, 0);
        emit page().roster().enterRequested();
        m_school->answer();
        QCOMPARE(m_school->people.imports, 1);
    }

    void aClassListWithAnotherOutcomeIsShownAgain()
    {
        m_school->people.outcome.people = {rosterPerson(false)};
        choose("username\nnew1\n");
        m_school->people.outcome.people = {rosterPerson(true)};  // another admin has added the user meanwhile
        emit page().roster().enterRequested();
        m_school->answer();
        QCOMPARE(m_school->people.imports, 0);
        QVERIFY(page().roster().findChild<QLabel*>("rosterSaid")->text().contains("somebody else"));
    }

    void aStoppedCheckSaysSo()
    {
        emit page().backups().checkRequested({});
        emit page().backups().stopRequested();
        m_school->answer();
        QCOMPARE(said(), QString("It was stopped."));
    }

    void aCheckThatFindsNothingSaysSo()
    {
        m_school->maintenance.report.attempts = 12;
        emit page().backups().checkRequested({});
        m_school->answer();
        QVERIFY2(said().contains("12 attempts"), qPrintable(said()));
    }

    void whatIsNoAuditCodeIsNotChecked()
    {
        emit page().backups().checkRequested("code");
        QVERIFY(!m_school->isAsked());
    }

    void theIdleLimitIsSaved()
    {
        QSignalSpy changed(m_controller.get(), &app::AdminController::idleMinutesChanged);
        emit page().station().idleMinutesRequested(15);
        m_school->answer();
        QCOMPARE(changed.count(), 1);
        QCOMPARE(m_school->settings.all["idle.minutes"], std::string("15"));
    }

    void anIdleLimitThatIsRefusedDoesNotHold()
    {
        QSignalSpy changed(m_controller.get(), &app::AdminController::idleMinutesChanged);
        m_school->settings.refusal = core::Error{ErrorCode::ConnectionLost, "the server is away"};
        emit page().station().idleMinutesRequested(15);
        m_school->answer();
        QCOMPARE(changed.count(), 0);
    }

private:
    [[nodiscard]] static database::RosterPerson rosterPerson(bool isNew)
    {
        database::RosterPerson person;
        person.username = "new1";
        person.fullName = "Nia New";
        person.isNew = isNew;
        return person;
    }
    [[nodiscard]] AdminPage& page() const { return m_window->adminPage(); }
    [[nodiscard]] QString said() const { return page().backups().findChild<QLabel*>("backupSaid")->text(); }
    /// Adds a user to the school and shows them on the page.
    void addPerson(const std::vector<ClassId>& classes)
    {
        QVERIFY(m_school->people.add(m_admin, {"s1001", "Sam", "One", Role::Student}, classes));
        emit page().partOpened(AdminPage::People);
        m_school->answer();
    }
    void choose(const QByteArray& csv)
    {
        QFile file(m_folder.filePath("class.csv"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(csv) == csv.size());
        file.close();
        emit page().roster().fileChosen(file.fileName());
        m_school->answer();
    }

    QTemporaryDir m_folder;
    database::Login m_admin;
    database::Login m_next;
    database::Login m_who;
    core::session::UiChannels m_links;
    std::unique_ptr<support::FakeSchool> m_school;
    std::unique_ptr<ui::window::MainWindow> m_window;
    std::unique_ptr<app::AdminController> m_controller;
};

QTEST_MAIN(TestAdminController)
#include "tst_admin_controller.moc"
