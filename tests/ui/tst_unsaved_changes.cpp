// SPDX-License-Identifier: GPL-3.0-or-later
// A window with changes that are not saved asks before they are lost, and only then.
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

#include "lessons/LessonCatalog.h"
#include "tests/database/SchoolRig.h"
#include "tests/support/SyntheticMolar.h"
#include "ui/admin/AdminPage.h"
#include "ui/admin/PeoplePart.h"
#include "ui/admin/RosterPart.h"
#include "ui/people/TalkPanel.h"
#include "ui/presets/PresetsPage.h"
#include "ui/shell/Actions.h"
#include "ui/shell/MainWindow.h"
#include "ui/shell/QuestionCard.h"
#include "ui/study/LessonEditor.h"
#include "ui/study/ScorePage.h"

using namespace ui::shell;

class TestUnsavedChanges : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase()
    {
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
        support::SchoolRig rig(false);
        rig.populate();
        m_admin = rig.admin;
        m_teacher = rig.instructor;
    }

    void init()
    {
        m_links = std::make_unique<core::session::UiLinks>();
        m_window = std::make_unique<MainWindow>(*m_links);
        m_window->show();
        m_window->showTooth(support::syntheticMolar(), 1, {});
        const core::settings::FeelPreset preset = lessons::shippedPresets().front();
        m_window->setPresets({{{}, preset, {}}}, preset);
        m_window->setWho(m_admin);
        m_window->setMayEdit(true);
        m_window->adminPage().people().setPeople(
            {{{1}, "1", "ada", "Ada", "Berg", database::Role::Student, false, true, "", "", {}},
             {{2}, "2", "bob", "Bob", "Berg", database::Role::Student, false, true, "", "", {}}},
            {});
    }

    void cleanup()
    {
        m_window.reset();
        m_links.reset();
    }

    void everyPageIsAskedAbout_data()
    {
        QTest::addColumn<QString>("page");
        for (const QString page : {"people", "code", "class list", "preset", "comment", "score", "lesson"})
            QTest::newRow(qPrintable(page)) << page;
    }

    /// When the window is closed.
    void everyPageIsAskedAbout()
    {
        QFETCH(QString, page);
        change(page);
        const QString before = unsaved();
        m_window->close();
        QVERIFY(m_window->isVisible() && question() != nullptr);
        QVERIFY(!question()->findChild<QLabel*>("questionDetail")->text().isEmpty());
        QVERIFY(!question()->findChild<QLabel*>("questionDetail")->text().contains("1234"));  // it opens an account
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
        m_window->askWho(ui::people::Door::Locked);
        QVERIFY(m_window->isAtDoor() && question() == nullptr);
        m_window->setWho(m_admin);
        QVERIFY(!m_window->isAtDoor());
        QCOMPARE(unsaved(), before);
        QCOMPARE(child<QLineEdit>("personGiven")->text(), QString("Adalina"));
        QCOMPARE(child<QPlainTextEdit>("commentWords")->toPlainText(), QString("Half a sentence"));
    }

    void atTheLockTheOwnerIsNamed_data()
    {
        QTest::addColumn<bool>("quits");
        QTest::newRow("another user logs in") << false;
        QTest::newRow("the window is closed") << true;
    }

    void atTheLockTheOwnerIsNamed()
    {
        QFETCH(bool, quits);
        change("people");
        QSignalSpy leaves(m_window.get(), &MainWindow::logoutWanted);
        m_window->askWho(ui::people::Door::Locked);
        const auto leave = [&] {
            if (quits)
                m_window->close();
            else
                child<QPushButton>("otherLogin")->click();
        };
        leave();
        QVERIFY(question() != nullptr);
        QVERIFY(question()
                    ->findChild<QLabel*>("questionText")
                    ->text()
                    .contains(QString::fromStdString(m_admin.fullName())));
        QVERIFY(question()->findChild<QLabel*>("questionDetail")->text().isEmpty());  // it is nobody else's business
        answer("questionStay");
        QVERIFY(leaves.isEmpty() && m_window->isVisible() && !unsaved().isEmpty());
        leave();
        answer("questionDiscard");
        QCOMPARE(leaves.size(), quits ? 0 : 1);
        QCOMPARE(m_window->isVisible(), !quits);
        QVERIFY(unsaved().isEmpty());
    }

    /// Whoever comes next, however that comes about.
    void aUserWhoIsLoggedOutLeavesNothing()
    {
        for (const char* page : {"people", "code", "class list", "preset", "comment", "score", "lesson"})
            change(page);
        m_window->setWho(m_teacher);
        QVERIFY2(unsaved().isEmpty(), qPrintable(unsaved()));
        QVERIFY(child<QLineEdit>("personGiven")->text().isEmpty() && !child<QLabel>("oneTimeCode")->isVisible());
        QVERIFY(child<QPlainTextEdit>("commentWords")->toPlainText().isEmpty());
    }

    /// In the list of people.
    void anotherRowIsChosenAfterTheQuestion()
    {
        change("people");
        auto* table = child<QTableView>("people");
        table->selectRow(1);
        answer("questionStay");
        QCOMPARE(child<QLineEdit>("personGiven")->text(), QString("Adalina"));
        QCOMPARE(table->selectionModel()->selectedRows().front().row(), 0);
        table->selectRow(1);
        m_window->askWho(ui::people::Door::Locked);  // the question does not stand over the lock
        QVERIFY(question() == nullptr);
        m_window->setWho(m_admin);
        child<QPushButton>("newPerson")->click();
        answer("questionDiscard");
        QVERIFY(child<QLineEdit>("personGiven")->text().isEmpty());
        table->selectRow(1);
        QCOMPARE(child<QLineEdit>("personGiven")->text(), QString("Bob"));
    }

    void withoutChangesNothingIsAsked()
    {
        QSignalSpy leaves(m_window.get(), &MainWindow::logoutWanted);
        m_window->askWho(ui::people::Door::Locked);
        child<QPushButton>("otherLogin")->click();
        QCOMPARE(leaves.size(), 1);
        m_window->setWho(m_admin);
        m_window->close();
        QVERIFY(!m_window->isVisible());
    }

private:
    template <class T>
    T* child(const char* name = "") const
    {
        return m_window->findChild<T*>(QString::fromLatin1(name));
    }
    QuestionCard* question() const { return child<QuestionCard>("unsavedQuestion"); }
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
            m_window->adminPage().people().showCode(
                {{1}, "1", "ada", "Ada", "Berg", database::Role::Student, false, false, "", "", {}}, "1234-5678");
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
            for (const lessons::CatalogEntry& entry : lessons::readCatalog({}))
                if (entry.read.lesson && entry.read.lesson->id == "class1-36")
                    child<ui::study::LessonEditor>()->edit(entry.read, m_folder.path());
            QTest::keyClicks(child<QLineEdit>("draftTitle"), "mine");
        }
        QVERIFY2(!unsaved().isEmpty(), qPrintable(page));
    }

    /// The sentences of all pages.
    QString unsaved() const
    {
        return m_window->adminPage().people().unsavedChanges() + m_window->adminPage().roster().unsavedChanges() +
               child<ui::presets::PresetsPage>()->unsavedChanges() + m_window->scorePage().talk().unsavedChanges() +
               child<ui::study::LessonEditor>()->unsavedChanges();
    }

    QTemporaryDir m_folder;
    database::Session m_admin;
    database::Session m_teacher;
    std::unique_ptr<core::session::UiLinks> m_links;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(TestUnsavedChanges)
#include "tst_unsaved_changes.moc"
