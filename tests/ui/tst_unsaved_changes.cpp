// SPDX-License-Identifier: GPL-3.0-or-later
// A window with unsaved changes asks before they are lost, and only then.
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTableView>

#include "tests/support/Suite.h"
#include "tests/support/Tables.h"
#include "tests/ui/WindowTest.h"
#include "ui/admin/AdminPage.h"
#include "ui/admin/PeoplePart.h"
#include "ui/admin/RosterPart.h"
#include "ui/lessoneditor/LessonEditor.h"
#include "ui/presets/PresetsPage.h"
#include "ui/scoring/CommentsPanel.h"
#include "ui/scoring/ScorePage.h"

using ui::window::MainWindow;

namespace {

database::Person user(qint64 id, const std::string& given, bool hasPassword = true)
{
    return {{id}, std::to_string(id), given, given, "Berg", database::Role::Student, false, hasPassword, "", "", {}};
}

const std::vector<QString> kPages{"people", "code", "class list", "preset", "comment", "score", "lesson"};

}  // namespace

class TestUnsavedChanges : public support::WindowTest
{
    Q_OBJECT
private slots:
    void initTestCase() { prepare(); }
    void init()
    {
        begin();
        m_window->hardness().setPresets({{{}, lessons::shippedPresets().front(), {}}},
                                        lessons::shippedPresets().front());
        m_window->setWho(school().admin);
        m_window->setMayEdit(true);
        m_window->adminPage().people().setPeople({user(1, "Ada"), user(2, "Bob")}, {});
    }
    void cleanup()
    {
        spoil();
        end();
    }

    void everyPageIsAskedAbout_data() { support::rows("page", kPages); }
    /// Closing the window asks about the changes of every page.
    void everyPageIsAskedAbout()
    {
        QFETCH(QString, page);
        change(page);
        const QString before = unsaved();
        m_window->close();
        QVERIFY(m_window->isVisible() && question() != nullptr);
        QVERIFY(!textOf("questionDetail").isEmpty());
        QVERIFY(!textOf("questionDetail").contains("1234"));  // the code gives access to an account
        QTest::keyClick(question(), Qt::Key_Escape);
        QVERIFY(m_window->isVisible() && question() == nullptr);
        QCOMPARE(unsaved(), before);
        m_window->close();
        answer("questionDiscard");
        QVERIFY(!m_window->isVisible() && unsaved().isEmpty());
    }

    void theOwnerFindsThemBehindTheLock()
    {
        for (const char* page : {"people", "preset", "comment", "lesson"})
            change(page);
        const QString before = unsaved();
        m_window->account().ask(ui::people::LoginMode::Locked);
        QVERIFY(m_window->navigation().isAtLogin() && question() == nullptr);
        m_window->setWho(school().admin);
        QVERIFY(!m_window->navigation().isAtLogin());
        QCOMPARE(unsaved(), before);
        QCOMPARE(child<QLineEdit>("personGiven")->text(), QString("Adalina"));
        QCOMPARE(child<QPlainTextEdit>("commentWords")->toPlainText(), QString("Half a sentence"));
    }

    void atTheLockTheOwnerIsNamed_data() { support::rows<bool>("quits", {false, true}); }
    void atTheLockTheOwnerIsNamed()
    {
        QFETCH(bool, quits);
        change("people");
        const QTemporaryDir recovery;
        m_window->lessonEditing().setRecoveryFolder(recovery.path());
        m_window->setMayEdit(true);
        change("lesson");
        QSignalSpy leaves(&m_window->account(), &ui::window::AccountController::logoutRequested);
        m_window->account().ask(ui::people::LoginMode::Locked);
        const auto leave = [&] {
            if (quits)
                m_window->close();
            else
                click("otherLogin");
        };
        leave();
        QVERIFY(question() != nullptr);
        QVERIFY(textOf("questionText").contains(QString::fromStdString(school().admin.fullName())));
        QVERIFY(textOf("questionDetail").isEmpty());  // the details are not shown to another user
        answer("questionStay");
        QVERIFY(leaves.isEmpty() && m_window->isVisible() && !unsaved().isEmpty());
        leave();
        answer("questionDiscard");
        QCOMPARE(leaves.size(), quits ? 0 : 1);
        QCOMPARE(m_window->isVisible(), !quits);
        QVERIFY(unsaved().isEmpty());
        // The draft of the lesson is kept for its owner only.
        m_window->setWho(school().instructor);
        m_window->setMayEdit(true);
        QVERIFY(unsaved().isEmpty());
        m_window->setWho(school().admin);
        m_window->setMayEdit(true);
        QVERIFY(!unsaved().isEmpty());
    }

    /// Another user logs in, in whatever way the previous one was logged out.
    void aUserWhoIsLoggedOutLeavesNothing()
    {
        for (const QString& page : kPages)
            change(page);
        m_window->setWho(school().instructor);
        QVERIFY2(unsaved().isEmpty(), qPrintable(unsaved()));
        QVERIFY(child<QLineEdit>("personGiven")->text().isEmpty() && !child<QLabel>("oneTimeCode")->isVisible());
        QVERIFY(child<QPlainTextEdit>("commentWords")->toPlainText().isEmpty());
    }

    /// In the list of users.
    void anotherRowIsChosenAfterTheQuestion()
    {
        change("people");
        auto* table = child<QTableView>("people");
        table->selectRow(1);
        answer("questionStay");
        QCOMPARE(child<QLineEdit>("personGiven")->text(), QString("Adalina"));
        QCOMPARE(table->selectionModel()->selectedRows().front().row(), 0);
        table->selectRow(1);
        m_window->account().ask(ui::people::LoginMode::Locked);  // the question does not stand over the lock
        QVERIFY(question() == nullptr);
        m_window->setWho(school().admin);
        child<QPushButton>("newPerson")->click();
        answer("questionDiscard");
        QVERIFY(child<QLineEdit>("personGiven")->text().isEmpty());
        table->selectRow(1);
        QCOMPARE(child<QLineEdit>("personGiven")->text(), QString("Bob"));
    }

    void withoutChangesNothingIsAsked()
    {
        QSignalSpy leaves(&m_window->account(), &ui::window::AccountController::logoutRequested);
        m_window->account().ask(ui::people::LoginMode::Locked);
        click("otherLogin");
        QCOMPARE(leaves.size(), 1);
        m_window->setWho(school().admin);
        m_window->close();
        QVERIFY(!m_window->isVisible());
    }

private:
    ui::kit::ConfirmOverlay* question() const { return WindowTest::question("unsavedQuestion"); }
    QString textOf(const char* label) const { return question()->findChild<QLabel*>(QLatin1String(label))->text(); }
    void answer(const char* button) const
    {
        QVERIFY(question() != nullptr);
        question()->findChild<QPushButton*>(QLatin1String(button))->click();
        QVERIFY(question() == nullptr);
    }
    void change(const QString& page) const
    {
        if (page == "people") {
            child<QTableView>("people")->selectRow(0);
            QTest::keyClicks(child<QLineEdit>("personGiven"), "lina");
        } else if (page == "code") {
            m_window->adminPage().people().showCode(user(1, "Ada", false), "1234-5678");
        } else if (page == "class list") {
            m_window->adminPage().roster().showOutcome(
                {{}, {{"eve", "Eve Berg", database::Role::Student, {}, true, "1234-5678", {}}}, {}}, "class.csv", true);
        } else if (page == "preset") {
            QTest::keyClicks(child<QLineEdit>("presetName"), " two");
        } else if (page == "comment") {
            child<QPlainTextEdit>("commentWords")->setPlainText("Half a sentence");
        } else if (page == "score") {
            child<QLineEdit>("reason")->setText("Half a reason");
        } else if (page == "lesson") {
            child<ui::lessoneditor::LessonEditor>()->edit(support::shipped("class1-36"), m_folder.path());
            QTest::keyClicks(child<QLineEdit>("draftTitle"), "mine");
        }
        QVERIFY2(!unsaved().isEmpty(), qPrintable(page));
    }

    /// Returns the sentences of all pages about unsaved changes.
    QString unsaved() const
    {
        return m_window->adminPage().people().unsavedChanges() + m_window->adminPage().roster().unsavedChanges() +
               child<ui::presets::PresetsPage>()->unsavedChanges() + m_window->scorePage().talk().unsavedChanges() +
               child<ui::lessoneditor::LessonEditor>()->unsavedChanges();
    }

    QTemporaryDir m_folder;
};

CUSP_TEST(TestUnsavedChanges)
#include "tst_unsaved_changes.moc"
