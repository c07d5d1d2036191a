// SPDX-License-Identifier: GPL-3.0-or-later
// Two admins of one school: neither undoes the other's changes or sees the other's one-time codes.
#include <memory>

#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include "app/pages/AdminController.h"
#include "app/pages/PresetController.h"
#include "app/school/SchoolService.h"
#include "core/session/SessionChannels.h"
#include "database/sql/Erasing.h"
#include "database/sql/Settings.h"
#include "tests/database/SchoolRig.h"
#include "ui/admin/AdminPage.h"
#include "ui/admin/PeoplePart.h"
#include "ui/kit/MessageBar.h"
#include "ui/window/MainWindow.h"

namespace sql = database::sql;

namespace {

constexpr int kPatienceMs = 60000;

}  // namespace

class TestTwoAdmins : public QObject
{
    Q_OBJECT
private slots:
    void init()
    {
        m_rig = std::make_unique<support::SchoolRig>(support::populatedSchool(false));
        m_who = m_rig->admin;
        m_window = std::make_unique<ui::window::MainWindow>(m_links);
        m_window->setWho(m_who);
        m_window->show();
        m_desk =
            std::make_unique<app::SchoolService>(database::Address::parse(m_rig->address()).value(), m_folder.path());
    }
    void cleanup()
    {
        m_desk.reset();
        m_window.reset();
    }

    void whatAnotherAdminHasChosenIsNotUndone()
    {
        app::PresetController presets(*m_window, [this] { return m_who; });
        presets.setSchool(m_desk.get());
        const auto inUse = [this] {
            return QString::fromStdString(sql::readSettings(m_rig->school(), m_rig->admin).value()["preset.in_use"]);
        };
        const auto chooseElsewhere = [this](const char* name) {
            QVERIFY(sql::changeSetting(m_rig->school(), m_rig->admin, "preset.in_use", name));
        };
        auto* messages = m_window->findChild<ui::kit::MessageBar*>();
        const auto choose = [&] {
            core::settings::FeelPreset mine;
            mine.name = "mine";
            while (messages->dismiss()) {
            }
            emit m_window->hardness().useRequested(mine);
            QTRY_VERIFY_WITH_TIMEOUT(messages->sentence().contains("everybody"), kPatienceMs);
            QCOMPARE(inUse(), QString("mine v1"));
        };
        const auto undo = [&] {
            for (QPushButton* button : messages->findChildren<QPushButton*>())
                if (button->text() == "Undo")
                    button->click();
            QTRY_VERIFY_WITH_TIMEOUT(!messages->sentence().isEmpty(), kPatienceMs);
        };
        // The other admin has selected this preset, and the window has not read it yet.
        chooseElsewhere("first v1");
        choose();
        undo();
        QCOMPARE(inUse(), QString("first v1"));
        choose();
        chooseElsewhere("second v1");
        undo();
        QVERIFY2(messages->sentence().contains("second"), qPrintable(messages->sentence()));
        QCOMPARE(inUse(), QString("second v1"));
    }

    void aCodeIsNotShownToTheNextAdmin_data()
    {
        QTest::addColumn<bool>("isLate");
        QTest::newRow("it was shown to the one before") << false;
        QTest::newRow("it comes after the switch") << true;
    }
    void aCodeIsNotShownToTheNextAdmin()
    {
        QFETCH(bool, isLate);
        const database::Login next = m_rig->join({"admin2", "Eve", "Admin", database::Role::Admin}, m_rig->first);
        app::AdminController admin(*m_window, *m_desk, {}, [this] { return m_who; });
        ui::admin::PeoplePart& people = m_window->adminPage().people();
        const auto* code = m_window->findChild<QLabel*>("oneTimeCode");
        const auto show = [&] {
            people.setPeople({sql::findPerson(m_rig->school(), next, "s1001").value()}, {});
            m_window->findChild<QTableView*>("people")->selectRow(0);
        };
        show();
        emit people.resetRequested(m_rig->student.person().value);
        if (!isLate)
            QTRY_VERIFY_WITH_TIMEOUT(!code->text().isEmpty(), kPatienceMs);
        m_who = next;
        m_window->setWho(next);
        bool isAnswered = false;
        m_desk->askDatabase(
            this, [](const sql::DatabaseContext&) { return core::Result<bool>(true); },
            [&isAnswered](const core::Result<bool>&) { isAnswered = true; });
        QTRY_VERIFY_WITH_TIMEOUT(isAnswered, kPatienceMs);
        show();
        QVERIFY2(code->text().isEmpty(), qPrintable(code->text()));
        QVERIFY(people.unsavedChanges().isEmpty());
    }

    void whoAnotherAdminHasErasedStaysErased()
    {
        app::AdminController admin(*m_window, *m_desk, {}, [this] { return m_who; });
        ui::admin::PeoplePart& people = m_window->adminPage().people();
        const auto* said = m_window->findChild<QLabel*>("personSaid");
        const auto* fault = m_window->findChild<QLabel*>("personFault");
        const auto* rows = m_window->findChild<QTableView*>("people")->model();
        emit m_window->adminPage().partOpened(ui::admin::AdminPage::People);
        QTRY_COMPARE_WITH_TIMEOUT(rows->rowCount(), 6, kPatienceMs);
        const database::PersonId sam = m_rig->student.person();
        database::Person renamed = sql::findPerson(m_rig->school(), m_rig->admin, "s1001").value();
        renamed.familyName = "Renamed";
        QVERIFY(sql::erasePerson(m_rig->school(), m_rig->admin, sam));
        emit people.changeRequested(renamed, {m_rig->first.value});
        QTRY_VERIFY_WITH_TIMEOUT(fault->text().contains("Somebody else"), kPatienceMs);
        emit people.eraseRequested(sam.value);
        QTRY_VERIFY_WITH_TIMEOUT(!rows->match(rows->index(0, 1), Qt::DisplayRole, "erased-").isEmpty(), kPatienceMs);
        QVERIFY(said->text().isEmpty());
        QCOMPARE(m_rig->count("audit WHERE action = 'person.erase'"), 1);
        // The other admin has the file open all the time.
        emit people.eraseRequested(m_rig->classmate.person().value);
        QTRY_VERIFY_WITH_TIMEOUT(said->text().startsWith("The person was erased. The attempts stay as erased-"),
                                 kPatienceMs);
        QCOMPARE(support::faultsOf(m_rig->school().db), QString());
    }

private:
    QTemporaryDir m_folder;
    std::unique_ptr<support::SchoolRig> m_rig;
    core::session::UiChannels m_links;
    database::Login m_who;
    std::unique_ptr<ui::window::MainWindow> m_window;
    std::unique_ptr<app::SchoolService> m_desk;
};

QTEST_MAIN(TestTwoAdmins)
#include "tst_two_admins.moc"
